// Steps of the model, of a fixed period, in the caller's time.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/math/time.h"

namespace hrt {

/// Uses no heap, lock or exception.
class StepClock {
 public:
  explicit StepClock(std::int64_t period_ns) : period_ns_(period_ns) {}

  std::int64_t period_ns() const { return period_ns_; }
  bool started() const { return step_ >= 0; }
  /// Current step, counted from 0; -1 before start().
  std::int64_t step() const { return step_; }
  std::int64_t end_ns() const { return later_ns(start_ns_, period_ns_); }

  void start(std::int64_t time_ns) {
    start_ns_ = time_ns;
    step_ = 0;
  }

  /// Advances to `time_ns`. Calls `end_step(end_ns)` for each step that has ended, up to `max_catch_up_steps` times.
  /// Returns the number of the other ended steps, which are skipped.
  template <class EndStep>
  std::int64_t advance(std::int64_t time_ns, const EndStep& end_step) {
    const auto period_ns = static_cast<std::uint64_t>(period_ns_);
    const std::uint64_t ended = elapsed_ns(start_ns_, time_ns) / period_ns;
    for (std::uint64_t i = 0; i < std::min(ended, max_catch_up_steps); ++i) {
      start_ns_ += period_ns_;
      end_step(start_ns_);
      ++step_;
    }
    if (ended <= max_catch_up_steps) return 0;
    const std::uint64_t skipped = ended - max_catch_up_steps;
    wait(skipped * period_ns);
    step_ += static_cast<std::int64_t>(skipped);
    return static_cast<std::int64_t>(skipped);
  }

  /// Delays the end of the current step by `duration_ns`.
  void wait(std::uint64_t duration_ns) {
    start_ns_ = static_cast<std::int64_t>(static_cast<std::uint64_t>(start_ns_) + duration_ns);
  }

  /// Advances to the next step, without a clock.
  void count() { ++step_; }

  /// Maximum number of calls of end_step() in advance(). Without samples, the model has settled after 64 steps.
  static constexpr std::uint64_t max_catch_up_steps = 64;

 private:
  std::int64_t period_ns_;     // > 0
  std::int64_t start_ns_ = 0;  // start of the current step
  std::int64_t step_ = -1;
};

}  // namespace hrt
