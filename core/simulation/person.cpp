#include "core/simulation/person.h"

#include <algorithm>
#include <cmath>

#include "core/math/elementary.h"
#include "core/paper/participant.h"
#include "core/simulation/minimum_jerk.h"

namespace hrt {
namespace {

constexpr double tick_s = 0.001;
constexpr double min_felt_speed_mm_s = 0.5;
constexpr int correction_ms = 250;

// Time in motion at `time_s`, for a motion that pauses at `at_s` for `rest_s`.
double time_without_rest(double time_s, double at_s, double rest_s) {
  return time_s <= at_s ? time_s : std::max(at_s, time_s - rest_s);
}

double with_pauses_s(const Person& person) {
  switch (person.pace) {
    case Pace::stop_and_go:
    case Pace::pause:
      return person.duration_s + 0.6;
    case Pace::reversal:
      return person.duration_s * 1.4;
    default:
      return person.duration_s;
  }
}

}  // namespace

double felt_shift_deg(const SimulatedIllusion& illusion, double offset_deg) {
  const double t = wrap_deg(offset_deg, 180.0);
  const double w = illusion.tactile_weight;
  const double scale = illusion.scale_deg;
  switch (illusion.family) {
    case IllusionFamily::linear:
      return w * t;
    case IllusionFamily::saturating:
      return w * std::clamp(t, -scale, scale);
    case IllusionFamily::sine:
      return w * scale * sin_deg(2.0 * t);
    case IllusionFamily::tanh:
      return w * scale * hyperbolic_tangent(t / scale);
    case IllusionFamily::dead_band:
      return w * std::copysign(std::max(0.0, std::abs(t) - scale), t);
    case IllusionFamily::unequal:
      return t > 0.0 ? w * t : 0.5 * w * t;
    case IllusionFamily::peaked:
      return w * std::copysign(std::min(std::abs(t), scale * (90.0 - std::abs(t)) / (90.0 - scale)), t);
  }
  return 0.0;
}

double mean_felt_shift_deg(const Person& person, double speed_mm_s, double offset_deg) {
  const double shift_deg = felt_shift_deg(person.illusion, offset_deg);
  if (person.steering != Steering::crossings) return shift_deg;
  // The shift is renewed at each ridge and decays until the next one.
  const double between_s = ridge_spacing_mm / (speed_mm_s * std::max(std::abs(cos_deg(offset_deg)), 1e-6));
  return shift_deg * touch_memory_s / between_s * (1.0 - exponential(-between_s / touch_memory_s));
}

double max_shift_deg(const Person& person, double speed_mm_s, double bound_deg, double sign) {
  double max = 0.0;
  for (int half = 0; half <= static_cast<int>(2.0 * bound_deg); ++half) {
    const double shift_deg = mean_felt_shift_deg(person, speed_mm_s, std::copysign(0.5 * half, sign));
    max = std::max(max, std::copysign(1.0, sign) * shift_deg);
  }
  return max;
}

double max_shift_deg(const SimulatedIllusion& illusion, double bound_deg, double sign) {
  return max_shift_deg({.illusion = illusion}, 0.0, bound_deg, sign);
}

SlidingPerson::SlidingPerson(const Person& person, const PlatePoint& start, double virtual_direction_deg,
                             double distance_mm, Draws draws)
    : person_(person),
      virtual_direction_deg_(virtual_direction_deg),
      distance_mm_(distance_mm * person.path_scale),
      duration_with_pauses_s_(with_pauses_s(person)),
      virtual_place_(point_ahead(start, virtual_direction_deg, distance_mm_)),
      draws_(draws),
      position_(start),
      felt_position_(start),
      delay_ms_(std::clamp(static_cast<int>(std::lround(person.delay_s / tick_s)), 0, history_size - 1)),
      noise_sd_deg_(std::sqrt(person.noise_deg2_per_s * tick_s)),
      direction_deg_(person.start_direction_deg),
      felt_deg_(person.start_direction_deg),
      goal_deg_(virtual_direction_deg + person.bias_deg + person.habit_deg) {
  draw_reach();
}

void SlidingPerson::draw_reach() {
  if (person_.scatter_deg > 0.0) {
    person_.bias_deg += person_.scatter_deg * draws_.normal();
    goal_deg_ = virtual_direction_deg_ + person_.bias_deg + person_.habit_deg;
  }
  if (person_.own_path.any()) {
    if (const auto& reaches = person_.own_path.recorded)
      recorded_ = (*reaches)[static_cast<std::size_t>(draws_.uniform() * static_cast<double>(reaches->size()))];
    else
      shape_ = draw_shape(person_.own_path, draws_);
    own_deg_ = own_direction_deg(0.0);
    direction_deg_ += own_deg_;
    felt_deg_ += own_deg_;
    goal_deg_ += own_deg_;
  }
  if (person_.pace == Pace::recorded) {
    pace_ = draw_pace(person_.own_path.log_duration_sd, draws_);
    duration_with_pauses_s_ = person_.duration_s * pace_.time_scale * (recorded_ ? 1.0 : recorded_tail_scale);
  }
  if (person_.pace != Pace::submovements) return;
  const double first = 0.5 + 0.35 * draws_.uniform();
  parts_[0] = {0.4 + 0.25 * draws_.uniform(), first};
  parts_[1] = {0.75 + 0.1 * draws_.uniform(), first + (1.0 - first) * (0.6 + 0.3 * draws_.uniform())};
  parts_[2] = {1.0, 1.0};
}

double SlidingPerson::own_direction_deg(double path_fraction) const {
  if (recorded_) return interpolated(recorded_->direction_deg, path_fraction);
  return person_.own_path.any() ? hrt::own_direction_deg(person_.own_path, shape_, path_fraction) : 0.0;
}

double SlidingPerson::progress(double time_s) const {
  const double d = person_.duration_s;
  switch (person_.pace) {
    case Pace::minimum_jerk:
      return minimum_jerk(time_s / d);
    case Pace::even:
      return std::clamp(time_s / d, 0.0, 1.0);
    case Pace::skewed: {
      const double u = std::clamp(time_s / d, 0.0, 1.0);
      return minimum_jerk(u * (1.0 + 0.4 * (1.0 - u)));
    }
    case Pace::stop_and_go:
      return minimum_jerk(time_without_rest(time_without_rest(time_s, 0.35 * d, 0.3), 0.7 * d, 0.3) / d);
    case Pace::pause:
      return minimum_jerk(time_without_rest(time_s, 0.5 * d, 0.6) / d);
    case Pace::two_parts:
      return 0.6 * minimum_jerk(time_s / (0.55 * d)) + 0.4 * minimum_jerk((time_s - 0.55 * d) / (0.45 * d));
    case Pace::submovements: {
      double share = 0.0;
      Part begun{0.0, 0.0};
      for (const Part& part : parts_) {
        share += (part.share - begun.share) * minimum_jerk((time_s / d - begun.time) / (part.time - begun.time));
        begun = part;
      }
      return share;
    }
    case Pace::recorded:
      return recorded_ ? interpolated(recorded_->path_fraction, time_s / duration_with_pauses_s_)
                       : pace_.path_fraction(time_s / duration_with_pauses_s_);
    case Pace::reversal:
      return 1.1 * minimum_jerk(time_s / d) - 0.1 * minimum_jerk((time_s - d) / (0.4 * d));
  }
  return 0.0;
}

void SlidingPerson::retarget(const PlatePoint& place) {
  virtual_place_ = place;
  answers_in_ms_ = static_cast<int>(reaction_s / tick_s);
}

void SlidingPerson::answer() {
  const double turn_deg = bearing_deg(felt_position_, virtual_place_) - virtual_direction_deg_;
  virtual_direction_deg_ += wrap_deg(turn_deg, 360.0);
  const double left_mm = person_.path_scale * hrt::distance_mm(felt_position_, virtual_place_);
  const double left = 1.0 - path_fraction_;
  distance_mm_ = left > 0.1 ? left_mm / left : left_mm;
  if (left > 0.1) return;
  millisecond_ = rested_ms_ = 0;
  time_s_ = path_fraction_ = 0.0;
  done_ = false;
}

void SlidingPerson::advance(double plate_orientation_deg) {
  if (answers_in_ms_ > 0 && --answers_in_ms_ == 0) answer();
  if (done_) return;
  time_s_ = ++millisecond_ / 1000.0;
  const double s = progress(time_s_);
  const double travel_mm = distance_mm_ * (s - path_fraction_);
  path_fraction_ = s;
  speed_mm_s_ = travel_mm / tick_s;
  const double own_deg = own_direction_deg(s);
  if (!person_.own_path.lags) direction_deg_ += own_deg - own_deg_;
  own_deg_ = own_deg;
  const double motion_deg = move(travel_mm);
  felt_deg_ = motion_deg + person_.own_bias_deg + felt_shift_deg(plate_orientation_deg - motion_deg, travel_mm);

  goal_deg_ = virtual_direction_deg_ + person_.bias_deg + person_.habit_deg * (1.0 - 2.0 * s) + own_deg_;
  const SinCos felt = sin_cos_deg(felt_deg_);
  felt_position_.right_mm -= travel_mm * felt.sine;
  felt_position_.away_mm += travel_mm * felt.cosine;
  if (seeks_place() && hrt::distance_mm(felt_position_, virtual_place_) > 0.15 * distance_mm_) {
    goal_deg_ += bearing_deg(felt_position_, virtual_place_) - virtual_direction_deg_;
  }
  steer(motion_deg);
  done_ = time_s_ >= duration_with_pauses_s_ + (is_arm() ? 0.25 : 0.0);
}

// Moves the finger along the present direction, or pulls an arm in that direction. Returns the direction of the motion.
double SlidingPerson::move(double travel_mm) {
  const auto [sine, cosine] = sin_cos_deg(direction_deg_);
  if (!is_arm()) {
    position_.right_mm -= travel_mm * sine;
    position_.away_mm += travel_mm * cosine;
    return direction_deg_;
  }
  constexpr double damping_kg_s = 20.0;
  const double wanted_right_mn = damping_kg_s * (-speed_mm_s_ * sine - velocity_right_mm_s_);
  const double wanted_away_mn = damping_kg_s * (speed_mm_s_ * cosine - velocity_away_mm_s_);
  force_right_mn_ += (wanted_right_mn - force_right_mn_) * tick_s / person_.muscle_s;
  force_away_mn_ += (wanted_away_mn - force_away_mn_) * tick_s / person_.muscle_s;
  velocity_right_mm_s_ += force_right_mn_ / person_.mass_kg * tick_s;
  velocity_away_mm_s_ += force_away_mn_ / person_.mass_kg * tick_s;
  position_.right_mm += velocity_right_mm_s_ * tick_s;
  position_.away_mm += velocity_away_mm_s_ * tick_s;
  const double speed =
      std::sqrt(velocity_right_mm_s_ * velocity_right_mm_s_ + velocity_away_mm_s_ * velocity_away_mm_s_);
  return speed > 2.0 ? atan2_deg(-velocity_right_mm_s_, velocity_away_mm_s_) : direction_deg_;
}

double SlidingPerson::felt_shift_deg(double offset_deg, double travel_mm) {
  SimulatedIllusion illusion = person_.illusion;
  if (person_.weight_drift != 0.0)
    illusion.tactile_weight += person_.weight_drift * (time_s_ / duration_with_pauses_s_);
  illusion.tactile_weight = std::clamp(illusion.tactile_weight, 0.01, 0.49);
  const double shift_deg = hrt::felt_shift_deg(illusion, offset_deg);
  if (person_.touch_s > 0.0) return touched_shift_deg_ += (shift_deg - touched_shift_deg_) * tick_s / person_.touch_s;
  if (person_.steering != Steering::crossings) return shift_deg;
  ridge_travel_mm_ += std::abs(travel_mm * cos_deg(offset_deg));
  crossed_shift_deg_ -= crossed_shift_deg_ * tick_s / touch_memory_s;
  if (ridge_travel_mm_ >= ridge_spacing_mm) {
    ridge_travel_mm_ -= ridge_spacing_mm;
    crossed_shift_deg_ = shift_deg;
  }
  return crossed_shift_deg_;
}

void SlidingPerson::steer(double motion_deg) {
  const double noise_deg = noise_sd_deg_ * draws_.normal();
  const bool predicts = person_.steering == Steering::predictive;
  // A predictive person knows the direction of motion without delay: only the shift and own_bias_deg are delayed. An
  // own path that the hand follows without delay causes neither an error nor a correction.
  const double followed_deg = person_.own_path.lags ? 0.0 : own_deg_;
  const double answered_deg = (predicts ? felt_deg_ - motion_deg : felt_deg_) - followed_deg;
  // At rest, no direction of motion is perceived, and the person does not steer.
  if (std::abs(speed_mm_s_) < min_felt_speed_mm_s) {
    rested_ms_ = millisecond_;
    felt_at_rest_deg_ = answered_deg;
    return;
  }
  if (person_.steering == Steering::steps) {
    if (millisecond_ % 100 != 0) return;
    const Participant participant;
    const auto [gain, variance_deg2] = next_gain(participant, perceived_variance_deg2_);
    perceived_variance_deg2_ = variance_deg2;
    direction_deg_ +=
        -gain * (felt_deg_ - goal_deg_) + std::sqrt(participant.motor_variance_deg2 + variance_deg2) * draws_.normal();
    return;
  }
  felt_history_[static_cast<std::size_t>(millisecond_ % history_size)] = answered_deg;
  if (millisecond_ > delay_ms_) {
    const int felt_ms = millisecond_ - delay_ms_;
    double delayed =
        felt_ms <= rested_ms_ ? felt_at_rest_deg_ : felt_history_[static_cast<std::size_t>(felt_ms % history_size)];
    if (predicts) delayed += direction_deg_;
    const double k = person_.gain_per_s;
    double answered = k * tick_s;
    if (person_.steering == Steering::corrections)
      answered = millisecond_ % correction_ms == 0 ? 1.0 - exponential(-k * correction_ms * tick_s) : 0.0;
    direction_deg_ -= answered * (delayed - (goal_deg_ - followed_deg));
  }
  direction_deg_ += noise_deg;
}

}  // namespace hrt
