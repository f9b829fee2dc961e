// Simulated slides over a plate at rest, as a calibration records them.
#pragma once

#include "core/calibrate/slide_track.h"
#include "core/simulation/people.h"

namespace hrt {

/// Simulates slide number `slide` of a session, straight ahead with the plate at rest at `plate_orientation_deg`.
/// Ignores the directions of the targets. The initial direction varies by 2 degrees (SD) about that of the person. Any
/// thread.
CalibrationTrial simulate_slide(const PersonCondition& condition, double plate_orientation_deg, std::uint64_t seed,
                                std::uint32_t person, std::uint32_t slide);

}  // namespace hrt
