#include "core/setup/slide_watch.h"

#include <cmath>

#include "core/math/time.h"

namespace hrt {
namespace {

constexpr double rest_s = 0.5;
constexpr double arrival_s = 0.5;
constexpr double stop_s = 1.5;
constexpr double start_radius_mm = 15.0;
constexpr double near_start_mm = 25.0;  // limit for a single position, which has tracker noise
constexpr double leaving_mm = 10.0;     // distance from the rest at which a slide has begun
constexpr double max_bearing_deg = 60.0;
constexpr double behind_deg = 90.0;
constexpr double plate_tolerance_deg = 2.0;
constexpr double plate_limit_s = 5.0;
constexpr double stuck_s = 60.0;
constexpr double unreported_turn_s = 1.0;
constexpr double max_turn_within_deg = 5.0;
constexpr double max_lost_s = 0.5;
constexpr double max_lifted_s = 0.1;
constexpr double min_slide_s = 0.25;  // duration from leaving the rest, without the rest at the end
constexpr double max_slide_s = 8.0;

}  // namespace

void SlideWatch::begin(const PlatePoint& start, double distance_mm, double plate_orientation_deg) {
  start_ = start;
  distance_mm_ = distance_mm;
  plate_orientation_deg_ = plate_orientation_deg;
  failed_ = 0;
  wrong_way_deg_.reset();
  again(SetupProblem::none);
}

void SlideWatch::again(SetupProblem problem) {
  problem_ = problem;
  phase_ = Phase::plate_turns;
  plate_is_stuck_ = false;
  resting_ = false;
  asked_ns_.reset();
  left_ns_.reset();
  finger_.lift();
}

void SlideWatch::fail(SetupProblem problem) {
  ++failed_;
  wrong_way_deg_.reset();
  const double bearing = bearing_deg(rest_, finger_.smoothed());
  if (left_ns_ && std::abs(bearing) > behind_deg) wrong_way_deg_ = bearing;
  again(problem);
}

bool SlideWatch::plate_is_off(const SetupSample& sample, double tolerance_deg) const {
  const std::optional<double>& at_deg = sample.on_plate.plate_orientation_deg;
  return at_deg && std::abs(std::remainder(*at_deg - plate_orientation_deg_, 180.0)) > tolerance_deg;
}

bool SlideWatch::observe(const SetupSample& sample) {
  first_ = false;
  if (phase_ == Phase::plate_turns) await_plate(sample);
  if (phase_ == Phase::rest_at_start) return await_rest(sample);
  return phase_ == Phase::slide && follow(sample);
}

void SlideWatch::await_plate(const SetupSample& sample) {
  if (!asked_ns_) asked_ns_ = sample.time_ns;
  const double waited_s = elapsed_s(*asked_ns_, sample.time_ns);
  const bool reported = sample.on_plate.plate_orientation_deg.has_value();
  if (reported ? !plate_is_off(sample, plate_tolerance_deg) : waited_s >= unreported_turn_s)
    phase_ = Phase::rest_at_start;
  else if (reported && waited_s >= plate_limit_s)
    problem_ = SetupProblem::plate;
  plate_is_stuck_ = phase_ == Phase::plate_turns && reported && waited_s >= stuck_s;
}

bool SlideWatch::await_rest(const SetupSample& sample) {
  const PlatePoint& at = sample.on_plate.position;
  const bool seen = sample.on_plate.observation == Observation::position && !sample.off_plate;
  if (plate_is_off(sample, max_turn_within_deg)) {
    again(problem_);
    return false;
  }
  if (!seen || distance_mm(at, start_) > near_start_mm) {
    finger_.lift();
    resting_ = false;
    return false;
  }
  first_ = !resting_;
  resting_ = true;
  finger_.observe(sample.time_ns, at);
  if (finger_.rest_s() < rest_s || distance_mm(finger_.rest_place(), start_) > start_radius_mm) return true;
  rest_ = finger_.rest_place();
  phase_ = Phase::slide;
  seen_ns_ = sample.time_ns;
  problem_ = SetupProblem::none;
  return true;
}

bool SlideWatch::follow(const SetupSample& sample) {
  const bool seen = sample.on_plate.observation == Observation::position && !sample.off_plate;
  if (plate_is_off(sample, max_turn_within_deg)) {
    fail(SetupProblem::moved);
  } else if (!seen) {
    const bool lost = sample.on_plate.observation == Observation::none;
    if (elapsed_s(seen_ns_, sample.time_ns) <= (lost ? max_lost_s : max_lifted_s)) return false;
    // A finger that leaves before the slide is not a failed attempt.
    if (left_ns_)
      fail(lost ? SetupProblem::lost : SetupProblem::left_plate);
    else
      again(SetupProblem::none);
  } else {
    seen_ns_ = sample.time_ns;
    finger_.observe(sample.time_ns, sample.on_plate.position);
    come_to(sample.time_ns);
    return phase_ == Phase::slide || phase_ == Phase::done;
  }
  return false;
}

void SlideWatch::come_to(std::int64_t time_ns) {
  if (!left_ns_) {
    if (distance_mm(finger_.smoothed(), rest_) > leaving_mm) left_ns_ = time_ns;
    return;
  }
  const double moved_s = elapsed_s(*left_ns_, time_ns);
  if (moved_s > max_slide_s) return fail(SetupProblem::too_slow);
  if (finger_.rest_s() < arrival_s) return;
  const PlatePoint& end = finger_.rest_place();
  const bool ahead =
      distance_mm(end, rest_) >= 0.5 * distance_mm_ && std::abs(bearing_deg(rest_, end)) <= max_bearing_deg;
  if (!ahead) {
    if (finger_.rest_s() >= stop_s) fail(SetupProblem::stopped);
  } else if (moved_s - finger_.rest_s() < min_slide_s) {
    fail(SetupProblem::too_fast);
  } else {
    phase_ = Phase::done;
  }
}

}  // namespace hrt
