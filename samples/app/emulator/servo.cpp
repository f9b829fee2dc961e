#include "samples/app/emulator/servo.h"

#include <algorithm>
#include <cmath>

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr auto max_step = 500us;
constexpr auto pulse_lasts = 24ms;  // time for which a pulse drives the motor: a period of 20 ms and a margin

}  // namespace

void EmulatedServo::set_goal(std::optional<double> goal_deg, Time now) {
  const std::optional<double> last_deg = pending_goals_.empty() ? goal_deg_ : pending_goals_.back().orientation_deg;
  if (goal_deg == last_deg) return;
  pending_goals_.push_back({now + traits_.dead_time, goal_deg});
}

void EmulatedServo::run_until(Time now) {
  while (now_ < now) {
    const Time step_end = std::min<Time>(now, now_ + max_step);
    const double seconds = std::chrono::duration<double>(step_end - now_).count();
    now_ = step_end;
    for (; !pending_goals_.empty() && pending_goals_.front().takes_effect <= now_; pending_goals_.pop_front())
      goal_deg_ = pending_goals_.front().orientation_deg;
    step(seconds);
  }
}

double EmulatedServo::full_speed_deg_s() const {
  return std::min(limit_deg_s_, traits_.speed_deg_s * supply * (1.0 - traits_.load));
}

void EmulatedServo::step(double seconds) {
  const double error_deg = goal_deg_ ? *goal_deg_ - motor_deg_ : 0.0;
  double wanted_deg_s = 0.0;
  if (!is_jammed && std::abs(error_deg) > traits_.dead_band_deg)
    wanted_deg_s = std::copysign(
        std::min(full_speed_deg_s(), std::sqrt(2.0 * traits_.acceleration_deg_s2 * std::abs(error_deg))), error_deg);
  const double change_deg_s = traits_.acceleration_deg_s2 * seconds;
  speed_deg_s_ += std::clamp(wanted_deg_s - speed_deg_s_, -change_deg_s, change_deg_s);
  // Friction stops a motor that has no goal or is within the dead band.
  if (is_jammed || std::abs(error_deg) <= traits_.dead_band_deg) speed_deg_s_ = 0.0;
  double step_deg = speed_deg_s_ * seconds;
  if (step_deg * error_deg > 0.0 && std::abs(step_deg) > std::abs(error_deg)) {
    step_deg = error_deg;
    speed_deg_s_ = 0.0;
  }
  motor_deg_ = std::clamp(motor_deg_ + step_deg, traits_.lower_stop_deg, traits_.upper_stop_deg);
  const double play_deg = traits_.backlash_deg / 2.0;
  plate_deg_ = std::clamp(plate_deg_, motor_deg_ - play_deg, motor_deg_ + play_deg);
  max_speed_deg_s_ = std::max(max_speed_deg_s_, std::abs(speed_deg_s_));
  max_turn_deg_ = std::max(max_turn_deg_, std::abs(plate_deg_));
}

double EmulatedServo::reading_deg() {
  const double wave = std::sin((bend_waves * plate_deg_ + bend_phase_deg) * 3.14159265358979 / 180.0);
  const double reading_deg = plate_deg_ + slip_deg + bend_deg * wave;
  if (traits_.noise_deg == 0.0) return reading_deg;
  return reading_deg + std::normal_distribution<double>(0.0, traits_.noise_deg)(random_);
}

void HobbyServo::receive_pulse(double width_us, Time now) {
  pulsed_ = now;
  set_goal((width_us - 1500.0) * 180.0 / span_us, now);
}

void HobbyServo::run_until(Time now) {
  if (pulsed_ && now - *pulsed_ > pulse_lasts) {
    EmulatedServo::run_until(*pulsed_ + pulse_lasts);
    set_goal(std::nullopt, *pulsed_ + pulse_lasts);
    pulsed_.reset();
  }
  EmulatedServo::run_until(now);
}

}  // namespace hrt::plate
