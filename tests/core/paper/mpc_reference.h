// The optimality conditions of the controller's problem in long double, dense, straight from the definition of the
// problem. It is convex, so a plan that meets them is optimal.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "core/paper/mpc.h"

// Widening double to long double is the point here.
#pragma GCC diagnostic ignored "-Wdouble-promotion"

namespace hrt {

using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// The controller's problem as a general one: minimise t' hessian t / 2 + gradient' t subject to
/// rows t <= limits, over the plate offsets t in degrees. Half the window's cost, without its constant part.
struct DenseProblem {
  LongMatrix hessian;
  LongVector gradient;
  LongMatrix rows;
  LongVector limits;
};

/// Writes the problem out. The plate must be able to reach the plate bound in one step.
DenseProblem dense_problem(const MpcConfig& config, const MpcProblem& problem);

/// How far `plate` is from meeting the Karush-Kuhn-Tucker conditions.
struct KktResidual {
  long double stationarity;   ///< |gradient of half the cost + rows' multipliers|, least over multipliers >= 0
  long double violation_deg;  ///< of the worst bound
};
KktResidual kkt_residual(const DenseProblem& problem, const LongVector& plate);

}  // namespace hrt
