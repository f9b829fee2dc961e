#include "core/calibrate/variance_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/calibrate/slide_onset.h"
#include "core/paper/estimator.h"
#include "core/paper/perception.h"
#include "core/paper/step_clock.h"
#include "core/plate/plate_limits.h"

namespace hrt {
namespace {

// A position that the tracker made up counts for no more than this.
constexpr double max_surprise = 25.0;

// A slide with its motion found: samples from `moving` on are after the onset.
struct Slide {
  const CalibrationTrial* trial;
  std::size_t moving;
  SlideOnset onset;
};

std::optional<Slide> find_slide(const CalibrationTrial& trial) {
  const std::optional<SlideOnset> onset = find_onset(trial.samples);
  if (!onset || distance_m(onset->place, trial.samples.back().position) < min_slide_m) return std::nullopt;
  const auto moving = std::find_if(trial.samples.begin(), trial.samples.end(),
                                   [&](const TimedPoint& sample) { return sample.time_ns > onset->time_ns; });
  return Slide{&trial, static_cast<std::size_t>(moving - trial.samples.begin()), *onset};
}

// The log-likelihood of a slide's positions under a participant, by the estimator's innovations.
double log_likelihood(const Slide& slide, const Participant& participant, double goal_deg, double noise_m,
                      std::int64_t period_ns) {
  Estimator estimator({.tracker_noise_m = noise_m}, participant, goal_deg, slide.onset.place);
  GainWindow gains(participant, 1);
  double sum = 0.0;
  std::int64_t now_ns = slide.onset.time_ns;
  const auto move_to = [&](std::int64_t until_ns) {
    estimator.move(elapsed_s(now_ns, until_ns));
    now_ns = until_ns;
  };
  const double plate_deg = ridge_normal_deg(slide.trial->plate_orientation_deg, goal_deg);
  StepClock clock(period_ns);
  clock.start(slide.onset.time_ns);
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
    sum -= 0.5 * (std::min(estimator.normalised_innovation(), max_surprise) +
                  std::log(estimator.innovation_determinant_mm4()));
  }
  return sum;
}

// Values from `least` to `most` in equal ratios.
template <std::size_t n>
std::array<double, n> ratios(double min, double max) {
  std::array<double, n> values{};
  for (std::size_t i = 0; i < n; ++i) values[i] = min * std::pow(max / min, static_cast<double>(i) / (n - 1));
  return values;
}

// The maximum of a profile likelihood over a grid of equal ratios, in the range of the grid.
template <std::size_t n>
Interval likeliest(const std::array<double, n>& values, const std::array<double, n>& likelihood) {
  const auto best =
      static_cast<std::size_t>(std::max_element(likelihood.begin(), likelihood.end()) - likelihood.begin());
  double shift = 0.0;
  if (best > 0 && best + 1 < n) {
    // The parabola through the best point and its neighbours.
    const double below = likelihood[best - 1] - likelihood[best];
    const double above = likelihood[best + 1] - likelihood[best];
    if (below + above < 0.0) shift = 0.5 * (below - above) / (below + above);
  }
  return {values[best] * std::pow(values[1] / values[0], shift), values.front(), values.back(), false};
}

}  // namespace

Variances fit_variances(std::span<const CalibrationTrial* const> trials, double goal_deg,
                        double tactile_weight, double tracker_noise_m, std::int64_t step_period_ns) {
  std::vector<Slide> slides;
  for (const CalibrationTrial* trial : trials)
    if (const auto slide = find_slide(*trial)) slides.push_back(*slide);
  constexpr std::size_t n = 13;
  const auto motor = ratios<n>(0.05, 5.0);
  const auto sensory = ratios<n>(0.01, 3.0);
  std::array<double, n> by_motor;
  std::array<double, n> by_sensory;
  by_motor.fill(-std::numeric_limits<double>::infinity());
  by_sensory.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const Participant participant{.tactile_weight = tactile_weight,
                                    .motor_variance_deg2 = motor[i],
                                    .sensory_variance_deg2 = sensory[k]};
      double sum = 0.0;
      for (const Slide& slide : slides)
        sum += log_likelihood(slide, participant, goal_deg, tracker_noise_m, step_period_ns);
      by_motor[i] = std::max(by_motor[i], sum);
      by_sensory[k] = std::max(by_sensory[k], sum);
    }
  }
  return {likeliest(motor, by_motor), likeliest(sensory, by_sensory)};
}

}  // namespace hrt
