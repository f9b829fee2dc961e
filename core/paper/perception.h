// The gains of the Kalman filter of paper section II-A, which fuses touch and proprioception. They do not
// depend on what is felt, so a controller knows them ahead. No heap, no lock, no exception.
#pragma once

#include <array>
#include <cstddef>

#include "core/paper/mpc_config.h"
#include "core/paper/participant.h"

namespace hrt {

/// One step of the filter.
struct FilterGain {
  double gain;           ///< K, in (0, 1] (0 only if both variances before it are 0)
  double variance_deg2;  ///< of the perceived direction once corrected: (1 - K) var-
};

/// Gain and variance of the step that follows a perceived direction of variance `variance_deg2`.
FilterGain next_gain(const Participant& participant, double variance_deg2);

/// Variance of the noise that a step of gain `gain` adds to the finger's direction: sigma_u^2 + var_k.
double step_variance_deg2(const Participant& participant, double gain);

/// The gains of the next steps: data() is K_k .. K_k+horizon-1.
class GainWindow {
 public:
  /// Starts at the first step of a reach. Requires is_valid(participant), 1 <= horizon <= max_horizon +
  /// max_lead.
  GainWindow(const Participant& participant, int horizon);

  /// `horizon` gains, the current step's first. Valid until advance().
  const double* data() const { return gains_.data() + first_; }

  /// Moves to the next step.
  void advance();

 private:
  Participant participant_;
  int horizon_;
  int first_ = 0;
  double last_variance_deg2_;
  // A ring that holds every gain twice, so that a window is contiguous wherever it starts.
  std::array<double, std::size_t{2} * (max_horizon + max_lead)> gains_{};
};

}  // namespace hrt
