#include "core/perception.h"

#include <cmath>

#include "core/trigonometry.h"

namespace hrt {

bool is_valid(const Participant& participant) {
  return participant.tactile_weight > 0.0 && participant.tactile_weight < 0.5 &&
         std::isfinite(participant.motor_variance_deg2) && participant.motor_variance_deg2 >= 0.0 &&
         std::isfinite(participant.sensory_variance_deg2) && participant.sensory_variance_deg2 > 0.0 &&
         std::isfinite(participant.initial_variance_deg2) && participant.initial_variance_deg2 >= 0.0;
}

FilterGain next_gain(const Participant& participant, double variance_deg2) {
  const double prior_variance_deg2 = variance_deg2 + participant.motor_variance_deg2;
  const double gain = prior_variance_deg2 / (prior_variance_deg2 + participant.sensory_variance_deg2);
  return {gain, (1.0 - gain) * prior_variance_deg2};
}

FilterGain steady_gain(const Participant& participant) {
  // var- = var + q and var = r var- / (var- + r) give var-^2 - q var- - q r = 0; its positive root.
  const double q = participant.motor_variance_deg2;
  const double r = participant.sensory_variance_deg2;
  const double prior_variance_deg2 = 0.5 * (q + std::sqrt(q * (q + 4.0 * r)));
  const double gain = prior_variance_deg2 / (prior_variance_deg2 + r);
  return {gain, (1.0 - gain) * prior_variance_deg2};
}

double ridge_normal_deg(double plate_orientation_deg, double goal_direction_deg) {
  const double offset_deg = plate_orientation_deg - goal_direction_deg;
  // A command on a bound of 90 may be a rounding error beyond it; it must not turn into the other bound.
  if (std::abs(offset_deg) <= 90.0 + 1e-9) return plate_orientation_deg;
  return goal_direction_deg + wrap_deg(offset_deg, 180.0);
}

double felt_direction_deg(double tactile_weight, double plate_orientation_deg, double finger_direction_deg) {
  return tactile_weight * plate_orientation_deg + (1.0 - tactile_weight) * finger_direction_deg;
}

double perceived_direction_deg(double gain, double goal_direction_deg, double felt_deg) {
  return goal_direction_deg + gain * (felt_deg - goal_direction_deg);
}

PerceptionFilter::PerceptionFilter(const Participant& participant, double goal_direction_deg)
    : participant_(participant),
      goal_direction_deg_(goal_direction_deg),
      variance_deg2_(participant.initial_variance_deg2) {}

double PerceptionFilter::update(double plate_orientation_deg, double finger_direction_deg) {
  const FilterGain step = next_gain(participant_, variance_deg2_);
  const double felt_deg =
      felt_direction_deg(participant_.tactile_weight, plate_orientation_deg, finger_direction_deg);
  perceived_direction_deg_ = hrt::perceived_direction_deg(step.gain, goal_direction_deg_, felt_deg);
  variance_deg2_ = step.variance_deg2;
  return perceived_direction_deg_;
}

GainWindow::GainWindow(const Participant& participant, int horizon)
    : participant_(participant), horizon_(horizon), last_variance_deg2_(participant.initial_variance_deg2) {
  for (int i = 0; i < horizon; ++i) advance();
}

void GainWindow::advance() {
  const FilterGain next = next_gain(participant_, last_variance_deg2_);
  last_variance_deg2_ = next.variance_deg2;
  gains_[first_] = gains_[first_ + horizon_] = next.gain;
  first_ = first_ + 1 == horizon_ ? 0 : first_ + 1;
}

}  // namespace hrt
