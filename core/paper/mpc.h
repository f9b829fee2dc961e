// The controller of paper section III: the plate orientations over a short window that keep both the
// perceived direction near the virtual target and the finger near the real one, solved exactly.
//
// With angles relative to the virtual direction theta_V (p finger, t plate, e perceived error) the
// participant of section II-A is a scalar system
//     e_i = K_i (w_T t_i + (1 - w_T) p_i),    p_i+1 = p_i - e_i
// and the cost over the window of N steps (paper equation 1, with weights) is
//     sum over i = k .. k+N-1 of  q_perceived e_i^2 + q_actual (p_i - p_R)^2,
// subject to |t_i| <= L and |t_i - t_i-1| <= R. The method is derived in core/paper/README.md.
#pragma once

#include <array>
#include <limits>

#include "core/paper/mpc_config.h"
#include "core/paper/mpc_plate_bound.h"
#include "core/paper/mpc_window.h"
#include "core/paper/participant.h"
#include "core/plate/plate_limits.h"

namespace hrt {

/// One problem; every angle in degrees relative to the virtual direction.
struct MpcProblem {
  double finger_offset_deg;  ///< p_k, finite
  double real_offset_deg;    ///< p_R, finite
  double tactile_weight;     ///< w_T in (0, 0.5)
  /// t_k-1: where the plate stands now, finite. Read only with a rate bound. If it is farther out of the
  /// plate bound than one step can turn, the plate returns at full rate and the bound gives way until then;
  /// beyond 90 the plate feels on the way as it does 180 nearer.
  double plate_offset_deg;
  /// K_k .. K_k+N-1, each in [0, 1]; must point at `horizon` values. Below 1e-12 a gain counts as 0: the
  /// plate is not felt in that step. With a rate bound it turns towards where it is next felt, or stays.
  const double* gains;
};

/// The plate over the window. Entries past `horizon` are not written.
struct MpcPlan {
  std::array<double, max_horizon> plate_offset_deg;  ///< t_k ..
  std::array<ActiveBound, max_horizon> active;  ///< the plate bound, or else the rate bound against the step before
};

/// Solves one problem a step. No heap, no lock, no exception. Time is bounded: by 8 pairs of sweeps and 153 passes over
/// a window of 50 steps, of about a microsecond each (tests/benchmarks has the measurements). Any thread.
class Mpc {
 public:
  /// Requires is_valid(config).
  explicit Mpc(const MpcConfig& config);

  struct Command {
    double plate_offset_deg;  ///< t_k, relative to the virtual direction; within both bounds in any case
    ActiveBound active;       ///< the bound that holds t_k
    bool optimal;             ///< false: the work was cut short, and a better t_k may exist
  };

  /// The exact optimum's first step.
  Command solve(const MpcProblem& problem) const;
  /// The same, and the whole window in `plan` if it is not null.
  Command solve(const MpcProblem& problem, MpcPlan* plan) const;

  const MpcConfig& config() const { return config_; }

 private:
  Command solve_without_rate(const MpcProblem& problem) const;
  void solve_window(const WindowProblem& window, WorkingSet& held, WindowSolution& solution) const;

  MpcConfig config_;
  PlateBoundSolver plate_bound_solver_;
};

}  // namespace hrt
