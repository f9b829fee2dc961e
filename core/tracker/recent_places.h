// The last positions of a finger, at no more than 250 Hz.
#pragma once

#include <array>
#include <cstddef>

#include "core/plate/plate_frame.h"

namespace hrt {

/// No heap, no lock, no exception. One thread at a time.
class RecentPlaces {
 public:
  static constexpr int capacity = 128;

  /// False if the position was averaged into the last place, which is less than 4 ms before it.
  bool add(double time_s, const PlatePoint& position);

  /// The last position was.
  bool merged() const { return merged_ > 1; }

  /// From 0 to `capacity`.
  int count() const { return count_; }
  /// `back` of 0 is the last one; less than count().
  const TimedPoint& operator[](int back) const {
    return places_[static_cast<std::size_t>((last_ + capacity - back) % capacity)];
  }
  /// Of the last `places`, 1 to count().
  PlatePoint mean_of_last(int places) const;
  /// All but the last one are void.
  void keep_last() { count_ = 1; }

 private:
  std::array<TimedPoint, capacity> places_{};
  int last_ = -1;
  int count_ = 0;
  int merged_ = 0;  // positions that make up the last place
};

}  // namespace hrt
