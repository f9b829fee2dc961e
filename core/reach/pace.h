// Pace of a reach: the fraction s of the path as a function of the fraction u of the time,
//
//   s(u) = (1 - a) (10 eta^3 - 15 eta^4 + 6 eta^5) + a u,   eta = u + kappa u (1 - u)
//
// where a is the evenness (0: the bell-shaped speed of a minimum-jerk motion, 1: constant speed) and kappa the skew (0:
// the speed is symmetric in time; 0.4, for a = 0: the speed peaks at 0.37 of the time).
#pragma once

#include <algorithm>

namespace hrt {

/// s and its derivatives by u and a.
struct Progress {
  double share;         ///< s
  double rate;          ///< ds/du
  double acceleration;  ///< second derivative of s by u
  double by_evenness;   ///< derivative of `rate` by a
};

/// Returns s and its derivatives at `phase` u, which is clamped to [0, 1]. `evenness` in [0, 1], `skew` in [-1, 1].
inline Progress progress(double evenness, double phase, double skew = 0.0) {
  const double u = std::clamp(phase, 0.0, 1.0);
  const double w = u * (1.0 + skew * (1.0 - u));
  const double w_by_u = 1.0 + skew * (1.0 - 2.0 * u);
  const double rest = w * (1.0 - w);
  const double bell = 30.0 * rest * rest;
  const double smooth = 1.0 - evenness;
  return {.share = smooth * w * w * w * (10.0 + w * (-15.0 + 6.0 * w)) + evenness * u,
          .rate = smooth * bell * w_by_u + evenness,
          .acceleration = smooth * (60.0 * rest * (1.0 - 2.0 * w) * w_by_u * w_by_u - 2.0 * skew * bell),
          .by_evenness = 1.0 - bell * w_by_u};
}

/// Inverse of progress(): returns u for the fraction `share` of the path, 0 to 1, with an error of at most 1e-6.
inline double phase_at(double evenness, double share, double skew = 0.0) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (progress(evenness, middle, skew).share < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace hrt
