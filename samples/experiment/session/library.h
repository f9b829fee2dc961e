// A session of the plugin for one reach or set-up.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "samples/experiment/session/subject.h"

namespace hrt::experiment {

/// Throws Refusal with the plugin's error text unless `result` is HRT_OK.
void check(hrt_result result);

std::string library_version();

/// Converts a sample of a set-up to a JSON array of numbers. sample_of() converts it back.
nlohmann::json row_of(const hrt_sample& sample);
hrt_sample sample_of(const nlohmann::json& row);

class LibrarySession {
 public:
  /// `profile`: the participant's profile; empty: the parameters in the configuration of the condition.
  LibrarySession(const Condition& condition, const std::string& profile, const Subject& subject);
  ~LibrarySession();
  LibrarySession(const LibrarySession&) = delete;
  LibrarySession& operator=(const LibrarySession&) = delete;

  hrt_session handle() const { return session_; }
  /// Returns the real and the virtual target.
  std::pair<hrt_target, hrt_target> add_targets(double real_deg, double virtual_deg, double distance_m,
                                                double radius_m) const;
  hrt_session_config config() const;
  std::string profile() const;
  void record(const std::filesystem::path& file) const;
  void finish_recording(const std::filesystem::path& file) const;

 private:
  hrt_session session_{};
};

}  // namespace hrt::experiment
