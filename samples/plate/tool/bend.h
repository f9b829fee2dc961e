#pragma once

#include <vector>

namespace hrt::plate {

struct SweepPoint;

/// Computes the nonlinearity of a sensor (settings bend_0 to bend_8). Fits a model of reported minus commanded
/// orientation by least squares: a line, the first two harmonics of the angle (an eccentric magnet or a nonlinear
/// potentiometer), and the play of the gears. Returns the model without the play, in degrees, at `count` reported
/// orientations from min_deg to max_deg. Requires at least eight points.
std::vector<double> fit_bend(const std::vector<SweepPoint>& sweep, double min_deg, double max_deg, int count);

}  // namespace hrt::plate
