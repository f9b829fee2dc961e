// The fast exact solver of the controller's problem when the plate bound is its only one. See
// core/paper/README.md for the derivation.
#pragma once

#include <array>

#include "core/paper/mpc_window.h"
#include "core/paper/participant.h"

namespace hrt {

/// Solves problems without a rate bound one after another. A backward sweep gives the cost to go under the
/// bounds that held the last problem, a forward one clamps each step's optimum, and they repeat until they
/// agree: once or twice in a closed loop. No proof says that they always agree: solve() gives up after 8
/// pairs.
class PlateBoundSolver {
 public:
  /// Weights and horizon as in MpcConfig, for all problems to come.
  PlateBoundSolver(int horizon, double perceived_weight, double actual_weight);

  /// The first step of a solution.
  struct FirstStep {
    double plate_deg;  ///< u_k, of no meaning where it is pinned or not felt
    std::int8_t pin;   ///< as in WorkingSet
    bool optimal;      ///< false: the solver gave up, and the others have no meaning
  };
  FirstStep solve_first(const WindowProblem& problem);

  /// Solves `problem` as if it had no rate bound. Returns the pins that hold the solution, valid until the next
  /// problem. Not optimal: the path breaks the rate bound, or it gave up, and the path is 0 everywhere.
  const WorkingSet& solve(const WindowProblem& problem, WindowSolution& solution);

 private:
  // The cost to go after a step: s x^2 + 2 r x plus a constant.
  struct CostToGo {
    double s;
    double r;
  };
  // Found by a pair of sweeps, step by step.
  struct Sweeps {
    std::array<CostToGo, max_horizon> after;  // written where a bound may be active
    std::array<double, max_horizon> miss_deg;
  };

  CostToGo free_cost_to_go(int steps_left) const { return {free_cost_[steps_left], 0.0}; }
  bool find_pins(const WindowProblem& problem, Sweeps& sweeps);
  void sweep_backwards(const WindowProblem& problem, int from, Sweeps& sweeps) const;
  template <class Horizon>
  int sweep_forwards(const WindowProblem& problem, Horizon horizon, Sweeps& sweeps);
  double first_plate_deg(const WindowProblem& problem, const Sweeps& sweeps) const;
  double plate_deg(const WindowProblem& problem, const Sweeps& sweeps, int i) const;
  bool write_window(const WindowProblem& problem, const Sweeps& sweeps, WindowSolution& solution) const;

  WorkingSet working_set_;  // of the last problem; a bound before held_steps_, none from there on
  int held_steps_ = 0;
  // By the number of steps left, while no bound is active: the cost to go S x^2, and e = gain x.
  std::array<double, max_horizon + 1> free_cost_{};
  std::array<double, max_horizon + 1> free_gain_{};
};

}  // namespace hrt
