// Quadratic program of one window, and an exact method for it. Derivation: README.md.
#pragma once

#include <array>
#include <cstdint>

#include "core/paper/mpc_config.h"

namespace hrt {

/// Problem: minimise  sum of q_perceived e_i^2 + miss_weight_i (p_i - p_R)^2  over the plate offsets t_i, where
/// e_i = K_i (w_T t_i + (1 - w_T) p_i)  and  p_i+1 = p_i - e_i,  subject to  |t_i| <= L  and  |t_i - t_i-1| <= R_i.
struct Window {
  int steps;                                        ///< 1 to max_horizon
  double perceived_weight;                          ///< q_perceived > 0
  double tactile_weight;                            ///< w_T
  double finger_deg;                                ///< p_0
  double real_deg;                                  ///< p_R
  double bound_deg;                                 ///< L
  double last_plate_deg;                            ///< t_-1, |t_-1| <= L + R_0
  std::array<double, max_horizon> gain;             ///< K_i > 0
  std::array<double, max_horizon> rate_deg;         ///< R_i, may be infinite
  std::array<double, max_horizon + 1> miss_weight;  ///< the last element weights the miss after the window
};

/// Plate offsets over the window, and their active bounds: +1 upper, -1 lower, 0 inactive.
struct WindowPath {
  std::array<double, max_horizon> plate_deg;  ///< t_i
  std::array<std::int8_t, max_horizon> pin;   ///< t_i is at +-L
  std::array<std::int8_t, max_horizon> link;  ///< t_i - t_i-1 is at +-R_i
};

/// Moves `path` to the optimum. Requires a path within the bounds with at most one active bound per step. Returns false
/// if the iteration limit is reached; `path` is then within the bounds, but may not be optimal.
bool solve_active_set(const Window& window, WindowPath& path);

}  // namespace hrt
