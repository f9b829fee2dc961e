#include "core/paper/mpc.h"

#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

// A smaller gain is treated as 0.
constexpr double min_gain = 1e-12;

// Returns the problem without steps of gain 0. Their rate bounds are added to that of the next step, and their weights
// to that of the next miss, because the finger's direction does not change in these steps.
Window window_of(const MpcConfig& config, const MpcProblem& problem, double last_plate_deg) {
  Window window;
  window.steps = 0;
  window.perceived_weight = config.perceived_weight;
  window.tactile_weight = problem.tactile_weight;
  window.finger_deg = problem.finger_offset_deg;
  window.real_deg = problem.real_offset_deg;
  window.bound_deg = config.plate_bound_deg;
  window.last_plate_deg = last_plate_deg;
  double rate_deg = 0.0;
  double weight = 0.0;
  for (int i = 0; i < config.horizon; ++i) {
    rate_deg += config.plate_rate_bound_deg;
    weight += config.actual_weight;
    if (problem.gains[i] < min_gain) continue;
    window.gain[window.steps] = problem.gains[i];
    window.rate_deg[window.steps] = rate_deg;
    window.miss_weight[window.steps] = weight;
    ++window.steps;
    rate_deg = weight = 0.0;
  }
  window.miss_weight[window.steps] = weight;
  return window;
}

}  // namespace

bool is_valid(const MpcConfig& config) {
  return config.horizon >= 1 && config.horizon <= max_horizon && std::isfinite(config.perceived_weight) &&
         config.perceived_weight > 0.0 && std::isfinite(config.actual_weight) && config.actual_weight >= 0.0 &&
         config.plate_bound_deg > 0.0 && config.plate_bound_deg <= 90.0 && config.plate_rate_bound_deg > 0.0;
}

Mpc::Mpc(const MpcConfig& config) : config_(config) {
  double cost = 0.0;  // S in "Table of gains" of README.md
  for (int left = 1; left <= config.horizon; ++left) {
    free_gain_[left] = cost / (config.perceived_weight + cost);
    cost = config.actual_weight + config.perceived_weight * free_gain_[left];
  }
}

// Sets `path` by free_gain_ and the bounds, and moves the path to the optimum. Returns false at the iteration limit.
bool Mpc::solve_window(const Window& window, WindowPath& path) const {
  double finger_deg = window.finger_deg;
  double last_deg = window.last_plate_deg;
  for (int i = 0; i < window.steps; ++i) {
    const double low_deg = std::max(-window.bound_deg, last_deg - window.rate_deg[i]);
    const double high_deg = std::min(window.bound_deg, last_deg + window.rate_deg[i]);
    const double finger_part_deg = (1.0 - window.tactile_weight) * finger_deg;
    const double error_deg = free_gain_[window.steps - i] * (finger_deg - window.real_deg);
    const double free_deg = (error_deg / window.gain[i] - finger_part_deg) / window.tactile_weight;
    const double plate_deg = free_deg >= high_deg ? high_deg : std::max(free_deg, low_deg);
    const int side = (free_deg >= high_deg) - (free_deg <= low_deg);
    const bool pinned = plate_deg == side * window.bound_deg;
    path.pin[i] = static_cast<std::int8_t>(pinned ? side : 0);
    path.link[i] = static_cast<std::int8_t>(pinned ? 0 : side);
    path.plate_deg[i] = last_deg = plate_deg;
    finger_deg -= window.gain[i] * (window.tactile_weight * plate_deg + finger_part_deg);
  }
  return window.steps == 0 || solve_active_set(window, path);
}

// Returns the optimum of a problem whose bounds may be active.
Mpc::Command Mpc::solve_bounded(const MpcProblem& problem, double last_deg, MpcPlan* plan) const {
  const double bound_deg = config_.plate_bound_deg;
  const double rate_deg = config_.plate_rate_bound_deg;
  const Window window = window_of(config_, problem, last_deg);
  WindowPath path;
  const bool optimal = solve_window(window, path);
  Command first{};
  for (int step = 0, i = 0; step < (plan ? config_.horizon : 1); ++step) {
    // At an active bound, the offset is computed from the bound, so that the offset cannot exceed the bound by
    // rounding. In a step that is not perceived, the plate rotates towards the offset of the next perceived step.
    const bool perceived = problem.gains[step] >= min_gain;
    const int side = !perceived ? 0 : path.pin[i] ? path.pin[i] : path.link[i];
    const double wanted_deg = side ? side * 2.0 * bound_deg : i < window.steps ? path.plate_deg[i] : last_deg;
    last_deg = std::clamp(std::clamp(wanted_deg, last_deg - rate_deg, last_deg + rate_deg), -bound_deg, bound_deg);
    const bool at_plate_bound = last_deg == side * bound_deg;
    const ActiveBound active = side > 0   ? (at_plate_bound ? ActiveBound::upper : ActiveBound::rate_up)
                               : side < 0 ? (at_plate_bound ? ActiveBound::lower : ActiveBound::rate_down)
                                          : ActiveBound::none;
    if (step == 0) first = {last_deg, active, optimal};
    if (plan) plan->plate_offset_deg[step] = last_deg, plan->active[step] = active;
    if (perceived) ++i;
  }
  return first;
}

Mpc::Command Mpc::solve(const MpcProblem& problem, MpcPlan* plan) const {
  const double bound_deg = config_.plate_bound_deg;
  const double rate_deg = config_.plate_rate_bound_deg;
  const double last_deg = std::isfinite(rate_deg) ? problem.plate_offset_deg : 0.0;
  if (last_deg > bound_deg + rate_deg) return {last_deg - rate_deg, ActiveBound::rate_down, true};
  if (last_deg < -bound_deg - rate_deg) return {last_deg + rate_deg, ActiveBound::rate_up, true};

  // The path by free_gain_ is the optimum unless the path reaches a bound or a step without gain.
  const double by_weight = 1.0 / problem.tactile_weight;
  const double finger_weight = 1.0 - problem.tactile_weight;
  double finger_deg = problem.finger_offset_deg;
  double plate_deg = last_deg;
  double first_deg = 0.0;
  for (int i = 0; i < config_.horizon; ++i) {
    const double before_deg = plate_deg;
    const double error_deg = free_gain_[config_.horizon - i] * (finger_deg - problem.real_offset_deg);
    plate_deg = (error_deg / problem.gains[i] - finger_weight * finger_deg) * by_weight;
    if (problem.gains[i] < min_gain || std::abs(plate_deg) >= bound_deg || std::abs(plate_deg - before_deg) >= rate_deg)
      return solve_bounded(problem, last_deg, plan);
    if (i == 0) first_deg = plate_deg;
    if (plan) plan->plate_offset_deg[i] = plate_deg, plan->active[i] = ActiveBound::none;
    finger_deg -= error_deg;
  }
  return {first_deg, ActiveBound::none, true};
}

}  // namespace hrt
