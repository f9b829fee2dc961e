// Positions as a tracker delivers them: detection of copies, and a buffer of the last positions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/math/time.h"
#include "core/plate/plate_frame.h"

namespace hrt {

/// Detects copies of a position. A tracker that is slower than its application delivers the same position in several
/// samples with new times; as measurements, copies would look like a finger that stops and jumps. If a tracker rounds
/// positions, a resting finger also gives equal positions. Therefore equal positions are copies for 50 ms only, the
/// longest period of a tracker of at least 20 Hz; after this time, they are measurements of a resting finger.
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

/// Ring buffer of positions, at most 250 per second. `Point`: PlatePoint, or Eigen::Vector3d for a tracked position off
/// the plate. Uses no heap, lock or exception. One thread at a time.
template <class Point>
class RecentPlaces {
 public:
  static constexpr int capacity = 128;
  /// Positions closer in time than this are averaged; a finger slower than 0.5 m/s moves by less than 2 mm meanwhile.
  static constexpr double min_spacing_s = 0.004;

  /// Adds a position, not earlier than the last one. Returns false if it was averaged with the last one.
  bool add(double time_s, const Point& position) {
    if (count_ > 0 && time_s - (*this)[0].time_s < min_spacing_s) {
      ++merged_;
      Point& last = places_[static_cast<std::size_t>(last_)].position;
      last = last + (1.0 / merged_) * (position - last);
      return false;
    }
    last_ = (last_ + 1) % capacity;
    places_[static_cast<std::size_t>(last_)] = {time_s, position};
    count_ = std::min(count_ + 1, capacity);
    merged_ = 1;
    return true;
  }

  int count() const { return count_; }
  /// Returns the last position for `back` = 0, the position before it for 1, and so on; `back` < count().
  const Timed<Point>& operator[](int back) const { return places_[static_cast<unsigned>(last_ - back) % capacity]; }
  /// Returns the mean of the last `places` positions, 1 to count().
  Point mean_of_last(int places) const {
    Point mean = (1.0 / places) * (*this)[0].position;
    for (int i = 1; i < places; ++i) mean = mean + (1.0 / places) * (*this)[i].position;
    return mean;
  }
  void keep_last() { count_ = std::min(count_, 1); }

 private:
  std::array<Timed<Point>, capacity> places_{};
  int last_ = -1;
  int count_ = 0;
  int merged_ = 0;  // number of positions that are averaged in the last one
};

}  // namespace hrt
