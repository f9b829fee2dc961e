#include "stl_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace hrt {
namespace {

using Eigen::Vector3d;

[[noreturn]] void refuse(int line, const std::string& text) {
  throw std::runtime_error("line " + std::to_string(line) + ": " + text);
}

Vector3d read_vertex(const std::string& text, int line) {
  std::istringstream words(text);
  std::string vertex;
  Vector3d at;
  if (!(words >> vertex >> at.x() >> at.y() >> at.z()) || vertex != "vertex") {
    refuse(line, "a vertex with three numbers is missing");
  }
  if (!at.allFinite()) refuse(line, "a coordinate is not finite");
  return at;
}

// Each corner's number; equal coordinates have the same.
class Corners {
 public:
  int number(const Vector3d& at) {
    return numbers_.try_emplace({at.x(), at.y(), at.z()}, static_cast<int>(numbers_.size())).first->second;
  }
  int count() const { return static_cast<int>(numbers_.size()); }

 private:
  std::map<std::tuple<double, double, double>, int> numbers_;
};

// The least number of each corner's shell.
int root(std::vector<int>& parents, int corner) {
  while (parents[corner] != corner) corner = parents[corner] = parents[parents[corner]];
  return corner;
}

}  // namespace

std::vector<Triangle> read_stl(std::istream& in) {
  std::vector<Triangle> mesh;
  std::string text;
  int line = 0;
  bool ended = false;
  const auto next = [&] {
    ++line;
    return static_cast<bool>(std::getline(in, text));
  };
  if (!next() || !text.starts_with("solid")) refuse(1, "\"solid\" is missing");
  while (!ended && next()) {
    std::istringstream words(text);
    std::string first;
    words >> first;
    if (first == "facet") {
      if (!next()) refuse(line, "\"outer loop\" is missing");
      Triangle triangle;
      for (Vector3d& corner : triangle) {
        if (!next()) refuse(line, "the file ends within a facet");
        corner = read_vertex(text, line);
      }
      mesh.push_back(triangle);
    } else if (first == "endsolid") {
      ended = true;
    } else if (first != "endloop" && first != "endfacet") {
      refuse(line, "neither a facet nor \"endsolid\"");
    }
  }
  if (!ended) refuse(line, "\"endsolid\" is missing");
  return mesh;
}

Surface inspect(const std::vector<Triangle>& mesh) {
  Surface surface;
  Corners corners;
  std::vector<std::array<int, 3>> faces;
  for (const Triangle& triangle : mesh) {
    faces.push_back({corners.number(triangle[0]), corners.number(triangle[1]), corners.number(triangle[2])});
    surface.volume += triangle[0].dot(triangle[1].cross(triangle[2])) / 6.0;
  }
  std::vector<int> parents(corners.count());
  std::iota(parents.begin(), parents.end(), 0);
  std::map<std::pair<int, int>, int> uses;  // of each edge, by direction
  for (const std::array<int, 3>& face : faces) {
    surface.flat_triangles += face[0] == face[1] || face[1] == face[2] || face[2] == face[0] ? 1 : 0;
    for (int i = 0; i < 3; ++i) {
      ++uses[{face[i], face[(i + 1) % 3]}];
      parents[root(parents, face[i])] = root(parents, face[(i + 1) % 3]);
    }
  }
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    surface.open_edges += count == 1 && back != uses.end() && back->second == 1 ? 0 : 1;
  }
  for (int corner = 0; corner < corners.count(); ++corner) {
    surface.shells += root(parents, corner) == corner ? 1 : 0;
  }
  return surface;
}

std::vector<double> crossings(const std::vector<Triangle>& mesh, const Vector3d& point, int axis) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  std::vector<double> found;
  for (const Triangle& triangle : mesh) {
    const auto [low_u, high_u] = std::minmax({triangle[0][u], triangle[1][u], triangle[2][u]});
    const auto [low_v, high_v] = std::minmax({triangle[0][v], triangle[1][v], triangle[2][v]});
    if (point[u] < low_u || point[u] > high_u || point[v] < low_v || point[v] > high_v) continue;
    // Twice the areas of the point with each side, seen along the axis: the weights of the corners.
    std::array<double, 3> areas{};
    for (int i = 0; i < 3; ++i) {
      const Vector3d& a = triangle[(i + 1) % 3];
      const Vector3d& b = triangle[(i + 2) % 3];
      areas[i] = (a[u] - point[u]) * (b[v] - point[v]) - (b[u] - point[u]) * (a[v] - point[v]);
    }
    const auto [min, max] = std::minmax({areas[0], areas[1], areas[2]});
    if (!(min > 0.0) && !(max < 0.0)) continue;
    found.push_back(
        (areas[0] * triangle[0][axis] + areas[1] * triangle[1][axis] + areas[2] * triangle[2][axis]) /
        (areas[0] + areas[1] + areas[2]));
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace hrt
