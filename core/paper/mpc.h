// The controller of paper section III: the plate orientations over a short window that keep both the perceived
// direction near the virtual target and the finger near the real target.
//
// With angles relative to the virtual direction theta_V (p finger, t plate, e perceived error) the participant of
// section II-A is a scalar system
//     e_i = K_i (w_T t_i + (1 - w_T) p_i),    p_i+1 = p_i - e_i
// and the cost over the window of N steps (paper equation 1, with weights) is
//     sum over i = k .. k+N-1 of  q_perceived e_i^2 + q_actual (p_i - p_R)^2,
// subject to |t_i| <= L and |t_i - t_i-1| <= R. core/paper/README.md derives the method.
#pragma once

#include <array>

#include "core/paper/mpc_active_set.h"
#include "core/paper/mpc_config.h"
#include "core/plate/plate_limits.h"

namespace hrt {

/// One problem; every angle in degrees relative to the virtual direction.
struct MpcProblem {
  double finger_offset_deg;  ///< p_k, finite
  double real_offset_deg;    ///< p_R, finite
  double tactile_weight;     ///< w_T in (0, 0.5)
  /// t_k-1: current plate offset, finite. Read only with a rate bound. A plate that is farther beyond the plate bound
  /// than one step can rotate it returns at full rate.
  double plate_offset_deg;
  /// K_k .. K_k+N-1, each in [0, 1]; must point at `horizon` values. A gain below 1e-12 counts as 0: the plate is not
  /// perceived in that step, and rotates towards the offset of the next step in which it is, or stays.
  const double* gains;
};

/// Plate offsets over the window. Entries past `horizon` are not written; no entry is if the plate returns from beyond
/// its bound.
struct MpcPlan {
  std::array<double, max_horizon> plate_offset_deg;  ///< t_k ..
  std::array<ActiveBound, max_horizon> active;       ///< the plate bound, or else the rate bound
};

/// Solves one problem per step, exactly. No heap, lock or exception; bounded time. Any thread.
class Mpc {
 public:
  /// Requires is_valid(config).
  explicit Mpc(const MpcConfig& config);

  struct Command {
    double plate_offset_deg;  ///< t_k, relative to the virtual direction; always within both bounds
    ActiveBound active;       ///< the bound at which t_k is
    bool optimal;             ///< false: the solver reached its limit of iterations, and a better t_k may exist
  };

  /// Returns the first step of the optimum, and writes all steps to `plan` if it is not null.
  Command solve(const MpcProblem& problem, MpcPlan* plan = nullptr) const;

  const MpcConfig& config() const { return config_; }

 private:
  Command solve_bounded(const MpcProblem& problem, double last_deg, MpcPlan* plan) const;
  bool solve_window(const Window& window, WindowPath& path) const;

  MpcConfig config_;
  std::array<double, max_horizon + 1> free_gain_{};  // g by number of steps left: e = g (p - p_R) without active bounds
};

}  // namespace hrt
