#include "scene/scene.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

const std::filesystem::path sample_scenes = HRT_SAMPLE_SCENES;
const std::filesystem::path scene_files = HRT_SCENE_FILES;

TEST(DeskScene, HasThePlateStartAndTargetsOfItsReadme) {
  const Scene scene = load_scene(sample_scenes / "desk.gltf");
  EXPECT_EQ(scene.plate.node_path, "Desk/Apparatus/Plate");
  EXPECT_DOUBLE_EQ(scene.plate.radius_m, 0.075);
  EXPECT_EQ(scene.plate.max_speed_deg_s, 400.0);
  EXPECT_DOUBLE_EQ(scene.plate.pose.position_m.x, 0.12);
  EXPECT_DOUBLE_EQ(scene.plate.pose.position_m.y, 0.75);
  EXPECT_DOUBLE_EQ(scene.start_m.z, 0.05);

  struct Expected {
    const char* name;
    double direction_deg;
    bool is_real;
  };
  const std::vector<Expected> expected{
      {"cylinder", 0.0, true}, {"bottle", 6.0, false}, {"goblet", -8.0, false}, {"pawn", 12.0, false}};
  ASSERT_EQ(scene.targets.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    SCOPED_TRACE(expected[i].name);
    const SceneTarget& target = scene.targets[i];
    EXPECT_EQ(target.name, expected[i].name);
    EXPECT_EQ(target.is_real, expected[i].is_real);
    EXPECT_NEAR(direction_deg(scene, target), expected[i].direction_deg, 1e-8);
    EXPECT_NEAR(distance_m(scene, target), 0.1, 1e-9);
    EXPECT_NEAR(target.position_m.y, 0.0, 1e-12);
    EXPECT_EQ(target.radius_m, 0.005);
    EXPECT_EQ(target.served_by.has_value(), !target.is_real);
    EXPECT_EQ(target.served_by.value_or(0), 0u);
  }
}

TEST(Table1Scene, HasTheSixPairsOfThePaper) {
  const Scene scene = load_scene(sample_scenes / "table1.gltf");
  const std::vector<std::pair<double, double>> real_and_virtual_deg{{-5, 5},  {5, -5}, {0, 10},
                                                                    {-10, 0}, {10, 0}, {0, -10}};
  std::vector<std::pair<double, double>> found;
  for (const SceneTarget& target : scene.targets) {
    if (target.served_by)
      found.emplace_back(direction_deg(scene, scene.targets[*target.served_by]), direction_deg(scene, target));
  }
  ASSERT_EQ(found.size(), real_and_virtual_deg.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].first, real_and_virtual_deg[i].first, 1e-8);
    EXPECT_NEAR(found[i].second, real_and_virtual_deg[i].second, 1e-8);
  }
}

// files/make_with_blender.py made the file, in single precision: 1e-8 m at 0.1 m are 1e-5 degrees. The group "Rig" is
// at (1.2, 2, 0.7) in Blender's axes, which is (1.2, 0.7, -2) in those of glTF, and is rotated by 30 degrees.
TEST(BlenderScene, LoadsFlatAndNestedPropertiesOfAnExport) {
  const Scene scene = load_scene(scene_files / "blender.gltf");
  EXPECT_EQ(scene.plate.node_path, "Desk/Rig/Plate");
  EXPECT_EQ(scene.plate.radius_m, 0.075);
  EXPECT_EQ(scene.plate.max_speed_deg_s, 400.0);
  EXPECT_NEAR(scene.plate.pose.position_m.x, 1.2, 1e-6);
  EXPECT_NEAR(scene.plate.pose.position_m.y, 0.7, 1e-6);
  EXPECT_NEAR(scene.plate.pose.position_m.z, -2.0, 1e-6);
  EXPECT_NEAR(scene.plate.pose.orientation.y, 0.25881904510252076, 1e-7);  // sin 15
  ASSERT_EQ(scene.targets.size(), 3u);
  const SceneTarget& bottle = scene.targets[0];
  const SceneTarget& cylinder = scene.targets[1];
  const SceneTarget& mirrored = scene.targets[2];
  EXPECT_EQ(bottle.name, "Bottle");
  EXPECT_EQ(bottle.served_by, 1u);
  EXPECT_EQ(bottle.radius_m, 0.005);
  EXPECT_NEAR(direction_deg(scene, bottle), 10.0, 1e-3);
  EXPECT_EQ(cylinder.name, "cylinder");
  EXPECT_TRUE(cylinder.is_real);
  EXPECT_NEAR(direction_deg(scene, cylinder), 0.0, 1e-3);
  EXPECT_NEAR(direction_deg(scene, mirrored), -8.0, 1e-3);
  EXPECT_NEAR(mirrored.position_m.y, 0.01, 1e-7);
  for (const SceneTarget& target : scene.targets) EXPECT_NEAR(distance_m(scene, target), 0.1, 1e-7);
}

}  // namespace
}  // namespace hrt
