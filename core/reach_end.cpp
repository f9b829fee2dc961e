#include "core/reach_end.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrt {
namespace {

constexpr double near_fraction = 0.25, min_near_mm = 15.0;
constexpr double near_covered = 0.9, near_rest_s = 0.4;
constexpr double missed_covered = 0.3, missed_rest_s = 2.0;
constexpr double min_square_cosine = 0.25;  // squared cosine of 60 degrees

}  // namespace

void ReachEnd::retarget(const PlatePoint& target, const PlatePoint& finger) {
  const bool jumps = distance_mm(target_, target) >= max_target_step_mm;
  target_ = target;
  progress_.arrived = missed_ = false;  // until the next sample
  if (!jumps) return;
  way_from_ = finger;
  retargeted_ = true;
  rest_from_s_ = now_s_;
}

void ReachEnd::observe(const FingerSample& sample, const FingerPhase& finger) {
  came_to_start_ = false;
  if (sample.observation == Observation::lifted) at_rest_ = false;
  if (sample.observation != Observation::position) return;
  now_s_ = finger.places()[0].time_s;
  const bool was_at_rest = std::exchange(at_rest_, finger.at_rest());
  if (start_is_felt_ && !finger.has_moved()) felt_offset_ = start_ - finger.rest_place();
  const bool is_there = is_at_start(on_plate(sample.position));
  if (!seen_) comes_from_elsewhere_ = !is_there;
  seen_ = true;
  was_at_start_ = was_at_start_ || is_there;
  if (!progress_.arrived && at_rest_) {
    judge_rest(finger);
    came_to_start_ = comes_from_elsewhere_ && finger.has_moved() && !was_at_rest && !retargeted_ &&
                     is_at_start(on_plate(finger.rest_place()));
  }
  const bool begun = was_at_start_ || finger.has_moved();
  const PlatePoint place = on_plate(finger.smoothed());
  const bool off_course =
      begun && distance_mm(way_from_, place) > missed_covered * distance_mm(way_from_, target_) && !is_on_course(place);
  progress_.off_target = missed_ || off_course;
  progress_.not_at_start = !begun;
}

// Compares the squared cosine of the angle between the path and the line to the target with its limit.
bool ReachEnd::is_on_course(const PlatePoint& place) const {
  const PlatePoint to_place = place - way_from_, to_target = target_ - way_from_;
  const double product = dot_mm2(to_place, to_target);
  return product >= 0.0 &&
         product * product >= min_square_cosine * dot_mm2(to_place, to_place) * dot_mm2(to_target, to_target);
}

void ReachEnd::judge_rest(const FingerPhase& finger) {
  if (!was_at_start_ && !finger.has_moved()) return;
  const PlatePoint place = on_plate(finger.rest_place());
  const double rest_s = std::min(finger.rest_s(), now_s_ - rest_from_s_);
  const double way_mm = distance_mm(way_from_, target_);
  const double covered_mm = distance_mm(way_from_, place);
  const bool is_near =
      distance_mm(place, target_) <= std::max(near_fraction * distance_mm(start_, target_), min_near_mm);
  const bool is_there = is_near && (covered_mm >= near_covered * way_mm || way_mm <= min_near_mm);
  const bool stays = rest_s >= missed_rest_s && covered_mm >= missed_covered * way_mm && is_on_course(place);
  progress_.arrived = stays || (is_there && rest_s >= near_rest_s);
  missed_ = progress_.arrived && !is_near;
}

}  // namespace hrt
