// The fast exact solver of the controller's problem when the plate bound is its only one. See
// core/paper/README.md for the derivation.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/paper/mpc_window.h"
#include "core/paper/participant.h"

namespace hrt {

/// Solves problems without a rate bound. A forward sweep clamps each step's optimum under the cost to go, at first
/// as if no bound were met later; a backward one gives the cost to go under the bounds that it met, and they repeat
/// until they agree: mostly at once or after one. No proof says that they always agree: after 8 pairs it gives up.
/// Any thread.
class PlateBoundSolver {
 public:
  /// Weights and horizon as in MpcConfig, for all problems to come.
  PlateBoundSolver(int horizon, double perceived_weight, double actual_weight);

  /// u_k if no step of the window meets the plate bound or the rate bound; none too if a gain counts as 0. In a closed
  /// loop it is mostly there.
  std::optional<double> free_first_deg(const WindowProblem& problem) const;

  /// The first step of a solution as if there were no rate bound. One that is not felt is 0, and not pinned.
  struct FirstStep {
    double plate_deg;  ///< u_k, 0 where it is pinned
    std::int8_t pin;   ///< as in WorkingSet
    bool optimal;      ///< false: the solver gave up, and the others have no meaning
  };
  FirstStep solve_first(const WindowProblem& problem) const;

  /// Solves `problem` as if it had no rate bound, and writes the pins that hold the solution. Not optimal: the path
  /// breaks the rate bound, or the solver gave up, and it is 0 everywhere.
  void solve(const WindowProblem& problem, WorkingSet& held, WindowSolution& solution) const;

 private:
  // The cost to go after a step: s x^2 + 2 r x plus a constant.
  struct CostToGo {
    double s;
    double r;
  };
  // Found by a pair of sweeps, step by step.
  struct Sweeps {
    explicit Sweeps(std::array<std::int8_t, max_horizon>& of_steps) : pin(of_steps) {}

    std::array<CostToGo, max_horizon> after;  // written where a bound may be active
    std::array<double, max_horizon> miss_deg;
    std::array<std::int8_t, max_horizon>& pin;
    int held_steps = 0;  // a bound before this, none from here on
  };

  CostToGo free_cost_to_go(int steps_left) const { return {free_cost_[steps_left], 0.0}; }
  bool find_pins(const WindowProblem& problem, Sweeps& sweeps) const;
  void sweep_backwards(const WindowProblem& problem, int from, Sweeps& sweeps) const;
  template <class Horizon>
  int sweep_forwards(const WindowProblem& problem, Horizon horizon, Sweeps& sweeps) const;
  static double first_plate_deg(const WindowProblem& problem, const CostToGo& after);
  double plate_deg(const WindowProblem& problem, const Sweeps& sweeps, int i) const;
  bool write_window(const WindowProblem& problem, const Sweeps& sweeps, WindowSolution& solution) const;

  // By the number of steps left, while no bound is active: the cost to go S x^2, and e = gain x.
  std::array<double, max_horizon + 1> free_cost_{};
  std::array<double, max_horizon + 1> free_gain_{};
};

// u_k, which no bound holds.
inline double PlateBoundSolver::first_plate_deg(const WindowProblem& problem, const CostToGo& after) {
  const double inverse = 1.0 / ((problem.perceived_weight + after.s) * problem.gains[0]);
  return (after.s * inverse - problem.proprioceptive_weight) * problem.miss_deg +
         (after.r * inverse - problem.proprioceptive_weight * problem.real_offset_deg);
}

inline std::optional<double> PlateBoundSolver::free_first_deg(const WindowProblem& problem) const {
  const double pw = problem.proprioceptive_weight;
  const double felt_at_real_deg = pw * problem.real_offset_deg;
  const double slack_deg = tolerance_deg(problem);
  const bool turns_at_once = std::isinf(problem.rate_deg);
  double x = problem.miss_deg;
  double last_deg = problem.last_plate_deg;
  double first_deg = 0.0;
  for (int i = 0; i < problem.horizon; ++i) {
    const double k = problem.gains[i];
    const double e = free_gain_[problem.horizon - i] * x;
    if (k < min_step_gain || std::abs(e - (k * pw * x + k * felt_at_real_deg)) > k * problem.bound_deg)
      return std::nullopt;
    if (!turns_at_once) {
      const double u = (free_gain_[problem.horizon - i] / k - pw) * x - felt_at_real_deg;
      if ((std::abs(u - last_deg) - problem.rate_deg) * k > slack_deg) return std::nullopt;
      if (i == 0) first_deg = u;
      last_deg = u;
    }
    x -= e;
  }
  return turns_at_once ? first_plate_deg(problem, free_cost_to_go(problem.horizon - 1)) : first_deg;
}

}  // namespace hrt
