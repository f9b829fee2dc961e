// The exact solver of the controller's problem with a rate bound, and of what PlateBoundSolver gives up. See
// core/paper/README.md for the derivation.
#pragma once

#include "core/paper/mpc_window.h"

namespace hrt {

/// Solves `problem`. Starts from the path in `solution`, which must be finite, clamped to the bounds, and leaves the
/// optimum there, and the constraints that hold it in `held`. If the work allowed runs out, `solution` is no optimum
/// and may break bounds.
void solve_rate_bound(const WindowProblem& problem, WorkingSet& held, WindowSolution& solution);

}  // namespace hrt
