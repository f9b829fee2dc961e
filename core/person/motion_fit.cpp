#include "core/person/motion_fit.h"

#include <algorithm>
#include <cmath>

#include "core/math/exponential.h"
#include "core/reach/pace.h"

namespace hrt {
namespace {

using T = PersonTrait;

// A place each 20 ms is enough to distinguish paces.
constexpr double fit_spacing_s = 0.02;
// Places before a candidate's onset that speak against a later one.
constexpr double fit_before_s = 0.1;
// The grid: rates at up to 2.4 deviations of the belief, evennesses at up to 2.6.
constexpr int rates_to_a_side = 6;
constexpr double rate_deviations = 0.4;
constexpr int evennesses = 3;
constexpr double evenness_deviations = 1.3;
constexpr double min_evenness_step = 0.1;

}  // namespace

// Rate and evenness decide when the motion began, since the share of the path that lies behind is known; the
// places since the rest decide between them.
MotionFit fit_motion(const RecentPlaces& places, const PlatePoint& origin, const PersonBelief& belief, double path_mm,
                     double noise_variance_mm2) {
  const double seen_s = places[1].time_s;
  const PlatePoint seen = places.mean_of_last(3);
  const double travelled_mm = std::sqrt(square_distance_mm2(seen, origin));
  const double unit_right = (seen.right_mm - origin.right_mm) / travelled_mm;
  const double unit_away = (seen.away_mm - origin.away_mm) / travelled_mm;
  const double share = travelled_mm / path_mm;

  const double log_rate_sd = std::sqrt(belief.covariance(T::log_rate, T::log_rate));
  const double evenness_sd = std::sqrt(belief.covariance(T::evenness, T::evenness));
  const double likely_evenness = std::clamp(belief.mean(T::evenness), 0.0, 1.0);
  const int count = places.count();
  const double spacing_s = (places[0].time_s - places[count - 1].time_s) / (count - 1);
  const int stride = static_cast<int>(std::clamp(std::ceil(fit_spacing_s / spacing_s), 1.0, 5.0));
  const auto squares = [&](double evenness, double rate, double onset_s) {
    double sum = 0.0;
    for (int back = 0; back < count && places[back].time_s > onset_s - fit_before_s; back += stride) {
      const PlatePoint& place = places[back].position;
      const double along_mm =
          (place.right_mm - origin.right_mm) * unit_right + (place.away_mm - origin.away_mm) * unit_away;
      const double expected_mm = path_mm * progress(evenness, (places[back].time_s - onset_s) * rate).share;
      sum += square(along_mm - expected_mm) / noise_variance_mm2;
    }
    return sum;
  };

  double min_cost = 1e300;
  MotionFit best{belief.mean(T::log_rate), likely_evenness, seen_s};
  for (int i = 0; i < evennesses; ++i) {
    const double evenness = std::min(1.0, likely_evenness + evenness_deviations * i * evenness_sd);
    if (i > 0 && evenness - likely_evenness < min_evenness_step) break;
    const double phase = phase_at(evenness, share);
    const double evenness_cost = square((evenness - likely_evenness) / evenness_sd);
    for (int j = -rates_to_a_side; j <= rates_to_a_side; ++j) {
      const double deviations = rate_deviations * j;
      const double log_rate = std::clamp(belief.mean(T::log_rate) + deviations * log_rate_sd,
                                         person_traits[T::log_rate].min, person_traits[T::log_rate].max);
      const double rate = exponential(log_rate);
      const double onset_s = seen_s - phase / rate;
      const double cost = square(deviations) + evenness_cost + squares(evenness, rate, onset_s);
      if (cost >= min_cost) continue;
      min_cost = cost;
      best = {log_rate, evenness, onset_s};
    }
  }
  return best;
}

}  // namespace hrt
