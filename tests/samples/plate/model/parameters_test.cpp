// Other dimensions than the defaults: the model follows them, or refuses them with a reason.
#include <gtest/gtest.h>

#include <fstream>

#include "plate_model.h"
#include "tests/samples/process.h"

namespace hrt {
namespace {

Outcome openscad(const std::string& out, const std::vector<std::string>& settings) {
  std::vector<std::string> words = {HRT_OPENSCAD, "-q", "-o", out};
  for (const std::string& setting : settings) words.insert(words.end(), {"-D", setting});
  words.push_back(std::string(HRT_PLATE_SOURCE) + "/model/apparatus.scad");
  return Process(words, {}).wait();
}

TEST(PlateParameters, RidgesFollowTheirParameters) {
  const TemporaryFolder folder;
  const Outcome outcome = openscad(folder / "plate.stl", {"part=\"plate\"", "ridge_spacing_mm=20",
                                                          "ridge_width_mm=2", "ridge_height_mm=0.5"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::ifstream in(folder / "plate.stl");
  const std::vector<Triangle> mesh = read_stl(in);
  EXPECT_EQ(inspect(mesh).open_edges, 0);
  // On the bed the face is at 8 mm: ridges at odd multiples of 10 mm.
  const std::vector<double> sides = crossings(mesh, {9.01, 0.0, 8.26}, 1);
  ASSERT_EQ(sides.size(), 16u);
  for (int i = 0; i < 8; ++i) {
    EXPECT_NEAR(sides[2 * i], 20.0 * (i - 4) + 9.0, 1e-3);
    EXPECT_NEAR(sides[2 * i + 1], 20.0 * (i - 4) + 11.0, 1e-3);
  }
  EXPECT_NEAR(crossings(mesh, {9.01, 10.02, 0.0}, 2).back(), 8.5, 1e-3);
}

TEST(PlateParameters, DimensionsThatWouldNotWorkAreRefused) {
  const TemporaryFolder folder;
  const std::pair<std::string, std::string> refused[] = {
      {"ridge_width_mm=10", "ridge_spacing_mm must be above ridge_width_mm"},
      {"start_distance_mm=75", "start_distance_mm must leave the start's dimple on the plate"},
      {"plate_thickness_mm=6", "plate_thickness_mm must leave 1.5 mm above the screws of the hub"},
      {"rim_gap_mm=5", "rim_gap_mm must be 4 or less: wider gaps admit a fingertip"},
      {"part=\"plat\"", "part is \"plat\"; it must be one of the list in apparatus.scad"},
  };
  for (const auto& [setting, reason] : refused) {
    const Outcome outcome = openscad(folder / "part.stl", {"part=\"object\"", setting});
    EXPECT_NE(outcome.exit_code, 0) << setting;
    EXPECT_TRUE(has(outcome.out + outcome.err, reason)) << outcome.err;
    EXPECT_FALSE(std::ifstream(folder / "part.stl").good()) << setting;
  }
}

}  // namespace
}  // namespace hrt
