#include "core/person/person_filter.h"

#include <algorithm>
#include <cmath>

#include "core/math/exponential.h"
#include "core/math/trigonometry.h"
#include "core/person/steering.h"
#include "core/reach/pace.h"

namespace hrt {
namespace {

// Random walks, per second.
constexpr double direction_density_deg2_s = 14.0;
constexpr double log_rate_density_s = 0.07;
constexpr double place_density_mm2_s = 0.018;
constexpr double place_share_s = 4e-4;  // of the speed squared: the pace is no law
// Of the fast part of the goal.
constexpr double wander_sd_deg = 0.75;
constexpr double resting_density_mm2_s = 0.5;
// Of a target that moves: the share of the turn that is uncertain, how much longer one motion gets,
// and when another one begins.
constexpr double turn_sd_share = 0.5;
constexpr double max_stretch = 1.5;
constexpr double min_path_mm = 1.0;
constexpr double another_motion_sd_s = 0.15;

// Those below are states; scatter only widens the bias of a reach.
constexpr int states = PersonTrait::scatter;
constexpr PersonFilter::Index state_of[states] = {PersonFilter::weight,  PersonFilter::curve,    PersonFilter::gain,
                                                  PersonFilter::bias,    PersonFilter::habit,    PersonFilter::evenness,
                                                  PersonFilter::heading, PersonFilter::log_rate, PersonFilter::fading};

// F P F', as (P F')' F': columns lie side by side. A step leaves the person's traits as they are.
void carry(PersonFilter::Covariance& covariance, const PersonFilter::Step& f) {
  using X = PersonFilter;
  // A row times F'. Each line uses only what is not yet changed.
  const auto transform = [&](auto&& row) {
    const double along =
        f.travel_by_phase * row(X::phase) + f.travel_mm * row(X::log_rate) + f.travel_by_evenness * row(X::evenness);
    const double across = f.travel_mm * rad_per_deg * row(X::direction);
    row(X::right) -= f.sine * along + f.cosine * across;
    row(X::away) += f.cosine * along - f.sine * across;
    const double goal =
        row(X::bias) + row(X::wander) + f.goal_by_habit * row(X::habit) + f.goal_by_phase * row(X::phase);
    const double shift =
        f.felt.by_weight * row(X::weight) + f.felt.by_curve * row(X::curve) + f.felt.by_fading * row(X::fading);
    row(X::direction) +=
        f.turn_by_direction * row(X::direction) + f.turn_by_gain * row(X::gain) + f.turn_by_felt * (goal - shift);
    row(X::phase) += f.phase * row(X::log_rate);
    row(X::wander) *= f.wander_kept;
    row(X::noise_right) *= f.noise_kept;
    row(X::noise_away) *= f.noise_kept;
  };
  for (int i = 0; i < X::size; ++i) transform(covariance.row(i));
  covariance.topLeftCorner<X::weight, X::weight>().transposeInPlace();
  covariance.topRightCorner<X::weight, X::size - X::weight>() =
      covariance.bottomLeftCorner<X::size - X::weight, X::weight>().transpose();
  for (int i = 0; i < X::weight; ++i) transform(covariance.row(i));
}

// Two coordinates have been measured, of which these are the rows of P and the variances.
void correct(PersonFilter::Covariance& covariance, const PersonFilter::State& by_right, double right_mm2,
             const PersonFilter::State& by_away, double away_mm2) {
  // Copies, which writing into P can't change. NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
  const PersonFilter::State right = by_right, away = by_away;
  const PersonFilter::State gain_right = right / right_mm2, gain_away = away / away_mm2;
  for (int j = 0; j < PersonFilter::size; ++j)
    for (int i = 0; i < PersonFilter::size; ++i) covariance(i, j) -= right(i) * gain_right(j) + away(i) * gain_away(j);
}

}  // namespace

PersonFilter::PersonFilter(const PersonBelief& belief, double virtual_direction_deg, double path_mm,
                           const TrackerNoise& noise)
    : virtual_direction_deg_(virtual_direction_deg),
      scatter_deg_(belief.mean(PersonTrait::scatter)),
      scatter_variance_deg2_(belief.covariance(PersonTrait::scatter, PersonTrait::scatter)),
      path_mm_(path_mm),
      noise_(noise) {
  state_.setZero();
  covariance_.setZero();
  for (int i = 0; i < states; ++i) {
    state_(state_of[i]) = belief.mean(i);
    for (int j = 0; j < states; ++j) covariance_(state_of[i], state_of[j]) = belief.covariance(i, j);
  }
  keep_in_range();
  covariance_(bias, bias) += scatter_deg_ * scatter_deg_;
  covariance_(wander, wander) = wander_sd_deg * wander_sd_deg;
  covariance_(noise_right, noise_right) = covariance_(noise_away, noise_away) =
      noise_.correlated_mm * noise_.correlated_mm;
  begin(state_(log_rate), state_(evenness), 0.0, 0.0);
}

void PersonFilter::begin(double motion_log_rate, double motion_evenness, double onset_sd_s, double place_sd_mm) {
  state_(log_rate) = motion_log_rate;
  state_(evenness) = motion_evenness;
  keep_in_range();
  const double phase_sd = rate_ * onset_sd_s;
  covariance_(phase, phase) = phase_sd * phase_sd;
  covariance_(right, right) = covariance_(away, away) = place_sd_mm * place_sd_mm;
  const double goal = now().goal_deg;
  state_(direction) = state_(heading) * goal;
  // direction = heading G, and G = V + d + dr + c at the start.
  const double share = state_(heading);
  covariance_.row(direction) = goal * covariance_.row(heading) +
                               share * (covariance_.row(bias) + covariance_.row(wander) + covariance_.row(habit));
  covariance_.col(direction) = goal * covariance_.col(heading) +
                               share * (covariance_.col(bias) + covariance_.col(wander) + covariance_.col(habit));
}

double PersonFilter::goal_deg(double share, double wander_deg) const {
  return virtual_direction_deg_ + state_(bias) + wander_deg + state_(habit) * (1.0 - 2.0 * share);
}

PersonNow PersonFilter::now() const {
  const Progress pace = progress(state_(evenness), state_(phase));
  const double speed_mm_s = mean_speed_mm_s() * pace.rate;
  return {.mean = state(),
          .pace = pace,
          .speed_mm_s = speed_mm_s,
          .goal_deg = goal_deg(pace.share, state_(wander)),
          .illusion = illusion(speed_mm_s, path_mm_ * pace.share)};
}

Illusion PersonFilter::illusion(double speed_mm_s, double travelled_mm) const {
  return {.weight = state_(weight),
          .curve = state_(curve),
          .fading = state_(fading),
          .slowness = ridge_slowness(speed_mm_s, travelled_mm)};
}

void PersonFilter::move(double seconds, double felt_plate_deg) {
  const bool arrived = state_(phase) >= 1.0;
  const Progress begun = progress(state_(evenness), state_(phase));
  const Progress middle = progress(state_(evenness), state_(phase) + 0.5 * rate_ * seconds);
  const double travel_mm = arrived ? 0.0 : path_mm_ * rate_ * middle.rate * seconds;

  const FeltShift g =
      felt_shift(illusion(travel_mm / seconds, path_mm_ * begun.share), felt_plate_deg - state_(direction));
  const double k = state_(gain);
  const SteeringStep steering = steer(k, state_(direction), g, goal_deg(begun.share, state_(wander)), seconds);
  const SinCos way = sin_cos_deg(state_(direction) + 0.5 * steering.turn_deg);
  const double travel_scale = arrived ? 0.0 : path_mm_ * rate_ * seconds;
  const Step step{.seconds = seconds,
                  .travel_mm = travel_mm,
                  .sine = way.sine,
                  .cosine = way.cosine,
                  .turn_deg = steering.turn_deg,
                  .phase = rate_ * seconds,
                  .wander_kept = exponential(-seconds / wander_s),
                  .noise_kept = exponential(-seconds / noise_.correlation_s),
                  .felt = g,
                  .travel_by_phase = travel_scale * begun.acceleration,
                  .travel_by_evenness = travel_scale * begun.by_evenness,
                  .goal_by_habit = 1.0 - 2.0 * begun.share,
                  .goal_by_phase = -2.0 * state_(habit) * begun.rate,
                  .turn_by_felt = k * seconds,
                  .turn_by_direction = -steering.decay_s * seconds,
                  .turn_by_gain = -steering.felt_error_deg * seconds};
  carry(covariance_, step);
  move_state(step);
  add_noise(step);
}

void PersonFilter::move_state(const Step& step) {
  state_(right) -= step.travel_mm * step.sine;
  state_(away) += step.travel_mm * step.cosine;
  state_(direction) += step.turn_deg;
  state_(phase) = std::min(state_(phase) + step.phase, 1.0);
  state_(wander) *= step.wander_kept;
  state_(noise_right) *= step.noise_kept;
  state_(noise_away) *= step.noise_kept;
}

// What the model leaves to chance in a step: random walks, and what is fresh of what decays.
void PersonFilter::add_noise(const Step& step) {
  covariance_(direction, direction) += direction_density_deg2_s * step.seconds;
  covariance_(log_rate, log_rate) += log_rate_density_s * step.seconds;
  const double along_mm2 = place_share_s * step.travel_mm * step.travel_mm / step.seconds;
  covariance_(right, right) += place_density_mm2_s * step.seconds + along_mm2 * step.sine * step.sine;
  covariance_(away, away) += place_density_mm2_s * step.seconds + along_mm2 * step.cosine * step.cosine;
  covariance_(wander, wander) += (1.0 - step.wander_kept * step.wander_kept) * wander_sd_deg * wander_sd_deg;
  const double fresh_mm2 = (1.0 - step.noise_kept * step.noise_kept) * noise_.correlated_mm * noise_.correlated_mm;
  covariance_(noise_right, noise_right) += fresh_mm2;
  covariance_(noise_away, noise_away) += fresh_mm2;
}

void PersonFilter::rest(double seconds) {
  const double kept = exponential(-seconds / noise_.correlation_s);
  for (const Index noise : {noise_right, noise_away}) {
    state_(noise) *= kept;
    covariance_.row(noise) *= kept;
    covariance_.col(noise) *= kept;
    covariance_(noise, noise) += (1.0 - kept * kept) * noise_.correlated_mm * noise_.correlated_mm;
  }
  covariance_(right, right) += resting_density_mm2_s * seconds;
  covariance_(away, away) += resting_density_mm2_s * seconds;
}

double PersonFilter::observe(double right_mm, double away_mm, double gate) {
  const double white_mm2 = noise_.white_mm * noise_.white_mm;
  // One coordinate after the other; the second as it stands after the first.
  const State by_right = covariance_.col(right) + covariance_.col(noise_right);
  const double right_mm2 = by_right(right) + by_right(noise_right) + white_mm2;
  const double off_right_mm = right_mm - state_(right) - state_(noise_right);
  const double shared = (by_right(away) + by_right(noise_away)) / right_mm2;
  const State by_away = covariance_.col(away) + covariance_.col(noise_away) - by_right * shared;
  const double away_mm2 = by_away(away) + by_away(noise_away) + white_mm2;
  const double off_away_mm = away_mm - state_(away) - state_(noise_away) - shared * off_right_mm;
  const double nis = off_right_mm * off_right_mm / right_mm2 + off_away_mm * off_away_mm / away_mm2;
  if (nis > gate) return nis;
  correct(covariance_, by_right, right_mm2, by_away, away_mm2);
  const double per_right = off_right_mm / right_mm2, per_away = off_away_mm / away_mm2;
  for (int i = 0; i < size; ++i) state_(i) += by_right(i) * per_right + by_away(i) * per_away;
  keep_in_range();
  return nis;
}

void PersonFilter::place_at(double right_mm, double away_mm) {
  for (const Index i : {right, away, noise_right, noise_away}) {
    covariance_.row(i).setZero();
    covariance_.col(i).setZero();
    state_(i) = 0.0;
  }
  state_(right) = right_mm;
  state_(away) = away_mm;
  covariance_(noise_right, noise_right) = covariance_(noise_away, noise_away) =
      noise_.correlated_mm * noise_.correlated_mm;
  covariance_(right, right) = covariance_(away, away) = noise_.variance_mm2();
}

void PersonFilter::retarget(double virtual_direction_deg, double longer_mm, bool answered) {
  const double turn_deg = virtual_direction_deg_ - virtual_direction_deg;
  // Until they answer, they go where they went: the goal's fast part is the turn to come.
  if (!answered) state_(wander) += turn_deg;
  covariance_(wander, wander) += turn_sd_share * turn_sd_share * turn_deg * turn_deg;
  virtual_direction_deg_ = virtual_direction_deg;

  const double left = 1.0 - progress(state_(evenness), state_(phase)).share;
  const double left_mm = std::max(path_mm_ * left + longer_mm, min_path_mm);
  if (left_mm <= max_stretch * path_mm_ * left) {  // the same motion, stretched or cut
    const double stretch = left_mm / (path_mm_ * left);
    covariance_(log_rate, log_rate) += (stretch - 1.0) * (stretch - 1.0);
    path_mm_ *= stretch;
    return;
  }
  // Another motion follows.
  path_mm_ = std::max(path_mm_, left_mm);
  state_(phase) = phase_at(state_(evenness), 1.0 - left_mm / path_mm_);
  loosen_clock(another_motion_sd_s);
}

void PersonFilter::loosen_clock(double seconds) {
  const double phases = rate_ * seconds;
  covariance_(phase, phase) += phases * phases;
}

double PersonFilter::place_variance_mm2(double along_right, double along_away) const {
  return along_right * along_right * covariance_(right, right) + along_away * along_away * covariance_(away, away) +
         2.0 * along_right * along_away * covariance_(right, away);
}

double PersonFilter::shift_variance_deg2(const FeltShift& slopes, double by_bias) const {
  const double by[] = {slopes.by_weight, slopes.by_curve, slopes.by_fading, by_bias};
  constexpr Index unknowns[] = {weight, curve, fading, bias};
  double variance = 0.0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) variance += by[i] * by[j] * covariance_(unknowns[i], unknowns[j]);
  return variance;
}

LinearIllusion PersonFilter::linear_illusion() const {
  return hrt::linear_illusion(state_(weight), state_(curve), covariance_(weight, weight), covariance_(weight, curve),
                              covariance_(curve, curve));
}

PersonBelief PersonFilter::belief() const {
  PersonBelief belief;
  belief.covariance.setZero();
  belief.mean(PersonTrait::scatter) = scatter_deg_;
  belief.covariance(PersonTrait::scatter, PersonTrait::scatter) = scatter_variance_deg2_;
  for (int i = 0; i < states; ++i) {
    belief.mean(i) = state_(state_of[i]);
    for (int j = 0; j < states; ++j) belief.covariance(i, j) = covariance_(state_of[i], state_of[j]);
  }
  return belief;
}

void PersonFilter::keep_in_range() {
  for (int i = 0; i < states; ++i)
    state_(state_of[i]) = std::clamp(state_(state_of[i]), person_traits[i].min, person_traits[i].max);
  state_(phase) = std::clamp(state_(phase), 0.0, 1.0);
  rate_ = exponential(state_(log_rate));
}

}  // namespace hrt
