#include "core/tracker/tracker_latency.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/math/trigonometry.h"

namespace hrt {
namespace {

constexpr double grid_s = 0.005;
// Of the grid, to 0.02 ms.
constexpr int latency_halvings = 8;
// Over which the change with the latency is taken.
constexpr double stride_s = 0.005;
// Noise of trackers is correlated over less.
constexpr double noise_memory_s = 0.8;
constexpr double max_memory_samples = 400.0;
// Latencies that are this far apart are different answers; this many variances make one clearly worse.
constexpr double apart_s = 0.05;
constexpr double clearly_worse = 100.0;
constexpr double min_duration_s = 2.0;
constexpr int min_pairs = 50;
constexpr double min_radius_m = 0.02;
constexpr double max_residual_share = 0.1;
constexpr double max_width_s = 0.04;
constexpr double normal_quantile = 1.96;
constexpr double unknowns = 10.0;
// Turns that differ by less than this leave the circle unknown.
constexpr double min_pivot = 1e-6;

using Samples = std::span<const CarriedSample>;
using Three = Eigen::Matrix3d;

// The plate's orientation between its reports.
class PlateReports {
 public:
  explicit PlateReports(Samples samples) : samples_(samples) {}

  // Later at each call.
  double at_deg(double time_s) {
    while (next_ + 1 < samples_.size() && samples_[next_ + 1].time_s < time_s) ++next_;
    const CarriedSample& before = samples_[next_];
    const CarriedSample& after = samples_[std::min(next_ + 1, samples_.size() - 1)];
    const double gap_s = after.time_s - before.time_s;
    if (time_s <= before.time_s || gap_s <= 0.0) return before.plate_orientation_deg;
    const double share = std::min(1.0, (time_s - before.time_s) / gap_s);
    return before.plate_orientation_deg +
           share * wrap_deg(after.plate_orientation_deg - before.plate_orientation_deg, 360.0);
  }

 private:
  Samples samples_;
  std::size_t next_ = 0;
};

// The best circle for a latency. Of all samples but the first 0.5 s, whatever the latency.
struct Circle {
  double square_sum_m2;
  double count;
  double radius_m;
  Three coefficients;  // of 1, cos and sin
};

Eigen::Vector3d regressors(double orientation_deg) { return {1.0, cos_deg(orientation_deg), sin_deg(orientation_deg)}; }

template <class Body>
void for_each(Samples samples, double latency_s, Body&& body) {
  PlateReports reports(samples);
  for (const CarriedSample& sample : samples) {
    if (sample.time_s - samples.front().time_s < max_latency_s) continue;
    if (samples.back().time_s - sample.time_s < -min_latency_s) break;
    body(sample, regressors(reports.at_deg(sample.time_s - latency_s)));
  }
}

std::optional<Circle> fit_circle(Samples samples, double latency_s) {
  Three information = Three::Zero();
  Three moment = Three::Zero();
  double square_sum_m2 = 0.0;
  double count = 0.0;
  const Eigen::Vector3d about_m = samples.front().finger_m;  // for accuracy
  for_each(samples, latency_s, [&](const CarriedSample& sample, const Eigen::Vector3d& by) {
    information += by * by.transpose();
    moment += by * (sample.finger_m - about_m).transpose();
    square_sum_m2 += (sample.finger_m - about_m).squaredNorm();
    count += 1.0;
  });
  const Eigen::LDLT<Three> solver(information);
  if (!(solver.vectorD().minCoeff() > min_pivot * count)) return std::nullopt;
  Circle circle{.square_sum_m2 = 0.0, .count = count, .radius_m = 0.0, .coefficients = solver.solve(moment)};
  circle.square_sum_m2 = std::max(0.0, square_sum_m2 - circle.coefficients.cwiseProduct(moment).sum());
  circle.radius_m = std::sqrt(0.5 * circle.coefficients.bottomRows<2>().squaredNorm());
  return circle;
}

std::vector<Eigen::Vector3d> residuals_m(Samples samples, double latency_s, const Circle& circle) {
  const Eigen::Vector3d about_m = samples.front().finger_m;
  std::vector<Eigen::Vector3d> residuals;
  for_each(samples, latency_s, [&](const CarriedSample& sample, const Eigen::Vector3d& by) {
    residuals.emplace_back(sample.finger_m - about_m - circle.coefficients.transpose() * by);
  });
  return residuals;
}

// Variance of the sum of values that are correlated over memory_samples at most (Newey and West, Econometrica
// 55, 1987).
double long_run_square_sum(const std::vector<double>& values, std::size_t memory_samples) {
  double sum = 0.0;
  for (std::size_t lag = 0; lag <= memory_samples && lag < values.size(); ++lag) {
    double product = 0.0;
    for (std::size_t i = lag; i < values.size(); ++i) product += values[i] * values[i - lag];
    const double weight = 1.0 - static_cast<double>(lag) / static_cast<double>(memory_samples + 1);
    sum += (lag == 0 ? 1.0 : 2.0) * weight * product;
  }
  return std::max(sum, 0.0);
}

// Half the 95 % interval of a latency whose circle is the best: the residuals against their change with the
// latency.
std::optional<double> half_interval_s(Samples samples, double latency_s, const Circle& circle) {
  const std::optional<Circle> earlier = fit_circle(samples, latency_s - stride_s);
  const std::optional<Circle> later = fit_circle(samples, latency_s + stride_s);
  if (!earlier || !later) return std::nullopt;
  const auto here = residuals_m(samples, latency_s, circle);
  const auto before = residuals_m(samples, latency_s - stride_s, *earlier);
  const auto after = residuals_m(samples, latency_s + stride_s, *later);
  std::vector<double> scores;
  double information = 0.0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const Eigen::Vector3d slope = (after[i] - before[i]) / (2.0 * stride_s);
    scores.push_back(here[i].dot(slope));
    information += slope.squaredNorm();
  }
  if (!(information > 0.0)) return std::nullopt;
  const double spacing_s = (samples.back().time_s - samples.front().time_s) / static_cast<double>(samples.size() - 1);
  const auto memory = static_cast<std::size_t>(std::min(noise_memory_s / spacing_s, max_memory_samples));
  // At least that of white noise. The quantile grows with the share of the samples that a memory is (Kiefer
  // and Vogelsang, Econometric Theory 21, 2005).
  const double share = static_cast<double>(memory + 1) / static_cast<double>(scores.size());
  const double square_sum = std::max(long_run_square_sum(scores, memory), long_run_square_sum(scores, 0));
  return (normal_quantile + 2.9694 * share + 0.416 * share * share) * std::sqrt(square_sum) / information;
}

struct Tried {
  double latency_s;
  double square_sum_m2;
};

// Whether a latency far from the best fits nearly as well, as when the plate's turns repeat.
bool is_ambiguous(const std::vector<Tried>& tried, double best_s, const Circle& best) {
  const double variance_m2 = best.square_sum_m2 / (3.0 * best.count - unknowns);
  return std::any_of(tried.begin(), tried.end(), [&](const Tried& other) {
    return std::abs(other.latency_s - best_s) >= apart_s &&
           other.square_sum_m2 < best.square_sum_m2 + clearly_worse * variance_m2;
  });
}

}  // namespace

TrackerLatency fit_tracker_latency(Samples samples) {
  TrackerLatency result;
  if (samples.size() < min_pairs || samples.back().time_s - samples.front().time_s < min_duration_s) return result;
  double best_s = min_latency_s;
  std::optional<Circle> best;
  std::vector<Tried> tried;
  const auto try_out = [&](double latency_s) {
    const std::optional<Circle> circle = fit_circle(samples, latency_s);
    if (!circle) return;
    tried.push_back({latency_s, circle->square_sum_m2});
    if (best && circle->square_sum_m2 >= best->square_sum_m2) return;
    best = circle;
    best_s = latency_s;
  };
  const auto intervals = static_cast<int>(std::lround((max_latency_s - min_latency_s) / grid_s));
  for (int i = 0; i <= intervals; ++i) try_out(min_latency_s + i * grid_s);
  double step_s = grid_s;
  for (int i = 0; i < latency_halvings; ++i) {
    step_s *= 0.5;
    const double about_s = best_s;
    try_out(about_s - step_s);
    try_out(about_s + step_s);
  }
  if (!best || best->count < min_pairs) return result;
  const std::optional<double> half_s = half_interval_s(samples, best_s, *best);
  if (!half_s) return result;
  result.latency_s = best_s;
  result.lower_s = best_s - *half_s;
  result.upper_s = best_s + *half_s;
  result.residual_m = std::sqrt(best->square_sum_m2 / (3.0 * best->count - unknowns));
  result.radius_m = best->radius_m;
  result.known = result.upper_s - result.lower_s <= max_width_s && result.lower_s > min_latency_s + stride_s &&
                 result.upper_s < max_latency_s - stride_s && result.radius_m >= min_radius_m &&
                 result.residual_m <= max_residual_share * result.radius_m && !is_ambiguous(tried, best_s, *best);
  return result;
}

}  // namespace hrt
