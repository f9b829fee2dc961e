// Optimality conditions of the controller's problem in long double, with dense matrices, from the definition of the
// problem. The problem is convex, so a plan that meets the conditions is optimal.
#pragma once

#include "core/paper/mpc.h"

namespace hrt {

/// Residuals of the Karush-Kuhn-Tucker conditions.
struct KktResidual {
  /// largest entry of |gradient of half the cost + rows^T multipliers|, for the least-squares multipliers >= 0
  long double stationarity;
  long double violation_deg;  ///< largest violation of a bound
};

/// A plate beyond its bound must be able to return within the bound in one step.
KktResidual kkt_residual(const MpcConfig& config, const MpcProblem& problem, const MpcPlan& plan);

}  // namespace hrt
