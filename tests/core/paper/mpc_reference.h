// Optimality conditions of the controller's problem in long double, with dense matrices, from the definition of the
// problem. The problem is convex, so a plan that meets the conditions is optimal.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "core/paper/mpc.h"

// This file widens double to long double on purpose.
#pragma GCC diagnostic ignored "-Wdouble-promotion"

namespace hrt {

using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// The controller's problem in general form: minimise t^T hessian t / 2 + gradient^T t, half of the window's cost
/// without its constant part, over the plate offsets t in degrees, subject to rows t <= limits.
struct DenseProblem {
  LongMatrix hessian;
  LongVector gradient;
  LongMatrix rows;
  LongVector limits;
};

/// Converts a problem. A plate beyond its bound must be able to return within the bound in one step.
DenseProblem dense_problem(const MpcConfig& config, const MpcProblem& problem);

/// Residuals of the Karush-Kuhn-Tucker conditions.
struct KktResidual {
  /// largest entry of |gradient of half the cost + rows^T multipliers|, for the least-squares multipliers >= 0
  long double stationarity;
  long double violation_deg;  ///< largest violation of a bound
};
KktResidual kkt_residual(const DenseProblem& problem, const LongVector& plate);

}  // namespace hrt
