// When a reach is over, by where its finger has been, whatever controls the plate.
#pragma once

#include "core/reach/finger_sample.h"
#include "core/tracker/still_finger.h"

namespace hrt {

/// The finger has come nine tenths of the way and has rested for 0.4 s, as StillFinger has it, or three
/// tenths of the way and for 2 s, within which it drifts by less than 2 mm/s. No heap, no lock, no exception.
class ReachEnd {
 public:
  ReachEnd() = default;
  /// Begins a reach from `start` to a target at `distance_mm` > 0.
  ReachEnd(const PlatePoint& start, double distance_mm) : start_(start), distance_mm_(distance_mm) {}

  void observe(const FingerSample& sample) {
    if (over_) return;
    if (sample.observation == Observation::lifted) finger_.restart();
    if (sample.observation == Observation::position) observe(sample.time_ns, sample.position);
  }
  bool over() const { return over_; }

 private:
  void observe(std::int64_t time_ns, const PlatePoint& place);

  PlatePoint start_;
  double distance_mm_ = 1.0;
  StillFinger finger_;
  bool rests_ = false;  // far enough from the start
  bool over_ = false;
};

}  // namespace hrt
