#include "core/paper/perception.h"

namespace hrt {

FilterGain next_gain(const Participant& participant, double variance_deg2) {
  const double prior_variance_deg2 = variance_deg2 + participant.motor_variance_deg2;
  const double gain = prior_variance_deg2 / (prior_variance_deg2 + participant.sensory_variance_deg2);
  return {gain, (1.0 - gain) * prior_variance_deg2};
}

// (1 - K) var- = K sigma_h^2.
double step_variance_deg2(const Participant& participant, double gain) {
  return participant.motor_variance_deg2 + gain * participant.sensory_variance_deg2;
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
