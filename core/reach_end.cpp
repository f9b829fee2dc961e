#include "core/reach_end.h"

#include <algorithm>
#include <cmath>

#include "core/math/trigonometry.h"

namespace hrt {
namespace {

constexpr double near_fraction = 0.25, min_near_mm = 15.0;
constexpr double near_covered = 0.9, near_rest_s = 0.4;
constexpr double missed_covered = 0.3, missed_rest_s = 2.0;
constexpr double max_off_course_deg = 60.0;

}  // namespace

ReachEnd::ReachEnd(const PlatePoint& start, const PlatePoint& target, bool start_is_felt,
                   const std::optional<TrackerNoise>& noise, const PhaseTuning& tuning)
    : start_(start), target_(target), way_from_(start), finger_({}, noise, tuning), start_is_felt_(start_is_felt) {}

void ReachEnd::retarget(const PlatePoint& target, const PlatePoint& finger) {
  const bool jumps = distance_mm(target_, target) >= max_target_step_mm;
  target_ = target;
  over_ = missed_ = false;  // until the next sample shows a finger that still rests there
  if (!jumps) return;
  way_from_ = finger;
  retargeted_ = true;
  finger_.lift();  // the time of the rest starts again
}

void ReachEnd::observe(const FingerSample& sample) {
  came_to_start_ = false;
  if (sample.observation == Observation::lifted) finger_.lift();
  if (sample.observation != Observation::position) return;
  const bool was_at_rest = finger_.at_rest();
  finger_.observe(sample.time_ns, sample.position);
  if (start_is_felt_ && !finger_.has_moved()) felt_offset_ = start_ - finger_.rest_place();
  const bool is_there = is_at_start(on_plate(sample.position));
  if (!seen_) comes_from_elsewhere_ = !is_there;
  seen_ = true;
  was_at_start_ = was_at_start_ || is_there;
  if (over_ || !finger_.at_rest()) return;
  judge_rest();
  came_to_start_ = comes_from_elsewhere_ && finger_.has_moved() && !was_at_rest && !retargeted_ &&
                   is_at_start(on_plate(finger_.rest_place()));
}

double ReachEnd::degrees_off_course(const PlatePoint& place) const {
  return std::abs(wrap_deg(bearing_deg(way_from_, place) - bearing_deg(way_from_, target_), 360.0));
}

void ReachEnd::judge_rest() {
  if (!was_at_start_ && !finger_.has_moved()) return;
  const PlatePoint place = on_plate(finger_.rest_place());
  const double way_mm = distance_mm(way_from_, target_);
  const double covered_mm = distance_mm(way_from_, place);
  const bool is_near =
      distance_mm(place, target_) <= std::max(near_fraction * distance_mm(start_, target_), min_near_mm);
  const bool is_there = is_near && (covered_mm >= near_covered * way_mm || way_mm <= min_near_mm);
  const bool stays = finger_.rest_s() >= missed_rest_s && covered_mm >= missed_covered * way_mm &&
                     degrees_off_course(place) <= max_off_course_deg;
  over_ = stays || (is_there && finger_.rest_s() >= near_rest_s);
  missed_ = over_ && !is_near;
}

ReachProgress ReachEnd::progress() const {
  if (!seen_) return {};
  const PlatePoint place = on_plate(finger_.smoothed());
  const bool begun = was_at_start_ || finger_.has_moved();
  const bool off_course = begun && distance_mm(way_from_, place) > missed_covered * distance_mm(way_from_, target_) &&
                          degrees_off_course(place) > max_off_course_deg;
  return {.arrived = over_, .off_target = missed_ || off_course, .not_at_start = !begun};
}

}  // namespace hrt
