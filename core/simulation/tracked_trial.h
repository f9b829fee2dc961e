// One simulated reach as it would be in a laboratory: an unknown person, a tracker with noise and a rate of
// its own, a servo with latency and bounded speed. The controller sees only tracked positions.
#pragma once

#include "core/retargeter.h"
#include "core/simulation/sliding_finger.h"
#include "core/simulation/trial.h"

namespace hrt {

/// All that a tracked reach depends on but its random numbers.
struct TrackedCondition {
  Participant participant;             ///< who reaches
  double weight_drift = 0.0;           ///< w_T changes by this from the start of the reach to its end
  RetargeterConfig controller;         ///< what leads them, and what it assumes
  PlateDynamics plate;                 ///< the servo as it is
  double plate_orientation_deg = 0.0;  ///< where it stands before the reach
  double real_direction_deg = -5.0;
  double virtual_direction_deg = 5.0;
  double distance_m = 0.1;     ///< of the path, > 0
  double duration_s = 3.0;     ///< of the path
  double step_period_s = 0.1;  ///< of the participant's steps
  double rest_s = 0.2;         ///< tracked at rest before the path
  SpeedProfile speed_profile = SpeedProfile::constant;
  double tracker_noise_m = 0.0012;
  double tracker_rate_hz = 90.0;
};

/// How it ended; truth, not estimate.
struct TrackedOutcome {
  double final_direction_deg;  ///< of the last step
  double bearing_deg;          ///< from the start to where the finger ends
  double bearing_error_deg;    ///< from the real direction
  double miss_m;               ///< across the real direction, signed as bearing_error_deg
  double perceived_error_deg;  ///< theta_hat - theta_V of the last step
  ReachSummary summary;        ///< the controller's own account
  bool unreachable;            ///< the controller said so at the end
};

/// Simulates one tracked reach. Any thread.
TrackedOutcome simulate_tracked_trial(const TrackedCondition& condition, const TrialId& id);

}  // namespace hrt
