#include "core/paper/mpc_rate_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/paper/mpc_active_set.h"
#include "core/plate/plate_limits.h"

namespace hrt {
namespace {

// Passes of the active-set method: before the sweeps, which is all that a closed loop mostly needs, and after them.
constexpr int first_passes = 3;
constexpr int last_passes = 150;

// Pairs of sweeps before the solver gives up.
constexpr int max_pairs = 8;

// Pairs after which the cost has to fall.
constexpr int free_pairs = 4;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The plate in a step as a function of the miss there.
struct Line {
  double slope;
  double offset_deg;

  double at(double miss_deg) const { return slope * miss_deg + offset_deg; }
  Line turned(double by_deg) const { return {slope, offset_deg + by_deg}; }
};

// A cost by a miss x and a plate u: xx x^2 + 2 xu x u + uu u^2 + 2 x1 x + 2 u1 u, and a constant that nobody needs.
struct Quadratic {
  double xx, xu, uu, x1, u1;

  // The best plate.
  Line best() const {
    const double inverse = 1.0 / uu;
    return {-xu * inverse, -u1 * inverse};
  }
  // The cost with it.
  Quadratic least(const Line& best) const { return {xx + xu * best.slope, 0.0, 0.0, x1 + xu * best.offset_deg, 0.0}; }
  // The cost with the plate on `line`.
  Quadratic along(const Line& line) const {
    return {xx + line.slope * (2.0 * xu + line.slope * uu), 0.0, 0.0,
            x1 + xu * line.offset_deg + line.slope * (u1 + uu * line.offset_deg), 0.0};
  }
  // The cost by the plate before a turn.
  Quadratic before_turn(double by_deg) const { return {xx, xu, uu, x1 + xu * by_deg, u1 + uu * by_deg}; }
};

// Where one piece of a piecewise quadratic ends, and the next.
struct Edge {
  Line at;
  Quadratic beyond;
};

// Of a piece; the side of an edge is 0 for the lower one and 1 for the upper one.
using Edges = std::array<Edge, 2>;

constexpr Edges no_edges{{{{0.0, -infinity}, {}}, {{0.0, infinity}, {}}}};

bool is_past(int side, double deg, double edge_deg) { return side ? deg > edge_deg : deg < edge_deg; }

// The cost to go from step i by x_i and u_i-1, near a path: the piece on which the path is, and its neighbours.
struct CostToGo {
  Quadratic here;
  Edges edges;
};

class RateBoundSolver {
 public:
  explicit RateBoundSolver(const FeltWindow& window) : window_(window), problem_(window.problem) {}

  // Moves `plate_deg` to the optimum. False if it gives up, on a path that keeps the bounds.
  bool solve(std::array<double, max_horizon>& plate_deg);
  WorkingSet held() const;

 private:
  struct Path {
    std::array<double, max_horizon> plate_deg;
    std::array<double, max_horizon + 1> miss_deg;
  };
  // What the plate is to be in a step if it can.
  struct Choice {
    Line plate;
    Quadratic cost;                          // of it
    std::array<const Quadratic*, 2> around;  // below it and above; they differ where it is an edge
  };

  void sweep_backwards(int from);
  void choose(int i, const CostToGo& after, CostToGo& before);
  void go_back(int i, const Choice& choice, const Edges& edges, CostToGo& before);
  Quadratic with_step(int i, const Quadratic& after) const;
  Line edge_in_step(int i, const Line& after) const;
  double above_edge(int i, double plate_deg, const Line& after) const;
  int sweep_forwards(Path& path);
  bool same_path(const Path& path) const;
  double cost_of(const Path& path) const;
  double plate_before_deg(int i) const { return i > 0 ? path_.plate_deg[i - 1] : problem_.last_plate_deg; }
  ActiveBound holding(int i, double wanted_deg, double last_deg) const;
  double held_deg(int i, ActiveBound active, double wanted_deg, double last_deg) const;

  const FeltWindow& window_;
  const WindowProblem& problem_;
  Path path_{};
  std::array<CostToGo, max_horizon + 1> costs_;  // from each step on
  std::array<Line, max_horizon> law_;            // what u_i is to be if no bound holds it
  std::array<ActiveBound, max_horizon> held_;    // what holds it on the path
  std::array<bool, max_horizon> crossed_{};      // the law is of another piece than the path
};

// What holds the plate that is to come to `wanted_deg` in step i, from `last_deg`.
ActiveBound RateBoundSolver::holding(int i, double wanted_deg, double last_deg) const {
  const double up_deg = last_deg + window_.rate_deg[i];
  const double down_deg = last_deg - window_.rate_deg[i];
  if (wanted_deg >= std::min(up_deg, problem_.bound_deg))
    return up_deg < problem_.bound_deg ? ActiveBound::rate_up : ActiveBound::upper;
  if (wanted_deg <= std::max(down_deg, -problem_.bound_deg))
    return down_deg > -problem_.bound_deg ? ActiveBound::rate_down : ActiveBound::lower;
  return ActiveBound::none;
}

double RateBoundSolver::held_deg(int i, ActiveBound active, double wanted_deg, double last_deg) const {
  switch (active) {
    case ActiveBound::upper:
      return problem_.bound_deg;
    case ActiveBound::lower:
      return -problem_.bound_deg;
    case ActiveBound::rate_up:
      return last_deg + window_.rate_deg[i];
    case ActiveBound::rate_down:
      return last_deg - window_.rate_deg[i];
    case ActiveBound::none:
      break;
  }
  return wanted_deg;
}

bool RateBoundSolver::solve(std::array<double, max_horizon>& plate_deg) {
  const int last = window_.steps - 1;
  for (int i = 0; i <= last; ++i) law_[i] = {0.0, plate_deg[i]}, held_[i] = ActiveBound::none;
  sweep_forwards(path_);
  double cost = cost_of(path_);
  costs_[window_.steps] = {{window_.last_miss_weight, 0.0, 0.0, 0.0, 0.0}, no_edges};
  Path next;
  int from = last;
  for (int pair = 0; pair < max_pairs && from >= 0; ++pair) {
    sweep_backwards(from);
    const int changed = sweep_forwards(next);
    // Where the same path comes back from the whole window, only rounding can have changed what holds it.
    from = changed < 0 || !same_path(next) ? changed : from < last ? last : -1;
    const double next_cost = cost_of(next);
    if (from >= 0 && pair >= free_pairs && next_cost >= cost) break;
    path_ = next;
    cost = next_cost;
  }
  plate_deg = path_.plate_deg;
  return from < 0;
}

// The costs to go from all steps up to `from`; those after it stand.
void RateBoundSolver::sweep_backwards(int from) {
  for (int i = from; i >= 0; --i) choose(i, costs_[i + 1], costs_[i]);
}

// The cost of step i and what comes after by x_i and u_i, if that of what comes after is `after` by x_i+1 and u_i.
// Inlined wherever it is called: as memory its five numbers are waited for.
[[gnu::always_inline]] inline Quadratic RateBoundSolver::with_step(int i, const Quadratic& after) const {
  const double q_perceived = problem_.perceived_weight;
  const double k = window_.gain[i];
  const double a = k * problem_.proprioceptive_weight;  // e = a x + k u + d
  const double d = a * problem_.real_offset_deg;
  const double b = 1.0 - a;
  const double felt = k * after.xx - after.xu;
  return {window_.miss_weight[i] + q_perceived * a * a + b * b * after.xx, q_perceived * a * k - b * felt,
          q_perceived * k * k + k * (felt - after.xu) + after.uu, q_perceived * a * d + b * (after.x1 - after.xx * d),
          q_perceived * k * d + d * felt - k * after.x1 + after.u1};
}

// An edge of u_i by x_i, if `after` is it by x_i+1.
Line RateBoundSolver::edge_in_step(int i, const Line& after) const {
  const double k = window_.gain[i];
  const double a = k * problem_.proprioceptive_weight;
  const double inverse = 1.0 / (1.0 + after.slope * k);
  return {after.slope * (1.0 - a) * inverse, (after.offset_deg - after.slope * a * problem_.real_offset_deg) * inverse};
}

// How far `plate_deg` in step i is above that edge.
double RateBoundSolver::above_edge(int i, double plate_deg, const Line& after) const {
  const double x = path_.miss_deg[i];
  const double e = window_.gain[i] * (plate_deg + problem_.proprioceptive_weight * (x + problem_.real_offset_deg));
  return plate_deg - after.at(x - e);
}

// Chooses u_i for the path's x_i from the cost to go `after` step i, and finds that `before` it.
void RateBoundSolver::choose(int i, const CostToGo& after, CostToGo& before) {
  const double x = path_.miss_deg[i];
  const double last_deg = plate_before_deg(i);
  const double low_deg = std::max(last_deg - window_.rate_deg[i], -problem_.bound_deg);
  const double high_deg = std::min(last_deg + window_.rate_deg[i], problem_.bound_deg);
  const Quadratic here = with_step(i, after.here);
  crossed_[i] = false;
  const Line best = here.best();
  const double nearest_deg = std::clamp(best.at(x), low_deg, high_deg);
  const bool below = above_edge(i, nearest_deg, after.edges[0].at) < 0.0;
  const bool above = above_edge(i, nearest_deg, after.edges[1].at) > 0.0;
  if (!below && !above) return go_back(i, {best, here.least(best), {&here, &here}}, after.edges, before);

  crossed_[i] = true;
  const int side = above;
  const Line edge = edge_in_step(i, after.edges[side].at);
  const Quadratic beyond = with_step(i, after.edges[side].beyond);
  const Line best_beyond = beyond.best();
  Edges edges = after.edges;
  edges[side] = no_edges[side];
  if (is_past(side, best_beyond.at(x), edge.at(x))) {
    edges[1 - side] = {after.edges[side].at, after.here};
    return go_back(i, {best_beyond, beyond.least(best_beyond), {&beyond, &beyond}}, edges, before);
  }
  Choice choice{edge, here.along(edge), {&here, &here}};  // to which the cost falls from both sides
  choice.around[side] = &beyond;
  if (!is_past(side, best.at(x), edge.at(x))) {  // a bound holds the plate beyond
    choice.plate = best;
    choice.cost = here.least(best);
    edges[1 - side] = {after.edges[side].at, after.here};
  }
  go_back(i, choice, edges, before);
}

// The cost to go `before` step i. The piece on which u_i is on the path ends at `edges`, by x_i+1.
[[gnu::always_inline]] inline void RateBoundSolver::go_back(int i, const Choice& choice, const Edges& edges,
                                                            CostToGo& before) {
  const double x = path_.miss_deg[i];
  const double rate_deg = window_.rate_deg[i];
  const double wanted_deg = choice.plate.at(x);
  law_[i] = choice.plate;
  held_[i] = holding(i, wanted_deg, plate_before_deg(i));
  Line reached = choice.plate;
  Quadratic cost = choice.cost;
  if (std::abs(wanted_deg) > problem_.bound_deg) {
    reached = {0.0, std::copysign(problem_.bound_deg, wanted_deg)};
    cost = choice.around[wanted_deg < 0.0]->along(reached);
  }
  if (held_[i] != ActiveBound::rate_up && held_[i] != ActiveBound::rate_down) {
    before.here = cost;
    before.edges[0] = {reached.turned(-rate_deg), choice.around[0]->before_turn(rate_deg)};
    before.edges[1] = {reached.turned(rate_deg), choice.around[1]->before_turn(-rate_deg)};
    return;
  }
  // The plate turns at full rate, until it reaches what it is to be, a bound or an edge.
  const int side = held_[i] == ActiveBound::rate_up;
  const double turn_deg = side ? rate_deg : -rate_deg;
  const Quadratic& short_of_it = *choice.around[1 - side];
  before.here = short_of_it.before_turn(turn_deg);
  before.edges[1 - side] = {edge_in_step(i, edges[1 - side].at).turned(-turn_deg),
                            with_step(i, edges[1 - side].beyond).before_turn(turn_deg)};
  const Line edge = edge_in_step(i, edges[side].at);
  if (is_past(side, reached.at(x), edge.at(x))) {
    const Quadratic beyond = with_step(i, edges[side].beyond);
    const bool goes_on = is_past(side, beyond.best().at(x), edge.at(x));
    before.edges[side] = {edge.turned(-turn_deg), goes_on ? beyond.before_turn(turn_deg) : short_of_it.along(edge)};
  } else {
    before.edges[side] = {reached.turned(-turn_deg), cost};
  }
}

// Follows the laws as far as the bounds allow. Returns the last step whose law does not hold for this path, because
// something else holds the plate: if there is none (-1), `path` is the optimum.
int RateBoundSolver::sweep_forwards(Path& path) {
  int changed = -1;
  double x = problem_.miss_deg;
  double last_deg = problem_.last_plate_deg;
  for (int i = 0; i < window_.steps; ++i) {
    const double wanted_deg = law_[i].at(x);
    const ActiveBound active = holding(i, wanted_deg, last_deg);
    const double u = held_deg(i, active, wanted_deg, last_deg);
    if (active != held_[i] || crossed_[i]) changed = i;
    held_[i] = active;
    path.miss_deg[i] = x;
    path.plate_deg[i] = last_deg = u;
    x -= window_.gain[i] * (u + problem_.proprioceptive_weight * (x + problem_.real_offset_deg));
  }
  path.miss_deg[window_.steps] = x;
  return changed;
}

// Whether `path` is felt as the one before.
bool RateBoundSolver::same_path(const Path& path) const {
  for (int i = 0; i < window_.steps; ++i)
    if (window_.gain[i] * std::abs(path.plate_deg[i] - path_.plate_deg[i]) > tolerance_deg(problem_)) return false;
  return true;
}

double RateBoundSolver::cost_of(const Path& path) const {
  const auto& x = path.miss_deg;
  double cost = window_.last_miss_weight * x[window_.steps] * x[window_.steps];
  for (int i = 0; i < window_.steps; ++i) {
    const double e = x[i] - x[i + 1];
    cost += problem_.perceived_weight * e * e + window_.miss_weight[i] * x[i] * x[i];
  }
  return cost;
}

WorkingSet RateBoundSolver::held() const {
  WorkingSet set{};
  for (int i = 0; i < window_.steps; ++i) {
    set.pin[i] = static_cast<std::int8_t>((held_[i] == ActiveBound::upper) - (held_[i] == ActiveBound::lower));
    set.link[i] = static_cast<std::int8_t>((held_[i] == ActiveBound::rate_up) - (held_[i] == ActiveBound::rate_down));
  }
  return set;
}

}  // namespace

void solve_rate_bound(const WindowProblem& problem, WorkingSet& held, WindowSolution& solution) {
  const FeltWindow window(problem);
  const int n = window.steps;
  std::array<double, max_horizon> plate_deg;
  for (int step = 0; step < n; ++step) plate_deg[step] = solution.plate_deg[window.index[step]];
  WorkingSet of_felt{};
  solution.optimal = solve_active_set(window, first_passes, plate_deg, of_felt);
  if (!solution.optimal) {
    RateBoundSolver solver(window);
    solution.optimal = solver.solve(plate_deg);
    of_felt = solver.held();
  }
  if (!solution.optimal) solution.optimal = solve_active_set(window, last_passes, plate_deg, of_felt);
  held = {};
  for (int i = problem.horizon - 1, step = n - 1; i >= 0; --i) {
    if (step >= 0 && i == window.index[step]) {
      held.pin[i] = of_felt.pin[step];
      held.link[i] = of_felt.link[step];
      --step;
    }
    solution.plate_deg[i] = n == 0 ? problem.last_plate_deg : plate_deg[std::min(step + 1, n - 1)];
  }
}

}  // namespace hrt
