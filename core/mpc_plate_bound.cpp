#include "core/mpc_plate_bound.h"

#include <cmath>
#include <type_traits>
#include <utility>

namespace hrt {
namespace {

// Sweeps that a problem may take. Those of a closed loop take one or two.
constexpr int max_sweeps = 8;

// A constant, so that the sweep over the usual window is unrolled.
constexpr std::integral_constant<int, 3> papers_horizon;

}  // namespace

PlateBoundSolver::PlateBoundSolver(int horizon, double perceived_weight, double actual_weight) {
  for (int left = 1; left <= horizon; ++left) {
    const double s = free_cost_[left - 1];
    free_gain_[left] = s / (perceived_weight + s);
    free_cost_[left] = actual_weight + perceived_weight * free_gain_[left];
  }
}

void PlateBoundSolver::solve(const WindowProblem& problem, int steps_wanted, WorkingSet& working_set,
                             WindowSolution& solution) {
  CostsToGo after;
  int from = held_steps_ - 1;
  if (from >= 0) after[from] = free_cost_to_go(problem.horizon - held_steps_);
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    sweep_backwards(problem, working_set, from, after);
    const int held_steps = held_steps_;
    from = problem.horizon == papers_horizon ? sweep_forwards(problem, papers_horizon, after, working_set)
                                             : sweep_forwards(problem, problem.horizon, after, working_set);
    if (from <= 0) {
      if (held_steps == 0 && held_steps_ == 1) after[0] = free_cost_to_go(problem.horizon - 1);
      write(problem, after, working_set, steps_wanted, solution);
      return;
    }
    if (from >= held_steps) after[from] = free_cost_to_go(problem.horizon - 1 - from);
  }
  solve_active_set(problem, working_set, solution);
  held_steps_ = problem.horizon;
}

// The costs to go after steps `from` (given), from - 1, .. 0 under the bounds assumed active.
void PlateBoundSolver::sweep_backwards(const WindowProblem& problem, const WorkingSet& working_set, int from,
                                       CostsToGo& after) const {
  const double q_perceived = problem.perceived_weight;
  const double q_actual = problem.actual_weight;
  const double felt_at_real_deg = problem.proprioceptive_weight * problem.real_offset_deg;
  if (from < 1) return;
  auto [s, r] = after[from];
  for (int i = from; i > 0; --i) {
    if (working_set.pin[i] == 0) {
      const double share = q_perceived / (q_perceived + s);
      r = share * r;
      s = q_actual + share * s;
    } else {
      const double a = problem.gains[i] * problem.proprioceptive_weight;  // e = a x + d
      const double d = problem.gains[i] * (felt_at_real_deg + working_set.pin[i] * problem.bound_deg);
      const double b = 1.0 - a;
      r = (q_perceived * a * d + b * r) - b * d * s;
      s = (q_actual + q_perceived * a * a) + b * b * s;
    }
    after[i - 1] = {s, r};
  }
}

// Clamps each step's optimum under those costs to go to the bound. Returns the last step at which what had
// to be clamped is not what was assumed, or -1: the costs to go after it, and what follows from there, are
// right. An assumption that is right but for rounding stands, or bounds that are just touched would come
// and go forever.
template <class Horizon>
int PlateBoundSolver::sweep_forwards(const WindowProblem& problem, Horizon horizon, const CostsToGo& after,
                                     WorkingSet& working_set) {
  const double q_perceived = problem.perceived_weight;
  const double pw = problem.proprioceptive_weight;
  const double felt_at_real_deg = pw * problem.real_offset_deg;
  const double bound_deg = problem.bound_deg;
  const double slack_deg =
      2e-15 * (std::abs(problem.miss_deg) + std::abs(problem.real_offset_deg) + bound_deg);
  const int held_steps = std::exchange(held_steps_, 0);
  int last_changed = -1;
  double x = problem.miss_deg;
  for (int i = 0; i < horizon; ++i) {
    const double k = problem.gains[i];
    const double a = k * pw;
    std::int8_t& pin = working_set.pin[i];
    double e;
    if (i >= held_steps) {
      e = free_gain_[horizon - i] * x;
    } else {
      const auto& [s, r] = after[i];
      const double total = q_perceived + s;
      if (pin != 0) {
        const double d = k * (felt_at_real_deg + pin * bound_deg);
        if (pin * (s * x + r - total * (a * x + d)) >= -slack_deg * k * total) [[likely]] {
          held_steps_ = i + 1;
          x = (1.0 - a) * x - d;
          continue;
        }
        pin = 0;
        last_changed = i;
      }
      e = (s * x + r) * (1.0 / total);  // the division does not wait for x
    }
    const double without_plate = a * x + k * felt_at_real_deg;  // e if u = 0
    if (std::abs(e - without_plate) > k * (bound_deg + slack_deg)) {
      pin = e > without_plate ? 1 : -1;
      e = without_plate + pin * k * bound_deg;
      last_changed = i;
      held_steps_ = i + 1;
    }
    x -= e;
  }
  return last_changed;
}

// The first `steps` steps of the solution, once the active bounds are known.
void PlateBoundSolver::write(const WindowProblem& problem, const CostsToGo& after,
                             const WorkingSet& working_set, int steps, WindowSolution& solution) const {
  if (steps == 1 && working_set.pin[0]) {
    solution.plate_deg[0] = working_set.pin[0] * problem.bound_deg;
    return;
  }
  double x = problem.miss_deg;
  for (int i = 0; i < steps; ++i) {
    const auto [s, r] = i < held_steps_ ? after[i] : free_cost_to_go(problem.horizon - 1 - i);
    const double k = problem.gains[i];
    double u = 0.0;
    if (working_set.pin[i]) {
      u = working_set.pin[i] * problem.bound_deg;
    } else if (k > 0.0) {
      const double inverse = 1.0 / ((problem.perceived_weight + s) * k);
      u = (s * inverse - problem.proprioceptive_weight) * x +
          (r * inverse - problem.proprioceptive_weight * problem.real_offset_deg);
    }
    solution.plate_deg[i] = u;
    x -= k * (u + problem.proprioceptive_weight * (x + problem.real_offset_deg));
  }
}

}  // namespace hrt
