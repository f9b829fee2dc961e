#include "tests/core/paper/mpc_reference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hrt {
namespace {

// min |columns y + target| over y >= 0 (Lawson and Hanson, Solving Least Squares Problems, chapter 23).
long double min_nonnegative_residual(const LongMatrix& columns, const LongVector& target) {
  const Eigen::Index n = columns.cols();
  LongVector y = LongVector::Zero(n);
  std::vector<Eigen::Index> positive;
  const long double tolerance = 1e-17L * (1.0L + target.norm()) * (1.0L + columns.norm());
  for (Eigen::Index round = 0; round < 10 * n + 10; ++round) {
    LongVector descent = -columns.transpose() * (columns * y + target);
    for (const Eigen::Index i : positive) descent[i] = 0.0L;
    Eigen::Index entering = 0;
    if (n == 0 || descent.maxCoeff(&entering) <= tolerance) break;
    positive.push_back(entering);
    while (!positive.empty()) {
      const LongMatrix chosen = columns(Eigen::seqN(0, columns.rows()), positive);
      const LongVector solution = chosen.colPivHouseholderQr().solve(-target);
      long double step = 1.0L;
      for (Eigen::Index i = 0; i < solution.size(); ++i) {
        if (solution[i] > 0.0L) continue;
        const long double from = y[positive[i]];
        step = std::min(step, from > 0.0L ? from / (from - solution[i]) : 0.0L);
      }
      std::vector<Eigen::Index> kept;
      for (Eigen::Index i = 0; i < solution.size(); ++i) {
        long double& value = y[positive[i]];
        value += step * (solution[i] - value);
        if (value > 1e-19L || (step == 1.0L && solution[i] > 0.0L))
          kept.push_back(positive[i]);
        else
          value = 0.0L;
      }
      positive = kept;
      if (step == 1.0L) break;
    }
  }
  return (columns * y + target).cwiseAbs().maxCoeff();
}

}  // namespace

DenseProblem dense_problem(const MpcConfig& config, const MpcProblem& problem) {
  const int n = config.horizon;
  const long double w = problem.tactile_weight;
  const bool has_rate_bound = std::isfinite(config.plate_rate_bound_deg);
  // Row i of `by_plate` and entry i of `alone`: e_i, and p_i - p_R below it, as affine functions of t.
  LongMatrix by_plate = LongMatrix::Zero(2 * n, n);
  LongVector alone(2 * n);
  LongVector finger_by_plate = LongVector::Zero(n);
  long double finger = problem.finger_offset_deg;
  for (int i = 0; i < n; ++i) {
    const long double k = problem.gains[i];
    LongVector error_by_plate = k * (1.0L - w) * finger_by_plate;
    error_by_plate[i] += k * w;
    const long double error = k * (1.0L - w) * finger;
    by_plate.row(i) = error_by_plate;
    alone[i] = error;
    by_plate.row(n + i) = finger_by_plate;
    alone[n + i] = finger - problem.real_offset_deg;
    finger_by_plate -= error_by_plate;
    finger -= error;
  }
  LongVector weights(2 * n);
  weights << LongVector::Constant(n, config.perceived_weight), LongVector::Constant(n, config.actual_weight);
  DenseProblem dense;
  dense.hessian = by_plate.transpose() * weights.asDiagonal() * by_plate;
  dense.gradient = by_plate.transpose() * weights.asDiagonal() * alone;
  const LongMatrix identity = LongMatrix::Identity(n, n);
  LongMatrix difference = identity;
  difference.diagonal(-1).setConstant(-1.0L);
  LongVector before = LongVector::Zero(n);
  before[0] = problem.plate_offset_deg;
  dense.rows.resize((has_rate_bound ? 4 : 2) * n, n);
  dense.limits.resize(dense.rows.rows());
  dense.rows.topRows(2 * n) << identity, -identity;
  dense.limits.head(2 * n).setConstant(config.plate_bound_deg);
  if (has_rate_bound) {
    dense.rows.bottomRows(2 * n) << difference, -difference;
    dense.limits.tail(2 * n).setConstant(config.plate_rate_bound_deg);
    dense.limits.tail(2 * n) += (LongVector(2 * n) << before, -before).finished();
  }
  return dense;
}

LongVector feasible_start(const MpcConfig& config, const MpcProblem& problem) {
  LongVector start(config.horizon);
  long double last = std::isfinite(config.plate_rate_bound_deg) ? problem.plate_offset_deg : 0.0;
  for (int i = 0; i < config.horizon; ++i) {
    const long double rate = config.plate_rate_bound_deg;
    last = last > rate ? last - rate : last < -rate ? last + rate : 0.0L;
    start[i] = last;
  }
  return start;
}

LongVector dense_optimum(const DenseProblem& problem, const LongVector& start) {
  const Eigen::Index n = start.size();
  // No two bounds may meet in one point, or the method could cycle there: each gives way by its own 1e-14.
  LongVector limits = problem.limits;
  for (int i = 0; i < limits.size(); ++i)
    limits[i] += 1e-14L * (1.0L + std::fmod(0.618L * static_cast<long double>(i), 1.0L));
  // A step that is not felt costs nothing wherever the plate stands: a cost too small to matter makes one
  // best.
  LongMatrix hessian = problem.hessian;
  for (int i = 0; i < n; ++i)
    if (hessian(i, i) == 0.0L) hessian(i, i) = 1e-15L;
  LongVector t = start;
  std::vector<int> held;
  constexpr int max_rounds = 2000;
  for (int round = 0; round < max_rounds; ++round) {
    // The move to the optimum on the bounds held, within the null space of their rows.
    const LongVector slope = hessian * t + problem.gradient;
    const auto m = static_cast<Eigen::Index>(held.size());
    LongVector move = LongVector::Zero(n);
    LongVector multipliers(m);
    LongMatrix basis = LongMatrix::Identity(n, n);
    Eigen::HouseholderQR<LongMatrix> factors;
    if (m > 0) {
      factors.compute(problem.rows(held, Eigen::seqN(0, n)).transpose());
      basis = factors.householderQ();
    }
    const LongMatrix null_space = basis.rightCols(n - m);
    if (m < n)
      move = -null_space * (null_space.transpose() * hessian * null_space).llt().solve(null_space.transpose() * slope);
    // The first bound on the way.
    long double step = 1.0L;
    int blocking = -1;
    for (int i = 0; i < problem.rows.rows(); ++i) {
      if (std::find(held.begin(), held.end(), i) != held.end()) continue;
      const long double rise = problem.rows.row(i).dot(move);
      if (rise <= 1e-16L) continue;
      const long double room = std::max(0.0L, limits[i] - problem.rows.row(i).dot(t));
      if (room < step * rise) step = room / rise, blocking = i;
    }
    t += step * move;
    if (blocking >= 0) {
      held.push_back(blocking);
      continue;
    }
    if (m == 0) return t;
    multipliers = factors.matrixQR().topRows(m).triangularView<Eigen::Upper>().solve(-basis.leftCols(m).transpose() *
                                                                                     (hessian * t + problem.gradient));
    Eigen::Index leaving = 0;
    if (multipliers.minCoeff(&leaving) >= -1e-17L) return t;
    held.erase(held.begin() + leaving);
  }
  throw std::runtime_error("the reference solver does not end");
}

KktResidual kkt_residual(const DenseProblem& problem, const LongVector& plate) {
  const LongVector room = problem.limits - problem.rows * plate;
  std::vector<int> active;
  for (int i = 0; i < room.size(); ++i)
    if (room[i] < 1e-10L) active.push_back(i);
  const LongVector gradient = problem.hessian * plate + problem.gradient;
  return {
      .stationarity =
          min_nonnegative_residual(problem.rows(active, Eigen::seqN(0, plate.size())).transpose(), gradient),
      .violation_deg = std::max(0.0L, -room.minCoeff()),
  };
}

}  // namespace hrt
