// The time of the runtime: XrTime counts nanoseconds, like CLOCK_MONOTONIC.
#pragma once

#include <openxr/openxr.h>

#include <cstdint>

namespace hrt::mock {

/// A manual clock advances only in xrWaitFrame and xrAdvanceTimeHRTX: runs are fast and repeat exactly. A
/// real-time clock is CLOCK_MONOTONIC.
class Clock {
 public:
  enum class Kind { manual, real_time };

  explicit Clock(Kind kind) : kind_(kind) {}

  Kind kind() const { return kind_; }
  void set_kind(Kind kind) { kind_ = kind; }
  XrTime now() const;

  /// Advances a manual clock to `time`; an earlier one does nothing.
  void advance_to(XrTime time);

 private:
  Kind kind_;
  XrTime manual_now_ = 1'000'000'000;  // 0 and below are no valid times
};

}  // namespace hrt::mock
