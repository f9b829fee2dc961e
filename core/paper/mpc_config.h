// The settings of the controller of paper section III.
#pragma once

#include <limits>

namespace hrt {

/// The longest window of steps that a controller looks ahead.
inline constexpr int max_horizon = 50;

/// The most steps that a command may take to reach the finger.
inline constexpr int max_lead = 8;

/// The controller's settings; is_valid() checks the ranges.
struct MpcConfig {
  int horizon = 3;                ///< N, steps in the window, 1 to max_horizon
  double perceived_weight = 1.0;  ///< q_perceived, > 0
  double actual_weight = 1.0;     ///< q_actual, >= 0
  /// L: the plate stays within this of the virtual direction, degrees in (0, 90].
  double plate_bound_deg = 84.5;
  /// The plate turns by at most this in a step, degrees > 0; infinity: no limit.
  double plate_rate_bound_deg = std::numeric_limits<double>::infinity();
};

/// True if every field is in its range.
bool is_valid(const MpcConfig& config);

}  // namespace hrt
