#include "tests/core/paper/mpc_reference.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

// This file widens double to long double on purpose.
#pragma GCC diagnostic ignored "-Wdouble-promotion"

namespace hrt {
namespace {

using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

// Returns the largest entry of |columns y + target| for the least-squares solution y >= 0 (Lawson and Hanson, Solving
// Least Squares Problems, chapter 23).
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

// Minimise t^T hessian t / 2 + gradient^T t over the plate offsets t, subject to rows t <= limits.
struct DenseProblem {
  LongMatrix hessian;
  LongVector gradient;
  LongMatrix rows;
  LongVector limits;
};

DenseProblem dense_problem(const MpcConfig& config, const MpcProblem& problem) {
  const int n = config.horizon;
  const long double w = problem.tactile_weight;
  const bool has_rate_bound = std::isfinite(config.plate_rate_bound_deg);
  // Row i of `by_plate` and entry i of `alone` are e_i as an affine function of t; rows n + i are p_i - p_R.
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

}  // namespace

KktResidual kkt_residual(const MpcConfig& config, const MpcProblem& of, const MpcPlan& plan) {
  const DenseProblem problem = dense_problem(config, of);
  const LongVector plate = Eigen::VectorXd::Map(plan.plate_offset_deg.data(), config.horizon).cast<long double>();
  const LongVector slack = problem.limits - problem.rows * plate;
  std::vector<int> active;
  for (int i = 0; i < slack.size(); ++i)
    if (slack[i] < 1e-10L) active.push_back(i);
  const LongVector gradient = problem.hessian * plate + problem.gradient;
  return {
      .stationarity =
          min_nonnegative_residual(problem.rows(active, Eigen::seqN(0, plate.size())).transpose(), gradient),
      .violation_deg = std::max(0.0L, -slack.minCoeff()),
  };
}

}  // namespace hrt
