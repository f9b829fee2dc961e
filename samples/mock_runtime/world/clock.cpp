#include "samples/mock_runtime/world/clock.h"

#include <ctime>

#include <algorithm>

namespace hrt::mock {

XrTime Clock::now() const {
  if (kind_ == Kind::manual) return manual_now_;
  std::timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<XrTime>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

void Clock::advance_to(XrTime time) { manual_now_ = std::max(manual_now_, time); }

}  // namespace hrt::mock
