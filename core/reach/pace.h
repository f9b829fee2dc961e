// How far and how long a reach still goes: the pace at which people move over a path.
//
//   s(u) = (1 - a) (10 u^3 - 15 u^4 + 6 u^5) + a u,   u' = r
//
// with u the share of the time, s the share of the path, a the evenness of the pace (0: the bell-shaped speed
// of a minimum-jerk motion, 1: even) and r one over the duration.
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

/// At `phase` u, clamped to [0, 1]; `evenness` in [0, 1].
inline Progress progress(double evenness, double phase) {
  const double u = std::clamp(phase, 0.0, 1.0);
  const double rest = u * (1.0 - u);
  const double bell = 30.0 * rest * rest;
  const double smooth = 1.0 - evenness;
  return {.share = smooth * u * u * u * (10.0 + u * (-15.0 + 6.0 * u)) + evenness * u,
          .rate = smooth * bell + evenness,
          .acceleration = smooth * 60.0 * rest * (1.0 - 2.0 * u),
          .by_evenness = 1.0 - bell};
}

/// u where `share` of the path lies behind, and 1 beyond its end; within 1e-5.
inline double phase_at(double evenness, double share) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (progress(evenness, middle).share < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace hrt
