// A tracker that is slower than its application delivers the same position in several samples, with new times. A copy
// is no measurement: taken as one, it is a finger that stops and jumps. A finger that rests on a tracker that rounds
// its positions gives the same position too; after 50 ms, which trackers of 20 Hz and more do not exceed, it rests.
#pragma once

#include <cstdint>
#include <optional>

#include "core/math/time.h"

namespace hrt {

template <class Point>
class RepeatedPosition {
 public:
  /// True if `position` equals the last measurement in all its numbers, less than 50 ms later. Times do not decrease.
  bool is_copy(std::int64_t time_ns, const Point& position) {
    if (last_ && last_->position == position) return elapsed_ns(last_->time_ns, time_ns) < max_copy_ns;
    last_ = {time_ns, position};
    return false;
  }

 private:
  static constexpr std::uint64_t max_copy_ns = 50'000'000;
  struct Measurement {
    std::int64_t time_ns;
    Point position;
  };
  std::optional<Measurement> last_;
};

}  // namespace hrt
