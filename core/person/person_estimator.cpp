#include "core/person/person_estimator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/exponential.h"
#include "core/person/motion_fit.h"
#include "core/reach/finger_sample.h"

namespace hrt {
namespace {

constexpr double max_step_s = 0.012;
// A sample further off than five standard deviations is left out; after this many in a row, the finger is
// there.
constexpr double gate = 25.0;
constexpr int max_outliers = 4;
// Samples since the onset that the filter takes in at each new one: bounds the time of an update.
constexpr int max_replayed = 6;
constexpr double onset_sd_s = 0.02;
// The least in which a finger is found to stand still, of places and of time.
constexpr int still_samples = 10;
constexpr double still_s = 0.11;
constexpr double still_deviations = 2.5;
constexpr double min_pausing_speed_mm_s = 25.0;
constexpr double pause_clock_sd_s = 0.07;
// A finger beyond this share of the time has come to rest.
constexpr double arrived_phase = 0.97;
// Of the means that make up ModelFit.
constexpr double fit_share = 0.05;
// A stray position is no misfit: a single one counts for no more than this.
constexpr double fit_cap = 9.0;
constexpr double recovery_nis = 20.0;
constexpr double noise_floor_share = 0.5;
// A resting finger that is seen further off than a motion could begin, and than four deviations of the
// difference of two positions, is not there, unless it is so seen more often than this.
constexpr double max_start_speed_mm_s = 600.0;
constexpr double wild_deviations = 5.7;
constexpr int max_wild = 2;

}  // namespace

PersonEstimator::PersonEstimator(const PersonBelief& belief, double virtual_direction_deg, double path_mm,
                                 const PlatePoint& start, const std::optional<TrackerNoise>& noise)
    : belief_(belief),
      virtual_direction_deg_(virtual_direction_deg),
      path_mm_(path_mm),
      rest_(start, noise),
      filter_(belief, virtual_direction_deg, path_mm, rest_.noise()) {}

bool PersonEstimator::observe(double time_s, const PlatePoint& position, const PlateTrace& plate) {
  if (motion_ == FingerMotion::resting) {
    if (is_wild(time_s, position)) return false;
    if (std::exchange(wild_, 0) > max_wild) lifted_ = true;  // it is there, however it came
  }
  if (!places_.add(time_s, position)) return true;
  if (motion_ == FingerMotion::resting) {
    filter_s_ = time_s;
    if (std::exchange(lifted_, false)) {  // set down, perhaps elsewhere
      rest_.lift();
      places_.keep_last();
    }
    if (!rest_.observe(places_)) return true;
    begin_motion();
  } else {
    ++backlog_;
  }
  return catch_up(plate);
}

bool PersonEstimator::is_wild(double time_s, const PlatePoint& position) {
  if (places_.count() == 0 || lifted_) return false;
  const double allowed_mm =
      max_start_speed_mm_s * (time_s - places_[0].time_s) + wild_deviations * std::sqrt(noise().variance_mm2());
  wild_ = square_distance_mm2(position, places_[0].position) > square(allowed_mm) ? wild_ + 1 : 0;
  return wild_ > 0 && wild_ <= max_wild;
}

void PersonEstimator::predict(double time_s, const PlateTrace& plate) {
  if (motion_ != FingerMotion::resting && caught_up()) carry_to(time_s, plate);
}

void PersonEstimator::lift(double time_s, const PlateTrace& plate) {
  predict(time_s, plate);
  if (motion_ != FingerMotion::resting) motion_ = FingerMotion::paused;
  lifted_ = true;
  backlog_ = 0;
}

void PersonEstimator::retarget(double time_s, double virtual_direction_deg, double longer_mm) {
  virtual_direction_deg_ = virtual_direction_deg;
  path_mm_ = std::max(path_mm_ + longer_mm, 1.0);
  if (motion_ == FingerMotion::resting) {
    filter_ = PersonFilter(belief_, virtual_direction_deg_, path_mm_, noise());
    return;
  }
  // A target that moves on before they have answered is answered with it.
  if (!retarget_) retarget_ = {.time_s = time_s + reaction_time_s, .virtual_direction_deg = 0.0, .longer_mm = 0.0};
  retarget_->virtual_direction_deg = virtual_direction_deg;
  retarget_->longer_mm += longer_mm;
  if (motion_ == FingerMotion::paused || filter_.state().phase <= arrived_phase) return;
  // The finger rests at its former target until it leaves.
  motion_ = FingerMotion::paused;
  pause_ = place();
  outliers_ = 0;
}

std::optional<PersonFilter> PersonEstimator::after_retarget() const {
  if (!retarget_) return std::nullopt;
  std::optional<PersonFilter> filter = filter_;
  filter->retarget(retarget_->virtual_direction_deg, retarget_->longer_mm, false);
  return filter;
}

PlatePoint PersonEstimator::place() const {
  if (motion_ == FingerMotion::resting) return places_.count() > 0 ? places_[0].position : origin();
  return origin() + PlatePoint{filter_.state().right_mm, filter_.state().away_mm};
}

void PersonEstimator::begin_motion() {
  const MotionFit best = fit_motion(places_, origin(), belief_, path_mm_, noise().variance_mm2());
  onset_s_ = best.onset_s;
  filter_ = PersonFilter(belief_, virtual_direction_deg_, path_mm_, noise());
  filter_.begin(best.log_rate, best.evenness, onset_sd_s, rest_.place_sd_mm());
  filter_s_ = onset_s_;
  motion_ = FingerMotion::moving;
  backlog_ = 0;
  while (backlog_ < places_.count() - 1 && places_[backlog_].time_s > onset_s_) ++backlog_;
}

bool PersonEstimator::catch_up(const PlateTrace& plate) {
  bool taken = true;
  for (int i = 0; i < max_replayed && backlog_ > 0; ++i) taken = take(places_[--backlog_], plate);
  return taken;
}

void PersonEstimator::carry_to(double time_s, const PlateTrace& plate) {
  if (retarget_ && retarget_->time_s <= time_s) {
    const Retarget answered = *std::exchange(retarget_, std::nullopt);
    carry_to(answered.time_s, plate);
    filter_.retarget(answered.virtual_direction_deg, answered.longer_mm, true);
  }
  const double left_s = std::min(time_s - filter_s_, max_gap_s);
  if (left_s <= 0.0) return;
  if (motion_ == FingerMotion::paused) {
    filter_.rest(left_s);
  } else {
    const int steps = static_cast<int>(std::ceil(left_s / max_step_s));
    const double step_s = left_s / steps;
    for (int i = 0; i < steps; ++i) {
      filter_.move(step_s, plate.at(time_s - left_s + (i + 0.5) * step_s - sensory_delay_s));
    }
  }
  filter_s_ = time_s;
}

bool PersonEstimator::take(const TimedPoint& sample, const PlateTrace& plate) {
  carry_to(sample.time_s, plate);
  const PlatePoint place = sample.position - origin();
  if (motion_ == FingerMotion::paused) {
    take_paused(sample);
    return true;
  }
  const double speed_mm_s = filter_.speed_mm_s();
  const PersonState x = filter_.state();
  const PlatePoint innovation = place - PlatePoint{x.right_mm + x.noise_right_mm, x.away_mm + x.noise_away_mm};
  const double nis = filter_.observe(place.right_mm, place.away_mm, gate);
  if (nis <= gate) {
    outliers_ = 0;
    fit_.nis += fit_share * (std::min(nis, fit_cap) - fit_.nis);
    const double product =
        innovation.right_mm * last_innovation_.right_mm + innovation.away_mm * last_innovation_.away_mm;
    const double size = 0.5 * (square(innovation.right_mm) + square(innovation.away_mm) +
                               square(last_innovation_.right_mm) + square(last_innovation_.away_mm));
    // Below the noise a deviation from the model is no misfit, however steady.
    const double min_mm2 = noise_floor_share * noise().variance_mm2();
    fit_.correlation += fit_share * (product / std::max(size, min_mm2) - fit_.correlation);
    last_innovation_ = innovation;
  }
  PlatePoint still{};
  if (backlog_ == 0 && nis > 6.0 && speed_mm_s > min_pausing_speed_mm_s && stands_still(still)) {
    motion_ = FingerMotion::paused;
    pause_ = still;
    filter_.place_at(still.right_mm - origin().right_mm, still.away_mm - origin().away_mm);
    filter_.loosen_clock(pause_clock_sd_s);
    fit_ = {};  // the start of a pause is not modelled: the statistics begin anew
    outliers_ = 0;
    return true;
  }
  if (nis <= gate) return true;
  if (++outliers_ > max_outliers) {
    filter_.place_at(place.right_mm, place.away_mm);
    filter_.loosen_clock(pause_clock_sd_s);
    outliers_ = 0;
    // One jump is another finger; several are a motion that the model does not describe.
    fit_.nis += fit_share * (recovery_nis - fit_.nis);
  }
  return false;
}

// A finger that comes down again, or leaves where it rested, moves on.
void PersonEstimator::take_paused(const TimedPoint& sample) {
  const PlatePoint place = sample.position - origin();
  if (lifted_) {
    lifted_ = false;
    filter_.place_at(place.right_mm, place.away_mm);
    pause_ = sample.position;
    outliers_ = 0;
    return;
  }
  const bool away = square_distance_mm2(sample.position, pause_) > square(3.5) * noise().variance_mm2();
  outliers_ = away ? outliers_ + 1 : 0;
  filter_.observe(place.right_mm, place.away_mm, gate);
  if (outliers_ < 3) return;
  motion_ = FingerMotion::moving;
  filter_.loosen_clock(pause_clock_sd_s);
  outliers_ = 0;
}

// The last samples go nowhere: their trend is within the noise, and short of what the motion would have been.
bool PersonEstimator::stands_still(PlatePoint& where) const {
  int count = still_samples;
  while (count < places_.count() && places_[0].time_s - places_[count - 1].time_s < still_s) ++count;
  if (places_.count() < count) return false;
  where = places_.mean_of_last(count);
  double moment_right = 0.0;
  double moment_away = 0.0;
  double spread = 0.0;
  for (int i = 0; i < count; ++i) {
    const double centred = 0.5 * (count - 1) - i;
    moment_right += centred * places_[i].position.right_mm;
    moment_away += centred * places_[i].position.away_mm;
    spread += centred * centred;
  }
  const double trend_mm = std::sqrt(square(moment_right) + square(moment_away)) / spread * (count - 1);
  const double expected_mm = filter_.speed_mm_s() * (places_[0].time_s - places_[count - 1].time_s);
  const double noise_mm = std::sqrt(noise().variance_mm2());
  return trend_mm < still_deviations * noise_mm && trend_mm < expected_mm - noise_mm;
}

}  // namespace hrt
