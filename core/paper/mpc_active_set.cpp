#include "core/paper/mpc_active_set.h"

#include <algorithm>
#include <cmath>

namespace hrt {
namespace {

constexpr int max_iterations = 1000;

// Primal active-set method. The constraints that are held as equalities are the pins and links of the path; links join
// steps to runs. They are linearly independent: a run contains at most one pin, and none if the run is linked to t_-1.
class ActiveSet {
 public:
  ActiveSet(const Window& window, WindowPath& path)
      : window_(window),
        path_(path),
        finger_weight_(1.0 - window.tactile_weight),
        tolerance_deg_(1e-14 * (std::abs(window.finger_deg) + std::abs(window.real_deg) +
                                window.tactile_weight * window.bound_deg)) {}

  void optimise();
  bool advance();
  bool release(bool only_first);

 private:
  void fix_runs();

  const Window& window_;
  WindowPath& path_;
  double finger_weight_;                                        // 1 - w_T
  double tolerance_deg_;                                        // rounding error of perceived angles such as e_i
  std::array<bool, max_horizon> fixed_;                         // true: the held constraints determine t_i
  std::array<double, max_horizon> law_slope_, law_offset_deg_;  // t_i = slope p_i + offset, if t_i is fixed or unlinked
  std::array<double, max_horizon> target_deg_;
  std::array<double, max_horizon + 1> finger_deg_;  // p_i on the target path
  std::array<double, max_horizon> error_deg_;       // e_i
};

// Finds the steps whose run contains a pin or is linked to t_-1. The held constraints determine t_i in these steps.
void ActiveSet::fix_runs() {
  double last_deg = window_.last_plate_deg;
  bool fixed = true;
  for (int i = 0; i < window_.steps; ++i) {
    const std::int8_t pin = path_.pin[i];
    const std::int8_t link = path_.link[i];
    fixed = pin || (link && fixed);
    fixed_[i] = fixed;
    if (!fixed) continue;
    last_deg = pin ? pin * window_.bound_deg : last_deg + link * window_.rate_deg[i];
    law_slope_[i] = 0.0;
    law_offset_deg_[i] = last_deg;
    if (!pin) continue;
    for (int j = i; j > 0 && path_.link[j]; --j) {
      fixed_[j - 1] = true;
      law_slope_[j - 1] = 0.0;
      law_offset_deg_[j - 1] = law_offset_deg_[j] - path_.link[j] * window_.rate_deg[j];
    }
  }
}

// Sets the target path to the optimum under the held constraints alone, by dynamic programming from the last step to
// the first. The least cost of the steps from i on is pp p_i^2 + 2 pt p_i t_i-1 + tt t_i-1^2 + 2 p1 p_i + 2 t1 t_i-1
// plus a constant; only if step i is linked to t_i-1 does it depend on t_i-1. The best t_i is a linear law of p_i.
void ActiveSet::optimise() {
  fix_runs();
  const double q = window_.perceived_weight;
  double pp = window_.miss_weight[window_.steps];
  double p1 = -pp * window_.real_deg;
  double pt = 0.0, tt = 0.0, t1 = 0.0;
  for (int i = window_.steps - 1; i >= 0; --i) {
    const double k = window_.gain[i] * window_.tactile_weight;
    const double a = window_.gain[i] * finger_weight_;  // e = k t + a p
    const double b = 1.0 - a;
    const double slope = k * pp - pt;
    tt += q * k * k + k * (slope - pt);
    t1 -= k * p1;
    pt = q * a * k - b * slope;
    pp = window_.miss_weight[i] + q * a * a + b * b * pp;
    p1 = b * p1 - window_.miss_weight[i] * window_.real_deg;
    if (path_.link[i] && !fixed_[i]) {
      const double turn_deg = path_.link[i] * window_.rate_deg[i];
      p1 += pt * turn_deg;
      t1 += tt * turn_deg;
      continue;
    }
    if (!fixed_[i]) law_slope_[i] = -pt / tt, law_offset_deg_[i] = -t1 / tt;
    pp += pt * law_slope_[i];
    p1 += pt * law_offset_deg_[i];
    pt = tt = t1 = 0.0;
  }
  finger_deg_[0] = window_.finger_deg;
  for (int i = 0; i < window_.steps; ++i) {
    target_deg_[i] = path_.link[i] && !fixed_[i] ? target_deg_[i - 1] + path_.link[i] * window_.rate_deg[i]
                                                 : law_slope_[i] * finger_deg_[i] + law_offset_deg_[i];
    error_deg_[i] = window_.gain[i] * (window_.tactile_weight * target_deg_[i] + finger_weight_ * finger_deg_[i]);
    finger_deg_[i + 1] = finger_deg_[i] - error_deg_[i];
  }
}

// Moves the path towards the target path as far as the bounds allow. If a bound blocks the path, holds this bound and
// returns false; otherwise returns true. Bounds on values that the held constraints determine are not considered.
bool ActiveSet::advance() {
  double fraction = 1.0;
  std::int8_t* blocking = nullptr;
  std::int8_t sign = 0;
  const auto consider = [&](double from_deg, double to_deg, double bound_deg, std::int8_t& constraint) {
    const double excess_deg = std::abs(to_deg) - bound_deg;
    if (window_.tactile_weight * excess_deg <= tolerance_deg_) return;
    const double room_deg = std::max(0.0, bound_deg - (to_deg < 0.0 ? -from_deg : from_deg));
    if (room_deg >= fraction * (room_deg + excess_deg)) return;
    fraction = room_deg / (room_deg + excess_deg);
    blocking = &constraint;
    sign = to_deg < 0.0 ? -1 : 1;
  };
  for (int i = 0; i < window_.steps; ++i) {
    const double last_deg = i > 0 ? path_.plate_deg[i - 1] : window_.last_plate_deg;
    const double last_target_deg = i > 0 ? target_deg_[i - 1] : window_.last_plate_deg;
    if (!fixed_[i]) consider(path_.plate_deg[i], target_deg_[i], window_.bound_deg, path_.pin[i]);
    if (!path_.link[i] && !(fixed_[i] && (i == 0 || fixed_[i - 1])))
      consider(path_.plate_deg[i] - last_deg, target_deg_[i] - last_target_deg, window_.rate_deg[i], path_.link[i]);
  }
  if (!blocking) {
    std::copy_n(target_deg_.begin(), window_.steps, path_.plate_deg.begin());
    return true;
  }
  for (int i = 0; i < window_.steps; ++i) path_.plate_deg[i] += fraction * (target_deg_[i] - path_.plate_deg[i]);
  *blocking = sign;
  return false;
}

// Releases constraints whose multipliers have the wrong sign, at the optimum under the held constraints. Returns true
// if there are any. Half the derivative of the cost by t_i is g_i = K_i w_T (q_perceived e_i - c_i+1), where c_i is
// half the derivative by p_i of the cost from step i on. From g_i + pin_i + link_i - link_i+1 = 0 follows the
// multiplier of a link: the sum of g over the earlier steps of its run, or minus the sum over the later steps. The side
// that is summed must not contain a pin or t_-1.
bool ActiveSet::release(bool only_first) {
  struct Part {
    double gradient;
    double gain;    // sum of K_i w_T, the scale of rounding errors
    bool grounded;  // contains a pin or is linked to t_-1

    Part operator+(const Part& o) const { return {gradient + o.gradient, gain + o.gain, grounded || o.grounded}; }
  };
  const int n = window_.steps;
  const double q = window_.perceived_weight;
  std::array<Part, max_horizon> step;
  std::array<Part, max_horizon> after;  // step i and the later steps that are linked to it
  double costate = window_.miss_weight[n] * (finger_deg_[n] - window_.real_deg);
  double weights = q + window_.miss_weight[n];
  for (int i = n - 1; i >= 0; --i) {
    const double k = window_.gain[i] * window_.tactile_weight;
    const double a = window_.gain[i] * finger_weight_;
    after[i] = step[i] = {k * (q * error_deg_[i] - costate), k, path_.pin[i] != 0};
    if (i + 1 < n && path_.link[i + 1]) after[i] = step[i] + after[i + 1];
    costate =
        a * q * error_deg_[i] + (1.0 - a) * costate + window_.miss_weight[i] * (finger_deg_[i] - window_.real_deg);
    weights += window_.miss_weight[i];
  }
  bool released = false;
  const auto check = [&](std::int8_t& constraint, double multiplier, double gain) {
    if (constraint * multiplier >= -weights * tolerance_deg_ * gain || (released && only_first)) return;
    constraint = 0;
    released = true;
  };
  Part before{0.0, 0.0, true};
  for (int i = 0; i < n; ++i) {
    if (!path_.link[i]) before = {};
    check(path_.pin[i], -(before.gradient + after[i].gradient), before.gain + after[i].gain);
    if (!before.grounded && (after[i].grounded || before.gain < after[i].gain))
      check(path_.link[i], before.gradient, before.gain);
    else
      check(path_.link[i], -after[i].gradient, after[i].gain);
    before = before + step[i];
  }
  return released;
}

}  // namespace

bool solve_active_set(const Window& window, WindowPath& path) {
  ActiveSet set(window, path);
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    set.optimise();
    if (set.advance() && !set.release(iteration > 2 * window.steps)) return true;
  }
  return false;
}

}  // namespace hrt
