#include "core/mpc.h"

#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

ActiveBound active_bound(const WorkingSet& set, int i) {
  if (set.pin[i]) return set.pin[i] > 0 ? ActiveBound::upper : ActiveBound::lower;
  if (set.link[i]) return set.link[i] > 0 ? ActiveBound::rate_up : ActiveBound::rate_down;
  return ActiveBound::none;
}

WindowProblem window_of(const MpcConfig& config, const MpcProblem& problem) {
  const double w = problem.tactile_weight;
  return {
      .horizon = config.horizon,
      .perceived_weight = config.perceived_weight,
      .actual_weight = config.actual_weight,
      .miss_deg = problem.finger_offset_deg - problem.real_offset_deg,
      .real_offset_deg = problem.real_offset_deg,
      .proprioceptive_weight = 1.0 - w,
      .bound_deg = w * config.plate_bound_deg,
      .rate_deg = w * config.plate_rate_bound_deg,
      .last_plate_deg = 0.0,
      .gains = problem.gains,
  };
}

// t of u. Rounding must not carry it past the plate bound, nor keep it from standing exactly on it.
double plate_offset_deg(const MpcConfig& config, const MpcProblem& problem, int pin, double felt_plate_deg) {
  if (pin != 0) return pin * config.plate_bound_deg;
  return std::clamp(felt_plate_deg * (1.0 / problem.tactile_weight), -config.plate_bound_deg,
                    config.plate_bound_deg);
}

}  // namespace

bool is_valid(const MpcConfig& config) {
  return config.horizon >= 1 && config.horizon <= max_horizon && std::isfinite(config.perceived_weight) &&
         config.perceived_weight > 0.0 && std::isfinite(config.actual_weight) &&
         config.actual_weight >= 0.0 && config.plate_bound_deg > 0.0 && config.plate_bound_deg <= 90.0 &&
         config.plate_rate_bound_deg > 0.0;
}

Mpc::Mpc(const MpcConfig& config)
    : config_(config), plate_bound_solver_(config.horizon, config.perceived_weight, config.actual_weight) {}

Mpc::Command Mpc::solve(const MpcProblem& problem, MpcDiagnostics* diagnostics) {
  if (std::isinf(config_.plate_rate_bound_deg) && !diagnostics) {
    WindowSolution solution;
    plate_bound_solver_.solve(window_of(config_, problem), 1, working_set_, solution);
    return {plate_offset_deg(config_, problem, working_set_.pin[0], solution.plate_deg[0]),
            active_bound(working_set_, 0)};
  }
  return solve_step_by_step(problem, diagnostics);
}

// With the whole window's solution, or a plate that may have to come back into its bound first.
Mpc::Command Mpc::solve_step_by_step(const MpcProblem& problem, MpcDiagnostics* diagnostics) {
  const double w = problem.tactile_weight;
  const double bound_deg = config_.plate_bound_deg;
  const double rate_deg = config_.plate_rate_bound_deg;
  const bool has_rate_bound = std::isfinite(rate_deg);
  double finger_deg = problem.finger_offset_deg;
  double last_plate_deg = problem.plate_offset_deg;
  double cost = 0.0;
  int i = 0;
  Command command{};
  const auto take = [&](double plate_deg, ActiveBound active) {
    if (i == 0) command = {plate_deg, active};
    const double error_deg =
        problem.gains[i] * (w * ridge_normal_deg(plate_deg, 0.0) + (1.0 - w) * finger_deg);
    const double miss_deg = finger_deg - problem.real_offset_deg;
    if (diagnostics) {
      diagnostics->active[i] = active;
      diagnostics->plate_offset_deg[i] = plate_deg;
      diagnostics->perceived_error_deg[i] = error_deg;
      diagnostics->finger_offset_deg[i] = finger_deg;
    }
    cost += config_.perceived_weight * error_deg * error_deg + config_.actual_weight * miss_deg * miss_deg;
    finger_deg -= error_deg;
    last_plate_deg = plate_deg;
    ++i;
  };

  // Out of the bound, and too far to come back in one step: full speed towards it is all there is.
  while (has_rate_bound && i < config_.horizon && std::abs(last_plate_deg) > bound_deg + rate_deg) {
    const bool above = last_plate_deg > 0.0;
    take(last_plate_deg + (above ? -rate_deg : rate_deg),
         above ? ActiveBound::rate_down : ActiveBound::rate_up);
  }

  if (const int forced = i; forced < config_.horizon) {
    WindowProblem window = window_of(config_, problem);
    window.horizon -= forced;
    window.miss_deg = finger_deg - problem.real_offset_deg;
    window.last_plate_deg = has_rate_bound ? w * last_plate_deg : 0.0;
    window.gains += forced;
    WindowSolution solution;
    if (has_rate_bound)
      solve_active_set(window, working_set_, solution);
    else
      plate_bound_solver_.solve(window, diagnostics ? config_.horizon : 1, working_set_, solution);
    while (i < config_.horizon) {
      const int step = i - forced;
      const ActiveBound active = active_bound(working_set_, step);
      double plate_deg = plate_offset_deg(config_, problem, working_set_.pin[step], solution.plate_deg[step]);
      if (active == ActiveBound::rate_up) plate_deg = last_plate_deg + rate_deg;
      if (active == ActiveBound::rate_down) plate_deg = last_plate_deg - rate_deg;
      if (has_rate_bound && working_set_.pin[step] == 0)
        plate_deg = std::clamp(plate_deg, last_plate_deg - rate_deg, last_plate_deg + rate_deg);
      take(std::clamp(plate_deg, -bound_deg, bound_deg), active);
      if (!diagnostics) break;
    }
  }
  if (diagnostics) {
    diagnostics->horizon = config_.horizon;
    diagnostics->cost = cost;
  }
  return command;
}

}  // namespace hrt
