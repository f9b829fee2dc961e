// The controller of paper section III: chooses the plate orientations over a short window that keep the perceived
// direction near the goal, and the finger's direction near that of the real target.
#pragma once

#include <array>

#include "core/paper/mpc_active_set.h"
#include "core/paper/mpc_config.h"
#include "core/plate/plate_limits.h"

namespace hrt {

/// Input of one step. Angles are relative to the goal direction, which is the virtual direction in the paper.
struct MpcProblem {
  double finger_offset_deg;  ///< p_k, finite
  double real_offset_deg;    ///< p_R, finite
  double tactile_weight;     ///< w_T in (0, 0.5)
  /// t_k-1: current plate offset, finite. Used only with a rate bound. If the plate is farther beyond the plate bound
  /// than it can rotate in one step, it returns at full rate.
  double plate_offset_deg;
  /// K_k .. K_k+N-1, `horizon` gains in [0, 1]. In a step with a gain below 1e-12 the plate is not perceived: the plate
  /// rotates towards the offset of the next step with a larger gain or, without such a step, does not move.
  const double* gains;
};

/// Plate offsets over the window: the first `horizon` elements, or none if the plate returns from beyond its bound.
struct MpcPlan {
  std::array<double, max_horizon> plate_offset_deg;  ///< t_k .. t_k+N-1
  /// Bound that limits each offset; the plate bound, if both do; `none` in a step in which the plate is not perceived.
  std::array<ActiveBound, max_horizon> active;
};

/// Uses no heap, lock or exception, and takes bounded time. Any thread.
class Mpc {
 public:
  /// Requires is_valid(config).
  explicit Mpc(const MpcConfig& config);

  struct Command {
    double plate_offset_deg;  ///< t_k; within both bounds, unless the plate returns from beyond the plate bound
    ActiveBound active;       ///< bound that limits t_k; may be `none` if the plate is not perceived
    bool optimal;             ///< false: the solver reached its iteration limit, and a better t_k may exist
  };

  /// Returns the first step of the optimum, and writes all steps to `plan` unless it is null.
  Command solve(const MpcProblem& problem, MpcPlan* plan = nullptr) const;

  const MpcConfig& config() const { return config_; }

 private:
  Command solve_bounded(const MpcProblem& problem, double last_deg, MpcPlan* plan) const;
  bool solve_window(const Window& window, WindowPath& path) const;

  MpcConfig config_;
  // g_n for n remaining steps, including the present one: without active bounds, p - p_R decreases by g_n (p - p_R).
  std::array<double, max_horizon + 1> free_gain_{};
};

}  // namespace hrt
