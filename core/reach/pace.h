// Pace of a reach: the path covered as a function of time.
//
//   s(u) = (1 - a) (10 w^3 - 15 w^4 + 6 w^5) + a u,   w = u + q u (1 - u),   u' = r
//
// with u the fraction of the time, s the fraction of the path, a the evenness of the pace (0: the bell-shaped speed
// of a minimum-jerk motion, 1: even), q its skew (0: symmetric; 0.5: the peak is at 0.38 of the time) and r one over
// the duration.
#pragma once

#include <algorithm>

namespace hrt {

/// s and its derivatives by u.
struct Progress {
  double share;         ///< s
  double rate;          ///< s'
  double acceleration;  ///< s''
  double by_evenness;   ///< d s' / d a
};

/// At `phase` u, clamped to [0, 1]; `evenness` in [0, 1]; `skew` in [-1, 1].
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

/// u where `share` of the path lies behind, and 1 beyond its end; within 1e-5.
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
