#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/samples/study/process.h"

namespace hrt::study {
namespace {

const std::string scenes = HRT_SCENES;

// The real cylinder is straight ahead, so w T = theta_V for the plate orientation T and the virtual direction theta_V.
// For w = 0.1, T is 6 / 0.1 = 60 and -8 / 0.1 = -80; 12 needs 120, which is 108 degrees from the virtual direction,
// above the limit of 84.5. For w = 0.15, 12 needs 80.
TEST(StudyScene, DeskByHand) {
  const StudyRun run = expect_exit(0, run_study({"scene", scenes + "/desk.gltf"}));
  const auto rows = lines(run.out);
  EXPECT_EQ(rows[0], "Plate Desk/Apparatus/Plate: radius 75.0 mm, at most 400 deg/s");
  EXPECT_EQ(rows[1], "Start (default): x 0.0 mm, z 50.0 mm from the plate's centre");
  EXPECT_EQ(rows[3], "target    kind     direction  distance  height  node");
  EXPECT_EQ(rows[5], "cylinder  real          0.00     100.0     0.0  Desk/Apparatus/Cylinder");
  EXPECT_EQ(rows[8], "pawn      virtual      12.00     100.0     0.0  Desk/Apparatus/Pawn");
  EXPECT_EQ(rows[rows.size() - 4], "                       deg     0.1    0.15     0.2");
  EXPECT_EQ(rows[rows.size() - 3], "bottle    cylinder    6.00    60.0    40.0    30.0");
  EXPECT_EQ(rows[rows.size() - 2], "goblet    cylinder   -8.00   -80.0   -53.3   -40.0");
  EXPECT_EQ(rows[rows.size() - 1], "pawn      cylinder   12.00       -    80.0    60.0");
  EXPECT_TRUE(has(run.out, "there was no human trial"));
}

TEST(StudyScene, Table1AsJson) {
  const StudyRun run = expect_exit(0, run_study({"scene", scenes + "/table1.gltf", "--format", "json"}));
  const auto page = nlohmann::json::parse(run.out);
  ASSERT_EQ(page["rows"].size(), 18U);
  for (const auto& pair : page["rows"]) {
    EXPECT_NEAR(std::abs(pair["gap_deg"].get<double>()), 10.0, 1e-8);
    EXPECT_EQ(pair["reachable"], pair["tactile_weight"] != 0.1);  // gaps up to 9.4 degrees are feasible at 0.1
  }
}

// The real target is at 175 degrees, behind the start, and the virtual one at -175: 10 degrees apart.
TEST(StudyScene, GapsAreWrappedTo180Degrees) {
  const TemporaryFolder folder;
  const std::string file = folder / "behind.gltf";
  std::ofstream(file) << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],"nodes":[
    {"name":"Plate","extras":{"haptic_role":"plate","haptic_radius_m":0.075}},
    {"name":"Real","translation":[-0.0087155743,0,0.1496194698],"extras":{"haptic_role":"real"}},
    {"name":"Virtual","translation":[0.0087155743,0,0.1496194698],"extras":{"haptic_role":"virtual"}}]})";
  const StudyRun run = expect_exit(0, run_study({"scene", file, "--format", "json", "--tactile-weight", "0.15"}));
  EXPECT_NEAR(nlohmann::json::parse(run.out)["rows"][0]["gap_deg"].get<double>(), 10.0, 1e-6);
}

TEST(StudyScene, AnErrorOfTheFileIsOneLine) {
  const StudyRun missing = expect_exit(1, run_study({"scene", "no such.gltf"}));
  EXPECT_TRUE(has(missing.err, "hrt-study: no such.gltf: "));
  EXPECT_EQ(missing.out, "");
  const TemporaryFolder folder;
  const std::string file = folder / "bare.gltf";
  std::ofstream(file) << R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"name":"Cube"}]})";
  const StudyRun bare = expect_exit(1, run_study({"scene", file}));
  EXPECT_TRUE(has(bare.err, "hrt-study: " + file + ": no node has a haptic role"));
  EXPECT_EQ(std::count(bare.err.begin(), bare.err.end(), '\n'), 1);
  EXPECT_EQ(run_study({"scene"}).exit_code, 2);
}

}  // namespace
}  // namespace hrt::study
