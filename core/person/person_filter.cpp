#include "core/person/person_filter.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/math/linear_algebra.h"

namespace hrt {
namespace {

constexpr double min_path_mm = 1.0;

// e^(-step / constant) to second order, for the short steps of a motion.
double kept(double step, double constant) { return (2.0 * constant - step) / (2.0 * constant + step); }

}  // namespace

// One step of the motion, and its derivatives.
struct PersonFilter::Step {
  double travel_mm, sine, cosine, turn_deg, phase;
  double wander_kept, noise_kept, displacement_kept;  // factors of decay in the step
  FeltShift felt;
  double travel_by_phase, travel_by_evenness;
  double own_by_habit, own_by_phase, own_by_displacement;
  double displacement_by_travel;
  double turn_by_felt, turn_by_steered, turn_by_own, turn_by_gain;
};

PersonFilter::PersonFilter(const PersonBelief& belief, double virtual_direction_deg, double path_mm,
                           const TrackerNoise& noise, const Tuning& tuning)
    : tuning_(tuning), virtual_direction_deg_(virtual_direction_deg), path_mm_(path_mm), noise_(noise) {
  mean_.setZero();
  covariance_.setZero();
  mean_.head<X::traits>() = belief.mean;
  covariance_.topLeftCorner<X::traits, X::traits>() = belief.covariance;
  keep_in_range();
  covariance_(X::bias, X::bias) += square(mean_(X::scatter));
  covariance_(X::habit, X::habit) += square(habit_scatter_deg(belief, tuning_));
  wander_deg2_ = exponential(2.0 * mean_(X::log_wander));
  covariance_(X::wander, X::wander) = wander_deg2_;
  covariance_(X::noise_right, X::noise_right) = covariance_(X::noise_away, X::noise_away) =
      square(noise_.correlated_mm);
  begin(mean_(X::log_rate), 0.0, 0.0);
}

void PersonFilter::begin(double log_rate, double onset_sd_s, double place_sd_mm) {
  mean_(X::log_rate) = log_rate;
  keep_in_range();
  covariance_(X::phase, X::phase) = square(rate_ * onset_sd_s);
  covariance_(X::right, X::right) = covariance_(X::away, X::away) = square(place_sd_mm);
  // Initial direction psi = h V + B, where h is random in each reach.
  mean_(X::steered) = tuning_.first_direction * virtual_direction_deg_ + mean_(X::bias);
  covariance_.row(X::steered) = covariance_.row(X::bias);
  covariance_.col(X::steered) = covariance_.col(X::bias);
  covariance_(X::steered, X::steered) =
      covariance_(X::bias, X::bias) + square(tuning_.first_direction_sd * virtual_direction_deg_);
}

PersonFilter PersonFilter::with_wander(double change) const {
  PersonFilter other = *this;
  const double scale = exponential(2.0 * change);
  const double habit_deg2 = square(tuning_.habit_scatter) * wander_deg2_;
  other.mean_(X::log_wander) += change;
  other.wander_deg2_ *= scale;
  other.covariance_(X::wander, X::wander) *= scale;
  other.covariance_(X::habit, X::habit) += (scale - 1.0) * habit_deg2;
  return other;
}

// Derivative of o by y, deg/mm.
double PersonFilter::displacement_deg_mm(double path_fraction) const {
  return -deg_per_rad / (path_mm_ * std::max(1.0 - path_fraction, tuning_.min_return_fraction));
}

double PersonFilter::own_deg(double path_fraction, double wander_kept) const {
  return wander_kept * mean_(X::wander) + mean_(X::habit) * (1.0 - 2.0 * path_fraction) +
         displacement_deg_mm(path_fraction) * mean_(X::displacement);
}

double PersonFilter::turn_kept(double seconds) const {
  return unanswered_deg_ == 0.0 ? 1.0 : exponential(-seconds / tuning_.answer_s);
}

double PersonFilter::own_to_come_mm() const {
  const double s = pace(mean_(X::phase)).share;
  return -mean_(X::displacement) - rad_per_deg * mean_(X::habit) * path_mm_ * s * (1.0 - s);
}

double PersonFilter::direction_deg() const { return mean_(X::steered) + own_deg(pace(mean_(X::phase)).share, 1.0); }

Illusion PersonFilter::illusion(double speed_mm_s, double travelled_mm) const {
  return {mean_(X::weight), mean_(X::curve), mean_(X::fading), slowness(speed_mm_s, travelled_mm, tuning_)};
}

// Returns a step over `seconds`, with pace, own path and shift at its middle.
PersonFilter::Step PersonFilter::linearised(double seconds, double felt_plate_deg) const {
  const bool arrived = mean_(X::phase) >= 1.0;
  const Progress middle = pace(mean_(X::phase) + 0.5 * rate_ * seconds);
  const double travel_scale = arrived ? 0.0 : path_mm_ * rate_ * seconds;
  const double travel_mm = travel_scale * middle.rate;

  const double own = own_deg(middle.share, 1.0);
  const FeltShift g =
      felt_shift(illusion(travel_mm / seconds, path_mm_ * middle.share), felt_plate_deg - mean_(X::steered) - own);
  const double k = mean_(X::gain);
  const double felt_error_deg = mean_(X::steered) + g.shift_deg - goal_deg();
  const SteeringStep steering = steer(k, felt_error_deg, g.by_offset, seconds, tuning_.max_slope);
  const SinCos way = sin_cos_deg(mean_(X::steered) + own + 0.5 * steering.turn_deg);
  const double by_displacement = displacement_deg_mm(middle.share);
  const double return_deg = by_displacement * mean_(X::displacement);
  return {.travel_mm = travel_mm,
          .sine = way.sine,
          .cosine = way.cosine,
          .turn_deg = steering.turn_deg,
          .phase = rate_ * seconds,
          .wander_kept = kept(rate_ * seconds, tuning_.wander_phase),
          .noise_kept = kept(seconds, noise_.correlation_s),
          .displacement_kept = std::max(0.0, 1.0 + rad_per_deg * travel_mm * by_displacement),
          .felt = g,
          .travel_by_phase = travel_scale * middle.acceleration,
          .travel_by_evenness = travel_scale * middle.by_evenness,
          .own_by_habit = 1.0 - 2.0 * middle.share,
          .own_by_phase = middle.rate * (return_deg / std::max(1.0 - middle.share, tuning_.min_return_fraction) -
                                         2.0 * mean_(X::habit)),
          .own_by_displacement = by_displacement,
          .displacement_by_travel = rad_per_deg * (mean_(X::wander) + return_deg),
          .turn_by_felt = k * seconds,
          .turn_by_steered = -steering.decay_per_s * seconds,
          .turn_by_own = (k - steering.decay_per_s) * seconds,
          .turn_by_gain = -felt_error_deg * seconds};
}

void PersonFilter::move(double seconds, double felt_plate_deg) {
  const Step f = linearised(seconds, felt_plate_deg);
  // P becomes F P F^T (F: Jacobian of the step), computed as (P F^T)^T F^T with one function for both products. Traits
  // do not change in a step. Traits from felt_traits on are taken as independent of all other states.
  constexpr int motion = X::count - X::traits;
  // Multiplies a row by F^T. Each statement uses only elements that are not yet changed.
  const auto transform = [&f](auto&& row) {
    const double along =
        f.travel_by_phase * row(X::phase) + f.travel_mm * row(X::log_rate) + f.travel_by_evenness * row(X::evenness);
    const double own = row(X::wander) + f.own_by_habit * row(X::habit) + f.own_by_displacement * row(X::displacement) +
                       f.own_by_phase * row(X::phase);
    const double across = f.travel_mm * rad_per_deg * (row(X::steered) + own);
    row(X::right) -= f.sine * along + f.cosine * across;
    row(X::away) += f.cosine * along - f.sine * across;
    const double shift =
        f.felt.by_weight * row(X::weight) + f.felt.by_curve * row(X::curve) + f.felt.by_fading * row(X::fading);
    row(X::steered) += f.turn_by_steered * row(X::steered) + f.turn_by_own * own + f.turn_by_gain * row(X::gain) +
                       f.turn_by_felt * (row(X::bias) - shift);
    row(X::displacement) = f.displacement_kept * row(X::displacement) + f.travel_mm * rad_per_deg * row(X::wander) +
                           f.displacement_by_travel * along;
    row(X::phase) += f.phase * row(X::log_rate);
    row(X::wander) *= f.wander_kept;
    row(X::noise_right) *= f.noise_kept;
    row(X::noise_away) *= f.noise_kept;
  };
  for (int i = 0; i < X::felt_traits; ++i) transform(covariance_.row(i));
  for (int i = X::traits; i < X::count; ++i) transform(covariance_.row(i));
  covariance_.bottomRightCorner<motion, motion>().transposeInPlace();
  covariance_.block<motion, X::felt_traits>(X::traits, 0) =
      covariance_.block<X::felt_traits, motion>(0, X::traits).transpose();
  for (int i = X::traits; i < X::count; ++i) transform(covariance_.row(i));

  mean_(X::right) -= f.travel_mm * f.sine;
  mean_(X::away) += f.travel_mm * f.cosine;
  mean_(X::steered) += f.turn_deg;
  mean_(X::phase) = std::min(mean_(X::phase) + f.phase, 1.0);
  mean_(X::displacement) = f.displacement_kept * mean_(X::displacement) + f.travel_mm * rad_per_deg * mean_(X::wander);
  mean_(X::wander) *= f.wander_kept;
  mean_(X::noise_right) *= f.noise_kept;
  mean_(X::noise_away) *= f.noise_kept;

  // The process noise of random walks, and of correlated quantities (of stationary variance).
  const auto add = [this](X::Index index, double variance) { covariance_(index, index) += variance; };
  add(X::steered, tuning_.direction_density_deg2_s * seconds);
  add(X::log_rate, tuning_.log_rate_density_s * seconds);
  const double along_mm2 = tuning_.speed_variance_s * square(f.travel_mm) / seconds;
  add(X::right, tuning_.place_density_mm2_s * seconds + along_mm2 * square(f.sine));
  add(X::away, tuning_.place_density_mm2_s * seconds + along_mm2 * square(f.cosine));
  add(X::wander, (1.0 - square(f.wander_kept)) * wander_deg2_);
  const double fresh_mm2 = (1.0 - square(f.noise_kept)) * square(noise_.correlated_mm);
  add(X::noise_right, fresh_mm2);
  add(X::noise_away, fresh_mm2);
  unanswered_deg_ *= turn_kept(seconds);
}

void PersonFilter::rest(double seconds) {
  const double kept = exponential(-seconds / noise_.correlation_s);
  for (const X::Index noise : {X::noise_right, X::noise_away}) {
    mean_(noise) *= kept;
    covariance_.row(noise) *= kept;
    covariance_.col(noise) *= kept;
    covariance_(noise, noise) += (1.0 - square(kept)) * square(noise_.correlated_mm);
  }
  covariance_(X::right, X::right) += tuning_.resting_density_mm2_s * seconds;
  covariance_(X::away, X::away) += tuning_.resting_density_mm2_s * seconds;
}

PersonFilter::Innovation PersonFilter::innovation(const PlatePoint& position) const {
  Innovation result;
  result.off_mm = {position.right_mm - mean_(X::right) - mean_(X::noise_right),
                   position.away_mm - mean_(X::away) - mean_(X::noise_away)};
  for (int i = 0; i < X::count; ++i) {
    result.cross(i, 0) = covariance_(i, X::right) + covariance_(i, X::noise_right);
    result.cross(i, 1) = covariance_(i, X::away) + covariance_(i, X::noise_away);
  }
  const double white_mm2 = square(noise_.white_mm);
  const double right_mm2 = result.cross(X::right, 0) + result.cross(X::noise_right, 0) + white_mm2;
  const double away_mm2 = result.cross(X::away, 1) + result.cross(X::noise_away, 1) + white_mm2;
  const double both_mm2 = result.cross(X::away, 0) + result.cross(X::noise_away, 0);
  result.information << away_mm2, -both_mm2, -both_mm2, right_mm2;
  result.information /= right_mm2 * away_mm2 - both_mm2 * both_mm2;
  const Eigen::Vector2d off(result.off_mm.right_mm, result.off_mm.away_mm);
  result.nis = off.dot(result.information * off);
  return result;
}

void PersonFilter::correct(const Innovation& innovation) {
  const State right = innovation.cross.col(0), away = innovation.cross.col(1);
  const Eigen::Matrix2d& information = innovation.information;
  State right_gain, away_gain;
  for (int i = 0; i < X::count; ++i) {
    right_gain(i) = right(i) * information(0, 0) + away(i) * information(1, 0);
    away_gain(i) = right(i) * information(0, 1) + away(i) * information(1, 1);
    mean_(i) += right_gain(i) * innovation.off_mm.right_mm + away_gain(i) * innovation.off_mm.away_mm;
  }
  const auto correct_column = [&](int j) {
    for (int i = 0; i < X::count; ++i) covariance_(i, j) -= right(i) * right_gain(j) + away(i) * away_gain(j);
  };
  for (int j = 0; j < X::felt_traits; ++j) correct_column(j);
  for (int j = X::traits; j < X::count; ++j) correct_column(j);
  keep_in_range();
}

void PersonFilter::place_at(const PlatePoint& position) {
  for (const X::Index index : {X::right, X::away}) set_independent(covariance_, index, noise_.variance_mm2());
  for (const X::Index index : {X::noise_right, X::noise_away}) {
    set_independent(covariance_, index, square(noise_.correlated_mm));
    mean_(index) = 0.0;
  }
  mean_(X::right) = position.right_mm;
  mean_(X::away) = position.away_mm;
}

void PersonFilter::retarget(double virtual_direction_deg, double longer_mm, bool answered) {
  const double turn_deg = virtual_direction_deg_ - virtual_direction_deg;
  // Until the person responds, the motion continues towards the former target.
  if (!answered) unanswered_deg_ += turn_deg;
  covariance_(X::steered, X::steered) += square(tuning_.turn_sd_fraction * turn_deg);
  virtual_direction_deg_ = virtual_direction_deg;

  const double left = 1.0 - pace(mean_(X::phase)).share;
  const double left_mm = std::max(path_mm_ * left + longer_mm, min_path_mm);
  if (left_mm <= tuning_.max_stretch * path_mm_ * left) {  // the motion continues over a rescaled path
    const double stretch = left_mm / (path_mm_ * left);
    covariance_(X::log_rate, X::log_rate) += square(stretch - 1.0);
    path_mm_ *= stretch;
    return;
  }
  // The person begins another motion.
  path_mm_ = std::max(path_mm_, left_mm);
  mean_(X::phase) = phase_at(mean_(X::evenness), 1.0 - left_mm / path_mm_, tuning_.pace_skew);
  add_phase_sd(tuning_.new_motion_sd_s);
}

void PersonFilter::add_phase_sd(double seconds) { covariance_(X::phase, X::phase) += square(rate_ * seconds); }

double PersonFilter::sd(X::Index index) const { return std::sqrt(std::max(0.0, covariance_(index, index))); }

double PersonFilter::position_variance_mm2(double right, double away) const {
  return square(right) * covariance_(X::right, X::right) + square(away) * covariance_(X::away, X::away) +
         2.0 * right * away * covariance_(X::right, X::away);
}

PersonBelief PersonFilter::belief() const {
  return {.mean = mean_.head<X::traits>(), .covariance = covariance_.topLeftCorner<X::traits, X::traits>()};
}

void PersonFilter::keep_in_range() {
  for (const StateVariable& row : person_state) mean_(row.index) = std::clamp(mean_(row.index), row.min, row.max);
  rate_ = exponential(mean_(X::log_rate));
}

}  // namespace hrt
