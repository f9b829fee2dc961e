#include "samples/plate/tool/step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrt::plate {
namespace {

constexpr double min_acceleration_deg_s2 = 300.0, max_acceleration_deg_s2 = 100'000.0;

// Output of a first-order filter whose input has a constant acceleration from time 0 on.
double filtered_deg(double time_s, double acceleration_deg_s2, double filter_s) {
  if (time_s <= 0.0) return 0.0;
  const double settling = 1.0 - std::exp(-time_s / std::max(filter_s, 1e-6));
  return acceleration_deg_s2 * (0.5 * time_s * time_s - filter_s * time_s + filter_s * filter_s * settling);
}

// Between these fractions of a step, the plate is assumed to have its full speed.
constexpr double ramp_begins = 0.3, ramp_ends = 0.65;

// Line through the samples between these fractions: its slope, and the time at which it crosses 0.
struct Ramp {
  double speed_deg_s;
  double start_s;
};
std::optional<Ramp> ramp_of(const Step& step) {
  double n = 0.0, t = 0.0, x = 0.0, tt = 0.0, tx = 0.0;
  for (const auto& [time_s, angle_deg] : step.samples) {
    if (angle_deg > ramp_ends * step.travel_deg) break;
    if (angle_deg < ramp_begins * step.travel_deg) continue;
    n += 1.0;
    t += time_s;
    x += angle_deg;
    tt += time_s * time_s;
    tx += time_s * angle_deg;
  }
  if (n < 4.0 || n * tt <= t * t) return std::nullopt;
  const double speed_deg_s = (n * tx - t * x) / (n * tt - t * t);
  if (speed_deg_s <= 0.0) return std::nullopt;
  return Ramp{speed_deg_s, (t - x / speed_deg_s) / n};
}

// Log likelihood of a step's onset and acceleration, for an unknown SD of the noise. The model is the filtered response
// to a constant acceleration minus the response to an equal one that starts when the plate has reached its full speed.
// The likelihood counts fewer than n samples, because the filter correlates successive samples.
double likelihood(const Step& step, const Ramp& ramp, double onset_s, double acceleration_deg_s2, double filter_s) {
  const double full_s = ramp.speed_deg_s / acceleration_deg_s2;
  double n = 0.0, squares = 0.0, last_s = 0.0;
  for (const auto& [sample_s, angle_deg] : step.samples) {
    if (angle_deg > ramp_ends * step.travel_deg) break;
    const double residual_deg = angle_deg - filtered_deg(sample_s - onset_s, acceleration_deg_s2, filter_s) +
                                filtered_deg(sample_s - onset_s - full_s, acceleration_deg_s2, filter_s);
    squares += residual_deg * residual_deg;
    n += 1.0;
    last_s = sample_s;
  }
  const double correlation = std::exp(-last_s / n / std::max(filter_s, 1e-6));
  return -0.5 * n * (1.0 - correlation) / (1.0 + correlation) * std::log(squares / n + 1e-6);
}

}  // namespace

Measured mean_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value;
  for (const double value : values) squares += (value - sum / n) * (value - sum / n);
  return {sum / n, std::sqrt(squares / (n - 1.0) / n)};
}

// The line through the ramp is delayed by the time constant of the filter and by half of the duration of the
// acceleration, so that only the acceleration is unknown. One acceleration is fitted to all steps, because few samples
// of a step depend on it. Acceleration and onset are means over all candidates of the acceleration, weighted by
// likelihood, so that the standard errors include the uncertainty of the acceleration.
std::optional<StepsFit> fit_steps(const std::vector<Step>& steps, double filter_s) {
  std::vector<Ramp> ramps;
  std::vector<double> starts_s, speeds_deg_s;
  for (const Step& step : steps) {
    const auto ramp = ramp_of(step);
    if (!ramp) return std::nullopt;
    ramps.push_back(*ramp);
    starts_s.push_back(ramp->start_s - filter_s);
    speeds_deg_s.push_back(ramp->speed_deg_s);
  }
  std::vector<std::pair<double, double>> candidates;  // acceleration, and its log likelihood
  double most = -1e300;
  for (double a = min_acceleration_deg_s2; a <= max_acceleration_deg_s2; a *= 1.03) {
    double found = 0.0;
    for (std::size_t i = 0; i < steps.size(); ++i)
      found += likelihood(steps[i], ramps[i], starts_s[i] - 0.5 * speeds_deg_s[i] / a, a, filter_s);
    candidates.emplace_back(a, found);
    most = std::max(most, found);
  }
  StepsFit fit{mean_of(starts_s), mean_of(speeds_deg_s), {}};
  const auto mean_by_likelihood = [&](auto number) -> Measured {
    double sum = 0.0, first = 0.0, second = 0.0;
    for (const auto& [a, found] : candidates) {
      const double weight = std::exp(found - most), value = number(a);
      sum += weight;
      first += weight * value;
      second += weight * value * value;
    }
    return {first / sum, std::sqrt(std::max(0.0, second / sum - first * first / (sum * sum)))};
  };
  fit.acceleration_deg_s2 = mean_by_likelihood([](double a) { return a; });
  const Measured late_s = mean_by_likelihood([&](double a) { return 0.5 * fit.speed_deg_s.value / a; });
  fit.onset_s.value -= late_s.value;
  fit.onset_s.deviation = std::hypot(fit.onset_s.deviation, late_s.deviation);
  return fit;
}

}  // namespace hrt::plate
