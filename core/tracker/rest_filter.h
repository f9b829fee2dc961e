// A Kalman filter of a tracker's noise over the positions of a finger at rest (core/tracker/tracker_noise.h),
// whose place is not known.
#pragma once

#include <array>
#include <vector>

namespace hrt {

/// A position that is used.
struct RestSample {
  double since_s;  ///< the one before it
  std::array<double, 2> place_mm;
};
using Rest = std::vector<RestSample>;

/// Noise of variance 1.
struct RestNoiseShape {
  double share;          ///< of the variance, correlated
  double correlation_s;  ///< time in which that part decays to 1/e
};

/// The share that correlated noise keeps of itself from each sample to the next, over all rests.
std::vector<double> kept_between(const std::vector<Rest>& rests, double correlation_s);

/// Sums over all samples, with the places of the rests fitted (restricted likelihood).
struct RestLikelihood {
  double squares = 0.0;      ///< normalised innovations squared
  double determinant = 0.0;  ///< sum of log variances
};
/// `kept`: kept_between() of the noise's correlation time.
RestLikelihood rest_likelihood(const std::vector<Rest>& rests, double share, const std::vector<double>& kept);

/// The rests without the positions that noise of this variance does not explain: 1 in 3000 of those that it
/// does.
std::vector<Rest> inliers(const std::vector<Rest>& rests, const RestNoiseShape& noise, double variance_mm2);

/// How normalised innovations are distributed: independent and normal if the noise is of this kind.
struct RestInnovations {
  static constexpr int lags = 10;
  double dependence = 0.0;  ///< chi-squared of their correlations, with `lags` degrees of freedom
  double kurtosis = 3.0;
};
RestInnovations innovations(const std::vector<Rest>& rests, const RestNoiseShape& noise);

}  // namespace hrt
