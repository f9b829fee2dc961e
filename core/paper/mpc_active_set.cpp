#include "core/paper/mpc_active_set.h"

#include <algorithm>
#include <limits>

namespace hrt {
namespace {

// The constraint multipliers, with the sign of the bound they belong to: >= 0 at an upper bound, <= 0 at
// a lower one, 0 where none is held. Stationarity at step i reads
//     gradient_i + pin_i + link_i - link_i+1 = 0.
struct Multipliers {
  std::array<double, max_horizon> pin;
  std::array<double, max_horizon> link;
};

// A constraint that may be held: step i's pin or link at the bound of `sign`.
struct Constraint {
  bool is_link;
  int i;
  std::int8_t sign;  // 0: no constraint
};

class DualActiveSet {
 public:
  DualActiveSet(const FeltWindow& window, int max_passes, std::array<double, max_horizon>& plate_deg, WorkingSet& held);

  bool climb();

 private:
  void hold_clamping();

  // Optimum under the constraints held, as if all others did not exist: plate_deg_ and target_.
  void solve_held();
  void resolve_fixed();
  void sweep_backwards();
  void sweep_forwards();
  void find_multipliers();
  void copy(const Multipliers& from, Multipliers& to) const;

  bool make_dual_feasible();
  Constraint max_violated() const;
  bool add(Constraint constraint);
  bool depends_on_held(Constraint constraint) const;
  void push_to_ground(int i, double flow);
  std::int8_t& held(const Constraint& c) { return (c.is_link ? set_.link : set_.pin)[c.i]; }
  static double& value(Multipliers& multipliers, const Constraint& c) {
    return (c.is_link ? multipliers.link : multipliers.pin)[c.i];
  }

  const FeltWindow& window_;
  const WindowProblem& problem_;
  double multiplier_tolerance_;
  double plate_tolerance_deg_;
  int sweeps_left_;
  int steps_;
  WorkingSet& set_;
  std::array<double, max_horizon>& plate_deg_;

  struct CostToGo {  // from x_i: s x^2 + 2 m x u_i-1 + 2 r x, and what does not depend on x
    double s;
    double m;
    double r;
  };
  std::array<CostToGo, max_horizon + 1> cost_to_go_;
  WorkingSet swept_{};  // for which they hold

  std::array<bool, max_horizon> fixed_;       // u_i is determined by the constraints held alone
  std::array<double, max_horizon> law_gain_;  // u_i = law_gain x_i + law_constant where it is chosen freely
  std::array<double, max_horizon> law_constant_;
  std::array<double, max_horizon> gradient_;  // half the derivative of the cost by u_i
  Multipliers current_;
  Multipliers target_;
};

DualActiveSet::DualActiveSet(const FeltWindow& window, int max_passes, std::array<double, max_horizon>& plate_deg,
                             WorkingSet& held)
    : window_(window),
      problem_(window.problem),
      multiplier_tolerance_((problem_.perceived_weight + problem_.actual_weight) * tolerance_deg(problem_)),
      plate_tolerance_deg_(tolerance_deg(problem_)),
      sweeps_left_(max_passes),
      steps_(window.steps),
      set_(held),
      plate_deg_(plate_deg) {
  cost_to_go_[steps_] = {window.last_miss_weight, 0.0, 0.0};
  swept_.pin.fill(2);  // of no step
}

// Holds the bounds that clamp the path in plate_deg_, step after step.
void DualActiveSet::hold_clamping() {
  set_ = {};
  double last_deg = problem_.last_plate_deg;
  for (int i = 0; i < steps_; ++i) {
    const double u = plate_deg_[i];
    const double high_deg = std::min(problem_.bound_deg, last_deg + window_.rate_deg[i]);
    const double low_deg = std::max(-problem_.bound_deg, last_deg - window_.rate_deg[i]);
    if (u >= high_deg) (high_deg == problem_.bound_deg ? set_.pin : set_.link)[i] = 1;
    if (u <= low_deg) (low_deg == -problem_.bound_deg ? set_.pin : set_.link)[i] = -1;
    last_deg = std::clamp(u, low_deg, high_deg);
  }
}

// From one optimum of the constraints held to the next, as the header says. False if out of sweeps.
bool DualActiveSet::climb() {
  hold_clamping();
  if (!make_dual_feasible()) return false;
  for (;;) {
    const Constraint violated = max_violated();
    if (violated.sign == 0) return true;
    if (!add(violated)) return false;
  }
}

void DualActiveSet::resolve_fixed() {
  auto& u = plate_deg_;
  double last_deg = problem_.last_plate_deg;
  bool fixed = true;
  for (int i = 0; i < steps_; ++i) {
    const std::int8_t pin = set_.pin[i];
    const std::int8_t link = set_.link[i];
    fixed = pin != 0 || (link != 0 && fixed);
    fixed_[i] = fixed;
    if (fixed) u[i] = last_deg = pin ? pin * problem_.bound_deg : last_deg + link * window_.rate_deg[i];
    if (pin == 0) continue;
    for (int j = i; j > 0 && set_.link[j]; --j) {
      u[j - 1] = u[j] - set_.link[j] * window_.rate_deg[j];
      fixed_[j - 1] = true;
    }
  }
}

// The cost to go from x_i is s x^2 + 2 r x plus a constant. Within a run of linked steps that no pin
// fixes, it depends on the run's free level z too: s x^2 + 2 m x z + v z^2 + 2 r x + 2 f z.
void DualActiveSet::sweep_backwards() {
  const int n = steps_;
  const double q_perceived = problem_.perceived_weight;
  const double pw = problem_.proprioceptive_weight;
  // Behind the run of the last constraint that changed since the last sweep, costs to go are as they were.
  int from = n - 1;
  while (from >= 0 && set_.pin[from] == swept_.pin[from] && set_.link[from] == swept_.link[from]) --from;
  while (from + 1 < n && set_.link[from + 1]) ++from;
  swept_ = set_;
  auto [s, unused, r] = cost_to_go_[from + 1];  // of no link
  double m = 0.0, v = 0.0, f = 0.0;
  double level_deg = 0.0;  // u_i - z
  for (int i = from; i >= 0; --i) {
    const double k = window_.gain[i];
    const double q_actual = window_.miss_weight[i];
    const double a = k * pw;  // e = a x + k u + a p_R
    const bool leads = !set_.link[i];
    const bool followed = i + 1 < n && set_.link[i + 1];
    if (!fixed_[i] && leads && !followed) {
      const double inverse = 1.0 / (q_perceived + s);
      const double per_gain = inverse / k;
      law_gain_[i] = s * per_gain - pw;
      law_constant_[i] = r * per_gain - pw * problem_.real_offset_deg;
      r *= q_perceived * inverse;
      s = q_actual + q_perceived * inverse * s;
      cost_to_go_[i] = {s, 0.0, r};
      continue;
    }
    const double u = fixed_[i] ? plate_deg_[i] : level_deg;
    const double d = k * u + a * problem_.real_offset_deg;  // e without x and z
    if (!fixed_[i]) {
      f = q_perceived * k * d - k * (r - s * d) + f - m * d;
      r = q_perceived * a * d + (1.0 - a) * (r - s * d);
      v = q_perceived * k * k + k * k * s - 2.0 * k * m + v;
      m = q_perceived * a * k + (1.0 - a) * (m - k * s);
      s = q_actual + q_perceived * a * a + (1.0 - a) * (1.0 - a) * s;
      level_deg -= set_.link[i] * window_.rate_deg[i];
      if (!leads) {
        cost_to_go_[i] = {s, m, r - m * level_deg};
        continue;
      }
      law_gain_[i] = -m / v;
      law_constant_[i] = level_deg - f / v;
      s -= m * m / v;
      r -= m * f / v;
      m = v = f = level_deg = 0.0;
    } else {
      r = q_perceived * a * d + (1.0 - a) * (r - s * d);
      s = q_actual + q_perceived * a * a + (1.0 - a) * (1.0 - a) * s;
    }
    cost_to_go_[i] = {s, 0.0, r};
  }
}

// The gradient comes with it, from the slope of the cost to go by x_i+1.
void DualActiveSet::sweep_forwards() {
  const double q_perceived = problem_.perceived_weight;
  double x = problem_.miss_deg;
  double u = problem_.last_plate_deg;
  for (int i = 0; i < steps_; ++i) {
    if (fixed_[i])
      u = plate_deg_[i];
    else
      plate_deg_[i] = u = set_.link[i] ? u + set_.link[i] * window_.rate_deg[i] : law_gain_[i] * x + law_constant_[i];
    const double e = window_.gain[i] * (u + problem_.proprioceptive_weight * (x + problem_.real_offset_deg));
    x -= e;
    const auto& [s, m, r] = cost_to_go_[i + 1];
    gradient_[i] = window_.gain[i] * (q_perceived * e - (s * x + m * u + r));
  }
}

// The multipliers that balance the gradient. A run of linked steps is a chain along which link multipliers flow;
// what is left of the chain's total goes to ground at its pin or at u_k-1. A run without either is free, and its
// gradients sum to 0 at the optimum.
void DualActiveSet::find_multipliers() {
  for (int i = steps_ - 1; i > 0; --i)
    if (set_.link[i]) gradient_[i - 1] += gradient_[i];  // now of all the run from here on
  double to_pin = 0.0;
  for (int i = 0; i < steps_; ++i) {
    if (!set_.link[i]) to_pin = gradient_[i];
    target_.link[i] = to_pin - gradient_[i];
    target_.pin[i] = 0.0;
    if (set_.pin[i]) target_.pin[i] = -to_pin, to_pin = 0.0;
  }
}

void DualActiveSet::copy(const Multipliers& from, Multipliers& to) const {
  for (int i = 0; i < steps_; ++i) {
    to.pin[i] = from.pin[i];
    to.link[i] = from.link[i];
  }
}

void DualActiveSet::solve_held() {
  --sweeps_left_;
  resolve_fixed();
  sweep_backwards();
  sweep_forwards();
  find_multipliers();
}

// Lets go of constraints that pull the wrong way until none does. False if out of sweeps.
bool DualActiveSet::make_dual_feasible() {
  bool dropped = true;
  while (dropped && sweeps_left_ > 0) {
    solve_held();
    dropped = false;
    for (int i = 0; i < steps_; ++i) {
      const double slack = multiplier_tolerance_ * window_.gain[i];
      if (set_.pin[i] * target_.pin[i] < -slack) set_.pin[i] = 0, dropped = true;
      if (set_.link[i] * target_.link[i] < -slack) set_.link[i] = 0, dropped = true;
    }
  }
  copy(target_, current_);
  return !dropped;
}

Constraint DualActiveSet::max_violated() const {
  Constraint max{false, 0, 0};
  double max_deg = plate_tolerance_deg_;
  const auto consider = [&](double excess_deg, bool is_link, int i, double sign) {
    const double effect_deg = excess_deg * window_.gain[i];
    if (effect_deg <= max_deg) return;
    max_deg = effect_deg;
    max = {is_link, i, static_cast<std::int8_t>(sign < 0.0 ? -1 : 1)};
  };
  double last_deg = problem_.last_plate_deg;
  for (int i = 0; i < steps_; ++i) {
    const double u = plate_deg_[i];
    if (!set_.pin[i]) consider(std::abs(u) - problem_.bound_deg, false, i, u);
    if (!set_.link[i]) consider(std::abs(u - last_deg) - window_.rate_deg[i], true, i, u - last_deg);
    last_deg = u;
  }
  return max;
}

// Whether the constraints held already determine the value that `constraint` would set.
bool DualActiveSet::depends_on_held(Constraint constraint) const {
  if (!fixed_[constraint.i]) return false;
  return !constraint.is_link || constraint.i == 0 || fixed_[constraint.i - 1];
}

// Adds to target_ the balance of a multiplier `flow` that enters at step i of a fixed run.
void DualActiveSet::push_to_ground(int i, double flow) {
  int pinned = i;
  while (!set_.pin[pinned] && pinned + 1 < steps_ && set_.link[pinned + 1]) ++pinned;
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
  while (sweeps_left_ > 0) {
    resolve_fixed();
    const bool dependent = depends_on_held(constraint);
    if (dependent) {
      // The plate cannot move. Only the multipliers do, by a circulation, until one of them is gone.
      --sweeps_left_;
      copy(current_, target_);
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
      if (to >= from || (!dependent && to >= -multiplier_tolerance_ * window_.gain[c.i])) return;
      const double at = std::max(0.0, from) / (from - to);
      if (at < step) step = at, blocking = c;
    };
    for (int i = 0; i < steps_; ++i) {
      consider({false, i, set_.pin[i]});
      consider({true, i, set_.link[i]});
    }
    if (blocking.sign == 0) {
      held(constraint) = constraint.sign;
      copy(target_, current_);
      return !dependent;
    }
    for (int i = 0; i < steps_; ++i) {
      current_.pin[i] += step * (target_.pin[i] - current_.pin[i]);
      current_.link[i] += step * (target_.link[i] - current_.link[i]);
    }
    held(blocking) = 0;
    value(current_, blocking) = 0.0;
  }
  return false;
}

}  // namespace

bool solve_active_set(const FeltWindow& window, int max_passes, std::array<double, max_horizon>& plate_deg,
                      WorkingSet& held) {
  return DualActiveSet(window, max_passes, plate_deg, held).climb();
}

}  // namespace hrt
