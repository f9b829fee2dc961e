#pragma once

#include <limits>

namespace hrt {

/// Largest number of steps in the controller's window.
inline constexpr int max_horizon = 20;

/// Largest number of steps between a command and its effect on the plate.
inline constexpr int max_lead = 8;

/// Parameters of the controller of paper section III; is_valid() checks the ranges.
struct MpcConfig {
  int horizon = 3;                ///< N, steps in the window, 1 to max_horizon
  double perceived_weight = 1.0;  ///< q_perceived: weight of the squared perceived-direction error, > 0
  double actual_weight = 1.0;     ///< q_actual: weight of the squared miss (direction minus real direction), >= 0
  /// L: largest plate offset from the goal direction (virtual direction plus bias), degrees in (0, 90].
  double plate_bound_deg = 84.5;
  /// R: largest rotation of the plate in one step, degrees > 0; infinity: no limit.
  double plate_rate_bound_deg = std::numeric_limits<double>::infinity();
};

bool is_valid(const MpcConfig& config);

}  // namespace hrt
