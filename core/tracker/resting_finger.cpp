#include "core/tracker/resting_finger.h"

#include <algorithm>
#include <cmath>

#include "core/math/exponential.h"

namespace hrt {
namespace {

// The finger moves once the mean of three places is this many deviations of the noise from where it rested.
constexpr double onset_deviations = 3.3;
constexpr double min_onset_mm = 1.0;
constexpr double hidden_share = 2.0;
// Places at rest that the assumed noise is worth: a rest of few correlation times shows its white part only.
constexpr double assumed_white_samples = 6.0;
constexpr double assumed_correlated_samples = 30.0;
// Departures beyond this are motion, such as that of a finger which never rested.
constexpr double max_departure_mm = 4.0;
// A finger further from the mean than this many deviations of the noise is about to leave.
constexpr double rest_place_deviations = 3.0;
// Where the finger rests is the mean over this time.
constexpr double place_memory_s = 1.0;
// A start this far from the configured one is believed only from a finger at rest.
constexpr double start_tolerance_mm = 15.0;
constexpr double min_place_sd_mm = 0.05;

}  // namespace

RestingFinger::RestingFinger(const PlatePoint& start, const std::optional<TrackerNoise>& noise)
    : noise_(noise.value_or(TrackerNoise{})), noise_known_(noise.has_value()), place_(start) {}

bool RestingFinger::has_left(const RecentPlaces& places) const {
  if (rested_ == 0 || places.count() < 3) return false;
  // Until the noise is learnt its steps show it, with as much more as so few of them may hide.
  const double seen_mm2 =
      noise_known_ || steps_ == 0 ? 0.0 : step_sum_mm2_ / steps_ * square(1.0 + hidden_share / steps_);
  const double moved_mm2 = square(onset_deviations) * std::max(noise_.variance_mm2(), seen_mm2);
  return square_distance_mm2(places.mean_of_last(3), place_) > std::max(square(min_onset_mm), moved_mm2);
}

bool RestingFinger::observe(const RecentPlaces& places) {
  if (has_left(places)) return true;
  const TimedPoint& seen = places[0];
  if (rested_ == 0) {
    // A finger that is seen first in motion began where it was asked to.
    if (square_distance_mm2(seen.position, place_) > square(start_tolerance_mm)) place_ = seen.position;
    rested_ = 1;
    return false;
  }
  step_sum_mm2_ += 0.25 * square_distance_mm2(seen.position, places[1].position);
  spacing_sum_s_ += seen.time_s - places[1].time_s;
  ++steps_;
  learn_noise();
  const double departure_mm2 = square_distance_mm2(seen.position, place_);
  if (departure_mm2 > square(rest_place_deviations) * noise_.variance_mm2() && rested_ > 3) return false;
  ++rested_;
  const double share = std::max(1.0 / (rested_ - 1), spacing_sum_s_ / steps_ / place_memory_s);
  place_.right_mm += share * (seen.position.right_mm - place_.right_mm);
  place_.away_mm += share * (seen.position.away_mm - place_.away_mm);
  if (rested_ <= 3) return false;
  square_sum_mm2_ += 0.5 * departure_mm2;
  ++departures_;
  return false;
}

// White noise shows in the steps of a resting finger, correlated noise only in its distance from the mean.
void RestingFinger::learn_noise() {
  if (noise_known_ || departures_ < 5) return;
  const double step_mm2 = step_sum_mm2_ / steps_;
  const double total_mm2 = std::max(step_mm2, std::min(square_sum_mm2_ / departures_, square(max_departure_mm)));
  const double kept = std::max(0.1, exponential(-spacing_sum_s_ / steps_ / 0.1));
  const double correlated_mm2 = std::min((total_mm2 - step_mm2) / kept, total_mm2);
  const auto blend = [this](double assumed_mm, double seen_mm2, double assumed_samples) {
    const double share = steps_ / (steps_ + assumed_samples);
    return std::max(0.02, std::sqrt((1.0 - share) * square(assumed_mm) + share * seen_mm2));
  };
  const TrackerNoise assumed;
  noise_ = {.white_mm = blend(assumed.white_mm, total_mm2 - correlated_mm2, assumed_white_samples),
            .correlated_mm = blend(assumed.correlated_mm, correlated_mm2, assumed_correlated_samples)};
}

double RestingFinger::place_sd_mm() const {
  return std::max(min_place_sd_mm, std::sqrt(noise_.variance_mm2() / std::max(1.0, rested_ / 4.0)));
}

}  // namespace hrt
