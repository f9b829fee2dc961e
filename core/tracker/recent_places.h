// The last positions of a finger, at no more than 250 Hz.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/plate/plate_frame.h"

namespace hrt {

/// A ring of positions. `Point` is PlatePoint, or Eigen::Vector3d for a tracked position off the plate. No heap, no
/// lock, no exception. One thread at a time.
template <class Point>
class RecentPlaces {
 public:
  static constexpr int capacity = 128;
  /// Positions that come faster than this are averaged: the finger moves by less than 2 mm meanwhile.
  static constexpr double min_spacing_s = 0.004;

  /// Returns false if the position was averaged into the last place, which is less than `min_spacing_s` before it.
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

  /// Number of stored places, from 0 to `capacity`.
  int count() const { return count_; }
  /// `back` of 0 is the last place; less than count().
  const Timed<Point>& operator[](int back) const { return places_[static_cast<unsigned>(last_ - back) % capacity]; }
  /// Mean of the last `places`, 1 to count().
  Point mean_of_last(int places) const {
    Point mean = (1.0 / places) * (*this)[0].position;
    for (int i = 1; i < places; ++i) mean = mean + (1.0 / places) * (*this)[i].position;
    return mean;
  }
  /// Forgets all places but the last one.
  void keep_last() { count_ = std::min(count_, 1); }

 private:
  std::array<Timed<Point>, capacity> places_{};
  int last_ = -1;
  int count_ = 0;
  int merged_ = 0;  // positions that make up the last place
};

}  // namespace hrt
