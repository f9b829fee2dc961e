// Who is this participant? w_T, bias, variances and the tracker's noise from slides over a plate that stands
// still (paper section V, "calibration"; the method is ours, derived in core/README.md).
//
// Off-line work: it allocates and takes as long as it needs. Any thread.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/plate_frame.h"

namespace hrt {

/// One slide towards the target with the plate at rest. Positions from before the motion show the
/// tracker's noise.
struct CalibrationTrial {
  double plate_orientation_deg = 0.0;  ///< finite
  std::vector<TimedPoint> samples;     ///< times increase; positions finite
};

struct CalibrationConfig {
  double goal_direction_deg = 0.0;  ///< direction of the target that the participant goes for, finite
  std::int64_t step_period_ns = 100'000'000;  ///< of the model, 1 ms to 10 s
};

/// An estimate with its 95 % interval. If the data cannot determine the value, `known` is false, the interval
/// is the searched range, and the value its most likely point.
struct Interval {
  double value = 0.0;
  double lower = 0.0;
  double upper = 0.0;
  bool known = true;
};

/// The normal quantile of 0.975.
inline constexpr double normal_975 = 1.959963984540054;

/// The standard deviation of which a 95 % interval from `lower` to `upper` is that of a normal estimate.
inline double deviation_of_interval(double lower, double upper) {
  return (upper - lower) / (2.0 * normal_975);
}

/// The second half of one slide: its direction, and the fitted one.
struct Chord {
  double plate_orientation_deg;
  double direction_deg;
  double fitted_deg;
};

struct Calibration {
  Interval tactile_weight;
  Interval bias_deg;               ///< the participant's own, left positive, at the target
  Interval motor_variance_deg2;    ///< sigma_u^2
  Interval sensory_variance_deg2;  ///< sigma_h^2
  Interval tracker_noise_m;
  std::vector<Chord> chords;  ///< one a trial that was used
};

/// Why there is no calibration: one sentence with the mistake and the requirement.
struct CalibrationRefusal {
  std::string reason;
};

/// Needs at least `least_trials` slides of at least 30 mm, at three plate angles or more that span
/// 40 degrees: one angle alone cannot separate w_T from a bias. Refuses a w_T whose interval is not within
/// the usable range (0.02, 0.48).
std::variant<Calibration, CalibrationRefusal> calibrate(const std::vector<CalibrationTrial>& trials,
                                                        const CalibrationConfig& config = {});

inline constexpr int least_trials = 10;
inline constexpr double least_slide_m = 0.03;

}  // namespace hrt
