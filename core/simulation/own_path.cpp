#include "core/simulation/own_path.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/math/elementary.h"
#include "core/simulation/minimum_jerk.h"

namespace hrt {
namespace {

// SDs of a0 to a3, deg: fits to the SD of the direction at s = .05, .2, .4, .6, .8, .95, with residuals of at most 0.5
// degrees. Data: 1683 reaches of 4 people, 72 pairs of person and target (README.md).
constexpr PathShape cell_sd_deg{8.1, 2.6, 7.3, 10.4};     // SD of the means of the 72 pairs
constexpr PathShape within_sd_deg{9.3, 5.9, 10.1, 18.2};  // SD of the reaches about the mean of their pair
// SD of the log of the wander's size between pairs: sqrt(ln(9.1 / 7.4)), from the RMS and the median of the recordings.
constexpr double log_size_sd = 0.455;

constexpr double peak_mean = 0.36, peak_sd = 0.09;
constexpr double second_part_share = 0.18, second_part_from = 0.6, first_part_until = 0.8;
constexpr double stop_share = 0.016, stop_fraction = 0.06;

double eighth_power(double x) {
  const double square = x * x;
  const double fourth = square * square;
  return fourth * fourth;
}

// Integral of (1 - x)^2 x^b from 0 to v.
double remaining(double v, double b) {
  if (v <= 0.0) return 0.0;
  const double power = exponential((b + 1.0) * logarithm(v));
  return power * (1.0 / (b + 1.0) + v * (-2.0 / (b + 2.0) + v / (b + 3.0)));
}

double first_part_of_path(double u, double b) {
  return 1.0 - remaining(1.0 - std::clamp(u, 0.0, 1.0), b) / remaining(1.0, b);
}

}  // namespace

OwnPath draw_own_path(double size, Draws& draws) {
  OwnPath path{.log_duration_sd = 0.15};
  const double within = exponential(log_size_sd * draws.normal() - log_size_sd * log_size_sd);
  for (std::size_t i = 0; i < path.mean_deg.size(); ++i) {
    path.mean_deg[i] = size * cell_sd_deg[i] * draws.normal();
    path.sd_deg[i] = size * within * within_sd_deg[i];
  }
  return path;
}

// The habit is the projection of the mean direction on 1 - 2 s. sd_deg[0] is set so that wander_sd_deg(), which counts
// a third of its square, returns the SD of the recordings about their mean.
OwnPath own_path_of(std::vector<RecordedReach> reaches) {
  constexpr std::size_t nodes = std::tuple_size_v<decltype(RecordedReach::direction_deg)>;
  const auto count = static_cast<double>(reaches.size());
  OwnPath path{.log_duration_sd = 0.15};
  double habit_deg = 0.0, variance_deg2 = 0.0, shape_square = 0.0;
  for (std::size_t i = 0; i < nodes; ++i) {
    double mean_deg = 0.0;
    for (const RecordedReach& reach : reaches) mean_deg += reach.direction_deg[i] / count;
    for (const RecordedReach& reach : reaches)
      variance_deg2 += square(reach.direction_deg[i] - mean_deg) / (count * nodes);
    const double shape = 1.0 - 2.0 * static_cast<double>(i) / (nodes - 1);
    habit_deg += shape * mean_deg;
    shape_square += square(shape);
  }
  path.mean_deg[0] = habit_deg / shape_square;
  path.sd_deg[0] = std::sqrt(3.0 * variance_deg2);
  path.recorded = std::make_shared<const std::vector<RecordedReach>>(std::move(reaches));
  return path;
}

double mean_habit_deg(const OwnPath& path) {
  return path.mean_deg[0] + 4.0 / 15.0 * (path.mean_deg[2] - path.mean_deg[3]);
}

double wander_sd_deg(const OwnPath& path) {
  constexpr PathShape square_means{1.0 / 3.0, 1.0 / 5.0, 1.0 / 17.0 - 1.0 / 81.0, 1.0 / 17.0 - 1.0 / 81.0};
  double variance_deg2 = 0.0;
  for (std::size_t i = 0; i < square_means.size(); ++i) variance_deg2 += square_means[i] * square(path.sd_deg[i]);
  return std::sqrt(variance_deg2);
}

PathShape draw_shape(const OwnPath& path, Draws& draws) {
  PathShape shape = path.mean_deg;
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (path.sd_deg[i] > 0.0) shape[i] += path.sd_deg[i] * draws.normal();
  return shape;
}

double own_direction_deg(const OwnPath& path, const PathShape& shape, double path_fraction) {
  const double s = std::clamp(path_fraction, 0.0, 1.0);
  const double whole_deg = shape[0] * (1.0 - 2.0 * s) + shape[1] * (1.0 - 6.0 * s * (1.0 - s)) +
                           shape[2] * (eighth_power(1.0 - s) - 1.0 / 9.0) + shape[3] * (eighth_power(s) - 1.0 / 9.0);
  return path.returns ? whole_deg : whole_deg * std::clamp((0.5 - s) / 0.1, 0.0, 1.0);
}

double RecordedPace::path_fraction(double fraction) const {
  double u = fraction;
  if (stop_at < 1.0) {
    const double clock = fraction * (1.0 + stop_fraction);
    u = clock <= stop_at ? clock : std::max(stop_at, clock - stop_fraction);
  }
  if (first_part >= 1.0) return first_part_of_path(u, late_power);
  return first_part * first_part_of_path(u / first_part_until, late_power) +
         (1.0 - first_part) * minimum_jerk((u - second_part_from) / (1.0 - second_part_from));
}

RecordedPace draw_pace(double log_duration_sd, Draws& draws) {
  RecordedPace pace;
  pace.time_scale = exponential(log_duration_sd * draws.normal());
  pace.late_power = 2.0 / std::clamp(peak_mean + peak_sd * draws.normal(), 0.2, 0.55) - 2.0;
  if (draws.uniform() < second_part_share) pace.first_part = 0.8 + 0.15 * draws.uniform();
  if (draws.uniform() < stop_share) {
    pace.stop_at = 0.3 + 0.4 * draws.uniform();
    pace.time_scale *= 1.0 + stop_fraction;
  }
  return pace;
}

}  // namespace hrt
