// Recorded reaches of real people, whose paths and speeds simulated people reproduce.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/simulation/own_path.h"
#include "samples/study/people/robustness.h"

namespace hrt::study {

/// Returns the .csv files of a folder, sorted by name. `what`: expected content, for errors. Throws UsageError if the
/// folder has no such file.
std::vector<std::string> csv_files(const std::string& argument, const std::string& folder, const std::string& what);

/// Reads the reaches of one person to one target. Columns, in any order:
///
///   reach     whole number; rows with the same number, one after another, are a reach
///   time_s    increases within a reach
///   right_mm, away_mm   position of the fingertip, in any fixed frame of the plane
///
/// A reach lasts from the first to the last time at which the finger is faster than 5 % of its largest speed. `name` is
/// the file's name in errors. Throws UsageError naming the line or reach and what is allowed.
std::vector<RecordedReach> parse_reaches(const std::string& name, std::string_view text);

/// Returns people with the paths and speeds of the files of `folder`, one file per person: person i has the reaches of
/// file i modulo the number of files, in random order. Their response to touch is drawn as in the family "linear".
SimulatedPeople people_of_recordings(const std::string& argument, const std::string& folder);

}  // namespace hrt::study
