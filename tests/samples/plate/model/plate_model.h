// The parts that the target plate_model wrote, where they are once they are built together.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "stl_mesh.h"

namespace hrt {

/// As printed: z = 0 is the printer's bed. Throws std::runtime_error if there is no such file.
std::vector<Triangle> printed(const std::string& part);

/// In place: +X to the user's right, +Y along the mid-line, z = 0 on the plate's face; millimetres.
const std::vector<Triangle>& installed(const std::string& part);

/// Lines that the model's tables print, without OpenSCAD's frame.
std::vector<std::string> table_lines();

/// The printed parts.
const std::vector<std::string>& printed_parts();

/// Coordinates on Z of the surface above and below (x, y), of an installed part.
std::vector<double> heights(const std::string& part, double x, double y);

/// In the plane, from the centre: counter-clockwise from +Y.
Eigen::Vector2d at_direction(double radius, double direction_deg);

}  // namespace hrt
