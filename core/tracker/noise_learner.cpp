#include "core/tracker/noise_learner.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"

namespace hrt {
namespace {

// Weights of the assumed noise, as numbers of differences. The weight of the correlated part is larger, since a rest of
// few time constants hardly shows correlated noise.
constexpr double assumed_white_differences = 6.0;
constexpr double assumed_correlated_differences = 30.0;
// If the observed noise is below the assumed noise, the assumed correlated part is reduced, at most to this fraction.
constexpr double min_assumed_share = 0.6;
constexpr int steps_per_estimate = 8;
// Upper limit of each part of the noise: larger differences are a motion.
constexpr double max_noise_mm = 4.0;
// During a motion, the distance of a position from the line through the positions before and after it counts as at most
// this many SDs.
constexpr double max_departure_deviations = 3.0;
// Lower limit of each part, since without noise a filter would attribute every deviation to the person.
constexpr double min_part_mm = 0.02;

}  // namespace

NoiseParts separate(const StructureFunction& differences, double correlation_s) {
  double n = 0.0, g = 0.0, gg = 0.0, d = 0.0, gd = 0.0, dd = 0.0;
  for (int lag = 0; lag < StructureFunction::lags; ++lag) {
    if (!(differences.count(lag) > 0.5 && differences.mean_mm2(lag) > 0.0)) continue;
    const double mean_mm2 = differences.mean_mm2(lag);
    const double growth = 1.0 - exponential(-differences.mean_s(lag) / correlation_s);
    const double weight = differences.count(lag) / StructureFunction::places(lag) / square(mean_mm2);
    n += weight;
    g += weight * growth;
    gg += weight * growth * growth;
    d += weight * mean_mm2;
    gd += weight * growth * mean_mm2;
    dd += weight * mean_mm2 * mean_mm2;
  }
  if (!(n > 0.0)) return {0.0, 0.0, 0.0};
  const double determinant = n * gg - g * g;
  double white = 0.0, correlated = 0.0;
  if (determinant > 1e-9 * n * gg) {
    white = (gg * d - g * gd) / determinant;
    correlated = (n * gd - g * d) / determinant;
  }
  if (!(correlated > 0.0)) {
    white = d / n;
    correlated = 0.0;
  } else if (white < 0.0) {
    white = 0.0;
    correlated = gd / gg;
  }
  const double cost = dd - 2.0 * (white * d + correlated * gd) + white * white * n + 2.0 * white * correlated * g +
                      correlated * correlated * gg;
  return {white, correlated, cost};
}

template <class Point>
void NoiseLearner<Point>::learn(const RecentPlaces<Point>& places, int rested) {
  if (known_) return;
  const Timed<Point>& last = places[0];
  for (int lag = 0; lag < StructureFunction::lags; ++lag) {
    const int back = StructureFunction::places(lag);
    if (back > rested || back >= places.count()) break;
    differences_.add(lag, 0.5 / coordinates * square_distance_mm2(last.position, places[back].position),
                     last.time_s - places[back].time_s);
  }
  update();
}

// Uses the distance of a position from the line through the positions before and after it: 0 in a uniform motion.
template <class Point>
void NoiseLearner<Point>::learn_moving(const RecentPlaces<Point>& places) {
  if (known_ || places.count() < 3) return;
  const double share = (places[1].time_s - places[2].time_s) / (places[0].time_s - places[2].time_s);
  const Point line = places[2].position + share * (places[0].position - places[2].position);
  const double departure_mm2 =
      square_distance_mm2(places[1].position, line) / (coordinates * (1.0 + square(1.0 - share) + square(share)));
  differences_.add(0, std::min(departure_mm2, square(max_departure_deviations) * noise_.variance_mm2()),
                   places[0].time_s - places[1].time_s);
  update();
}

template <class Point>
void NoiseLearner<Point>::update() {
  if (steps() % steps_per_estimate != 0) return;
  const NoiseParts seen = separate(differences_, noise_.correlation_s);
  const auto blended_mm = [this](double assumed_mm, double seen_mm2, double assumed_differences) {
    const double share = steps() / (steps() + assumed_differences);
    const double mm2 = (1.0 - share) * square(assumed_mm) + share * std::min(seen_mm2, square(max_noise_mm));
    return std::max(min_part_mm, std::sqrt(mm2));
  };
  constexpr TrackerNoise assumed;
  noise_.white_mm = blended_mm(assumed.white_mm, seen.white_mm2, assumed_white_differences);
  const double seen_share = std::sqrt((seen.white_mm2 + seen.correlated_mm2) / assumed.variance_mm2());
  const double assumed_share = std::clamp(seen_share, min_assumed_share, 1.0);
  noise_.correlated_mm =
      blended_mm(assumed_share * assumed.correlated_mm, seen.correlated_mm2, assumed_correlated_differences);
}

template class NoiseLearner<PlatePoint>;
template class NoiseLearner<Eigen::Vector3d>;

}  // namespace hrt
