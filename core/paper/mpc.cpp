#include "core/paper/mpc.h"

#include <algorithm>
#include <cmath>

#include "core/paper/mpc_rate_bound.h"

namespace hrt {
namespace {

ActiveBound active_bound(const WorkingSet& set, int i) {
  if (set.pin[i]) return set.pin[i] > 0 ? ActiveBound::upper : ActiveBound::lower;
  if (set.link[i]) return set.link[i] > 0 ? ActiveBound::rate_up : ActiveBound::rate_down;
  return ActiveBound::none;
}

// The problem from step `first` on, in units of what is felt of the plate.
WindowProblem window_of(const MpcConfig& config, const MpcProblem& problem, int first, double miss_deg,
                        double last_plate_deg) {
  const double w = problem.tactile_weight;
  return {
      .horizon = config.horizon - first,
      .perceived_weight = config.perceived_weight,
      .actual_weight = config.actual_weight,
      .miss_deg = miss_deg,
      .real_offset_deg = problem.real_offset_deg,
      .proprioceptive_weight = 1.0 - w,
      .bound_deg = w * config.plate_bound_deg,
      .rate_deg = w * config.plate_rate_bound_deg,
      .last_plate_deg = w * last_plate_deg,
      .gains = problem.gains + first,
  };
}

// What the plate does in a step of the window, from `last_plate_deg`.
Mpc::Command command_of(const MpcConfig& config, const WindowProblem& window, const WindowSolution& solution,
                        const WorkingSet& held, int step, double tactile_weight, double last_plate_deg) {
  const double bound_deg = config.plate_bound_deg;
  const double rate_deg = config.plate_rate_bound_deg;
  // Where the plate is not felt it turns to where it next is, or stays.
  int felt = step;
  while (felt < window.horizon && window.gains[felt] < min_step_gain)
    felt = std::isfinite(rate_deg) ? felt + 1 : window.horizon;
  ActiveBound active = felt == step ? active_bound(held, step) : ActiveBound::none;
  double wanted_deg = felt < window.horizon ? solution.plate_deg[felt] * (1.0 / tactile_weight) : last_plate_deg;
  if (active == ActiveBound::upper || active == ActiveBound::lower) wanted_deg = held.pin[step] * bound_deg;
  if (active == ActiveBound::rate_up) wanted_deg = last_plate_deg + rate_deg;
  if (active == ActiveBound::rate_down) wanted_deg = last_plate_deg - rate_deg;
  // Rounding, or a path that is not optimal, must not carry the plate past a bound.
  const double low_deg = last_plate_deg - rate_deg;
  const double high_deg = last_plate_deg + rate_deg;
  const double plate_deg = std::clamp(std::clamp(wanted_deg, low_deg, high_deg), -bound_deg, bound_deg);
  if (plate_deg != wanted_deg && (active != ActiveBound::none || !solution.optimal))
    active = plate_deg == bound_deg    ? ActiveBound::upper
             : plate_deg == -bound_deg ? ActiveBound::lower
             : plate_deg < wanted_deg  ? ActiveBound::rate_up
                                       : ActiveBound::rate_down;
  return {plate_deg, active, solution.optimal};
}

}  // namespace

bool is_valid(const MpcConfig& config) {
  return config.horizon >= 1 && config.horizon <= max_horizon && std::isfinite(config.perceived_weight) &&
         config.perceived_weight > 0.0 && std::isfinite(config.actual_weight) && config.actual_weight >= 0.0 &&
         config.plate_bound_deg > 0.0 && config.plate_bound_deg <= 90.0 && config.plate_rate_bound_deg > 0.0;
}

Mpc::Mpc(const MpcConfig& config)
    : config_(config), plate_bound_solver_(config.horizon, config.perceived_weight, config.actual_weight) {}

Mpc::Command Mpc::solve(const MpcProblem& problem) const {
  const double bound_deg = config_.plate_bound_deg;
  const double rate_deg = config_.plate_rate_bound_deg;
  const double by_felt = 1.0 / problem.tactile_weight;
  const double last_plate_deg = std::isfinite(rate_deg) ? problem.plate_offset_deg : 0.0;
  const WindowProblem window =
      window_of(config_, problem, 0, problem.finger_offset_deg - problem.real_offset_deg, last_plate_deg);
  if (const std::optional<double> free_deg = plate_bound_solver_.free_first_deg(window)) {
    const double within_rate_deg =
        std::clamp(*free_deg * by_felt, last_plate_deg - rate_deg, last_plate_deg + rate_deg);
    return {std::clamp(within_rate_deg, -bound_deg, bound_deg), ActiveBound::none, true};
  }
  return std::isfinite(rate_deg) ? solve(problem, nullptr) : solve_without_rate(problem);
}

// Of a plate that turns at once the first step is all that has to be written.
Mpc::Command Mpc::solve_without_rate(const MpcProblem& problem) const {
  const double bound_deg = config_.plate_bound_deg;
  const PlateBoundSolver::FirstStep first = plate_bound_solver_.solve_first(
      window_of(config_, problem, 0, problem.finger_offset_deg - problem.real_offset_deg, 0.0));
  if (!first.optimal) return solve(problem, nullptr);
  if (first.pin) return {first.pin * bound_deg, first.pin > 0 ? ActiveBound::upper : ActiveBound::lower, true};
  const double plate_deg = first.plate_deg * (1.0 / problem.tactile_weight);
  return {std::clamp(plate_deg, -bound_deg, bound_deg), ActiveBound::none, true};
}

Mpc::Command Mpc::solve(const MpcProblem& problem, MpcPlan* plan) const {
  const double w = problem.tactile_weight;
  const double bound_deg = config_.plate_bound_deg;
  const double rate_deg = config_.plate_rate_bound_deg;
  const bool has_rate_bound = std::isfinite(rate_deg);
  double last_plate_deg = has_rate_bound ? problem.plate_offset_deg : 0.0;
  double finger_deg = problem.finger_offset_deg;
  int i = 0;
  Command command{};
  const auto take = [&](const Command& step) {
    if (i == 0) command = step;
    if (plan) plan->plate_offset_deg[i] = step.plate_offset_deg, plan->active[i] = step.active;
    last_plate_deg = step.plate_offset_deg;
    ++i;
  };

  // Out of the bound, and too far to come back in one step: full speed towards it.
  while (has_rate_bound && i < config_.horizon && std::abs(last_plate_deg) > bound_deg + rate_deg) {
    const bool above = last_plate_deg > 0.0;
    const double plate_deg = last_plate_deg + (above ? -rate_deg : rate_deg);
    finger_deg += participant_step_on_plate({.tactile_weight = w,
                                             .gain = problem.gains[i],
                                             .goal_direction_deg = 0.0,
                                             .plate_orientation_deg = plate_deg,
                                             .finger_direction_deg = finger_deg})
                      .motor_command_deg;
    take({plate_deg, above ? ActiveBound::rate_down : ActiveBound::rate_up, true});
  }
  if (i == config_.horizon) return command;

  const int forced = i;
  const WindowProblem window =
      window_of(config_, problem, forced, finger_deg - problem.real_offset_deg, last_plate_deg);
  WindowSolution solution;
  WorkingSet held;
  solve_window(window, held, solution);
  do {
    take(command_of(config_, window, solution, held, i - forced, w, last_plate_deg));
  } while (plan && i < config_.horizon);
  return command;
}

void Mpc::solve_window(const WindowProblem& window, WorkingSet& held, WindowSolution& solution) const {
  plate_bound_solver_.solve(window, held, solution);
  if (!solution.optimal) solve_rate_bound(window, held, solution);
}

}  // namespace hrt
