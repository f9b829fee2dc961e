#pragma once

#include <openxr/openxr.h>

#include <ctime>

#include <algorithm>

namespace hrt::mock {

/// Clock of the runtime, in nanoseconds. A manual clock advances in xrWaitFrame only, so that runs are fast and
/// repeatable. The real-time clock is CLOCK_MONOTONIC.
class Clock {
 public:
  enum class Kind { manual, real_time };

  explicit Clock(Kind kind) : kind_(kind) {}

  Kind kind() const { return kind_; }
  XrTime now() const {
    if (kind_ == Kind::manual) return manual_now_;
    std::timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<XrTime>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
  }

  /// Advances a manual clock to `time`; no effect for an earlier time.
  void advance_to(XrTime time) { manual_now_ = std::max(manual_now_, time); }

 private:
  Kind kind_;
  XrTime manual_now_ = 1'000'000'000;  // 1 s, because OpenXR does not allow the time 0
};

}  // namespace hrt::mock
