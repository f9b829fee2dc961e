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

// Passes from the path given, which is near the optimum in a closed loop. Then the solver starts anew from
// an interior point, which is worth more of them where windows are short.
constexpr int min_sweeps_from_path = 12;
constexpr int min_steps_from_path = 300;

// Of a million random problems none takes more than 25.
constexpr int max_interior_steps = 30;

// The work after which the solver gives up, in steps of passes over the window: 150 passes over the longest.
// No random problem of a million takes more than 27.
constexpr int max_steps_swept = 150 * max_horizon;

class DualActiveSet {
 public:
  DualActiveSet(const WindowProblem& problem, WorkingSet& working_set, WindowSolution& solution);

  void run();

 private:
  void hold_clamping();
  void hold_interior();

  bool climb();
  bool ascend();
  // Optimum under the constraints held, as if all others did not exist: plate_deg_ and target_.
  void resolve_fixed();
  void sweep_backwards();
  void sweep_forwards();
  void find_multipliers();

  Constraint max_violated() const;
  void hold_violated();
  bool exchange(Constraint constraint);
  void push_to_ground(int i, double flow);
  std::int8_t& held(const Constraint& c) { return (c.is_link ? set_.link : set_.pin)[c.i]; }
  void let_go(const Constraint& c) { held(c) = 0, value(current_, c) = 0.0; }
  static double& value(Multipliers& multipliers, const Constraint& c) {
    return (c.is_link ? multipliers.link : multipliers.pin)[c.i];
  }

  const WindowProblem& problem_;
  WorkingSet& window_set_;
  WindowSolution& solution_;
  double multiplier_tolerance_;
  double plate_tolerance_deg_;
  int sweeps_left_;

  // The steps at which the plate is felt. One that is not only adds to what the plate may turn until the
  // next, and to the weight of the miss that it leaves as it is.
  int steps_ = 0;
  double last_miss_weight_;             // of the miss after the last of them
  std::array<int, max_horizon> index_;  // in the window
  std::array<double, max_horizon> gain_;
  std::array<double, max_horizon> rate_deg_;
  std::array<double, max_horizon> miss_weight_;
  WorkingSet set_;

  struct CostToGo {  // from x_i: s x^2 + 2 m x u_i-1 + 2 r x, and what does not depend on x
    double s;
    double m;
    double r;
  };
  std::array<CostToGo, max_horizon + 1> cost_to_go_;
  WorkingSet swept_;  // for which they hold

  std::array<bool, max_horizon> fixed_;       // u_i is determined by the constraints held alone
  std::array<double, max_horizon> law_gain_;  // u_i = law_gain x_i + law_constant where it is chosen freely
  std::array<double, max_horizon> law_constant_;
  std::array<double, max_horizon> plate_deg_;
  std::array<double, max_horizon> gradient_;  // half the derivative of the cost by u_i
  Multipliers current_;
  Multipliers target_;
};

DualActiveSet::DualActiveSet(const WindowProblem& problem, WorkingSet& working_set, WindowSolution& solution)
    : problem_(problem),
      window_set_(working_set),
      solution_(solution),
      multiplier_tolerance_((problem.perceived_weight + problem.actual_weight) * tolerance_deg(problem)),
      plate_tolerance_deg_(tolerance_deg(problem)) {
  double rate_deg = 0.0;
  double miss_weight = 0.0;
  for (int i = 0; i < problem.horizon; ++i) {
    rate_deg += problem.rate_deg;
    miss_weight += problem.actual_weight;
    if (problem.gains[i] < min_step_gain) continue;
    index_[steps_] = i;
    gain_[steps_] = problem.gains[i];
    rate_deg_[steps_] = rate_deg;
    miss_weight_[steps_] = miss_weight;
    plate_deg_[steps_] = solution.plate_deg[i];
    ++steps_;
    rate_deg = miss_weight = 0.0;
  }
  last_miss_weight_ = miss_weight;
  cost_to_go_[steps_] = {miss_weight, 0.0, 0.0};
  swept_.pin.fill(2);  // of no step
}

void DualActiveSet::run() {
  hold_clamping();
  sweeps_left_ = std::max(min_sweeps_from_path, min_steps_from_path / std::max(steps_, 1));
  solution_.optimal = climb();
  if (!solution_.optimal) {
    hold_interior();
    sweeps_left_ = max_steps_swept / std::max(steps_, 1);
    solution_.optimal = climb();
  }
  window_set_ = {};
  for (int i = problem_.horizon - 1, step = steps_ - 1; i >= 0; --i) {
    if (step >= 0 && i == index_[step]) {
      window_set_.pin[i] = set_.pin[step];
      window_set_.link[i] = set_.link[step];
      --step;
    }
    solution_.plate_deg[i] = steps_ == 0 ? problem_.last_plate_deg : plate_deg_[std::min(step + 1, steps_ - 1)];
  }
}

// Holds the bounds that clamp the path in plate_deg_, step after step.
void DualActiveSet::hold_clamping() {
  set_ = {};
  double last_deg = problem_.last_plate_deg;
  for (int i = 0; i < steps_; ++i) {
    const double u = plate_deg_[i];
    const double high_deg = std::min(problem_.bound_deg, last_deg + rate_deg_[i]);
    const double low_deg = std::max(-problem_.bound_deg, last_deg - rate_deg_[i]);
    if (u >= high_deg) (high_deg == problem_.bound_deg ? set_.pin : set_.link)[i] = 1;
    if (u <= low_deg) (low_deg == -problem_.bound_deg ? set_.pin : set_.link)[i] = -1;
    last_deg = std::clamp(u, low_deg, high_deg);
  }
}

// Holds the bounds that an interior point method finds active. Each of its steps solves, in O(N) over the state
// (p_i, u_i-1), for where every slack times its multiplier is a twentieth of what it was meant to be before.
void DualActiveSet::hold_interior() {
  using Steps = std::array<double, max_horizon>;
  using Sides = std::array<Steps, 4>;  // u_i at its upper and lower bound, u_i - u_i-1 at its
  Sides bound, slack, multiplier, stiff, pull;
  Sides slack_growth{}, multiplier_growth{};  // relative, in a whole step
  Steps by_p, by_last, constant;              // u_i = by_p p_i + by_last u_i-1 + constant
  const double q = problem_.perceived_weight;
  const double pw = problem_.proprioceptive_weight;
  const double offset_deg = problem_.real_offset_deg;
  const double bound_deg = problem_.bound_deg;
  const double start_deg = std::clamp(problem_.last_plate_deg, -0.9 * bound_deg, 0.9 * bound_deg);
  const double unit = multiplier_tolerance_ * bound_deg;
  double product = 1e13 * unit;
  double step = 0.0;
  for (int i = 0; i < steps_; ++i) {
    const double rate_deg = std::min(rate_deg_[i], 4.0 * bound_deg + std::abs(problem_.last_plate_deg));
    const double slack_deg[] = {bound_deg - start_deg, bound_deg + start_deg, rate_deg, rate_deg};
    for (int side = 0; side < 4; ++side) {
      bound[side][i] = side < 2 ? bound_deg : rate_deg;
      slack[side][i] = slack_deg[side];
      multiplier[side][i] = product / bound[side][i];
    }
  }
  for (int left = max_interior_steps;; --left) {
    const double wanted = 0.05 * product;
    for (int side = 0; side < 4; ++side) {
      for (int i = 0; i < steps_; ++i) {
        const double s = slack[side][i] *= 1.0 + step * slack_growth[side][i];
        const double m = multiplier[side][i] *= 1.0 + step * multiplier_growth[side][i];
        const double per_product = 1.0 / (s * m);
        const double per_slack = m * per_product;
        stiff[side][i] = m * per_slack;
        pull[side][i] = per_slack * (wanted - m * (bound[side][i] - s));
        slack_growth[side][i] = per_slack;
        multiplier_growth[side][i] = wanted * per_product;
      }
    }
    if (left == 0 || product <= 1e3 * unit) break;
    // The cost to go is pp p^2 + 2 pu p u + uu u^2 + 2 p1 p + 2 u1 u in (p_i, u_i-1).
    double pp = last_miss_weight_, pu = 0.0, uu = 0.0, p1 = -last_miss_weight_ * offset_deg, u1 = 0.0;
    for (int i = steps_ - 1; i >= 0; --i) {
      const double k = gain_[i];
      const double a = k * pw;
      const double b = 1.0 - a;
      const double link = stiff[2][i] + stiff[3][i];
      const double link_pull = pull[2][i] - pull[3][i];
      const double alone = k * k * pp + ((uu - 2.0 * k * pu) + (k * k * q + stiff[0][i] + stiff[1][i]));
      const double inverse = 1.0 / (alone + link);
      const double cross = (k * a * q + b * pu) - k * b * pp;
      by_p[i] = -cross * inverse;
      by_last[i] = link * inverse;
      constant[i] = (k * p1 - u1 - (pull[0][i] - pull[1][i] + link_pull)) * inverse;
      pp = (miss_weight_[i] + a * a * q + b * b * pp) - cross * cross * inverse;
      pu = cross * by_last[i];
      uu = alone * by_last[i];
      p1 = (b * p1 - miss_weight_[i] * offset_deg) + cross * constant[i];
      u1 = -link_pull - link * constant[i];
    }
    double p = problem_.miss_deg + offset_deg;
    double last_deg = problem_.last_plate_deg;
    double least = -0.999;  // slacks and multipliers stay positive
    for (int i = 0; i < steps_; ++i) {
      const double u = (by_last[i] * last_deg + constant[i]) + by_p[i] * p;
      const double at_deg[] = {u, -u, u - last_deg, last_deg - u};
      for (int side = 0; side < 4; ++side) {
        const double grown = (bound[side][i] - at_deg[side]) * slack_growth[side][i];
        slack_growth[side][i] = grown - 1.0;
        multiplier_growth[side][i] -= grown;
        least = std::min({least, slack_growth[side][i], multiplier_growth[side][i]});
      }
      p -= gain_[i] * (u + pw * p);
      last_deg = u;
    }
    step = -0.999 / least;
    product *= 1.0 - 0.95 * step;
  }
  set_ = {};
  bool grounded = true;
  for (int i = 0; i < steps_; ++i) {
    const auto active = [&](int side) { return stiff[side][i] > 30.0 * q * gain_[i] * gain_[i]; };
    set_.link[i] = static_cast<std::int8_t>(active(2) - active(3));
    grounded &= set_.link[i] != 0;
    if (!grounded) set_.pin[i] = static_cast<std::int8_t>(active(0) - active(1));
    grounded |= set_.pin[i] != 0;
  }
}

// From one optimum of the constraints held to the next, as the header says. False if out of sweeps.
bool DualActiveSet::climb() {
  for (int i = 0; i < steps_; ++i) current_.pin[i] = current_.link[i] = 0.0;
  while (ascend()) {
    const Constraint violated = max_violated();
    if (violated.sign == 0) return true;
    // Whether those held already determine the value that it would set.
    const bool dependent = fixed_[violated.i] && (!violated.is_link || violated.i == 0 || fixed_[violated.i - 1]);
    if (dependent && !exchange(violated)) return false;
    held(violated) = violated.sign;
    if (!dependent) hold_violated();
  }
  return false;
}

void DualActiveSet::resolve_fixed() {
  auto& u = plate_deg_;
  double last_deg = problem_.last_plate_deg;
  bool fixed = true;
  for (int i = 0; i < steps_; ++i) {
    const int pin = set_.pin[i];
    const int link = set_.link[i];
    fixed = pin || (link && fixed);
    fixed_[i] = fixed;
    if (fixed) u[i] = last_deg = pin ? pin * problem_.bound_deg : last_deg + link * rate_deg_[i];
    if (!pin) continue;
    for (int j = i; j > 0 && set_.link[j]; --j) {
      u[j - 1] = u[j] - set_.link[j] * rate_deg_[j];
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
  auto [s, unused, r] = cost_to_go_[from + 1];
  double m = 0.0, v = 0.0, f = 0.0;
  double level_deg = 0.0;  // u_i - z
  for (int i = from; i >= 0; --i) {
    const double k = gain_[i];
    const double q_actual = miss_weight_[i];
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
      level_deg -= set_.link[i] * rate_deg_[i];
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
  const double q = problem_.perceived_weight;
  const double pw = problem_.proprioceptive_weight;
  const double offset_deg = problem_.real_offset_deg;
  double x = problem_.miss_deg;
  double u = problem_.last_plate_deg;
  for (int i = 0; i < steps_; ++i) {
    if (fixed_[i])
      u = plate_deg_[i];
    else
      plate_deg_[i] = u = set_.link[i] ? u + set_.link[i] * rate_deg_[i] : law_gain_[i] * x + law_constant_[i];
    const double e = gain_[i] * (u + pw * (x + offset_deg));
    x -= e;
    const auto& [s, m, r] = cost_to_go_[i + 1];
    gradient_[i] = gain_[i] * (q * e - (s * x + m * u + r));
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

// Moves along the dual to the optimum of the constraints held, letting go of those that come to pull the wrong
// way: at once of those that nothing is held by so far. False if out of sweeps.
bool DualActiveSet::ascend() {
  while (sweeps_left_ > 0) {
    --sweeps_left_;
    resolve_fixed();
    sweep_backwards();
    sweep_forwards();
    find_multipliers();
    double step = 1.0;
    Constraint blocking{false, 0, 0};  // whose multiplier vanishes first on the way from current_ to target_
    bool dropped = false;
    const auto consider = [&](const Constraint& c) {
      const double to = c.sign * value(target_, c);
      if (to >= -multiplier_tolerance_ * gain_[c.i]) return;
      const double from = c.sign * value(current_, c);
      if (from <= 0.0)
        let_go(c), dropped = true;
      else if (from < step * (from - to))
        step = from / (from - to), blocking = c;
    };
    for (int i = 0; i < steps_; ++i) {
      if (set_.pin[i]) consider({false, i, set_.pin[i]});
      if (set_.link[i]) consider({true, i, set_.link[i]});
    }
    if (dropped) continue;
    for (int i = 0; i < steps_; ++i) {
      current_.pin[i] += step * (target_.pin[i] - current_.pin[i]);
      current_.link[i] += step * (target_.link[i] - current_.link[i]);
    }
    if (blocking.sign == 0) return true;
    let_go(blocking);
  }
  return false;
}

Constraint DualActiveSet::max_violated() const {
  Constraint max{false, 0, 0};
  double max_deg = plate_tolerance_deg_;
  const auto consider = [&](double excess_deg, bool is_link, int i, double sign) {
    const double effect_deg = excess_deg * gain_[i];
    if (effect_deg <= max_deg) return;
    max_deg = effect_deg;
    max = {is_link, i, static_cast<std::int8_t>(sign < 0.0 ? -1 : 1)};
  };
  double last_deg = problem_.last_plate_deg;
  for (int i = 0; i < steps_; ++i) {
    const double u = plate_deg_[i];
    if (!set_.pin[i]) consider(std::abs(u) - problem_.bound_deg, false, i, u);
    if (!set_.link[i]) consider(std::abs(u - last_deg) - rate_deg_[i], true, i, u - last_deg);
    last_deg = u;
  }
  return max;
}

// Holds every other violated constraint too that leaves those held independent. The dual rises towards each of
// them, so that not all of those added block at once.
void DualActiveSet::hold_violated() {
  const auto path_deg = plate_deg_;
  resolve_fixed();
  bool grounded = true;
  double last_deg = problem_.last_plate_deg;
  for (int i = 0; i < steps_; ++i) {
    const double u = path_deg[i];
    const double slack_deg = plate_tolerance_deg_ / gain_[i];
    const double turn_deg = u - last_deg;
    last_deg = u;
    const bool tied = set_.link[i] || (std::abs(turn_deg) - rate_deg_[i] > slack_deg && !(grounded && fixed_[i]));
    if (tied && !set_.link[i]) set_.link[i] = turn_deg < 0.0 ? -1 : 1;
    grounded = fixed_[i] || (tied && grounded);
    if (grounded || std::abs(u) - problem_.bound_deg <= slack_deg) continue;
    set_.pin[i] = u < 0.0 ? -1 : 1, grounded = true;
  }
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

// Lets go of one constraint so that one which depends on those held can be. The plate cannot move. Only the
// multipliers do, by a circulation, until one of them is gone. False if none goes.
bool DualActiveSet::exchange(Constraint constraint) {
  --sweeps_left_;
  target_ = {};
  value(target_, constraint) = constraint.sign;
  push_to_ground(constraint.i, constraint.sign);
  if (constraint.is_link && constraint.i > 0) push_to_ground(constraint.i - 1, -constraint.sign);
  double step = std::numeric_limits<double>::infinity();
  Constraint blocking{false, 0, 0};
  for (int i = 0; i < steps_; ++i) {
    for (const Constraint& c : {Constraint{false, i, set_.pin[i]}, Constraint{true, i, set_.link[i]}}) {
      const double fall = -c.sign * value(target_, c);
      const double from = std::max(0.0, c.sign * value(current_, c));
      if (fall > 0.0 && from < step * fall) step = from / fall, blocking = c;
    }
  }
  if (blocking.sign == 0) return false;
  for (int i = 0; i < steps_; ++i) {
    current_.pin[i] += step * target_.pin[i];
    current_.link[i] += step * target_.link[i];
  }
  let_go(blocking);
  return true;
}

}  // namespace

void solve_active_set(const WindowProblem& problem, WorkingSet& working_set, WindowSolution& solution) {
  DualActiveSet(problem, working_set, solution).run();
}

}  // namespace hrt
