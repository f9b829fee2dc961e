#include "core/setup/slide_watch.h"

#include <cmath>

#include "core/math/time.h"

namespace hrt {
namespace {

constexpr int rest_tenths = 5;
constexpr int arrival_tenths = 5;
constexpr int stop_tenths = 15;
constexpr double start_radius_mm = 15.0;
constexpr double near_start_mm = 25.0;  // of a single position, with the tracker's noise
// A finger this far from where it rested has left; so has one of so many positions in a row, not one wild
// one.
constexpr double leaving_mm = 10.0;
constexpr int leaving_samples = 3;
constexpr double max_bearing_deg = 60.0;
constexpr double plate_tolerance_deg = 2.0;
constexpr double plate_limit_s = 5.0;
constexpr double unreported_turn_s = 1.0;
constexpr double max_turn_within_deg = 5.0;
constexpr double max_lost_s = 0.5;
constexpr double max_lifted_s = 0.1;
constexpr double min_slide_s = 0.25;  // from where it has left, without the rest in the end
constexpr double max_slide_s = 8.0;
constexpr double tenth_s = 0.1;

// In the plane of the plate.
Eigen::Vector3d to_vector(const PlatePoint& point) { return {point.right_mm, 0.0, -point.away_mm}; }

}  // namespace

void SlideWatch::begin(const PlatePoint& start, double distance_mm, double plate_orientation_deg) {
  start_ = start;
  distance_mm_ = distance_mm;
  plate_orientation_deg_ = plate_orientation_deg;
  again(SetupProblem::none);
}

void SlideWatch::again(SetupProblem problem) {
  problem_ = problem;
  phase_ = Phase::plate_turns;
  resting_ = false;
  asked_ns_.reset();
  left_ns_.reset();
  still_.restart();
  beyond_ = 0;
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
}

bool SlideWatch::await_rest(const SetupSample& sample) {
  const PlatePoint& at = sample.on_plate.position;
  const bool seen = sample.on_plate.observation == Observation::position && !sample.off_plate;
  if (plate_is_off(sample, max_turn_within_deg)) {
    again(problem_);
    return false;
  }
  if (!seen || distance_mm(at, start_) > near_start_mm) {
    still_.restart();
    resting_ = false;
    return false;
  }
  first_ = !resting_;
  resting_ = true;
  still_.observe(sample.time_ns, to_vector(at));
  if (const auto rest_mm = still_.rest(rest_tenths)) {
    rest_ = {rest_mm->x(), -rest_mm->z()};
    if (distance_mm(rest_, start_) > start_radius_mm) return true;
    phase_ = Phase::slide;
    seen_ns_ = sample.time_ns;
    problem_ = SetupProblem::none;
  }
  return true;
}

bool SlideWatch::follow(const SetupSample& sample) {
  const bool seen = sample.on_plate.observation == Observation::position && !sample.off_plate;
  if (plate_is_off(sample, max_turn_within_deg)) {
    again(SetupProblem::moved);
  } else if (!seen) {
    const bool lost = sample.on_plate.observation == Observation::none;
    if (elapsed_s(seen_ns_, sample.time_ns) <= (lost ? max_lost_s : max_lifted_s)) return false;
    // A finger that goes before it has slid is no failure: it may come again.
    const bool began = left_ns_.has_value();
    again(!began ? SetupProblem::none : lost ? SetupProblem::lost : SetupProblem::left_plate);
  } else {
    seen_ns_ = sample.time_ns;
    still_.observe(sample.time_ns, to_vector(sample.on_plate.position));
    come_to(sample.on_plate.position, sample.time_ns);
    return phase_ == Phase::slide || phase_ == Phase::done;
  }
  return false;
}

void SlideWatch::come_to(const PlatePoint& place, std::int64_t time_ns) {
  if (!left_ns_) {
    beyond_ = distance_mm(place, rest_) > leaving_mm ? beyond_ + 1 : 0;
    if (beyond_ == leaving_samples) left_ns_ = time_ns;
    return;
  }
  const double moved_s = elapsed_s(*left_ns_, time_ns);
  if (moved_s > max_slide_s) return again(SetupProblem::too_slow);
  const auto arrived_mm = still_.rest(arrival_tenths);
  if (!arrived_mm) return;
  const PlatePoint end{arrived_mm->x(), -arrived_mm->z()};
  const bool ahead =
      distance_mm(end, rest_) >= 0.5 * distance_mm_ && std::abs(bearing_deg(rest_, end)) <= max_bearing_deg;
  if (!ahead) {
    if (still_.rest(stop_tenths)) again(SetupProblem::stopped);
  } else if (moved_s - arrival_tenths * tenth_s < min_slide_s) {
    again(SetupProblem::too_fast);
  } else {
    phase_ = Phase::done;
  }
}

}  // namespace hrt
