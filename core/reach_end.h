// Detects the end of a reach, under either controller, from the positions of the finger.
//
// A finger is near the real target if it is within a quarter of the target's distance from the start, or within 15 mm
// if this is more. A reach can end once the finger has been at the start or has moved. The reach ends after a rest
//   of 0.4 s near the target, if the finger has covered nine tenths of the path or the path is at most 15 mm long
//   of 2 s   if the finger has covered three tenths of the path, at most 60 degrees off the direction of the target;
//            the reach has missed if the finger is not near the target
// The path begins at the start or, after a jump of the target, at the position of the finger at that time. Near the
// target, people begin a correction within 0.3 s of the end of a first motion; farther away, they may pause for longer.
#pragma once

#include "core/reach/finger_sample.h"
#include "core/reach/reach.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

/// A finger within this distance of the start is at the start.
inline constexpr double at_start_mm = 15.0;
/// A call of retarget() that moves the target by at least this distance is a jump: path and rest begin again.
inline constexpr double max_target_step_mm = 2.0;

/// Uses no heap, lock or exception.
class ReachEnd {
 public:
  ReachEnd() = default;
  /// Begins a reach from `start` to another point, `target`. `start_is_felt`: the first rest of the finger is at
  /// `start`, so tracked positions are shifted by `start` minus the tracked position of this rest.
  ReachEnd(const PlatePoint& start, const PlatePoint& target, bool start_is_felt)
      : start_(start), target_(target), way_from_(start), start_is_felt_(start_is_felt) {}

  void retarget(const PlatePoint& target, const PlatePoint& finger);

  /// Processes a sample. `finger`: the phase detector, which has already processed this sample.
  void observe(const FingerSample& sample, const FingerPhase& finger);
  const ReachProgress& progress() const { return progress_; }
  /// True if the finger was first tracked elsewhere, has moved, and came to rest at the start with the last sample.
  /// Retargeter then begins the reach again. False after a jump of the target.
  bool came_to_start() const { return came_to_start_; }

 private:
  PlatePoint on_plate(const PlatePoint& seen) const { return seen + felt_offset_; }
  bool is_at_start(const PlatePoint& place) const { return distance_mm(start_, place) <= at_start_mm; }
  bool is_on_course(const PlatePoint& place) const;
  void judge_rest(const FingerPhase& finger);

  PlatePoint start_;
  PlatePoint target_;
  PlatePoint way_from_;
  PlatePoint felt_offset_;  // start minus tracked position of the first rest; 0 unless start_is_felt_
  bool start_is_felt_ = false;
  bool seen_ = false;
  bool comes_from_elsewhere_ = false;
  bool was_at_start_ = false;
  bool retargeted_ = false;
  bool came_to_start_ = false;
  bool at_rest_ = false;
  double now_s_ = 0.0;        // time of the last position
  double rest_from_s_ = 0.0;  // a rest counts from this time on
  ReachProgress progress_;
  bool missed_ = false;
};

}  // namespace hrt
