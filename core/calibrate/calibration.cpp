#include "core/calibrate/calibration.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/math/decimal.h"
#include "core/paper/estimator.h"

namespace hrt {
namespace {

constexpr double min_plate_span_deg = 40.0;
constexpr int min_plate_angles = 3;
// If no slide on one side has a settled offset from motion to ridge normal this large, the largest gap is unknown.
constexpr double min_offset_deg = 60.0;
// Wider intervals are reported as unknown.
constexpr double max_weight_width = 0.1;
constexpr double max_angle_width_deg = 10.0;
constexpr int band_steps = 15;  // steps of 5 degrees to either side
// Additional SD of the largest gap, as a fraction of curve_bend_deg(): the curve may have a kink between two knots.
constexpr double peak_fraction = 0.25;
// Additional SD of the habit as a fraction of the habit: the goal direction need not change evenly over the path.
constexpr double uneven_fraction = 0.2;
// Excluded end of a rest, in which a slow start may look like noise.
constexpr double before_onset_s = 0.05;

// One point of the curve, or one rest, takes 0.02 ms on a core of 3 GHz.
constexpr int points_per_step = 16;
constexpr std::size_t rests_per_step = 8;

std::optional<CalibrationRefusal> check(const std::vector<CalibrationTrial>& trials, double goal_direction_deg) {
  if (!std::isfinite(goal_direction_deg))
    return CalibrationRefusal{"the goal direction is not a finite number. Give it in degrees"};
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const std::string name = "trial " + std::to_string(i + 1);
    if (!std::isfinite(trials[i].plate_orientation_deg)) {
      return CalibrationRefusal{name + ": the plate orientation is not a finite number. Correct or remove the trial"};
    }
    const auto& samples = trials[i].samples;
    if (!trials[i].plate_deg.empty() && trials[i].plate_deg.size() != samples.size())
      return CalibrationRefusal{name +
                                ": not every sample has the plate's orientation. Add it to each sample or to none"};
    for (const double plate_deg : trials[i].plate_deg)
      if (!std::isfinite(plate_deg))
        return CalibrationRefusal{name + ": a plate orientation is not finite. Correct or remove the trial"};
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (!std::isfinite(samples[k].position.right_mm) || !std::isfinite(samples[k].position.away_mm)) {
        return CalibrationRefusal{name + ", sample " + std::to_string(k + 1) +
                                  ": the position is not finite. Correct or remove the sample"};
      }
      if (!std::isfinite(samples[k].time_s) || (k > 0 && samples[k].time_s <= samples[k - 1].time_s)) {
        return CalibrationRefusal{name + ", sample " + std::to_string(k + 1) +
                                  ": the time is not finite or does not increase. Correct or remove the sample"};
      }
    }
  }
  return std::nullopt;
}

void describe_controllers_curve(const PersonFit& person, Calibration* calibration) {
  const auto slope = [](const SlidingPersonModel& p) { return controllers_curve(p.curve).weight; };
  const auto curve = [](const SlidingPersonModel& p) { return controllers_curve(p.curve).curve; };
  calibration->slope = person.value(slope);
  calibration->curve = person.value(curve);
  const double slope_sd = fit_value(person.fit, slope).deviation;
  const double curve_sd = fit_value(person.fit, curve).deviation;
  const double sum_sd = fit_value(person.fit, [&](const auto& p) { return slope(p) + curve(p); }).deviation;
  if (slope_sd * curve_sd > 0.0)
    calibration->slope_curve_correlation = std::clamp(
        (sum_sd * sum_sd - slope_sd * slope_sd - curve_sd * curve_sd) / (2.0 * slope_sd * curve_sd), -1.0, 1.0);
}

std::optional<CalibrationRefusal> check(const CalibrationSlides& slides, std::size_t trials) {
  const std::string needed = "; at least " + std::to_string(min_trials) + " are needed";
  if (slides.resting.size() < min_trials)
    return CalibrationRefusal{std::to_string(slides.resting.size()) + " of " + std::to_string(trials) +
                              " trials have a slide of at least 30 mm over a plate at rest" + needed +
                              ". Add slides, or repeat the others"};
  const std::vector<SlideVerdict> verdicts = slide_verdicts(slides.resting);
  std::vector<SlideTrack> counting;
  for (std::size_t i = 0; i < slides.resting.size(); ++i)
    if (verdicts[i] == SlideVerdict::used) counting.push_back(slides.resting[i]);
  if (counting.size() < min_trials)
    return CalibrationRefusal{std::to_string(counting.size()) + " of " + std::to_string(slides.resting.size()) +
                              " slides end in a direction that is not along the ridges" + needed +
                              ": use smaller plate angles"};
  const int angles = different_angles(counting);
  const auto [low, high] =
      std::minmax_element(counting.begin(), counting.end(),
                          [](const SlideTrack& a, const SlideTrack& b) { return a.plate_deg < b.plate_deg; });
  if (angles >= min_plate_angles && high->plate_deg - low->plate_deg >= min_plate_span_deg) return std::nullopt;
  return CalibrationRefusal{"different angles of the plate: " + std::to_string(angles) + ", over " +
                            decimal(high->plate_deg - low->plate_deg, 1) +
                            " degrees; needed: 3 that span 40 degrees. Add slides at other plate angles"};
}

void add_slide(const CalibrationTrial& trial, std::size_t index, double goal_direction_deg, CalibrationSlides* slides) {
  std::optional<SlideTrack> track = track_slide(trial, goal_direction_deg);
  if (!track) return;
  if (plate_turned(trial, *track)) {
    ++slides->turned;
    return;
  }
  slides->resting.push_back(*std::move(track));
  slides->order.push_back(static_cast<double>(index));
}

std::vector<TimedPoint> rest_of(const CalibrationTrial& trial, const SlideTrack& track) {
  std::vector<TimedPoint> samples = measurements_of(trial.samples);
  std::erase_if(samples, [&](const TimedPoint& p) { return p.time_s > track.onset_s - before_onset_s; });
  return samples;
}

void widen(double half, Interval* interval) {
  interval->lower = interval->value - in_quadrature(interval->value - interval->lower, half);
  interval->upper = interval->value + in_quadrature(interval->upper - interval->value, half);
}

Calibration described(const PersonFit& person) {
  Calibration calibration;
  calibration.lack_of_fit = person.lack_of_fit;
  calibration.tactile_weight = person.value([](const auto& p) { return curve_weight(p.curve); });
  calibration.bias_deg = person.value([](const auto& p) { return p.bias_deg; });
  calibration.habit_deg = person.value([](const auto& p) { return p.habit_deg; });
  widen(normal_975 * uneven_fraction * std::abs(calibration.habit_deg.value), &calibration.habit_deg);
  const CurvePeak peak = weaker_peak(person.fit.person.curve);
  calibration.max_gap_deg = person.value([](const auto& p) { return weaker_peak(p.curve).shift_deg; });
  widen(normal_975 * peak_fraction * curve_bend_deg(person.fit.person.curve, peak.offset_deg),
        &calibration.max_gap_deg);
  calibration.peak_offset_deg = peak.offset_deg;
  describe_controllers_curve(person, &calibration);

  const bool fits = calibration.fits();
  const bool reaches = std::min(person.max_left_deg, person.max_right_deg) >= min_offset_deg;
  const auto is_within = [](const Interval& interval, double width) {
    return interval.upper - interval.lower <= width;
  };
  calibration.tactile_weight.known = fits && is_within(calibration.tactile_weight, max_weight_width);
  calibration.slope.known = fits;
  calibration.bias_deg.known = fits && is_within(calibration.bias_deg, max_angle_width_deg);
  calibration.habit_deg.known = fits && is_within(calibration.habit_deg, max_angle_width_deg);
  calibration.curve.known = fits;
  calibration.max_gap_deg.known = fits && reaches && is_within(calibration.max_gap_deg, max_angle_width_deg);
  return calibration;
}

}  // namespace

bool Calibration::fits() const {
  return std::min({lack_of_fit.angle_p, lack_of_fit.order_p, lack_of_fit.path_p}) >= min_fit_p;
}

std::size_t Calibration::count(SlideVerdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(slides.begin(), slides.end(), [&](const CalibratedSlide& s) { return s.verdict == verdict; }));
}

std::vector<std::string> Calibration::advice() const {
  std::vector<std::string> sentences;
  if (lack_of_fit.angle_p < min_fit_p)
    sentences.emplace_back(
        "no illusion curve fits the directions: check the plate's orientations and the target's direction, and repeat");
  if (lack_of_fit.order_p < min_fit_p)
    sentences.emplace_back(
        "the person changed from the first slide to the last: let them practise, or rest, and "
        "repeat the calibration");
  if (lack_of_fit.path_p < min_fit_p)
    sentences.emplace_back(
        "neither a habit nor the steering law explains how the paths bend: repeat with even, slower, longer motions");
  if (fits() && !max_gap_deg.known)
    sentences.emplace_back(
        "the largest gap is uncertain: add slides on both sides, with plate angles farther from the target");
  if (slides_turned > 0)
    sentences.emplace_back("slides in which the plate turned were excluded: keep the plate still during slides");
  if (5 * count(SlideVerdict::outlying) > slides.size())
    sentences.emplace_back("more than a fifth of the slides are outliers: check the tracker and repeat");
  return sentences;
}

CalibrationFit::CalibrationFit(std::vector<CalibrationTrial> trials, double goal_direction_deg)
    : trials_(std::move(trials)), goal_direction_deg_(goal_direction_deg) {}

bool CalibrationFit::step() {
  if (noise_) {
    if (!noise_->step()) return false;
    std::get<Calibration>(result_).noise = noise_->noise();
    return true;
  }
  if (rests_) {
    add_details();
    return false;
  }
  if (person_) return person_->step() && !describe();
  return !begin();
}

bool CalibrationFit::refuse(std::string reason) {
  result_ = CalibrationRefusal{std::move(reason)};
  return false;
}

// Reduces one slide; after the last one, selects the slides to fit. Returns false if the calibration is rejected.
bool CalibrationFit::begin() {
  if (next_trial_ == 0)
    if (auto refusal = check(trials_, goal_direction_deg_)) return refuse(refusal->reason);
  if (next_trial_ < trials_.size()) {
    add_slide(trials_[next_trial_], next_trial_, goal_direction_deg_, &slides_);
    ++next_trial_;
    return true;
  }
  if (auto refusal = check(slides_, trials_.size())) return refuse(refusal->reason);
  person_.emplace(slides_.resting, slides_.order);
  const std::size_t used = person_->result().used.size();
  return used >= static_cast<std::size_t>(min_fitted_slides) ||
         refuse(std::to_string(used) + " of " + std::to_string(slides_.resting.size()) +
                " slides are not outliers; at least " + std::to_string(min_fitted_slides) +
                " are needed: check the tracker");
}

// Returns false if the calibration is rejected.
bool CalibrationFit::describe() {
  Calibration calibration = described(person_->result());
  const Interval& w = calibration.tactile_weight;
  if (!(w.lower > Estimator::min_tactile_weight && w.upper < Estimator::max_tactile_weight))
    return refuse("the tactile weight is between " + decimal(w.lower, 3) + " and " + decimal(w.upper, 3) +
                  "; allowed: 0.02 to 0.48. Check that the finger feels the ridges");
  calibration.slides_turned = slides_.turned;
  result_ = std::move(calibration);
  rests_.emplace();
  return true;
}

// Adds the next points of the curve or, after the last point, the next slides. After the last slide, begins the fit of
// the tracker noise.
void CalibrationFit::add_details() {
  auto& calibration = std::get<Calibration>(result_);
  if (const int added = static_cast<int>(calibration.band.size()); added <= 2 * band_steps) {
    for (int i = added; i < std::min(added + points_per_step, 2 * band_steps + 1); ++i) {
      const double offset_deg = curve_bound_deg * (i - band_steps) / band_steps;
      calibration.band.push_back(
          {offset_deg, person_->result().value([&](const auto& p) { return curve_shift_deg(p.curve, offset_deg); })});
    }
    return;
  }
  const std::size_t first = calibration.slides.size();
  if (first == slides_.resting.size()) {
    noise_.emplace(*rests_);
    return;
  }
  for (std::size_t i = first; i < std::min(first + rests_per_step, slides_.resting.size()); ++i) {
    const SlideTrack& track = slides_.resting[i];
    const auto trial = static_cast<std::size_t>(slides_.order[i]);
    const SlideVerdict verdict = person_->result().verdicts[i];
    calibration.slides.push_back({.trial = trial,
                                  .plate_deg = track.plate_deg,
                                  .parts_deg = track.direction_deg,
                                  .fitted_deg = predicted_directions(track, person_->result().fit.person),
                                  .verdict = verdict});
    if (verdict != SlideVerdict::used) continue;
    rests_->push_back(rest_of(trials_[trial], track));
    calibration.max_plate_deg = std::max(calibration.max_plate_deg, std::abs(track.plate_deg));
  }
}

std::variant<Calibration, CalibrationRefusal> calibrate(const std::vector<CalibrationTrial>& trials,
                                                        double goal_direction_deg) {
  CalibrationFit fit(trials, goal_direction_deg);
  while (!fit.step()) {
  }
  return fit.result();
}

}  // namespace hrt
