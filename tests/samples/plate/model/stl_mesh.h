// STL files of a solid: whether the surface is closed, and where a line meets it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <istream>
#include <string>
#include <vector>

namespace hrt {

using Triangle = std::array<Eigen::Vector3d, 3>;  ///< counter-clockwise seen from outside

/// Reads the text form of STL, as OpenSCAD writes it. Throws std::runtime_error with the line's number.
std::vector<Triangle> read_stl(std::istream& in);

/// A surface bounds a solid if all counts of faults are 0 and the volume is positive.
struct Surface {
  int flat_triangles = 0;  ///< of which two corners are the same
  int open_edges = 0;      ///< that do not belong to exactly two triangles, once in each direction
  int shells = 0;          ///< parts of the surface that share no corner
  double volume = 0.0;     ///< negative if the triangles are inside out
};
Surface inspect(const std::vector<Triangle>& mesh);

/// Where the line through `point` along an axis (0 to 2) meets the surface: coordinates on that axis in
/// ascending order. Inside are the stretches from the first to the second, the third to the fourth, and so
/// on. The line must not pass through an edge: give `point` odd coordinates.
std::vector<double> crossings(const std::vector<Triangle>& mesh, const Eigen::Vector3d& point, int axis);

}  // namespace hrt
