// Simulated people with the paths and speeds of recorded reaches of real people.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/simulation/own_path.h"
#include "samples/study/people/robustness.h"

namespace hrt::study {

/// Reads the reaches of one person to one target. Columns, in any order:
///
///   reach     whole number; contiguous rows with the same number are one reach
///   time_s    increases within a reach
///   right_mm, away_mm   position of the fingertip, in any fixed coordinate system of the plane
///
/// A reach lasts from the first to the last time at which the finger is faster than 5 % of its largest speed. `name` is
/// the file's name in errors. Throws UsageError naming the line or reach and what is allowed.
std::vector<RecordedReach> parse_reaches(const std::string& name, std::string_view text);

/// Returns simulated people with the paths and speeds of the files in `folder`. Each reach of person i replays a random
/// reach of file i modulo the number of files. The response to touch is drawn as in the family "linear". `argument` is
/// the option's name in errors.
SimulatedPeople people_of_recordings(const std::string& argument, const std::string& folder);

}  // namespace hrt::study
