#include "core/paper_simulation/control_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrt {
namespace {

using Node = PiecewiseLinear::Node;
using Nodes = std::vector<Node>;

double interpolate(const Node& a, const Node& b, double x) {
  const double slope = (b.value - a.value) / (b.x - a.x);
  return x - a.x < b.x - x ? a.value + slope * (x - a.x) : b.value - slope * (b.x - x);
}

// The same function without nodes that make no difference.
Nodes simplified(const Nodes& nodes) {
  Nodes kept;
  for (const Node& node : nodes) {
    const auto close = [&](double x, double y) { return std::abs(x - y) <= 1e-13 * (1.0 + std::abs(y)); };
    if (!kept.empty() && close(node.x, kept.back().x)) continue;
    while (kept.size() >= 2 && close(interpolate(kept[kept.size() - 2], node, kept.back().x), kept.back().value)) {
      kept.pop_back();
    }
    kept.push_back(node);
  }
  return kept;
}

// Between -max and largest.
Nodes restricted(const PiecewiseLinear& function, double max) {
  Nodes nodes{{-max, function(-max)}};
  for (const Node& node : function.nodes())
    if (std::abs(node.x) < max) nodes.push_back(node);
  nodes.push_back({max, function(max)});
  return nodes;
}

// min(max(function, -bound), bound), with a node wherever that sets in.
Nodes clamped(const Nodes& nodes, double bound) {
  Nodes result;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i > 0) {
      const Node& a = nodes[i - 1];
      const Node& b = nodes[i];
      const double first = a.value < b.value ? -bound : bound;
      for (const double level : {first, -first}) {
        if ((a.value < level) != (b.value < level) && a.value != level && b.value != level)
          result.push_back({a.x + (level - a.value) * ((b.x - a.x) / (b.value - a.value)), level});
      }
    }
    result.push_back({nodes[i].x, std::clamp(nodes[i].value, -bound, bound)});
  }
  return result;
}

Nodes swapped(Nodes nodes) {
  for (Node& node : nodes) std::swap(node.x, node.value);
  return nodes;
}

// Where the plate stands at the bound. None if it does so between two places where it does not.
std::optional<ControlLaw> with_saturation(Nodes plate, double bound_deg) {
  for (Node& node : plate) {
    // Of two nodes that all but coincide, the one that stays may be a rounding error short of the bound.
    if (std::abs(node.value) > (1.0 - 1e-10) * bound_deg) node.value = std::copysign(bound_deg, node.value);
  }
  const auto at_bound = [&](const Node& node) { return std::abs(node.value) == bound_deg; };
  const double infinity = std::numeric_limits<double>::infinity();
  ControlLaw law{PiecewiseLinear(plate), -infinity, infinity};
  std::size_t first = 0;
  std::size_t last = plate.size() - 1;
  const auto same_bound = [&](std::size_t a, std::size_t b) {
    return at_bound(plate[a]) && plate[a].value == plate[b].value;
  };
  while (first < last && same_bound(first, first + 1)) law.saturated_below_deg = plate[++first].x;
  while (last > first && same_bound(last, last - 1)) law.saturated_above_deg = plate[--last].x;
  for (std::size_t i = first; i < last; ++i)
    if (same_bound(i, i + 1)) return std::nullopt;
  return law;
}

}  // namespace

double PiecewiseLinear::operator()(double x) const {
  const auto above = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, x,
                                      [](double value, const Node& node) { return value < node.x; });
  return interpolate(*(above - 1), *above, x);
}

double PiecewiseLinear::slope(std::size_t piece) const {
  const Node& a = nodes_[piece];
  const Node& b = nodes_[piece + 1];
  return (b.value - a.value) / (b.x - a.x);
}

std::optional<ControlLaw> control_law(const MpcConfig& config, const MpcProblem& problem) {
  if (config.plate_rate_bound_deg != std::numeric_limits<double>::infinity()) return std::nullopt;
  const double q_perceived = config.perceived_weight;
  const double q_actual = config.actual_weight;
  const double w = problem.tactile_weight;
  const double bound_deg = config.plate_bound_deg;
  const double max_deg = max_law_offset_deg + 180.0;

  PiecewiseLinear derivative({{-max_deg, 0.0}, {max_deg, 0.0}});  // D_i+1
  Nodes plate;                                                    // t_i of x
  for (int i = config.horizon - 1; i >= 0; --i) {
    const double gain = problem.gains[i];
    if (!(gain > 0.0)) return std::nullopt;
    const auto felt_by_finger = [&](double x) { return (1.0 - w) * (x + problem.real_offset_deg); };

    Nodes next_of_x;  // y without the bound
    for (const Node& node : derivative.nodes()) next_of_x.push_back({node.x + node.value / q_perceived, node.x});
    plate = restricted(PiecewiseLinear(next_of_x), max_deg);
    for (Node& node : plate) node.value = ((node.x - node.value) / gain - felt_by_finger(node.x)) / w;
    plate = simplified(clamped(plate, bound_deg));
    if (i == 0) break;

    Nodes next = plate;  // y under the bound, which rises with x
    for (Node& node : next) node.value = node.x - gain * (w * node.value + felt_by_finger(node.x));
    const PiecewiseLinear x_of_next(swapped(next));
    for (const Node& node : derivative.nodes()) {
      const double x = x_of_next(node.x);
      if (std::abs(x) < max_deg) next.push_back({x, node.x});
    }
    std::sort(next.begin(), next.end(), [](const Node& a, const Node& b) { return a.x < b.x; });
    const double held_slope = 1.0 - gain * (1.0 - w);
    Nodes cost;  // D_i
    for (const auto& [x, y] : next) {
      cost.push_back({x, q_actual * x + (1.0 - held_slope) * q_perceived * (x - y) + held_slope * derivative(y)});
    }
    derivative = PiecewiseLinear(simplified(cost));
  }

  for (Node& node : plate) node.x += problem.real_offset_deg;
  return with_saturation(std::move(plate), bound_deg);
}

}  // namespace hrt
