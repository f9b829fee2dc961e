#include "core/calibrate/steering_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/calibrate/slide_model.h"
#include "core/math/exponential.h"
#include "core/math/trigonometry.h"
#include "core/person/steering_delay.h"

namespace hrt {
namespace {

// Nearer to the target, as a share of the path, nobody turns after its place.
constexpr double min_place_share = 0.15;
// The finger rests at the ends of the path, and a turn of the plate there is not felt.
constexpr double end_share = 0.02;

}  // namespace

std::optional<TurningSlide> turning_slide(const CalibrationTrial& trial, const SlideTrack& track,
                                          double goal_direction_deg) {
  if (trial.plate_deg.size() != trial.samples.size() || trial.samples.empty()) return std::nullopt;
  TurningSlide slide{.track = track, .plate_deg = {}};
  double min_deg = std::numeric_limits<double>::infinity();
  double max_deg = -min_deg;
  std::size_t before = 0;
  for (std::size_t i = 0; i < track.steps.size(); ++i) {
    const std::int64_t time_ns =
        track.onset_ns + std::llround(1e9 * track.step_s * (static_cast<double>(i) + 0.5));
    while (before + 1 < trial.samples.size() && trial.samples[before + 1].time_ns <= time_ns) ++before;
    double plate_deg = trial.plate_deg[before];
    if (before + 1 < trial.samples.size() && time_ns > trial.samples[before].time_ns) {
      const double share =
          static_cast<double>(time_ns - trial.samples[before].time_ns) /
          static_cast<double>(trial.samples[before + 1].time_ns - trial.samples[before].time_ns);
      plate_deg += share * (trial.plate_deg[before + 1] - plate_deg);
    }
    slide.plate_deg.push_back(plate_deg - goal_direction_deg);
    if (track.steps[i].share < end_share || track.steps[i].share > 1.0 - end_share) continue;
    min_deg = std::min(min_deg, plate_deg);
    max_deg = std::max(max_deg, plate_deg);
  }
  if (!(max_deg - min_deg > min_turn_deg)) return std::nullopt;
  return slide;
}

Eigen::VectorXd predicted_left_m(const TurningSlide& slide, const std::vector<SlideBin>& bins,
                                 const IllusionCurve& curve, const Eigen::VectorXd& person, SteeringLaw law) {
  const SlideTrack& track = slide.track;
  const double gain = std::min(exponential(person(steering_log_rate)) * track.step_s, 1.0);
  // Directions are those of the steps' middles, so an answer is of half a step before the next one.
  SteeringDelay steering(std::min(person(steering_delay_s) / track.step_s - 0.5, SteeringDelay::max_steps));
  const bool predicts = law == SteeringLaw::predicted;
  double length_m = 0.0;
  for (const SlideTrack::Step& step : track.steps) length_m += step.advance_m;
  double felt_along_m = 0.0;
  double felt_left_m = 0.0;
  const double min_advance_m = SteeringDelay::min_felt_speed_m_s * track.step_s;
  Eigen::VectorXd left_m = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(bins.size()));
  double direction_deg = person(steering_start_deg);
  double here_m = 0.0;
  std::size_t bin = 0;
  for (std::size_t i = 0; i < track.steps.size() && bin < bins.size(); ++i) {
    const SlideTrack::Step& step = track.steps[i];
    const double across_m = step.advance_m * sin_deg(direction_deg) / cos_deg(direction_deg);
    if (i >= bins[bin].end) ++bin;
    if (bin < bins.size() && i >= bins[bin].begin && step.seen > 0.0)
      left_m(static_cast<Eigen::Index>(bin)) += step.seen / bins[bin].seen * (here_m + 0.5 * across_m);
    here_m += across_m;
    if (step.advance_m < min_advance_m) {
      steering.rest();
      continue;
    }
    const double shift_deg =
        person(steering_scale) * curve_shift_deg(curve, slide.plate_deg[i] - direction_deg);
    double goal_deg = person(steering_bias_deg) + person(steering_habit_deg) * (1.0 - 2.0 * step.share);
    if (law == SteeringLaw::place) {
      const double ahead_m = length_m - felt_along_m;
      if (ahead_m > min_place_share * length_m) goal_deg -= atan2_deg(felt_left_m, ahead_m);
      felt_along_m += step.advance_m;
      felt_left_m += rad_per_deg * step.advance_m * (direction_deg + shift_deg);
    }
    const auto answer = steering.feel(shift_deg + (predicts ? 0.0 : direction_deg));
    if (!answer) continue;
    // The own direction half a step ahead is the mean of this step's and the next one's.
    const double own = predicts ? 0.5 * gain * answer->share : 0.0;
    const double delayed_deg = answer->felt_deg + (predicts ? direction_deg : 0.0);
    direction_deg = std::clamp(direction_deg - gain * answer->share * (delayed_deg - goal_deg) / (1.0 + own),
                               -max_direction_deg, max_direction_deg);
  }
  return left_m;
}

}  // namespace hrt
