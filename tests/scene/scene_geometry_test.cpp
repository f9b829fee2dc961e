// Scenes with hand-computed results. The default plate has a radius of 75 mm, so that reaches start at z = +50 mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

#include "core/plate/plate_frame.h"
#include "tests/scene/scene_document.h"

namespace hrt {
namespace {

const double sin_45 = std::sqrt(0.5);
const Json quarter_left = {0.0, sin_45, 0.0, sin_45};  // by 90 degrees about +Y, counter-clockwise from above

TEST(SceneGeometry, DefaultStartIsTwoThirdsTowardsTheUser) {
  const Scene scene = load(document({plate(), real(), virtual_on_the_left()}));
  EXPECT_EQ(scene.start_m.x, 0.0);
  EXPECT_EQ(scene.start_m.y, 0.0);
  EXPECT_DOUBLE_EQ(scene.start_m.z, 0.05);
  EXPECT_FALSE(scene.start_path.has_value());
  ASSERT_EQ(scene.targets.size(), 2u);
  EXPECT_DOUBLE_EQ(direction_deg(scene, scene.targets[0]), 0.0);
  EXPECT_DOUBLE_EQ(distance_m(scene, scene.targets[0]), 0.1);
  EXPECT_DOUBLE_EQ(direction_deg(scene, scene.targets[1]), 90.0);
  EXPECT_EQ(scene.targets[1].served_by, 0u);
}

// Two real targets are at 60 degrees, one at -170. The real target at -170 degrees is 100 degrees from the virtual
// target at 90 degrees, and 40 degrees from the one at 150.
TEST(SceneGeometry, WithoutServedByTheNearestInDirectionIsAssigned) {
  const auto at = [](const char* name, const char* role, double direction_deg) {
    const PlatePoint place = point_ahead({0.0, -50.0}, direction_deg, 50.0);
    return node(name, haptic(role), {{"translation", {place.right_mm / mm_per_m, 0.0, -place.away_mm / mm_per_m}}});
  };
  const Scene scene =
      load(document({plate(), at("Far", "real", -170.0), at("Near", "real", 60.0), at("Equal", "real", 60.0),
                     at("Left", "virtual", 90.0), at("Behind", "virtual", 150.0)}));
  EXPECT_EQ(scene.targets[3].served_by, 1u);
  EXPECT_EQ(scene.targets[4].served_by, 0u);
}

// The target is 40 mm ahead of the start, 30 mm to the left and 120 mm up. Its distance along the plate is 50 mm.
TEST(SceneGeometry, DirectionsAreMeasuredFromTheStartNodeAlongThePlate) {
  const Json start = node("Start", haptic("start"), {{"translation", {0.03, 0.005, 0.02}}});
  const Scene scene = load(document({plate(), start, real({{"translation", {0.0, 0.12, -0.02}}})}));
  EXPECT_EQ(scene.start_path, "Start");
  EXPECT_EQ(scene.start_m.y, 0.0);
  EXPECT_NEAR(direction_deg(scene, scene.targets[0]), 36.86989764584402, 1e-12);
  EXPECT_NEAR(distance_m(scene, scene.targets[0]), 0.05, 1e-15);
  EXPECT_DOUBLE_EQ(scene.targets[0].position_m.y, 0.12);
}

// The mid-line of the plate at (1, 1, 1) is the world's -X, so its right is the world's -Z. Its start is at (1.05, 1,
// 1), and 100 mm ahead of it is (0.95, 1, 1).
TEST(SceneGeometry, DirectionsAreRelativeToARotatedPlate) {
  const Scene scene = load(document({plate({{"translation", {1, 1, 1}}, {"rotation", quarter_left}}),
                                     real({{"translation", {0.95, 1.0, 1.0}}}),
                                     node("Right", haptic("virtual"), {{"translation", {1.05, 1.0, 0.9}}})}));
  EXPECT_NEAR(direction_deg(scene, scene.targets[0]), 0.0, 1e-12);
  EXPECT_NEAR(distance_m(scene, scene.targets[0]), 0.1, 1e-15);
  EXPECT_NEAR(direction_deg(scene, scene.targets[1]), -90.0, 1e-12);
  EXPECT_NEAR(scene.targets[1].position_m.x, 0.1, 1e-15);
  EXPECT_DOUBLE_EQ(scene.targets[1].world_position_m.x, 1.05);
  EXPECT_NEAR(scene.plate.pose.orientation.y, sin_45, 1e-15);
  EXPECT_NEAR(scene.plate.pose.orientation.w, sin_45, 1e-15);
}

// A group at (10, 0, 0) is rotated by 90 degrees to the left. In it, a shelf is 1 m along the group's -Z, which is the
// world's -X, with the plate: at (9, 0, 0), with the mid-line along -X. The same with every transform as a matrix.
TEST(SceneGeometry, NestedTransformsEqualNestedMatrices) {
  const Json nodes = {node("Group", {}, {{"translation", {10, 0, 0}}, {"rotation", quarter_left}, {"children", {1}}}),
                      node("Shelf", {}, {{"translation", {0, 0, -1}}, {"children", {2, 3}}}), plate(), real()};
  const Json matrices = {
      node("Group", {}, {{"matrix", {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 10, 0, 0, 1}}, {"children", {1}}}),
      node("Shelf", {}, {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1}}, {"children", {2, 3}}}), plate(),
      real({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -0.05, 1}}})};
  for (const Json& form : {nodes, matrices}) {
    const Scene scene = load(document(form));
    EXPECT_EQ(scene.plate.node_path, "Group/Shelf/Plate");
    EXPECT_NEAR(scene.plate.pose.position_m.x, 9.0, 1e-15);
    EXPECT_NEAR(scene.plate.pose.position_m.z, 0.0, 1e-15);
    EXPECT_NEAR(scene.plate.pose.orientation.y, sin_45, 1e-15);
    EXPECT_NEAR(scene.targets[0].world_position_m.x, 8.95, 1e-15);
    EXPECT_NEAR(direction_deg(scene, scene.targets[0]), 0.0, 1e-12);
    EXPECT_NEAR(distance_m(scene, scene.targets[0]), 0.1, 1e-12);
    EXPECT_EQ(scene.targets[0].node_path, "Group/Shelf/Real");
  }
}

// Each component of the quaternion is the largest in turn.
TEST(SceneGeometry, AnyRotationOfThePlateIsReturned) {
  for (std::vector<double> q = {0.8, 0.4, -0.4, 0.2}; const int turn : {0, 1, 2, 3}) {
    const Quaternion found = load(document({plate({{"rotation", q}}), real()})).plate.pose.orientation;
    const double sign = q[3] < 0.0 ? -1.0 : 1.0;
    EXPECT_NEAR(found.x, sign * q[0], 1e-12) << turn;
    EXPECT_NEAR(found.y, sign * q[1], 1e-12) << turn;
    EXPECT_NEAR(found.z, sign * q[2], 1e-12) << turn;
    EXPECT_NEAR(found.w, sign * q[3], 1e-12) << turn;
    std::rotate(q.begin(), q.begin() + 1, q.end());
  }
}

TEST(SceneGeometry, ScaleMovesChildrenAndKeepsTheRadius) {
  const Json doubled = node("Group", {}, {{"scale", {3.0, 5.0, 2.0}}, {"children", {1, 2}}});
  const Scene scene = load(document({doubled, plate(), real({{"translation", {-0.05, 0.01, 0.025}}})}));
  EXPECT_DOUBLE_EQ(scene.plate.radius_m, 0.075);
  EXPECT_DOUBLE_EQ(scene.start_m.z, 0.05);
  EXPECT_DOUBLE_EQ(scene.targets[0].position_m.x, -0.15);
  EXPECT_DOUBLE_EQ(scene.targets[0].position_m.y, 0.05);
  EXPECT_DOUBLE_EQ(scene.targets[0].position_m.z, 0.05);
  EXPECT_DOUBLE_EQ(direction_deg(scene, scene.targets[0]), 90.0);
}

// The plate's own scale does not change distances. A mirrored +X changes neither the normal nor the mid-line, so left
// stays left; a mirrored -Z reverses the mid-line, and a mirrored +Y the normal, which exchanges left and right.
TEST(SceneGeometry, NegativeScaleOfThePlateMirrorsItsAxes) {
  const Json left = node("Left", haptic("real"), {{"translation", {-0.03, 0.0, 0.0}}});
  const auto position = [&](const Json& scale) {
    return load(document({plate({{"scale", scale}}), left})).targets[0].position_m;
  };
  EXPECT_DOUBLE_EQ(position({2.0, 3.0, 4.0}).x, -0.03);
  EXPECT_DOUBLE_EQ(position({-1.0, 1.0, 1.0}).x, -0.03);
  EXPECT_DOUBLE_EQ(position({1.0, 1.0, -1.0}).x, 0.03);
  EXPECT_DOUBLE_EQ(position({1.0, -1.0, 1.0}).x, 0.03);
  EXPECT_DOUBLE_EQ(position({-1.0, -1.0, -1.0}).x, -0.03);
  EXPECT_DOUBLE_EQ(position({1.0, 1.0, 1e-5}).x, -0.03);
}

// Within a non-uniform scale, rotations by 90 degrees about X and by 45 degrees about Y keep the normal perpendicular
// to the mid-line; one by 45 degrees about X does not.
TEST(SceneGeometry, ShearedPlateIsRejected) {
  const double sin_deg_22_5 = std::sqrt(0.5 - 0.5 * sin_45);
  const double cos_deg_22_5 = std::sqrt(0.5 + 0.5 * sin_45);
  const Json group = node("Group", {}, {{"scale", {1.0, 1.0, 3.0}}, {"children", {1}}});
  EXPECT_EQ(refusal(document({group, plate({{"rotation", {sin_45, 0.0, 0.0, sin_45}}})})), "");
  EXPECT_EQ(refusal(document({group, plate({{"rotation", {0.0, sin_deg_22_5, 0.0, cos_deg_22_5}}})})), "");
  EXPECT_TRUE(refusal(document({group, plate({{"rotation", {sin_deg_22_5, 0.0, 0.0, cos_deg_22_5}}})}))
                  .starts_with("test.gltf: node \"Group/Plate\": "));
}

TEST(SceneGeometry, DefaultSceneOfSeveralIsLoaded) {
  Json file = document({plate(), real(), node("Other", haptic("plate", {{"radius_m", 1.0}}))});
  file["scenes"] = Json::array({{{"nodes", {2}}}, {{"nodes", {0, 1}}}});
  file["scene"] = 1;
  EXPECT_EQ(load(file).plate.node_path, "Plate");
  file["scene"] = 0;
  EXPECT_EQ(load(file).plate.node_path, "Other");
  file.erase("scene");
  EXPECT_NE(refusal(file).find("2 scenes"), std::string::npos);
  file["scenes"].erase(0);
  EXPECT_EQ(load(file).plate.node_path, "Plate");
  file.erase("scenes");
  EXPECT_NE(refusal(file).find("the file has no scene"), std::string::npos);
}

TEST(SceneGeometry, FlatPropertiesEqualNestedOnes) {
  const Json flat_plate = node("Plate", {{"haptic_role", "plate"},
                                         {"haptic_radius_m", 0.075},
                                         {"haptic_max_speed_deg_s", 400},
                                         {"unrelated", Json::array()}});
  const Json flat_real = node("Brass", {{"haptic_role", "real"}, {"haptic_name", "cylinder"}, {"haptic_radius_m", 1}},
                              {{"translation", {0.0, 0.0, -0.05}}});
  const Json flat_virtual = node("Bottle", {{"haptic_role", "virtual"}, {"haptic_served_by", "cylinder"}},
                                 {{"translation", {-0.1, 0.0, 0.05}}});
  const Scene scene = load(document({flat_plate, flat_real, flat_virtual}));
  EXPECT_EQ(scene.plate.max_speed_deg_s, 400.0);
  EXPECT_EQ(scene.targets[0].name, "cylinder");
  EXPECT_EQ(scene.targets[0].radius_m, 1.0);
  EXPECT_EQ(scene.targets[1].name, "Bottle");
  EXPECT_EQ(scene.targets[1].served_by, 0u);
}

TEST(SceneGeometry, NamelessNodesAreNamedByTheirPath) {
  Json group = {{"children", {1, 2}}};
  Json target = {{"extras", haptic("real")}, {"translation", {0.0, 0.0, -0.05}}};
  const Scene scene = load(document({group, plate(), target}));
  EXPECT_EQ(scene.targets[0].name, "[0]/[2]");
  EXPECT_EQ(scene.plate.node_path, "[0]/Plate");
}

TEST(SceneGeometry, BinaryFileLoadsFromMemoryAndFromDisk) {
  Json file = document({plate(), real(), virtual_on_the_left()});
  file["buffers"] = Json::array({{{"byteLength", 4}}});
  const std::string bytes = glb(file, "abcd");
  const Scene from_memory = load(bytes);
  EXPECT_DOUBLE_EQ(direction_deg(from_memory, from_memory.targets[1]), 90.0);

  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "hrt_scene_geometry.glb";
  std::ofstream(path, std::ios::binary) << bytes;
  const Scene from_disk = load_scene(path);
  EXPECT_DOUBLE_EQ(direction_deg(from_disk, from_disk.targets[1]), 90.0);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace hrt
