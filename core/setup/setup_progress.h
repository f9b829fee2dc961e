// Detects a set-up that does not progress and diagnoses it from its samples. Without a diagnosis, a mistake of the host
// looks to the user like a request that is repeated for ever.
#pragma once

#include <cstdint>
#include <optional>

#include "core/setup/setup_step.h"

namespace hrt {

/// Uses no heap, lock or exception.
class SetupProgress {
 public:
  /// Something was completed: counts from the next sample on.
  void restart() { *this = {}; }
  void observe(const SetupSample& sample);
  /// False means that observed() finds nothing yet. Times may be far apart, so their difference is unsigned.
  bool may_be_stuck() const {
    const auto passed_ns =
        static_cast<std::uint64_t>(now_ns_) - static_cast<std::uint64_t>(since_ns_.value_or(now_ns_));
    return samples_ >= many_samples || (samples_ >= min_samples && passed_ns >= patience_ns);
  }
  /// None within 20 s of samples. `place`: where the finger is to go, if its position on the plate is known.
  /// `commanded_deg`: if the plate is waited for.
  Observed observed(const std::optional<PlatePoint>& place, const std::optional<double>& commanded_deg) const;

 private:
  static constexpr std::uint64_t patience_ns = 20'000'000'000;
  static constexpr int min_samples = 100;  // otherwise the application paused
  // 11 s at 90 Hz.
  static constexpr int many_samples = 1000;

  std::optional<std::int64_t> since_ns_;
  std::int64_t now_ns_ = 0;
  int samples_ = 0;
  bool seen_ = false;                 // true once any sample had the finger
  bool touched_ = false;              // true once any sample was not above the plate
  std::optional<PlatePoint> finger_;  // last observed position
  std::optional<double> plate_deg_;   // last reported
};

}  // namespace hrt
