#include "core/mpc_active_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrt {
namespace {

// The constraint multipliers, with the sign of the bound they belong to: >= 0 at an upper bound, <= 0 at
// a lower one, 0 where none is held. Stationarity at step i reads
//     gradient_i + pin_i + link_i - link_i+1 = 0.
struct Multipliers {
  std::array<double, max_horizon> pin{};
  std::array<double, max_horizon> link{};
};

// A constraint that may be held: step i's pin or link at the bound of `sign`.
struct Constraint {
  bool is_link;
  int i;
  std::int8_t sign;  // 0: no constraint
};

// Stands in for a smaller gain: nothing the plate does is felt, but divisions by it stay finite.
constexpr double smallest_gain = 1e-12;

class DualActiveSet {
 public:
  DualActiveSet(const WindowProblem& problem, WorkingSet& working_set, WindowSolution& solution)
      : problem_(problem), set_(working_set), solution_(solution) {
    const double scale_deg =
        std::abs(problem.miss_deg) + std::abs(problem.real_offset_deg) + problem.bound_deg;
    multiplier_tolerance_ = 1e-14 * (problem.perceived_weight + problem.actual_weight) * scale_deg;
    plate_tolerance_deg_ = 1e-14 * scale_deg;
  }

  void run() {
    solution_.sweeps = 0;
    make_dual_feasible();
    while (true) {
      const Constraint violated = most_violated();
      solution_.optimal = violated.sign == 0;
      if (solution_.optimal || !add(violated)) break;
    }
  }

 private:
  // Optimum under the constraints held, as if all others did not exist: solution_ and target_.
  void solve_held();
  void resolve_fixed();
  void sweep_backwards();
  void sweep_forwards();
  void find_multipliers();

  void make_dual_feasible();
  Constraint most_violated() const;
  bool add(Constraint constraint);
  bool depends_on_held(Constraint constraint) const;
  void push_to_ground(int i, double flow);
  std::int8_t& held(const Constraint& c) { return (c.is_link ? set_.link : set_.pin)[c.i]; }
  static double& value(Multipliers& multipliers, const Constraint& c) {
    return (c.is_link ? multipliers.link : multipliers.pin)[c.i];
  }

  double gain(int i) const { return std::max(problem_.gains[i], smallest_gain); }

  const WindowProblem& problem_;
  WorkingSet& set_;
  WindowSolution& solution_;
  double multiplier_tolerance_;
  double plate_tolerance_deg_;

  std::array<bool, max_horizon> fixed_;       // u_i is determined by the constraints held alone
  std::array<double, max_horizon> law_gain_;  // u_i = law_gain x_i + law_constant where it is chosen freely
  std::array<double, max_horizon> law_constant_;
  std::array<double, max_horizon> gradient_;  // half the derivative of the cost by u_i
  Multipliers current_;
  Multipliers target_;
};

void DualActiveSet::resolve_fixed() {
  const int n = problem_.horizon;
  auto& u = solution_.plate_deg;
  for (int i = 0; i < n; ++i) {
    fixed_[i] = true;
    if (set_.pin[i])
      u[i] = set_.pin[i] * problem_.bound_deg;
    else if (set_.link[i] && i == 0)
      u[i] = problem_.last_plate_deg + set_.link[i] * problem_.rate_deg;
    else if (set_.link[i] && fixed_[i - 1])
      u[i] = u[i - 1] + set_.link[i] * problem_.rate_deg;
    else
      fixed_[i] = false;
  }
  for (int i = n - 1; i > 0; --i) {
    if (!fixed_[i] || !set_.link[i] || fixed_[i - 1]) continue;
    u[i - 1] = u[i] - set_.link[i] * problem_.rate_deg;
    fixed_[i - 1] = true;
  }
}

// The cost to go from x_i is s x^2 + 2 r x plus a constant. Within a run of linked steps that no pin
// fixes, it depends on the run's free level z too: s x^2 + 2 m x z + v z^2 + 2 r x + 2 f z.
void DualActiveSet::sweep_backwards() {
  const int n = problem_.horizon;
  const double q_perceived = problem_.perceived_weight;
  const double q_actual = problem_.actual_weight;
  const double pw = problem_.proprioceptive_weight;
  double s = 0.0, r = 0.0;
  double m = 0.0, v = 0.0, f = 0.0;
  double level_deg = 0.0;  // u_i - z
  for (int i = n - 1; i >= 0; --i) {
    const double k = gain(i);
    const double a = k * pw;  // e = a x + k u + a p_R
    const bool leads = !set_.link[i];
    const bool followed = i + 1 < n && set_.link[i + 1];
    if (!fixed_[i] && leads && !followed) {
      const double inverse = 1.0 / (q_perceived + s);
      law_gain_[i] = s * inverse / k - pw;
      law_constant_[i] = r * inverse / k - pw * problem_.real_offset_deg;
      r *= q_perceived * inverse;
      s = q_actual + q_perceived * inverse * s;
      continue;
    }
    const double u = fixed_[i] ? solution_.plate_deg[i] : level_deg;
    const double d = k * u + a * problem_.real_offset_deg;  // e without x and z
    if (!fixed_[i]) {
      f = q_perceived * k * d - k * (r - s * d) + f - m * d;
      r = q_perceived * a * d + (1.0 - a) * (r - s * d);
      v = q_perceived * k * k + k * k * s - 2.0 * k * m + v;
      m = q_perceived * a * k + (1.0 - a) * (m - k * s);
      s = q_actual + q_perceived * a * a + (1.0 - a) * (1.0 - a) * s;
      level_deg -= set_.link[i] * problem_.rate_deg;
      if (!leads) continue;
      law_gain_[i] = -m / v;
      law_constant_[i] = level_deg - f / v;
      s -= m * m / v;
      r -= m * f / v;
      m = v = f = level_deg = 0.0;
    } else {
      r = q_perceived * a * d + (1.0 - a) * (r - s * d);
      s = q_actual + q_perceived * a * a + (1.0 - a) * (1.0 - a) * s;
    }
  }
}

void DualActiveSet::sweep_forwards() {
  double x = problem_.miss_deg;
  auto& u = solution_.plate_deg;
  for (int i = 0; i < problem_.horizon; ++i) {
    if (!fixed_[i])
      u[i] = set_.link[i] ? u[i - 1] + set_.link[i] * problem_.rate_deg : law_gain_[i] * x + law_constant_[i];
    const double e = gain(i) * (u[i] + problem_.proprioceptive_weight * (x + problem_.real_offset_deg));
    solution_.error_deg[i] = e;
    solution_.miss_deg[i] = x;
    x -= e;
  }
}

// The gradient by the adjoint recursion, then the multipliers that balance it. A run of linked steps is a
// chain along which link multipliers flow; what is left of the chain's total goes to ground at its pin or
// at u_k-1. A run without either is free, and its gradients sum to 0 at the optimum.
void DualActiveSet::find_multipliers() {
  const int n = problem_.horizon;
  double slope = 0.0;  // half the derivative of the cost to go by x_i+1
  for (int i = n - 1; i >= 0; --i) {
    const double k = gain(i);
    const double a = k * problem_.proprioceptive_weight;
    const double weighted_error = problem_.perceived_weight * solution_.error_deg[i];
    gradient_[i] = k * (weighted_error - slope);
    slope = problem_.actual_weight * solution_.miss_deg[i] + a * weighted_error + (1.0 - a) * slope;
  }
  for (int first = 0, end; first < n; first = end) {
    double total = gradient_[first];
    for (end = first + 1; end < n && set_.link[end]; ++end) total += gradient_[end];
    double flow = set_.link[first] ? -total : 0.0;
    for (int i = first; i < end; ++i) {
      target_.link[i] = flow;
      target_.pin[i] = set_.pin[i] ? -total : 0.0;
      flow += gradient_[i] + target_.pin[i];
    }
  }
}

void DualActiveSet::solve_held() {
  ++solution_.sweeps;
  resolve_fixed();
  sweep_backwards();
  sweep_forwards();
  find_multipliers();
}

// Lets go of every constraint that pulls the wrong way until none does.
void DualActiveSet::make_dual_feasible() {
  bool dropped = true;
  while (dropped) {
    solve_held();
    dropped = false;
    for (int i = 0; i < problem_.horizon; ++i) {
      const double slack = multiplier_tolerance_ * gain(i);
      if (set_.pin[i] * target_.pin[i] < -slack) set_.pin[i] = 0, dropped = true;
      if (set_.link[i] * target_.link[i] < -slack) set_.link[i] = 0, dropped = true;
    }
  }
  current_ = target_;
}

Constraint DualActiveSet::most_violated() const {
  Constraint most{false, 0, 0};
  double largest_deg = plate_tolerance_deg_;
  const auto consider = [&](double excess_deg, bool is_link, int i, double sign) {
    const double effect_deg = excess_deg * gain(i);
    if (effect_deg <= largest_deg) return;
    largest_deg = effect_deg;
    most = {is_link, i, static_cast<std::int8_t>(sign < 0.0 ? -1 : 1)};
  };
  double last_deg = problem_.last_plate_deg;
  for (int i = 0; i < problem_.horizon; ++i) {
    const double u = solution_.plate_deg[i];
    if (!set_.pin[i]) consider(std::abs(u) - problem_.bound_deg, false, i, u);
    if (!set_.link[i]) consider(std::abs(u - last_deg) - problem_.rate_deg, true, i, u - last_deg);
    last_deg = u;
  }
  return most;
}

// Whether the constraints held already determine the value that `constraint` would set.
bool DualActiveSet::depends_on_held(Constraint constraint) const {
  if (!fixed_[constraint.i]) return false;
  return !constraint.is_link || constraint.i == 0 || fixed_[constraint.i - 1];
}

// Adds to target_ what balances a multiplier `flow` that enters at step i of a fixed run.
void DualActiveSet::push_to_ground(int i, double flow) {
  int pinned = i;
  while (!set_.pin[pinned] && pinned + 1 < problem_.horizon && set_.link[pinned + 1]) ++pinned;
  if (set_.pin[pinned]) {
    for (int j = i + 1; j <= pinned; ++j) target_.link[j] += flow;
    target_.pin[pinned] -= flow;
    return;
  }
  for (int j = i; j >= 0; --j) {
    if (set_.pin[j]) {
      target_.pin[j] -= flow;
      return;
    }
    target_.link[j] -= flow;
  }
}

// Moves along the dual to where `constraint` holds as well, letting go of those that come to pull the
// wrong way. False if out of sweeps.
bool DualActiveSet::add(Constraint constraint) {
  while (solution_.sweeps < max_active_set_sweeps) {
    resolve_fixed();
    const bool dependent = depends_on_held(constraint);
    if (dependent) {
      // The plate cannot move. Only the multipliers do, by a circulation, until one of them is gone.
      ++solution_.sweeps;
      target_ = current_;
      value(target_, constraint) += constraint.sign;
      push_to_ground(constraint.i, constraint.sign);
      if (constraint.is_link && constraint.i > 0) push_to_ground(constraint.i - 1, -constraint.sign);
    } else {
      held(constraint) = constraint.sign;
      solve_held();
      held(constraint) = 0;
    }
    // The first multiplier to vanish on the way from current_ to target_, and beyond if dependent.
    double step = dependent ? std::numeric_limits<double>::infinity() : 1.0;
    Constraint blocking{false, 0, 0};
    const auto consider = [&](const Constraint& c) {
      if (c.sign == 0) return;
      const double from = c.sign * value(current_, c);
      const double to = c.sign * value(target_, c);
      if (to >= from || (!dependent && to >= -multiplier_tolerance_ * gain(c.i))) return;
      const double at = std::max(0.0, from) / (from - to);
      if (at < step) step = at, blocking = c;
    };
    for (int i = 0; i < problem_.horizon; ++i) {
      consider({false, i, set_.pin[i]});
      consider({true, i, set_.link[i]});
    }
    if (blocking.sign == 0) {
      held(constraint) = constraint.sign;
      current_ = target_;
      return !dependent;
    }
    for (int i = 0; i < problem_.horizon; ++i) {
      current_.pin[i] += step * (target_.pin[i] - current_.pin[i]);
      current_.link[i] += step * (target_.link[i] - current_.link[i]);
    }
    held(blocking) = 0;
    value(current_, blocking) = 0.0;
  }
  return false;
}

}  // namespace

void solve_active_set(const WindowProblem& problem, WorkingSet& working_set, WindowSolution& solution) {
  DualActiveSet(problem, working_set, solution).run();
}

}  // namespace hrt
