#include "core/paper/participant.h"

#include <algorithm>
#include <cmath>

namespace hrt {

bool is_valid(const Participant& participant) {
  return participant.tactile_weight > 0.0 && participant.tactile_weight < 0.5 &&
         std::isfinite(participant.motor_variance_deg2) && participant.motor_variance_deg2 >= 0.0 &&
         std::isfinite(participant.sensory_variance_deg2) && participant.sensory_variance_deg2 > 0.0 &&
         std::isfinite(participant.initial_variance_deg2) && participant.initial_variance_deg2 >= 0.0 &&
         std::isfinite(participant.bias_deg);
}

GapFeasibility paper_gap_feasibility(double real_direction_deg, double virtual_direction_deg, double tactile_weight,
                                     double plate_bound_deg) {
  const double gap_deg = virtual_direction_deg - real_direction_deg;
  const double max_deg = max_gap_deg(tactile_weight, plate_bound_deg);
  const double held_gap_deg = std::clamp(gap_deg, -max_deg, max_deg);
  const bool reachable = held_gap_deg == gap_deg;
  const double plate_offset_deg = held_gap_deg * (1.0 - tactile_weight) / tactile_weight;
  return {
      .reachable = reachable,
      .gap_deg = gap_deg,
      .max_gap_deg = max_deg,
      .margin_deg = max_deg - std::abs(gap_deg),
      .plate_orientation_deg = virtual_direction_deg + std::clamp(plate_offset_deg, -plate_bound_deg, plate_bound_deg),
      .settling_direction_deg = reachable ? real_direction_deg : virtual_direction_deg - held_gap_deg,
  };
}

FilterGain next_gain(const Participant& participant, double variance_deg2) {
  const double prior_variance_deg2 = variance_deg2 + participant.motor_variance_deg2;
  const double gain = prior_variance_deg2 / (prior_variance_deg2 + participant.sensory_variance_deg2);
  return {gain, (1.0 - gain) * prior_variance_deg2};
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
