// The fast exact solver of the controller's problem when the plate bound is its only one. See
// core/paper/README.md for the derivation.
#pragma once

#include <array>

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

  /// The first step of a solution.
  struct FirstStep {
    double plate_deg;  ///< u_k, of no meaning where it is pinned or not felt
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
  double first_plate_deg(const WindowProblem& problem, const Sweeps& sweeps) const;
  double plate_deg(const WindowProblem& problem, const Sweeps& sweeps, int i) const;
  bool write_window(const WindowProblem& problem, const Sweeps& sweeps, WindowSolution& solution) const;

  // By the number of steps left, while no bound is active: the cost to go S x^2, and e = gain x.
  std::array<double, max_horizon + 1> free_cost_{};
  std::array<double, max_horizon + 1> free_gain_{};
};

}  // namespace hrt
