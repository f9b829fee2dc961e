// When a reach is over, by where its finger has been, whatever controls the plate.
#pragma once

#include <algorithm>
#include <iterator>

#include "core/reach/finger_sample.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

/// A reach is over once the finger rests at this share of the way, for this long.
struct ArrivalRule {
  double share;
  double rest_s;
};
/// People correct themselves within 0.3 s of a first motion's end, and pause for longer on the way.
inline constexpr ArrivalRule arrival_rules[] = {{0.9, 0.4}, {0.3, 2.0}};

/// No heap, no lock, no exception.
class ReachEnd {
 public:
  ReachEnd() = default;
  /// Begins a reach from `start` to a target at `distance_mm` > 0. `noise`: of the tracker, if it is known.
  ReachEnd(const PlatePoint& start, double distance_mm, const std::optional<TrackerNoise>& noise,
           const PhaseTuning& tuning = {})
      : start_(start), distance_mm_(distance_mm), finger_({}, noise, tuning) {}

  /// The target is elsewhere from now on.
  void retarget(const PlatePoint& start, double distance_mm) {
    start_ = start;
    distance_mm_ = distance_mm;
    over_ = false;
    finger_.lift();  // a rest at the former target does not count
  }

  void observe(const FingerSample& sample) {
    if (over_) return;
    if (sample.observation == Observation::lifted) finger_.lift();
    if (sample.observation != Observation::position) return;
    finger_.observe(sample.time_ns, sample.position);
    over_ = std::any_of(std::begin(arrival_rules), std::end(arrival_rules), [&](const ArrivalRule& rule) {
      return finger_.rest_s() >= rule.rest_s && distance_mm(start_, finger_.rest_place()) >= rule.share * distance_mm_;
    });
  }
  bool over() const { return over_; }

 private:
  PlatePoint start_;
  double distance_mm_ = 1.0;
  FingerPhase finger_;
  bool over_ = false;
};

}  // namespace hrt
