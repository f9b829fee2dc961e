// The bend of a plate's sensor: how far its reports are off a straight line.
#pragma once

#include <vector>

namespace hrt::plate {

struct SweepPoint;

/// Fits reported less commanded orientation by a line and the first two harmonics of the angle, as a magnet beside the
/// axis and a bent potentiometer have them, and by the gears' play, which is left out of the result. Returns the bend
/// at `count` reported places from min_deg to max_deg, in degrees. Takes eight points or more.
std::vector<double> fit_bend(const std::vector<SweepPoint>& sweep, double min_deg, double max_deg, int count);

}  // namespace hrt::plate
