#include "core/paper/mpc_plate_bound.h"

#include <algorithm>
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
    const double inverse = 1.0 / (perceived_weight + s);
    free_gain_[left] = s * inverse;
    free_cost_[left] = actual_weight + perceived_weight * inverse * s;
  }
}

PlateBoundSolver::FirstStep PlateBoundSolver::solve_first(const WindowProblem& problem) const {
  std::array<std::int8_t, max_horizon> pin;
  Sweeps sweeps(pin);
  if (!find_pins(problem, sweeps)) return {};
  if (problem.gains[0] < min_step_gain) return {0.0, 0, true};
  return {pin[0] ? 0.0 : first_plate_deg(problem, sweeps.after[0]), pin[0], true};
}

void PlateBoundSolver::solve(const WindowProblem& problem, WorkingSet& held, WindowSolution& solution) const {
  Sweeps sweeps(held.pin);
  held.link.fill(0);
  solution.optimal = find_pins(problem, sweeps);
  if (!solution.optimal) {
    solution.plate_deg.fill(0.0);
    return;
  }
  solution.optimal = write_window(problem, sweeps, solution);
  // With a rate bound the bits are those of solve_rate_bound(), which finds what rate bounds hold.
  if (std::isinf(problem.rate_deg) && held.pin[0] == 0 && problem.gains[0] >= min_step_gain)
    solution.plate_deg[0] = first_plate_deg(problem, sweeps.after[0]);
}

// Writes the costs to go up to the last bound, that of the first step in any case. False: it gave up.
inline bool PlateBoundSolver::find_pins(const WindowProblem& problem, Sweeps& sweeps) const {
  const int horizon = problem.horizon;
  int from = -1;
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    sweep_backwards(problem, from, sweeps);
    const int held_steps = sweeps.held_steps;
    from = horizon == papers_horizon ? sweep_forwards(problem, papers_horizon, sweeps)
                                     : sweep_forwards(problem, horizon, sweeps);
    if (from <= 0) {
      if (held_steps == 0) sweeps.after[0] = free_cost_to_go(horizon - 1);
      return true;
    }
    if (from >= held_steps) sweeps.after[from] = free_cost_to_go(horizon - 1 - from);
  }
  return false;
}

// The costs to go after steps `from` (given), from - 1, .. 0 under the bounds assumed active.
inline void PlateBoundSolver::sweep_backwards(const WindowProblem& problem, int from, Sweeps& sweeps) const {
  const double q_perceived = problem.perceived_weight;
  const double q_actual = problem.actual_weight;
  if (from < 1) return;
  auto [s, r] = sweeps.after[from];
  for (int i = from; i > 0; --i) {
    if (sweeps.pin[i] == 0) {
      const double inverse = 1.0 / (q_perceived + s);
      r *= q_perceived * inverse;
      s = q_actual + q_perceived * inverse * s;
    } else {
      const double a = problem.gains[i] * problem.proprioceptive_weight;  // e = a x + d
      const double d = problem.gains[i] * (sweeps.pin[i] * problem.bound_deg) + a * problem.real_offset_deg;
      r = q_perceived * a * d + (1.0 - a) * (r - s * d);
      s = q_actual + q_perceived * a * a + (1.0 - a) * (1.0 - a) * s;
    }
    sweeps.after[i - 1] = {s, r};
  }
}

// Clamps each step's optimum under those costs to go to the bound. Returns the last step that is clamped
// against the assumption, or free against it, or -1: the costs to go after that step are right. A difference
// of rounding keeps the assumption, because bounds that are just touched would cycle.
template <class Horizon>
int PlateBoundSolver::sweep_forwards(const WindowProblem& problem, Horizon horizon, Sweeps& sweeps) const {
  const double q_perceived = problem.perceived_weight;
  const double pw = problem.proprioceptive_weight;
  const double felt_at_real_deg = pw * problem.real_offset_deg;
  const double bound_deg = problem.bound_deg;
  const double slack_deg = 2e-15 * (std::abs(problem.miss_deg) + std::abs(problem.real_offset_deg) + bound_deg);
  const double free_within_deg = bound_deg + slack_deg;
  const double* const gains = problem.gains;
  const int held_steps = std::exchange(sweeps.held_steps, 0);
  int last_changed = -1;
  double x = problem.miss_deg;
  for (int i = 0; i < horizon; ++i) {
    const double k = gains[i];
    const double a = k * pw;
    sweeps.miss_deg[i] = x;
    std::int8_t& pin = sweeps.pin[i];
    double e;
    if (i >= held_steps) {
      pin = 0;
      e = free_gain_[horizon - i] * x;
    } else {
      const auto& [s, r] = sweeps.after[i];
      const double total = q_perceived + s;
      if (pin != 0) {
        const double d = k * (felt_at_real_deg + pin * bound_deg);
        if (pin * (s * x + r - total * (a * x + d)) >= -slack_deg * k * total) [[likely]] {
          sweeps.held_steps = i + 1;
          x = (1.0 - a) * x - d;
          continue;
        }
        pin = 0;
        last_changed = i;
      }
      e = (s * x + r) * (1.0 / total);  // the division does not wait for x
    }
    const double without_plate = a * x + k * felt_at_real_deg;  // e if u = 0
    if (std::abs(e - without_plate) > k * free_within_deg) {
      pin = e > without_plate ? 1 : -1;
      e = without_plate + pin * k * bound_deg;
      last_changed = i;
      sweeps.held_steps = i + 1;
    }
    x -= e;
  }
  return last_changed;
}

inline double PlateBoundSolver::plate_deg(const WindowProblem& problem, const Sweeps& sweeps, int i) const {
  const double k = std::max(problem.gains[i], min_step_gain);
  const double pw = problem.proprioceptive_weight;
  const double felt_at_real_deg = pw * problem.real_offset_deg;
  const double x = sweeps.miss_deg[i];
  if (i >= sweeps.held_steps) return (free_gain_[problem.horizon - i] / k - pw) * x - felt_at_real_deg;
  if (sweeps.pin[i]) return sweeps.pin[i] * problem.bound_deg;
  const auto [s, r] = sweeps.after[i];
  const double inverse = 1.0 / (problem.perceived_weight + s);
  return (s * inverse / k - pw) * x + (r * inverse / k - felt_at_real_deg);
}

// Returns whether the plate nowhere turns faster than it can; its turns while it is not felt are left open.
bool PlateBoundSolver::write_window(const WindowProblem& problem, const Sweeps& sweeps,
                                    WindowSolution& solution) const {
  const double slack_deg = tolerance_deg(problem);
  double last_deg = problem.last_plate_deg;
  double room_deg = problem.rate_deg;
  bool keeps_rate = true;
  for (int i = 0; i < problem.horizon; ++i) {
    const double k = problem.gains[i];
    const double u = solution.plate_deg[i] = plate_deg(problem, sweeps, i);
    if (k < min_step_gain) {
      room_deg += problem.rate_deg;
      continue;
    }
    keeps_rate &= (std::abs(u - last_deg) - room_deg) * k <= slack_deg;
    last_deg = u;
    room_deg = problem.rate_deg;
  }
  return keeps_rate;
}

}  // namespace hrt
