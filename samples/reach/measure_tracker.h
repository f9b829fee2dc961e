// The error of one's own tracker over a reach, from touches of two dimples.
#pragma once

#include <span>
#include <string>

#include "samples/app/run/stage.h"

namespace hrt::reach {

using namespace app;

/// SD of the bearings, its 95 % interval, and the share of reaches that can end within 1.5 degrees, in words.
/// `bearings_deg`: 20 of them, any of which may lie across the half turn.
std::string bearing_sd_text(std::span<const double> bearings_deg, double mean_distance_m);

/// Asks the user to touch two dimples in turn, 20 times each, and returns bearing_sd_text(). Throws Failure
/// (ExitCode::no_hand) if one is not touched within the time limit.
std::string measure_tracker(Stage& stage);

}  // namespace hrt::reach
