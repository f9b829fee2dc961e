// Measurement of the tracker's bearing error over a reach, from touches of two dimples.
#pragma once

#include <span>
#include <string>

#include "samples/app/run/run_context.h"

namespace hrt::reach {

using namespace app;

/// Text with the SD of the bearings and the fraction of reaches that can end within 1.5 degrees, with 95 % intervals.
/// `bearings_deg`: 20 bearings; they may wrap around at 180 degrees.
std::string bearing_sd_text(std::span<const double> bearings_deg, double mean_distance_m);

/// Asks the user to touch two dimples in turn, 20 times each, and returns bearing_sd_text(). Throws Failure
/// (ExitCode::no_hand) if the finger does not rest in a dimple within the time limit.
std::string measure_tracker(RunContext& context);

}  // namespace hrt::reach
