// An exact solver of the controller's problem with any mixture of plate and rate bounds: a dual active-set
// method (Goldfarb and Idnani, Mathematical Programming 27, 1983) whose every equality-constrained
// problem is solved along the window in O(N). See core/paper/README.md for the derivation.
#pragma once

#include <array>

#include "core/paper/mpc_window.h"

namespace hrt {

/// Solves the problem of `window`. Starts from the path in `plate_deg`, the plate in degrees felt at each felt step,
/// finite: each step is clamped to the bounds, and those that clamp it are held. Leaves the optimum in `plate_deg`, and
/// the constraints that hold it in `held`. False if `max_passes` over the window do not lead there: the path is then no
/// optimum and may break bounds.
bool solve_active_set(const FeltWindow& window, int max_passes, std::array<double, max_horizon>& plate_deg,
                      WorkingSet& held);

}  // namespace hrt
