// sigma_u^2 and sigma_h^2 of paper section II-A from slides over a plate at rest.
#pragma once

#include <cstdint>
#include <span>

#include "core/calibrate/slide_track.h"
#include "core/math/interval.h"
#include "core/paper/participant.h"

namespace hrt {

struct Variances {
  Interval motor_deg2;    ///< sigma_u^2
  Interval sensory_deg2;  ///< sigma_h^2
};

/// The likeliest variances of the paper's person with `tactile_weight`, who goes for `goal_deg`, tracked with
/// white noise. Never known: people who steer continuously give as narrow a likelihood, at values that mean
/// nothing, and slides do not show which they are. Trials without a motion are left out.
Variances fit_variances(std::span<const CalibrationTrial* const> trials, double goal_deg,
                        double tactile_weight, double tracker_noise_m, std::int64_t step_period_ns);

}  // namespace hrt
