// The optimum of core/paper/mpc.h as a function of where the finger moves. Without a rate bound the only
// state of the problem is p, the finger's offset from the virtual direction, and the gains of a step are the
// same in every trial. So the plate offset t(p) of one step is a fixed function, continuous and linear in
// pieces, that a batch can tabulate once and then evaluate in place of a solver.
//
// With x = p - p_R and V_i the least cost from step i on, V_N = 0, the optimality principle says
//     V_i(x) = q_actual x^2 + min over |t| <= L of  q_perceived e^2 + V_i+1(y),   y = x - e,
//     e = K_i (w_T t + (1 - w_T) (x + p_R)).
// Let D_i = V_i' / 2, continuous, rising, and linear in pieces. The best y without the bound solves
//     x = y + D_i+1(y) / q_perceived,
// whose right side rises with y, so its inverse gives y, e and t; the bound clamps t, because the cost is
// convex in it. With a = 1 - K_i (1 - w_T), the slope of y in x while t is held,
//     D_i(x) = q_actual x + (1 - a) q_perceived (x - y) + a D_i+1(y)
// holds with and without an active bound (without one, D_i+1(y) = q_perceived (x - y)). Breakpoints of D_i
// are where t meets the bound and where y meets a breakpoint of D_i+1.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/paper/mpc.h"

namespace hrt {

/// A continuous function, linear between its nodes.
class PiecewiseLinear {
 public:
  struct Node {
    double x;
    double value;
  };

  PiecewiseLinear() = default;
  /// At least two nodes, x rising.
  explicit PiecewiseLinear(std::vector<Node> nodes) : nodes_(std::move(nodes)) {}

  const std::vector<Node>& nodes() const { return nodes_; }

  /// The value at `x`; beyond the nodes, the first or last piece continues.
  double operator()(double x) const;

  /// The slope between nodes `piece` and `piece` + 1.
  double slope(std::size_t piece) const;

 private:
  std::vector<Node> nodes_;
};

/// Finger offsets up to this size, degrees, are within the reach of a law.
inline constexpr double max_law_offset_deg = 1e5;

struct ControlLaw {
  /// t_k of p_k, both relative to the virtual direction, |p_k| <= max_law_offset_deg.
  PiecewiseLinear plate_offset_deg;
  /// t_k is at a bound for p_k at or below the first and at or above the second; infinite: never.
  double saturated_below_deg;
  double saturated_above_deg;
};

/// The answer of Mpc::solve() to every finger offset, with the other fields of `problem` fixed. None if
/// that is no function of the finger offset alone (a rate bound, a gain of 0), or if the plate is at a bound
/// elsewhere than at both ends. Requires is_valid(config). Uses the heap.
std::optional<ControlLaw> control_law(const MpcConfig& config, const MpcProblem& problem);

}  // namespace hrt
