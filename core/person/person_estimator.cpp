#include "core/person/person_estimator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/exponential.h"
#include "core/person/arrival.h"
#include "core/reach/finger_sample.h"

namespace hrt {
namespace {

// Positions that come faster than this are averaged.
constexpr double min_spacing_s = 0.004;
constexpr double max_step_s = 0.012;
// A sample further off than five standard deviations is left out; after this many in a row, the finger is
// there.
constexpr double gate = 25.0;
constexpr int max_outliers = 4;
// Samples since the onset that the filter takes in at each new one: bounds the time of an update.
constexpr int max_replayed = 6;
// The finger moves once the mean of three samples is this many deviations of the noise from where it rested.
constexpr double onset_deviations = 3.3;
constexpr double min_onset_mm = 1.0;
constexpr double onset_sd_s = 0.02;
constexpr double fit_spacing_s = 0.02;
// Samples at rest that the assumed noise is worth.
constexpr double assumed_noise_samples = 30.0;
// Departures beyond this are motion, such as that of a finger which never rested.
constexpr double max_departure_mm = 4.0;
// A finger further from the mean than this many deviations of the noise is about to leave.
constexpr double resting_deviations = 3.0;
// Where the finger rests is the mean over this time.
constexpr double origin_memory_s = 1.0;
// A start this far from the configured one is believed only from a finger at rest.
constexpr double start_tolerance_mm = 15.0;
constexpr int still_samples = 10;
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

double square(double x) {
  return x * x;
}

double square_distance(const PlaceMm& a, const PlaceMm& b) {
  return square(a.right_mm - b.right_mm) + square(a.away_mm - b.away_mm);
}

}  // namespace

PersonEstimator::PersonEstimator(const PersonBelief& belief, double virtual_direction_deg, double path_mm,
                                 const PlaceMm& start, const std::optional<TrackerNoise>& noise)
    : belief_(belief),
      virtual_direction_deg_(virtual_direction_deg),
      path_mm_(path_mm),
      noise_(noise.value_or(TrackerNoise{})),
      noise_known_(noise.has_value()),
      filter_(belief, virtual_direction_deg, path_mm, noise_),
      origin_(start) {}

bool PersonEstimator::observe(double time_s, const PlaceMm& position, const PlateTrace& plate) {
  if (!store(time_s, position)) return true;
  if (motion_ == FingerMotion::resting) {
    filter_s_ = time_s;
    if (lifted_) {  // set down, perhaps elsewhere
      lifted_ = false;
      rested_ = 0;
      count_ = 1;
    }
    const double moved_mm2 =
        square(std::max(min_onset_mm, onset_deviations * std::sqrt(noise_.variance_mm2())));
    if (rested_ > 0 && count_ >= 3 && square_distance(mean_of_last(3), origin_) > moved_mm2) {
      begin_motion();
      return catch_up(plate);
    }
    watch_rest();
    return true;
  }
  ++backlog_;
  return catch_up(plate);
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
    filter_ = PersonFilter(belief_, virtual_direction_deg_, path_mm_, noise_);
    return;
  }
  // A target that moves on before they have answered is answered with it.
  if (!retarget_)
    retarget_ = {.time_s = time_s + reaction_time_s, .virtual_direction_deg = 0.0, .longer_mm = 0.0};
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

PlaceMm PersonEstimator::place() const {
  if (motion_ == FingerMotion::resting) return count_ > 0 ? recent(0).place : origin_;
  return {origin_.right_mm + filter_.state().right_mm, origin_.away_mm + filter_.state().away_mm};
}

// False if the position was merged into the last sample.
bool PersonEstimator::store(double time_s, const PlaceMm& position) {
  if (count_ > 0 && merged_ > 0 && time_s - recent(0).time_s < min_spacing_s) {
    ++merged_;
    Sample& last = samples_[static_cast<std::size_t>(last_)];
    last.place.right_mm += (position.right_mm - last.place.right_mm) / merged_;
    last.place.away_mm += (position.away_mm - last.place.away_mm) / merged_;
    return false;
  }
  last_ = (last_ + 1) % capacity;
  samples_[static_cast<std::size_t>(last_)] = {time_s, position};
  count_ = std::min(count_ + 1, capacity);
  merged_ = 1;
  return true;
}

PlaceMm PersonEstimator::mean_of_last(int samples) const {
  PlaceMm mean{0.0, 0.0};
  for (int i = 0; i < samples; ++i) {
    mean.right_mm += recent(i).place.right_mm / samples;
    mean.away_mm += recent(i).place.away_mm / samples;
  }
  return mean;
}

void PersonEstimator::watch_rest() {
  const Sample& sample = recent(0);
  if (rested_ == 0) {
    // A finger that is seen first in motion began where it was asked to.
    if (square_distance(sample.place, origin_) > square(start_tolerance_mm)) origin_ = sample.place;
    rested_ = 1;
    return;
  }
  step_sum_mm2_ += 0.25 * square_distance(sample.place, recent(1).place);
  spacing_sum_s_ += sample.time_s - recent(1).time_s;
  ++steps_;
  learn_noise();
  const double departure_mm2 = square_distance(sample.place, origin_);
  if (departure_mm2 > square(resting_deviations) * noise_.variance_mm2() && rested_ > 3) return;
  ++rested_;
  const double share = std::max(1.0 / (rested_ - 1), spacing_sum_s_ / steps_ / origin_memory_s);
  origin_.right_mm += share * (sample.place.right_mm - origin_.right_mm);
  origin_.away_mm += share * (sample.place.away_mm - origin_.away_mm);
  if (rested_ <= 3) return;
  square_sum_mm2_ += 0.5 * departure_mm2;
  ++departures_;
}

// White noise shows in the steps of a resting finger, correlated noise only in its distance from the mean.
void PersonEstimator::learn_noise() {
  if (noise_known_ || departures_ < 5) return;
  const double step_mm2 = step_sum_mm2_ / steps_;
  const double total_mm2 =
      std::max(step_mm2, std::min(square_sum_mm2_ / departures_, square(max_departure_mm)));
  const double kept = std::max(0.1, exponential(-spacing_sum_s_ / steps_ / 0.1));
  const double correlated_mm2 = std::min((total_mm2 - step_mm2) / kept, total_mm2);
  const double share = steps_ / (steps_ + assumed_noise_samples);
  const auto blend = [share](double assumed_mm, double seen_mm2) {
    return std::max(0.02, std::sqrt((1.0 - share) * square(assumed_mm) + share * seen_mm2));
  };
  const TrackerNoise assumed;
  noise_ = {.white_mm = blend(assumed.white_mm, total_mm2 - correlated_mm2),
            .correlated_mm = blend(assumed.correlated_mm, correlated_mm2)};
}

// Rate and evenness decide when the motion began, since the share of the path that lies behind is known; the
// samples since the rest decide between them.
PersonEstimator::MotionFit PersonEstimator::fit_motion() const {
  const double seen_s = recent(1).time_s;
  const PlaceMm seen = mean_of_last(3);
  const double travelled_mm = std::sqrt(square_distance(seen, origin_));
  const double unit_right = (seen.right_mm - origin_.right_mm) / travelled_mm;
  const double unit_away = (seen.away_mm - origin_.away_mm) / travelled_mm;
  const double share = std::min(travelled_mm / path_mm_, 0.9);

  using T = PersonTrait;
  const double log_rate_sd = std::sqrt(belief_.covariance(T::log_rate, T::log_rate));
  const double evenness_sd = std::sqrt(belief_.covariance(T::evenness, T::evenness));
  const double likely_evenness = std::clamp(belief_.mean(T::evenness), 0.0, 1.0);
  // A sample each fit_spacing_s is enough to distinguish paces.
  const double spacing_s = (recent(0).time_s - recent(count_ - 1).time_s) / (count_ - 1);
  const int stride = static_cast<int>(std::clamp(std::ceil(fit_spacing_s / spacing_s), 1.0, 5.0));
  double min_cost = 1e300;
  MotionFit best{belief_.mean(T::log_rate), likely_evenness, seen_s};
  for (int i = 0; i < 3; ++i) {
    const double evenness = std::min(1.0, likely_evenness + 1.3 * i * evenness_sd);
    if (i > 0 && evenness - likely_evenness < 0.1) break;
    const double phase = phase_at(evenness, share);
    for (int j = -6; j <= 6; ++j) {
      const double deviations = 0.4 * j;
      const double log_rate = std::clamp(belief_.mean(T::log_rate) + deviations * log_rate_sd,
                                         person_traits[T::log_rate].min, person_traits[T::log_rate].max);
      const double rate = exponential(log_rate);
      const double onset_s = seen_s - phase / rate;
      double cost = square(deviations) + square((evenness - likely_evenness) / evenness_sd);
      for (int back = 0; back < count_ && recent(back).time_s > onset_s - 0.1; back += stride) {
        const PlaceMm& place = recent(back).place;
        const double along_mm =
            (place.right_mm - origin_.right_mm) * unit_right + (place.away_mm - origin_.away_mm) * unit_away;
        const double expected_mm =
            path_mm_ * progress(evenness, (recent(back).time_s - onset_s) * rate).share;
        cost += square(along_mm - expected_mm) / noise_.variance_mm2();
      }
      if (cost < min_cost) {
        min_cost = cost;
        best = {log_rate, evenness, onset_s};
      }
    }
  }
  return best;
}

void PersonEstimator::begin_motion() {
  const MotionFit best = fit_motion();
  onset_s_ = best.onset_s;
  filter_ = PersonFilter(belief_, virtual_direction_deg_, path_mm_, noise_);
  filter_.begin(best.log_rate, best.evenness, onset_sd_s,
                std::max(0.05, std::sqrt(noise_.variance_mm2() / std::max(1.0, rested_ / 4.0))));
  filter_s_ = onset_s_;
  motion_ = FingerMotion::moving;
  backlog_ = 0;
  while (backlog_ < count_ - 1 && recent(backlog_).time_s > onset_s_) ++backlog_;
}

bool PersonEstimator::catch_up(const PlateTrace& plate) {
  bool taken = true;
  for (int i = 0; i < max_replayed && backlog_ > 0; ++i) taken = take(recent(--backlog_), plate);
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

bool PersonEstimator::take(const Sample& sample, const PlateTrace& plate) {
  carry_to(sample.time_s, plate);
  const PlaceMm place{sample.place.right_mm - origin_.right_mm, sample.place.away_mm - origin_.away_mm};
  if (motion_ == FingerMotion::paused) {
    take_paused(sample);
    return true;
  }
  const PersonState x = filter_.state();
  const PlaceMm innovation{place.right_mm - x.right_mm - x.noise_right_mm,
                           place.away_mm - x.away_mm - x.noise_away_mm};
  const Progress p = progress(x.evenness, x.phase);
  const double speed_mm_s = path_mm_ * exponential(x.log_rate) * p.rate;
  const double nis = filter_.observe(place.right_mm, place.away_mm, gate);
  if (nis <= gate) {
    outliers_ = 0;
    fit_.nis += fit_share * (std::min(nis, fit_cap) - fit_.nis);
    const double product =
        innovation.right_mm * last_innovation_.right_mm + innovation.away_mm * last_innovation_.away_mm;
    const double size = 0.5 * (square(innovation.right_mm) + square(innovation.away_mm) +
                               square(last_innovation_.right_mm) + square(last_innovation_.away_mm));
    // Below the noise a deviation from the model is no misfit, however steady.
    const double min_mm2 = noise_floor_share * noise_.variance_mm2();
    fit_.correlation += fit_share * (product / std::max(size, min_mm2) - fit_.correlation);
    last_innovation_ = innovation;
  }
  PlaceMm still{};
  if (backlog_ == 0 && nis > 6.0 && speed_mm_s > min_pausing_speed_mm_s && stands_still(still)) {
    motion_ = FingerMotion::paused;
    pause_ = still;
    filter_.place_at(still.right_mm - origin_.right_mm, still.away_mm - origin_.away_mm);
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
void PersonEstimator::take_paused(const Sample& sample) {
  const PlaceMm place{sample.place.right_mm - origin_.right_mm, sample.place.away_mm - origin_.away_mm};
  if (lifted_) {
    lifted_ = false;
    filter_.place_at(place.right_mm, place.away_mm);
    pause_ = sample.place;
    outliers_ = 0;
    return;
  }
  const bool away = square_distance(sample.place, pause_) > square(3.5) * noise_.variance_mm2();
  outliers_ = away ? outliers_ + 1 : 0;
  filter_.observe(place.right_mm, place.away_mm, gate);
  if (outliers_ < 3) return;
  motion_ = FingerMotion::moving;
  filter_.loosen_clock(pause_clock_sd_s);
  outliers_ = 0;
}

// The last samples go nowhere: their trend is within the noise.
bool PersonEstimator::stands_still(PlaceMm& where) const {
  if (count_ < still_samples) return false;
  where = mean_of_last(still_samples);
  double moment_right = 0.0;
  double moment_away = 0.0;
  double spread = 0.0;
  for (int i = 0; i < still_samples; ++i) {
    const double centred = 0.5 * (still_samples - 1) - i;
    moment_right += centred * recent(i).place.right_mm;
    moment_away += centred * recent(i).place.away_mm;
    spread += centred * centred;
  }
  const double trend_mm =
      std::sqrt(square(moment_right) + square(moment_away)) / spread * (still_samples - 1);
  return trend_mm < 2.5 * std::sqrt(noise_.variance_mm2());
}

}  // namespace hrt
