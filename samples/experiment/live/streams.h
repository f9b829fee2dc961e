// Outlets of the lab streaming layer: the finger as numbers, the journal's events as markers.
#pragma once

#include <optional>
#include <string>

#include "samples/experiment/data/journal.h"
#include "samples/reach/xr/session.h"

namespace hrt::experiment {

class LabStreams {
 public:
  /// Loads liblsl by its name, and throws Refusal if it cannot be. `source` names the session for receivers, which find
  /// its streams again after a crash by it.
  explicit LabStreams(const std::string& source);
  ~LabStreams();
  LabStreams(const LabStreams&) = delete;
  LabStreams& operator=(const LabStreams&) = delete;

  /// What is not known is NaN.
  void frame(const reach::Fingertip& tip, std::optional<double> felt_deg, std::optional<double> plate_deg) const;
  /// Without lists and long texts.
  void mark(const Event& event) const;

 private:
  void* find(const char* function) const;
  template <typename Result, typename... Arguments>
  Result call(const char* function, Arguments... arguments) const;
  void* outlet(const char* name, const char* type, const std::string& source) const;

  void* library_ = nullptr;
  void* finger_;
  void* events_;
  void (*destroy_)(void*);
};

}  // namespace hrt::experiment
