#include "samples/plate/tool/step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrt::plate {
namespace {

constexpr double min_acceleration_deg_s2 = 300.0, max_acceleration_deg_s2 = 100'000.0;

// What a filter of first order shows of an even acceleration from time 0 on.
double shown_of(double time_s, double acceleration_deg_s2, double filter_s) {
  if (time_s <= 0.0) return 0.0;
  const double settling = 1.0 - std::exp(-time_s / std::max(filter_s, 1e-6));
  return acceleration_deg_s2 * (0.5 * time_s * time_s - filter_s * time_s + filter_s * filter_s * settling);
}

// The part of a step in which it has its full speed.
constexpr double ramp_begins = 0.35, ramp_ends = 0.65;

// The line through the samples there: its speed, and where it meets 0.
struct Ramp {
  double speed_deg_s;
  double start_s;
};
std::optional<Ramp> ramp_of(const std::vector<StepSample>& samples, double way_deg) {
  double n = 0.0, t = 0.0, x = 0.0, tt = 0.0, tx = 0.0;
  for (const auto& [time_s, part_deg] : samples) {
    if (part_deg > ramp_ends * way_deg) break;
    if (part_deg < ramp_begins * way_deg) continue;
    n += 1.0;
    t += time_s;
    x += part_deg;
    tt += time_s * time_s;
    tx += time_s * part_deg;
  }
  if (n < 4.0 || n * tt <= t * t) return std::nullopt;
  const double speed_deg_s = (n * tx - t * x) / (n * tt - t * t);
  if (speed_deg_s <= 0.0) return std::nullopt;
  return Ramp{speed_deg_s, (t - x / speed_deg_s) / n};
}

// Squares between the samples and the filtered motion: an acceleration, and one that ends it at full speed.
double misfit(const std::vector<StepSample>& samples, double way_deg, double filter_s, const StepFit& fit) {
  const double full_s = fit.speed_deg_s / fit.acceleration_deg_s2;
  double squares = 0.0;
  for (const auto& [sample_s, part_deg] : samples) {
    if (part_deg > ramp_ends * way_deg) break;
    const double time_s = sample_s - fit.onset_s;
    const double off_deg = part_deg - shown_of(time_s, fit.acceleration_deg_s2, filter_s) +
                           shown_of(time_s - full_s, fit.acceleration_deg_s2, filter_s);
    squares += off_deg * off_deg;
  }
  return squares;
}

}  // namespace

// On a ramp a filter is late by its time constant, and an acceleration by half of the time that it takes: the
// line leaves the acceleration alone to be found.
std::optional<StepFit> fit_step(const std::vector<StepSample>& samples, double way_deg, double filter_s) {
  const auto ramp = ramp_of(samples, way_deg);
  if (!ramp) return std::nullopt;
  StepFit best{};
  double least = std::numeric_limits<double>::infinity();
  for (double a = min_acceleration_deg_s2; a <= max_acceleration_deg_s2; a *= 1.03) {
    const StepFit fit{ramp->start_s - filter_s - 0.5 * ramp->speed_deg_s / a, ramp->speed_deg_s, a};
    const double squares = misfit(samples, way_deg, filter_s, fit);
    if (squares >= least) continue;
    least = squares;
    best = fit;
  }
  return best;
}

}  // namespace hrt::plate
