#include "core/person/arrival.h"

#include <algorithm>

namespace hrt {

Progress progress(double evenness, double phase) {
  const double u = std::clamp(phase, 0.0, 1.0);
  const double rest = u * (1.0 - u);
  const double bell = 30.0 * rest * rest;
  const double smooth = 1.0 - evenness;
  return {.share = smooth * u * u * u * (10.0 + u * (-15.0 + 6.0 * u)) + evenness * u,
          .rate = smooth * bell + evenness,
          .acceleration = smooth * 60.0 * rest * (1.0 - 2.0 * u),
          .by_evenness = 1.0 - bell};
}

double phase_at(double evenness, double share) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (progress(evenness, middle).share < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace hrt
