// Minimum-jerk pace of simulated motions. Independent of the controller's core/person/person_model.h.
#pragma once

#include <algorithm>

namespace hrt {

/// Returns the fraction of the path of a minimum-jerk motion (Flash and Hogan, J. Neurosci. 5, 1985) after `fraction`
/// of its duration. `fraction` is clamped to [0, 1].
inline double minimum_jerk(double fraction) {
  const double u = std::clamp(fraction, 0.0, 1.0);
  return u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}

}  // namespace hrt
