// What a calibration found, in words.
#pragma once

#include <iosfwd>
#include <string>

#include "samples/reach/run/calibrate.h"

namespace hrt::reach {

/// The curve of the illusion with the numbers that follow from it, the other values with their intervals,
/// lack of fit with what to do about it, and the slides that were left out. Slides are numbered from 1.
void print_calibration(std::ostream& out, const CalibrationOutcome& outcome);

/// What matters of it, to be spoken.
std::string calibration_in_words(const CalibrationOutcome& outcome);

}  // namespace hrt::reach
