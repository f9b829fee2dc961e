// The model's files measured, beside the dimensions that the documents give. Millimetres.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "plate_model.h"

namespace hrt {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double tolerance = 1e-3;  // STL has six digits
constexpr double off = 0.0137;      // lines keep clear of corners

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << i;
}

std::vector<double> heights_at(const std::string& part, const Vector2d& at) {
  return heights(part, at.x() + off, at.y() - off);
}

// Where the line through the axis along X meets the part at this height, to the right of the axis.
std::vector<double> to_the_right(const std::string& part, double z) {
  std::vector<double> right = crossings(installed(part), {0.0, off, z + off}, 0);
  std::erase_if(right, [](double x) { return x < 0.0; });
  return right;
}

double outer_diameter(const std::string& part, double z) {
  return 2.0 * to_the_right(part, z).back();
}

double bore(const std::string& part, double z) {
  return 2.0 * to_the_right(part, z).front();
}

TEST(PlateModel, EveryPartIsOneSolid) {
  for (const std::string& part : printed_parts()) {
    const Surface surface = inspect(printed(part));
    EXPECT_EQ(surface.flat_triangles, 0) << part;
    EXPECT_EQ(surface.open_edges, 0) << part;
    EXPECT_EQ(surface.shells, 1) << part;
    EXPECT_GT(surface.volume, 1000.0) << part;
  }
}

TEST(PlateModel, EveryPartStandsOnTheBedOfASmallPrinter) {
  for (const std::string& part : printed_parts()) {
    Vector3d low = Vector3d::Constant(1e9);
    Vector3d high = -low;
    for (const Triangle& triangle : printed(part)) {
      for (const Vector3d& corner : triangle) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
      }
    }
    EXPECT_NEAR(low.z(), 0.0, tolerance) << part;
    EXPECT_LT(high.x() - low.x(), 200.0) << part;
    EXPECT_LT(high.y() - low.y(), 200.0) << part;
    EXPECT_LT(high.z() - low.z(), 100.0) << part;
  }
}

// Faces that look down above the bed are bridged by the printer: ceilings of holes and of the cable's slot.
TEST(PlateModel, NothingNeedsSupport) {
  for (const std::string& part : printed_parts()) {
    for (const Triangle& triangle : printed(part)) {
      const Vector3d area = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
      if (triangle[0].z() < 0.1 || area.z() > -0.75 * area.norm()) continue;
      const Vector3d low = triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
      const Vector3d high = triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
      EXPECT_LT((high - low).norm(), 16.0) << part << " at a height of " << low.z();
    }
  }
}

TEST(PlateModel, PlateIs150Across) {
  const std::vector<Triangle> plate = installed("plate");
  expect_near(crossings(plate, {0.0, off, -4.0 + off}, 0), {-75.0, 75.0});
  expect_near(heights("plate", 1.0 + off, off), {-8.0, 0.0});
}

// At orientation 0 the ridges run left to right, 1 mm wide and high, every 10 mm.
TEST(PlateModel, RidgesAreOneByOneEveryTen) {
  const std::vector<Triangle> plate = installed("plate");
  std::vector<double> sides;
  for (int i = -7; i < 7; ++i) sides.insert(sides.end(), {10.0 * i + 4.5, 10.0 * i + 5.5});
  expect_near(crossings(plate, {1.0 + off, 0.0, 0.5 + off}, 1), sides);
  for (int i = -7; i < 7; ++i) {
    for (const double x : {-25.0, 0.0, 25.0}) {
      EXPECT_NEAR(heights("plate", x + off, 10.0 * i + 5.0 + off).back(), 1.0, tolerance);
    }
  }
}

// The pointer of the plate, half of the zero pin's hole, is on the ridges' normal: away from the user.
TEST(PlateModel, ZeroPinJoinsPlateAndDeckOnTheMidLine) {
  for (const double y : {74.5, 75.5, 76.5}) {
    EXPECT_TRUE(heights("plate", off, y + off).empty()) << y;
    EXPECT_NEAR(heights("deck", off, y + off).back(), -21.0, tolerance) << y;
  }
  for (const double direction_deg : {15.0, -15.0, 90.0, -90.0, 180.0}) {
    EXPECT_EQ(heights_at("plate", at_direction(74.5, direction_deg)).size(), 2u) << direction_deg;
  }
}

// Engraved on the deck: ticks every 15 degrees, the longest one on the mid-line.
TEST(PlateModel, ScaleIsEngravedAboutTheMidLine) {
  for (int orientation_deg = -90; orientation_deg <= 90; orientation_deg += 15) {
    EXPECT_NEAR(heights_at("deck", at_direction(78.5, orientation_deg)).back(), -0.6, tolerance)
        << orientation_deg;
    EXPECT_NEAR(heights_at("deck", at_direction(78.5, orientation_deg + 7.5)).back(), 0.0, tolerance);
  }
  for (const double r : {78.5, 82.0, 86.0, 90.0, 92.5}) {
    EXPECT_NEAR(heights_at("deck", at_direction(r, 0.0)).back(), -0.6, tolerance) << r;
  }
  EXPECT_NEAR(heights_at("deck", at_direction(80.0, 180.0)).back(), -0.6, tolerance);
}

TEST(PlateModel, BearingFits) {
  EXPECT_NEAR(outer_diameter("hub", -17.0), 39.9, tolerance);
  EXPECT_NEAR(bore("deck", -17.0), 52.1, tolerance);
  EXPECT_NEAR(bore("deck", -22.0), 49.0, tolerance);           // the outer ring's face, not the inner one's
  EXPECT_NEAR(outer_diameter("hub", -13.5), 43.0, tolerance);  // the inner ring's face, not the outer one's
  EXPECT_NEAR(outer_diameter("retainer", -22.0), 43.0, tolerance);
  EXPECT_NEAR(heights("deck", 25.0, off).back(), -21.0, tolerance);
  EXPECT_NEAR(heights("hub", off, 1.0).front(), -20.8, tolerance);  // 0.2 short of the bearing's lower face
}

// A screw of the assembly guide: from under its head at `face`, along Z, `length` up (below 0: down).
struct Screw {
  std::string through;  ///< the part that it clamps
  std::string into;     ///< the part that its thread bites
  std::vector<Vector2d> at;
  double face;
  double length;
};

std::vector<Vector2d> on_circle(double radius, int count, double first_deg) {
  std::vector<Vector2d> at;
  for (int i = 0; i < count; ++i) at.push_back(at_direction(radius, first_deg + 360.0 * i / count));
  return at;
}

// As samples/plate/guide/draw shows them. The horn's threads are metal, 2 mm thick.
std::vector<Screw> screws() {
  const std::vector<Vector2d> posts = {{-28.0, 14.0}, {28.0, 14.0}, {-28.0, -34.0}, {28.0, -34.0}};
  const std::vector<Vector2d> flange = {{-5.0, 14.6}, {5.0, 14.6}, {-5.0, -34.9}, {5.0, -34.9}};
  return {{"hub", "plate", on_circle(27.0, 6, 0.0), -10.5, 8.0},
          {"retainer", "hub", on_circle(16.0, 4, 0.0), -28.0, 16.0},
          {"servo_mount", "deck", posts, -47.5, 30.0},
          {"servo", "servo_mount", flange, -41.5, -8.0},
          {"deck", "bridge", {at_direction(86.0, -20.0), at_direction(86.0, 20.0)}, -11.0, 16.0},
          {"bridge", "object", {{0.0, 50.0}}, 49.0, -16.0},
          {"drum", "deck", on_circle(88.0, 6, 0.0), -31.0, 16.0}};
}

// The screw passes the one part, bites 5 mm or more of the other, and does not reach the end of a blind hole.
TEST(PlateModel, EveryScrewFits) {
  for (const Screw& screw : screws()) {
    const double way = screw.length > 0.0 ? 1.0 : -1.0;
    for (const Vector2d& at : screw.at) {
      const auto along = [&](const std::string& part, double aside) {
        std::vector<double> found = heights_at(part, at + Vector2d(aside, 0.0));
        for (double& z : found) z *= way;
        std::sort(found.begin(), found.end());
        return found;
      };
      const double tip = way * screw.face + std::abs(screw.length);
      EXPECT_TRUE(along(screw.through, 0.0).empty()) << screw.through;
      const std::vector<double> hole = along(screw.into, 0.0);
      EXPECT_TRUE(hole.empty() || hole.front() > tip + 0.3) << screw.into;
      // Beside the hole is the plastic that the thread bites; beside its head's seat, what it clamps.
      const std::vector<double> bitten = along(screw.into, 1.6);
      ASSERT_GE(bitten.size(), 2u) << screw.into;
      EXPECT_GE(std::min(tip, bitten.back()) - bitten.front(), 4.99) << screw.into;
      const std::vector<double> clamped = along(screw.through, 2.5);
      EXPECT_NEAR(clamped.at(0), way * screw.face, screw.through == "servo" ? 0.501 : tolerance)
          << screw.through;
    }
  }
}

TEST(PlateModel, HornAndLugsHaveTheirHoles) {
  for (const Vector2d& at : on_circle(7.0, 4, 45.0)) {
    EXPECT_TRUE(heights_at("retainer", at).empty());
    EXPECT_TRUE(heights_at("horn", at).empty());
  }
  for (const Vector2d& at : on_circle(102.0, 4, 45.0)) EXPECT_TRUE(heights_at("drum", at).empty());
}

// From the start at (0, -50), 100 mm away, in the directions of the paper's real targets.
TEST(PlateModel, SocketsHoldObjectsAtTheEndOfAReach) {
  for (const double direction_deg : {-10.0, -5.0, 0.0, 5.0, 10.0}) {
    const Vector2d socket = Vector2d(0.0, -50.0) + at_direction(100.0, direction_deg);
    EXPECT_TRUE(heights_at("bridge", socket).empty()) << direction_deg;
    // Beside the screw's hole: the socket for the peg, open downwards.
    expect_near(heights_at("bridge", socket + Vector2d(0.0, 2.5)), {45.0, 49.0});
  }
  EXPECT_NEAR(heights("object", 2.0 + off, 50.0 + off).front(), 3.0, tolerance);  // 2 mm above the crests
  EXPECT_NEAR(heights("object", 4.0 + off, 50.0 + off).back(), 43.0, tolerance);
}

// Stretches of plastic along a vertical line, as pairs of heights.
using Column = std::vector<double>;

double overlap(const Column& a, const Column& b) {
  double max = 0.0;
  for (std::size_t i = 0; i + 1 < a.size(); i += 2) {
    for (std::size_t j = 0; j + 1 < b.size(); j += 2) {
      max = std::max(max, std::min(a[i + 1], b[j + 1]) - std::max(a[i], b[j]));
    }
  }
  return max;
}

TEST(PlateModel, NoTwoPartsShareAPlace) {
  std::vector<std::string> parts = printed_parts();
  parts.insert(parts.end(), {"bearing", "servo", "horn"});
  std::map<std::string, double> shared;
  for (double x = -110.0 + off; x < 110.0; x += 2.3) {
    for (double y = -110.0 - off; y < 110.0; y += 2.3) {
      std::vector<Column> columns;
      for (const std::string& part : parts) columns.push_back(heights(part, x, y));
      for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          double& max = shared[parts[j] + " and " + parts[i]];
          max = std::max(max, overlap(columns[i], columns[j]));
        }
      }
    }
  }
  for (const auto& [pair, max] : shared) EXPECT_LE(max, tolerance) << pair;
}

// What turns is swept through a whole turn: 0.4 mm of air about it everywhere, except in the bearing and on
// the servo's shaft.
TEST(PlateModel, WhatTurnsTouchesNothing) {
  constexpr double step = 0.4;
  const auto swept = [](const std::vector<std::string>& parts) {
    std::vector<std::vector<Column>> rings;
    for (double r = 3.5; r < 110.0; r += step) {
      rings.emplace_back();
      for (double direction_deg = 0.37; direction_deg < 360.0; direction_deg += 4.0) {
        const Vector2d at = at_direction(r, direction_deg);
        for (const std::string& part : parts) {
          Column column = heights(part, at.x(), at.y());
          if (!column.empty()) rings.back().push_back(std::move(column));
        }
      }
    }
    return rings;
  };
  const std::vector<std::vector<Column>> turning = swept({"plate", "hub", "retainer", "horn"});
  std::vector<std::vector<Column>> fixed =
      swept({"deck", "drum", "servo_mount", "bridge", "object", "servo"});
  for (std::vector<Column>& ring : fixed) {
    for (Column& column : ring) {
      for (std::size_t i = 0; i + 1 < column.size(); i += 2) column[i] -= step, column[i + 1] += step;
    }
  }
  ASSERT_EQ(turning.size(), fixed.size());
  for (std::size_t ring = 0; ring < turning.size(); ++ring) {
    double max = 0.0;
    for (std::size_t beside = ring == 0 ? 0 : ring - 1; beside < std::min(ring + 2, fixed.size()); ++beside) {
      for (const Column& turns : turning[ring]) {
        for (const Column& stays : fixed[beside]) max = std::max(max, overlap(turns, stays));
      }
    }
    EXPECT_EQ(max, 0.0) << "at a radius of " << 3.5 + step * static_cast<double>(ring);
  }
}

}  // namespace
}  // namespace hrt
