#include "stl_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <sstream>
#include <stdexcept>

namespace hrt {
namespace {

using Eigen::Vector3d;

// From (0, 0, 0) to (2, 3, 5), twelve triangles.
std::vector<Triangle> box() {
  const auto corner = [](int bits) {
    return Vector3d((bits & 1) != 0 ? 2 : 0, (bits & 2) != 0 ? 3 : 0, (bits & 4) != 0 ? 5 : 0);
  };
  std::vector<Triangle> mesh;
  for (const std::array<int, 4>& quad : std::vector<std::array<int, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    mesh.push_back({corner(quad[0]), corner(quad[1]), corner(quad[2])});
    mesh.push_back({corner(quad[0]), corner(quad[2]), corner(quad[3])});
  }
  return mesh;
}

std::string text_of(const std::vector<Triangle>& mesh) {
  std::ostringstream text;
  text << "solid OpenSCAD_Model\n";
  for (const Triangle& triangle : mesh) {
    text << "  facet normal 0 0 1\n    outer loop\n";
    for (const Vector3d& corner : triangle) {
      text << "      vertex " << corner.x() << ' ' << corner.y() << ' ' << corner.z() << '\n';
    }
    text << "    endloop\n  endfacet\n";
  }
  text << "endsolid OpenSCAD_Model\n";
  return text.str();
}

std::string refusal(const std::string& text) {
  std::istringstream in(text);
  try {
    read_stl(in);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(StlMesh, BoxIsReadBack) {
  std::istringstream in(text_of(box()));
  EXPECT_EQ(read_stl(in), box());
}

TEST(StlMesh, FilesThatAreCutOffAreRefused) {
  const std::string whole = text_of(box());
  EXPECT_EQ(refusal(""), "line 1: \"solid\" is missing");
  EXPECT_EQ(refusal(whole.substr(0, whole.find("endsolid"))), "line 86: \"endsolid\" is missing");
  EXPECT_EQ(refusal(whole.substr(0, whole.find("vertex"))), "line 4: a vertex with three numbers is missing");
}

TEST(StlMesh, BoxIsASolidOfThirty) {
  const Surface surface = inspect(box());
  EXPECT_EQ(surface.flat_triangles, 0);
  EXPECT_EQ(surface.open_edges, 0);
  EXPECT_EQ(surface.shells, 1);
  EXPECT_DOUBLE_EQ(surface.volume, 30.0);
}

TEST(StlMesh, MissingTriangleLeavesThreeOpenEdges) {
  std::vector<Triangle> mesh = box();
  mesh.pop_back();
  EXPECT_EQ(inspect(mesh).open_edges, 3);
}

TEST(StlMesh, TriangleThatIsInsideOutIsSeen) {
  std::vector<Triangle> mesh = box();
  std::swap(mesh[5][0], mesh[5][1]);
  EXPECT_GT(inspect(mesh).open_edges, 0);
}

TEST(StlMesh, BoxInsideOutHasNegativeVolume) {
  std::vector<Triangle> mesh = box();
  for (Triangle& triangle : mesh) std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(inspect(mesh).open_edges, 0);
  EXPECT_DOUBLE_EQ(inspect(mesh).volume, -30.0);
}

TEST(StlMesh, TwoBoxesAreTwoShells) {
  std::vector<Triangle> mesh = box();
  for (Triangle triangle : box()) {
    for (Vector3d& corner : triangle) corner.x() += 10;
    mesh.push_back(triangle);
  }
  EXPECT_EQ(inspect(mesh).shells, 2);
}

TEST(StlMesh, LinesMeetTheBoxOnItsSides) {
  const Vector3d inside(0.7, 1.3, 2.1);
  EXPECT_EQ(crossings(box(), inside, 0), (std::vector<double>{0, 2}));
  EXPECT_EQ(crossings(box(), inside, 1), (std::vector<double>{0, 3}));
  EXPECT_EQ(crossings(box(), inside, 2), (std::vector<double>{0, 5}));
  EXPECT_TRUE(crossings(box(), {2.1, 1.3, 2.1}, 2).empty());
}

}  // namespace
}  // namespace hrt
