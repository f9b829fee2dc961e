#include "core/mpc.h"

#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

// With x_i = p_i - p_R and the perceived error e_i as the input, x_i+1 = x_i - e_i, and the cost to go
// from x_i is S_i x_i^2 + 2 r_i x_i plus a constant for given active bounds.
struct CostToGo {
  double s;
  double r;
};

// Sweeps that a problem may take before the last one counts. Problems of a closed loop take one or two.
constexpr int max_sweeps = 4 * max_horizon;

}  // namespace

bool is_valid(const MpcConfig& config) {
  return config.horizon >= 1 && config.horizon <= max_horizon && std::isfinite(config.perceived_weight) &&
         config.perceived_weight > 0.0 && std::isfinite(config.actual_weight) &&
         config.actual_weight >= 0.0 && config.plate_bound_deg > 0.0 && config.plate_bound_deg <= 90.0 &&
         config.plate_rate_bound_deg == std::numeric_limits<double>::infinity();
}

Mpc::Mpc(const MpcConfig& config) : config_(config) {}

Mpc::Command Mpc::solve(const MpcProblem& problem, MpcDiagnostics* diagnostics) {
  const int horizon = config_.horizon;
  const double q_perceived = config_.perceived_weight;
  const double q_actual = config_.actual_weight;
  const double w = problem.tactile_weight;
  const double bound = w * config_.plate_bound_deg;

  std::array<CostToGo, max_horizon + 1> to_go;
  Command command{};
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    // Backwards: the cost to go under the assumed active bounds.
    to_go[horizon] = {0.0, 0.0};
    for (int i = horizon - 1; i >= 0; --i) {
      const auto [s, r] = to_go[i + 1];
      const double k = problem.gains[i];
      if (active_[i] == ActiveBound::none) {
        const double share = q_perceived / (q_perceived + s);
        to_go[i] = {q_actual + share * s, share * r};
      } else {
        const double pull = k * (1.0 - w);
        const double push =
            k * ((1.0 - w) * problem.real_offset_deg + (active_[i] == ActiveBound::upper ? bound : -bound));
        to_go[i] = {q_actual + q_perceived * pull * pull + (1.0 - pull) * (1.0 - pull) * s,
                    q_perceived * pull * push + (1.0 - pull) * (r - s * push)};
      }
    }
    // Forwards: each step's optimum, clamped to what the plate can reach.
    bool settled = true;
    double cost = 0.0;
    double x = problem.finger_offset_deg - problem.real_offset_deg;
    for (int i = 0; i < horizon; ++i) {
      const auto [s, r] = to_go[i + 1];
      const double k = problem.gains[i];
      const double felt_by_finger = (1.0 - w) * (x + problem.real_offset_deg);
      const double wanted = (s * x + r) / (q_perceived + s) / k - felt_by_finger;  // w_T t_i
      const double slack = 1e-12 * bound;
      ActiveBound active = ActiveBound::none;
      if (wanted > bound + (active_[i] == ActiveBound::upper ? -slack : slack)) active = ActiveBound::upper;
      if (wanted < -bound - (active_[i] == ActiveBound::lower ? -slack : slack)) active = ActiveBound::lower;
      settled = settled && active == active_[i];
      active_[i] = active;
      const double plate = std::clamp(wanted, -bound, bound);
      const double e = k * (plate + felt_by_finger);
      if (i == 0) command = {plate / w, active};
      if (diagnostics) {
        diagnostics->active[i] = active;
        diagnostics->plate_offset_deg[i] = plate / w;
        diagnostics->perceived_error_deg[i] = e;
        diagnostics->finger_offset_deg[i] = x + problem.real_offset_deg;
        cost += q_perceived * e * e + q_actual * x * x;
      }
      x -= e;
    }
    if (diagnostics) {
      diagnostics->horizon = horizon;
      diagnostics->cost = cost;
    }
    if (settled) break;
  }
  return command;
}

}  // namespace hrt
