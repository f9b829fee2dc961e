// Detects a set-up that does not progress, and diagnoses the cause from the samples. Without a diagnosis, a mistake of
// the host would only look like a request that is repeated.
#pragma once

#include <cstdint>
#include <optional>

#include "core/setup/setup_step.h"

namespace hrt {

/// Observer of the samples since the last completed step. Uses no heap, lock or exception.
class SetupProgress {
 public:
  void restart() { *this = {}; }
  void observe(const SetupSample& sample);
  /// Returns false if observed() cannot have a diagnosis yet.
  bool may_be_stuck() const {
    const auto passed_ns =
        static_cast<std::uint64_t>(now_ns_) - static_cast<std::uint64_t>(since_ns_.value_or(now_ns_));
    return samples_ >= many_samples || (samples_ >= min_samples && passed_ns >= patience_ns);
  }
  /// Returns a diagnosis; Kind::none or Kind::time in the first 20 s. `place`: requested position of the finger, if it
  /// is on the plate. `commanded_deg`: commanded plate orientation, if the set-up waits for the plate.
  Observed observed(const std::optional<PlatePoint>& place, const std::optional<double>& commanded_deg) const;

 private:
  static constexpr std::uint64_t patience_ns = 20'000'000'000;
  static constexpr int min_samples = 100;    // fewer: the application paused
  static constexpr int many_samples = 1000;  // enough to diagnose Kind::time; 11 s at 90 Hz

  std::optional<std::int64_t> since_ns_;
  std::int64_t now_ns_ = 0;
  int samples_ = 0;
  bool seen_ = false;                 // a sample had the finger
  bool touched_ = false;              // a sample had the finger on the plate
  std::optional<PlatePoint> finger_;  // last observed position
  std::optional<double> plate_deg_;   // last reported plate orientation
};

}  // namespace hrt
