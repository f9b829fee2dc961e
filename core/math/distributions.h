// Distribution functions of statistics, from the four operations, core/exponential and the square root: the
// same bits on every host.
#pragma once

#include <span>

#include "core/math/interval.h"

namespace hrt {

/// P(N(0, 1) <= x); absolute error below 2e-7.
double normal_cdf(double x);

/// P(F > f) for F of `numerator` and `denominator` degrees of freedom, both > 0; 1 for f <= 0.
double f_tail(double f, double numerator, double denominator);

/// The 97.5 % point of Student's t with `degrees` of freedom, clamped to 3 or more; to 0.05 at 3 and to 0.003
/// from 8 on.
double student_975(double degrees);

/// A normal distribution of a mixture.
struct NormalPart {
  double probability;
  double mean;
  double deviation;  ///< >= 0
};

/// The median and the 95 % interval of a mixture of at least one part, whose probabilities sum to 1.
Interval mixture_interval(std::span<const NormalPart> parts);

}  // namespace hrt
