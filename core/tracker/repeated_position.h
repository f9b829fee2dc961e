// Detects copies of a position. A tracker that is slower than its application delivers the same position in several
// samples with new times; as measurements, copies would look like a finger that stops and jumps. If a tracker rounds
// positions, a resting finger also gives equal positions. Therefore equal positions are copies for 50 ms only, the
// longest period of a tracker of at least 20 Hz; after this time, they are measurements of a resting finger.
#pragma once

#include <cstdint>
#include <optional>

#include "core/math/time.h"

namespace hrt {

template <class Point>
class RepeatedPosition {
 public:
  /// Returns true if `position` equals the previous one exactly, less than 50 ms after the first of these equal
  /// positions. Times must not decrease.
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
