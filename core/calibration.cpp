#include "core/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/estimator.h"
#include "core/onset.h"
#include "core/perception.h"
#include "core/plate_limits.h"
#include "core/step_clock.h"

namespace hrt {
namespace {

constexpr double least_plate_span_deg = 40.0;
constexpr int least_plate_angles = 3;
// Twice the log-likelihood drops by this at the ends of a 95 % interval: chi-squared with one degree.
constexpr double likelihood_drop = 3.841458820694124;

// A position that the tracker made up counts for no more than this.
constexpr double most_surprise = 25.0;

// A slide with its motion found: samples from `moving` on are after the onset.
struct Slide {
  const CalibrationTrial* trial;
  std::size_t moving;
  std::int64_t start_ns;
  PlatePoint start;
};

// The 97.5 % point of Student's t, expanded about the normal's (Abramowitz and Stegun 26.7.5); to 0.003 from
// 8 degrees on.
double student_975(double degrees) {
  constexpr double z = normal_975;
  constexpr double z3 = z * z * z;
  constexpr double z5 = z3 * z * z;
  const double n = degrees;
  return z + (z3 + z) / (4.0 * n) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n);
}

std::optional<CalibrationRefusal> check(const std::vector<CalibrationTrial>& trials,
                                        const CalibrationConfig& config) {
  if (!std::isfinite(config.goal_direction_deg))
    return CalibrationRefusal{"the goal direction is not a finite number"};
  if (config.step_period_ns < 1'000'000 || config.step_period_ns > 10'000'000'000) {
    return CalibrationRefusal{"the step period is out of range; allowed: 1 ms to 10 s"};
  }
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const std::string name = "trial " + std::to_string(i + 1);
    if (!std::isfinite(trials[i].plate_orientation_deg)) {
      return CalibrationRefusal{name + ": the plate orientation is not a finite number"};
    }
    const auto& samples = trials[i].samples;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (!std::isfinite(samples[k].position.right_m) || !std::isfinite(samples[k].position.away_m)) {
        return CalibrationRefusal{name + ", sample " + std::to_string(k + 1) +
                                  ": the position is not finite"};
      }
      if (k > 0 && samples[k].time_ns <= samples[k - 1].time_ns) {
        return CalibrationRefusal{name + ", sample " + std::to_string(k + 1) + ": time does not increase"};
      }
    }
  }
  return std::nullopt;
}

// The standard deviation of a coordinate, from how each sample departs from the line through its neighbours.
double learn_noise_m(const CalibrationTrial& trial) {
  Estimator estimator({}, Participant{}, 0.0, {});
  for (const TimedPoint& sample : trial.samples)
    estimator.learn_tracker_noise(sample.time_ns, sample.position);
  return estimator.estimate().tracker_noise_m;
}

std::optional<Slide> find_slide(const CalibrationTrial& trial) {
  if (trial.samples.size() < 8) return std::nullopt;
  Onset onset;
  const double noise_m = learn_noise_m(trial);
  std::size_t i = 0;
  while (i < trial.samples.size() &&
         !onset.observe(trial.samples[i].time_ns, trial.samples[i].position, noise_m))
    ++i;
  if (i == trial.samples.size()) return std::nullopt;
  if (distance_m(onset.place(), trial.samples.back().position) < least_slide_m) return std::nullopt;
  while (i > 0 && trial.samples[i - 1].time_ns > onset.time_ns()) --i;
  return Slide{&trial, i, onset.time_ns(), onset.place()};
}

// The direction of the second half of the path, half by distance from the start: the line of total least
// squares, which uses every sample where a chord has two.
double second_half_direction_deg(const Slide& slide) {
  const auto& samples = slide.trial->samples;
  const double half_m = 0.5 * distance_m(slide.start, samples.back().position);
  std::size_t first = slide.moving;
  while (first + 2 < samples.size() && distance_m(slide.start, samples[first].position) < half_m) ++first;
  const auto count = static_cast<double>(samples.size() - first);
  PlatePoint mean;
  for (std::size_t i = first; i < samples.size(); ++i) {
    mean.right_m += samples[i].position.right_m / count;
    mean.away_m += samples[i].position.away_m / count;
  }
  double rr = 0.0;
  double ra = 0.0;
  double aa = 0.0;
  for (std::size_t i = first; i < samples.size(); ++i) {
    const double right_m = samples[i].position.right_m - mean.right_m;
    const double away_m = samples[i].position.away_m - mean.away_m;
    rr += right_m * right_m;
    ra += right_m * away_m;
    aa += away_m * away_m;
  }
  // The axis of the scatter, turned to where the finger went.
  const double axis = 0.5 * std::atan2(2.0 * ra, aa - rr);
  PlatePoint along{std::sin(axis), std::cos(axis)};
  const PlatePoint& end = samples.back().position;
  if (along.right_m * (end.right_m - slide.start.right_m) + along.away_m * (end.away_m - slide.start.away_m) <
      0.0) {
    along = {-along.right_m, -along.away_m};
  }
  return bearing_deg({}, along);
}

// Regression of the chords on the plate orientation: direction = intercept - slope T.
struct Line {
  double intercept_deg;
  double slope;
  double intercept_error_deg;  // half the 95 % interval
  double slope_error;
};

Line regress(const std::vector<Chord>& chords) {
  const auto n = static_cast<double>(chords.size());
  double mean_plate = 0.0;
  double mean_direction = 0.0;
  for (const Chord& chord : chords) {
    mean_plate += chord.plate_orientation_deg / n;
    mean_direction += chord.direction_deg / n;
  }
  double spread = 0.0;
  double product = 0.0;
  for (const Chord& chord : chords) {
    const double plate = chord.plate_orientation_deg - mean_plate;
    spread += plate * plate;
    product += plate * (chord.direction_deg - mean_direction);
  }
  const double slope = -product / spread;
  const double intercept = mean_direction + slope * mean_plate;
  double residuals = 0.0;
  for (const Chord& chord : chords) {
    const double residual = chord.direction_deg - (intercept - slope * chord.plate_orientation_deg);
    residuals += residual * residual;
  }
  const double variance = residuals / (n - 2.0);
  const double t = student_975(n - 2.0);
  return {intercept, slope, t * std::sqrt(variance * (1.0 / n + mean_plate * mean_plate / spread)),
          t * std::sqrt(variance / spread)};
}

// Below -1/2, where no w_T has such a slope, it continues as a straight line, so that an interval of slopes
// stays one of weights.
double weight_of_slope(double slope) {
  return slope / std::max(1.0 + slope, 0.5);
}

// The log-likelihood of a slide's positions under a participant, by the estimator's innovations.
double log_likelihood(const Slide& slide, const Participant& participant, double goal_deg, double noise_m,
                      std::int64_t period_ns) {
  Estimator estimator({.tracker_noise_m = noise_m}, participant, goal_deg, slide.start);
  GainWindow gains(participant, 1);
  double sum = 0.0;
  std::int64_t now_ns = slide.start_ns;
  const auto move_to = [&](std::int64_t until_ns) {
    estimator.move(static_cast<double>(elapsed_ns(now_ns, until_ns)) * 1e-9);
    now_ns = until_ns;
  };
  const double plate_deg = ridge_normal_deg(slide.trial->plate_orientation_deg, goal_deg);
  StepClock clock(period_ns);
  clock.start(slide.start_ns);
  for (std::size_t i = slide.moving; i < slide.trial->samples.size(); ++i) {
    const TimedPoint& sample = slide.trial->samples[i];
    clock.advance(sample.time_ns, [&](std::int64_t end_ns) {
      move_to(end_ns);
      const double gain = gains.data()[0];
      estimator.end_step(plate_deg, gain, step_variance_deg2(participant, gain));
      gains.advance();
    });
    move_to(sample.time_ns);
    estimator.observe_position(sample.position);
    sum -= 0.5 * (std::min(estimator.normalised_innovation(), most_surprise) +
                  std::log(estimator.innovation_determinant_mm4()));
  }
  return sum;
}

// Values from `least` to `most` in equal ratios.
template <std::size_t n>
std::array<double, n> ratios(double least, double most) {
  std::array<double, n> values{};
  for (std::size_t i = 0; i < n; ++i)
    values[i] = least * std::pow(most / least, static_cast<double>(i) / (n - 1));
  return values;
}

// The maximum of a profile likelihood over a grid of equal ratios, and its interval; ends of the grid that
// are no less likely than the interval allows leave the value unknown.
template <std::size_t n>
Interval profile_interval(const std::array<double, n>& values, const std::array<double, n>& likelihood) {
  const auto best =
      static_cast<std::size_t>(std::max_element(likelihood.begin(), likelihood.end()) - likelihood.begin());
  double peak = likelihood[best];
  double shift = 0.0;
  if (best > 0 && best + 1 < n) {
    // The parabola through the best point and its neighbours.
    const double below = likelihood[best - 1] - peak;
    const double above = likelihood[best + 1] - peak;
    shift = 0.5 * (below - above) / (below + above);
    peak -= 0.25 * (below - above) * shift;
  }
  const double ratio = values[1] / values[0];
  const double floor = peak - 0.5 * likelihood_drop;
  const auto crossing = [&](std::size_t inside, std::size_t outside) {
    const double share = (likelihood[inside] - floor) / (likelihood[inside] - likelihood[outside]);
    return values[inside] * std::pow(values[outside] / values[inside], share);
  };
  Interval interval{values[best] * std::pow(ratio, shift), values.front(), values.back(), true};
  std::size_t low = best;
  while (low > 0 && likelihood[low - 1] >= floor) --low;
  std::size_t high = best;
  while (high + 1 < n && likelihood[high + 1] >= floor) ++high;
  if (low > 0 && likelihood[low] >= floor) interval.lower = crossing(low, low - 1);
  if (high + 1 < n && likelihood[high] >= floor) interval.upper = crossing(high, high + 1);
  interval.known = low > 0 && high + 1 < n;
  if (interval.known && low == high) {
    // The peak is narrower than the grid: its ends are those of the parabola.
    const double curvature = likelihood[best] - 0.5 * (likelihood[best - 1] + likelihood[best + 1]);
    const double half = std::sqrt(0.5 * likelihood_drop / curvature);
    interval.lower = interval.value * std::pow(ratio, -half);
    interval.upper = interval.value * std::pow(ratio, half);
  }
  return interval;
}

// sigma_u^2 and sigma_h^2 show only in the dynamics: K depends on their ratio.
void fit_variances(const std::vector<Slide>& slides, const CalibrationConfig& config,
                   Calibration& calibration) {
  constexpr std::size_t n = 13;
  const auto motor = ratios<n>(0.05, 5.0);
  const auto sensory = ratios<n>(0.01, 3.0);
  std::array<double, n> by_motor;
  std::array<double, n> by_sensory;
  by_motor.fill(-std::numeric_limits<double>::infinity());
  by_sensory.fill(-std::numeric_limits<double>::infinity());
  const double goal_deg = config.goal_direction_deg + calibration.bias_deg.value;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const Participant participant{.tactile_weight = calibration.tactile_weight.value,
                                    .motor_variance_deg2 = motor[i],
                                    .sensory_variance_deg2 = sensory[k]};
      double sum = 0.0;
      for (const Slide& slide : slides) {
        sum += log_likelihood(slide, participant, goal_deg, calibration.tracker_noise_m.value,
                              config.step_period_ns);
      }
      by_motor[i] = std::max(by_motor[i], sum);
      by_sensory[k] = std::max(by_sensory[k], sum);
    }
  }
  calibration.motor_variance_deg2 = profile_interval(motor, by_motor);
  calibration.sensory_variance_deg2 = profile_interval(sensory, by_sensory);
}

Interval tracker_noise(const std::vector<Slide>& slides) {
  double variance_m2 = 0.0;
  double samples = 0.0;
  for (const Slide& slide : slides) {
    const double noise_m = learn_noise_m(*slide.trial);
    const auto count = static_cast<double>(slide.trial->samples.size());
    variance_m2 += count * noise_m * noise_m;
    samples += count;
  }
  const double noise_m = std::sqrt(variance_m2 / samples);
  // Two coordinates; neighbouring departures share samples, which is worth a factor of about two.
  const double error = normal_975 * noise_m / std::sqrt(2.0 * samples);
  return {noise_m, noise_m - error, noise_m + error, true};
}

std::string three_digits(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 4);
}

}  // namespace

std::variant<Calibration, CalibrationRefusal> calibrate(const std::vector<CalibrationTrial>& trials,
                                                        const CalibrationConfig& config) {
  if (auto refusal = check(trials, config)) return *refusal;
  std::vector<Slide> slides;
  Calibration calibration;
  std::vector<double> angles;
  for (const CalibrationTrial& trial : trials) {
    const auto slide = find_slide(trial);
    if (!slide) continue;
    slides.push_back(*slide);
    const double plate_deg = ridge_normal_deg(trial.plate_orientation_deg, config.goal_direction_deg);
    calibration.chords.push_back({plate_deg, second_half_direction_deg(*slide), 0.0});
    angles.push_back(plate_deg);
  }
  if (slides.size() < least_trials) {
    return CalibrationRefusal{std::to_string(slides.size()) + " of " + std::to_string(trials.size()) +
                              " trials have a slide of at least 30 mm; at least " +
                              std::to_string(least_trials) + " are needed"};
  }
  std::sort(angles.begin(), angles.end());
  const double span_deg = angles.back() - angles.front();
  angles.erase(std::unique(angles.begin(), angles.end(), [](double a, double b) { return b - a < 5.0; }),
               angles.end());
  if (static_cast<int>(angles.size()) < least_plate_angles || span_deg < least_plate_span_deg) {
    return CalibrationRefusal{
        "the plate stood at " + std::to_string(angles.size()) +
        " different angles; at least 3 that span 40 degrees are needed to separate w_T from a bias"};
  }

  const Line line = regress(calibration.chords);
  for (Chord& chord : calibration.chords)
    chord.fitted_deg = line.intercept_deg - line.slope * chord.plate_orientation_deg;
  calibration.tactile_weight = {weight_of_slope(line.slope), weight_of_slope(line.slope - line.slope_error),
                                weight_of_slope(line.slope + line.slope_error), true};
  const Interval& w = calibration.tactile_weight;
  if (!(w.lower > Estimator::least_tactile_weight && w.upper < Estimator::most_tactile_weight)) {
    return CalibrationRefusal{
        "w_T is " + three_digits(w.value) + " with a 95 % interval of " + three_digits(w.lower) + " to " +
        three_digits(w.upper) +
        "; within 0.02 to 0.48 is needed: more trials, or this hand does not feel the ridges"};
  }
  // At rest P = (G + bias - w T) / (1 - w): the intercept is the goal that the participant goes for.
  const double scale = 1.0 - w.value;
  const double bias_deg = line.intercept_deg * scale - config.goal_direction_deg;
  calibration.bias_deg = {bias_deg, bias_deg - line.intercept_error_deg * scale,
                          bias_deg + line.intercept_error_deg * scale, true};
  calibration.tracker_noise_m = tracker_noise(slides);
  fit_variances(slides, config, calibration);
  return calibration;
}

}  // namespace hrt
