// The controller's problem over one window, in the coordinates in which it is simplest, and its solution.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/paper/participant.h"

namespace hrt {

/// The controller's problem in the coordinates in which it is simplest: x = p - p_R, and the plate in
/// degrees felt, u = w_T t, so that e_i = K_i (u_i + (1 - w_T)(x_i + p_R)) and x_i+1 = x_i - e_i.
struct WindowProblem {
  int horizon;                   ///< 1 to max_horizon
  double perceived_weight;       ///< q_perceived > 0
  double actual_weight;          ///< q_actual >= 0
  double miss_deg;               ///< x_k
  double real_offset_deg;        ///< p_R
  double proprioceptive_weight;  ///< 1 - w_T
  double bound_deg;              ///< w_T L: |u_i| <= this
  double rate_deg;               ///< w_T R: |u_i - u_i-1| <= this; may be infinite
  double last_plate_deg;         ///< w_T t_k-1, finite. Some u_k within both bounds must exist
  const double* gains;           ///< K_k .., `horizon` values in [0, 1]
};

/// The constraints that are held as equalities: +1 at the upper bound, -1 at the lower one, 0 not held.
/// A pin holds u_i at a plate bound, a link holds u_i - u_i-1 at a rate bound (link[0] ties to u_k-1).
/// Invariant: no run of linked steps holds more than one pin, none if it is tied to u_k-1, so that the
/// constraints held are always linearly independent.
struct WorkingSet {
  std::array<std::int8_t, max_horizon> pin;
  std::array<std::int8_t, max_horizon> link;
};

/// The plate over the window. Entries past the horizon are not written; one at a gain of 0 has no meaning.
struct WindowSolution {
  std::array<double, max_horizon> plate_deg;  ///< u_i
  bool optimal;                               ///< false: the solver gave up
};

/// A smaller gain counts as 0.
inline constexpr double min_step_gain = 1e-12;

/// Bounds that are broken by no more than this, in degrees felt at the finger (times the gain), hold.
inline double tolerance_deg(const WindowProblem& problem) {
  return 1e-14 * (std::abs(problem.miss_deg) + std::abs(problem.real_offset_deg) + problem.bound_deg);
}

/// The steps of a window in which the plate is felt. One that is not only adds to what the plate may turn until the
/// next, and to the weight of the miss that it leaves as it is.
struct FeltWindow {
  explicit FeltWindow(const WindowProblem& of) : problem(of) {
    double rate = 0.0;
    double weight = 0.0;
    for (int i = 0; i < problem.horizon; ++i) {
      rate += problem.rate_deg;
      weight += problem.actual_weight;
      if (problem.gains[i] < min_step_gain) continue;
      index[steps] = i;
      gain[steps] = problem.gains[i];
      rate_deg[steps] = rate;
      miss_weight[steps] = weight;
      ++steps;
      rate = weight = 0.0;
    }
    last_miss_weight = weight;
  }

  const WindowProblem& problem;
  int steps = 0;
  std::array<int, max_horizon> index;  ///< in the window
  std::array<double, max_horizon> gain;
  std::array<double, max_horizon> rate_deg;
  std::array<double, max_horizon> miss_weight;
  double last_miss_weight;  ///< of the miss after the last of them
};

}  // namespace hrt
