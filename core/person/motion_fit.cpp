#include "core/person/motion_fit.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/person/person_model.h"

namespace hrt {
namespace {

using T = PersonState;

constexpr int rates_to_a_side = 3;  // number of rates in the grid below, and above, the mean of the prior

}  // namespace

// For each candidate rate, the path covered so far determines the onset. The selected candidate has the least cost:
// the sum of the squared differences between observed and predicted distances along the path, in SDs of the noise, plus
// the squared deviation from the mean of the prior, in SDs.
MotionFit fit_motion(const RecentPlaces<PlatePoint>& places, const PlatePoint& origin, const PersonBelief& belief,
                     double path_mm, double noise_variance_mm2, const Tuning& tuning) {
  const double seen_s = places[1].time_s;
  const PlatePoint travelled = places.mean_of_last(3) - origin;
  const double travelled_mm = std::sqrt(dot_mm2(travelled, travelled));

  const double log_rate_sd = trait_sd(belief, T::log_rate);
  const double evenness = std::clamp(belief.mean(T::evenness), 0.0, 1.0);
  const double phase = phase_at(evenness, travelled_mm / path_mm, tuning.pace_skew);
  const int count = places.count();
  const double spacing_s = (places[0].time_s - places[count - 1].time_s) / (count - 1);
  const int stride = static_cast<int>(std::clamp(std::ceil(tuning.fit_spacing_s / spacing_s), 1.0, 5.0));
  const auto misfit = [&](double rate, double onset_s) {
    double sum = 0.0;
    for (int back = 0; back < count && places[back].time_s > onset_s; back += stride) {
      const double along_mm = dot_mm2(places[back].position - origin, travelled) / travelled_mm;
      const double expected_mm =
          path_mm * progress(evenness, (places[back].time_s - onset_s) * rate, tuning.pace_skew).share;
      sum += square(along_mm - expected_mm) / noise_variance_mm2;
    }
    return sum;
  };

  double min_cost = 1e300;
  MotionFit best{belief.mean(T::log_rate), seen_s};
  for (int j = -rates_to_a_side; j <= rates_to_a_side; ++j) {
    const double deviations = tuning.rate_deviations * j;
    const double log_rate = std::clamp(belief.mean(T::log_rate) + deviations * log_rate_sd,
                                       person_state[T::log_rate].min, person_state[T::log_rate].max);
    const double rate = exponential(log_rate);
    const double onset_s = seen_s - phase / rate;
    const double cost = square(deviations) + misfit(rate, onset_s);
    if (cost >= min_cost) continue;
    min_cost = cost;
    best = {log_rate, onset_s};
  }
  return best;
}

}  // namespace hrt
