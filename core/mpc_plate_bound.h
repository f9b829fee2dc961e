// The fast exact solver of the controller's problem when the plate bound is its only one. See
// core/README.md for the derivation.
#pragma once

#include <array>

#include "core/mpc_active_set.h"
#include "core/perception.h"

namespace hrt {

/// Solves problems without a rate bound one after another. A backward sweep gives the cost to go under the
/// bounds that held the last problem, a forward one clamps each step's optimum, and they repeat until they
/// agree: once or twice in a closed loop. That they do is not proven, so the active-set solver stands behind.
class PlateBoundSolver {
 public:
  /// Weights and horizon as in MpcConfig, for all problems to come.
  PlateBoundSolver(int horizon, double perceived_weight, double actual_weight);

  /// Solves `problem`, writing the first `steps_wanted` >= 1 plate offsets of `solution`. `working_set` is
  /// that of the last problem, empty at first, and no one else's.
  void solve(const WindowProblem& problem, int steps_wanted, WorkingSet& working_set,
             WindowSolution& solution);

 private:
  // The cost to go after a step: s x^2 + 2 r x plus a constant.
  struct CostToGo {
    double s;
    double r;
  };
  using CostsToGo = std::array<CostToGo, max_horizon>;

  CostToGo free_cost_to_go(int steps_left) const { return {free_cost_[steps_left], 0.0}; }
  void sweep_backwards(const WindowProblem& problem, const WorkingSet& working_set, int from,
                       CostsToGo& after) const;
  template <class Horizon>
  int sweep_forwards(const WindowProblem& problem, Horizon horizon, const CostsToGo& after,
                     WorkingSet& working_set);
  void write(const WindowProblem& problem, const CostsToGo& after, const WorkingSet& working_set, int steps,
             WindowSolution& solution) const;

  int held_steps_ = 0;  // no bound is active from this step on
  // By the number of steps left, while no bound is active: the cost to go S x^2, and e = gain x.
  std::array<double, max_horizon + 1> free_cost_{};
  std::array<double, max_horizon + 1> free_gain_{};
};

}  // namespace hrt
