// Estimates the white and the correlated noise of a tracker from differences between positions of a finger.
// Model of each coordinate at rest:
//
//   position = rest position + n + e,   dn/dt = -n / tau + noise (stationary, variance c),   e white, variance w
//
// Half of the mean square difference of two positions x, a time t apart, does not depend on the rest position:
//
//   D(t) = mean of (x(s + t) - x(s))^2 / 2 = w + c (1 - exp(-t / tau))
//
// (structure function; Kolmogorov 1941). D of successive positions shows the white noise, and the growth of D with t
// the correlated noise. Tremor and drift of a resting finger count as correlated noise.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <type_traits>

#include "core/plate/plate_frame.h"
#include "core/tracker/recent_places.h"

namespace hrt {

/// Noise of a tracked coordinate: SDs >= 0. The defaults are what NoiseLearner assumes for an unknown tracker.
struct TrackerNoise {
  double white_mm = 0.8;
  double correlated_mm = 0.9;
  double correlation_s = 0.1;  ///< time constant of the correlated part, > 0

  double variance_mm2() const { return white_mm * white_mm + correlated_mm * correlated_mm; }
};

inline double square_distance_mm2(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).squaredNorm(); }

/// Sums for D at lags of 1, 2, 4, ... 32 positions, with the indices 0 to 5. `sums` of several rests may be added.
struct StructureFunction {
  static constexpr int lags = 6;
  static constexpr int places(int lag) { return 1 << lag; }  ///< number of positions of a lag

  /// One column per lag: sum of half the squared differences of a coordinate, in mm^2; sum of the times between the two
  /// positions, in seconds; number of differences.
  Eigen::Array<double, 3, lags> sums = Eigen::Array<double, 3, lags>::Zero();

  void add(int lag, double half_square_mm2, double seconds) {
    sums.col(lag) += Eigen::Array3d(half_square_mm2, seconds, 1.0);
  }
  double count(int lag) const { return sums(2, lag); }
  double mean_mm2(int lag) const { return sums(0, lag) / sums(2, lag); }  ///< D
  double mean_s(int lag) const { return sums(1, lag) / sums(2, lag); }
};

struct NoiseParts {
  double white_mm2;       ///< w
  double correlated_mm2;  ///< c
  double cost;            ///< weighted sum of squared relative errors
};
/// Fits w >= 0 and c >= 0 to D for tau = `correlation_s`, by least squares of relative errors. The weight of a
/// lag is the number of its differences that do not overlap.
NoiseParts separate(const StructureFunction& differences, double correlation_s);

/// Estimates the white part of the noise at rest and in motion, and the correlated part at rest. `Point`: PlatePoint or
/// Eigen::Vector3d. Uses no heap, lock or exception.
template <class Point>
class NoiseLearner {
 public:
  /// `known`: configured noise, which positions do not change.
  explicit NoiseLearner(const std::optional<TrackerNoise>& known = {})
      : noise_(known.value_or(TrackerNoise{})), known_(known.has_value()) {}

  /// Processes the last of `places` of a resting finger; the last `rested` + 1 positions belong to the same rest.
  void learn(const RecentPlaces<Point>& places, int rested);
  /// Processes the last three of `places` of a moving finger, which show the white noise only.
  void learn_moving(const RecentPlaces<Point>& places);

  /// The known noise, or a mean of assumed and estimated noise; the weight of the estimate grows with steps().
  const TrackerNoise& noise() const { return noise_; }
  bool known() const { return known_; }
  /// Number of differences of successive positions, and D at this lag.
  int steps() const { return static_cast<int>(differences_.count(0)); }
  double step_variance_mm2() const { return differences_.mean_mm2(0); }

 private:
  static constexpr double coordinates = std::is_same_v<Point, PlatePoint> ? 2.0 : 3.0;
  void update();

  TrackerNoise noise_;
  bool known_;
  StructureFunction differences_;
};

extern template class NoiseLearner<PlatePoint>;
extern template class NoiseLearner<Eigen::Vector3d>;

}  // namespace hrt
