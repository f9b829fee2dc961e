// marks.csv beside the model that it describes, and what registration makes of its marks.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "core/plate/registration.h"
#include "plate_model.h"
#include "tests/samples/text.h"

namespace hrt {
namespace {

using Eigen::Vector3d;

struct Mark {
  std::string name;
  Vector3d plate_m;  ///< plate coordinates: x right, y up, z towards the user
  std::string orientation;
};

std::string file(const std::string& name) {
  std::ifstream in(std::string(HRT_PLATE_SOURCE) + "/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<Mark> marks() {
  std::istringstream rows(file("model/marks.csv"));
  std::vector<Mark> found;
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    std::istringstream fields(row);
    Mark mark;
    std::getline(fields, mark.name, ',');
    for (double& coordinate : mark.plate_m) {
      std::string field;
      std::getline(fields, field, ',');
      coordinate = std::stod(field);
    }
    std::getline(fields, mark.orientation);
    found.push_back(mark);
  }
  return found;
}

TEST(PlateMarks, TableIsThatOfTheModel) {
  std::string expected;
  for (const std::string& line : table_lines()) {
    if (!line.starts_with("bed,")) expected += line + "\n";
  }
  EXPECT_EQ(file("model/marks.csv"), expected);
}

TEST(PlateMarks, ReadmeHasTheTable) {
  std::string indented;
  std::istringstream rows(file("model/marks.csv"));
  for (std::string row; std::getline(rows, row);) indented += "    " + row + "\n";
  EXPECT_TRUE(has(file("model/README.md"), indented));
}

// The mark is the lowest point of a dimple: 1 mm deep there, shallower 2 mm away, and gone 4.5 mm away.
TEST(PlateMarks, SurfaceHasADimpleAtEachMark) {
  ASSERT_EQ(marks().size(), 6u);
  for (const Mark& mark : marks()) {
    const std::string part = mark.orientation == "any" ? "deck" : "plate";
    const double x = 1000.0 * mark.plate_m.x();
    const double y = -1000.0 * mark.plate_m.z();
    EXPECT_NEAR(heights(part, x + 0.01, y + 0.007).back(), 1000.0 * mark.plate_m.y(), 0.01) << mark.name;
    for (const double turn : {0.1, 1.7, 3.2, 4.8}) {
      const auto surface = [&](double r) {
        return heights(part, x + r * std::cos(turn), y + r * std::sin(turn)).back();
      };
      EXPECT_NEAR(surface(2.0), -0.76, 0.04) << mark.name;  // of a sphere of 8.5 mm
      EXPECT_EQ(surface(4.3), 0.0) << mark.name;
    }
  }
}

// By the names: far is away from the user, -z; left is -x.
TEST(PlateMarks, NamesSayWhereTheMarksAre) {
  for (const Mark& mark : marks()) {
    const bool far = mark.name.find("far") != std::string::npos;
    EXPECT_EQ(mark.plate_m.z() < 0.0, far) << mark.name;
    const bool left = mark.name.find("left") != std::string::npos;
    const bool right = mark.name.find("right") != std::string::npos;
    EXPECT_EQ(mark.plate_m.x() < 0.0, left) << mark.name;
    EXPECT_EQ(mark.plate_m.x() > 0.0, right) << mark.name;
  }
}

// One exact touch of each mark, with the deviation of 3 mm that registration assumes. The README has the
// number.
TEST(PlateMarks, SixTouchesGiveTheTurnToADegree) {
  std::vector<MarkTouch> touches;
  for (const Mark& mark : marks()) touches.push_back({mark.plate_m, mark.plate_m + Vector3d(0.3, 0.7, -0.2)});
  const Registration found = fit_registration({.touch_sd_m = 0.003}, touches);
  ASSERT_EQ(found.verdict, RegistrationVerdict::holds);
  const double assumed_over_seen = 0.003 / found.touch_sd_m;  // exact touches lower the deviation
  const double turn_sd_deg = std::sqrt(found.covariance(1, 1)) * assumed_over_seen * 57.29577951308232;
  EXPECT_NEAR(turn_sd_deg, 0.88, 0.01);
}

// Five remain when one touch is bad: it is named.
TEST(PlateMarks, OneBadTouchIsNamed) {
  std::vector<MarkTouch> touches;
  for (const Mark& mark : marks()) touches.push_back({mark.plate_m, mark.plate_m});
  touches[2].touched_m.x() += 0.05;
  const Registration found = fit_registration({.touch_sd_m = 0.003}, touches);
  ASSERT_EQ(found.verdict, RegistrationVerdict::holds);
  EXPECT_EQ(found.left_out, 2);
}

}  // namespace
}  // namespace hrt
