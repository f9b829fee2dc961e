// Simulated slides of people (people.h) over a plate at rest, as a calibration records them.
#pragma once

#include "core/calibrate/slide_track.h"
#include "core/simulation/people.h"

namespace hrt {

/// One slide straight ahead, with the plate at rest at `plate_orientation_deg`; the
/// gap of the condition does not count. `slide` is its number in the session; each sets out within 2 degrees
/// (SD) of the person's start direction. Any thread.
CalibrationTrial simulate_slide(const PersonCondition& condition, double plate_orientation_deg, std::uint64_t seed,
                                std::uint32_t person, std::uint32_t slide);

}  // namespace hrt
