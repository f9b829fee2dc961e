// One simulated reach of the paper's participant and a controller, step by step as in paper sections II-A and III.
#pragma once

#include <cstdint>
#include <vector>

#include "core/retargeter_config.h"

namespace hrt {

inline constexpr int max_trial_steps = 10'000;

/// Parameters of a trial except its random numbers. The defaults are condition 1 of Table I.
struct Condition {
  Participant participant;
  RetargeterConfig controller;         ///< `controller.participant` is the one that the controller assumes
  double real_direction_deg = -5.0;    ///< P_R
  double virtual_direction_deg = 5.0;  ///< theta_V, less than 90 degrees from P_R
  double plate_orientation_deg = 0.0;  ///< plate orientation before the first step
  int steps = 30;                      ///< 1 to max_trial_steps
  double tolerance_deg = 1.5;          ///< a trial is a hit if |P - P_R| after the last step is at most this; >= 0
};

bool is_valid(const Condition& condition);

/// Identifies the random numbers of a trial: equal values give equal numbers.
struct TrialId {
  std::uint64_t seed;
  std::uint32_t condition;
  std::uint32_t trial;
};

/// Index of the first random number of the tracker; the steps use lower indices.
inline constexpr std::uint32_t tracker_draws = 1U << 20;

/// Step k, 0 to Condition::steps - 1. Directions and orientations are in degrees from the mid-line.
struct TrialStep {
  int step;                        ///< k
  double finger_direction_deg;     ///< P_k
  double plate_orientation_deg;    ///< T_k
  double felt_direction_deg;       ///< h_k
  double perceived_direction_deg;  ///< theta_hat_k
  double gain;                     ///< K_k of the simulated participant
  double variance_deg2;            ///< var_k of the perceived direction
  double motor_command_deg;        ///< u_k
  double noise_deg;                ///< eps_u + eps_theta: P_k+1 = P_k + u_k + noise
  ActiveBound active;              ///< see Mpc::Command
};

struct TrialOutcome {
  double final_direction_deg;      ///< P after the last step
  double perceived_direction_deg;  ///< theta_hat of the last step
  int saturated_steps;             ///< steps in which a bound limited T_k
  bool hit;
};

/// Simulates one trial with the Retargeter. Appends every step to `steps`, unless null. Requires is_valid(condition).
TrialOutcome simulate_trial(const Condition& condition, const TrialId& id, std::vector<TrialStep>* steps = nullptr);

}  // namespace hrt
