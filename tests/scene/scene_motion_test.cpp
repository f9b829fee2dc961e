// A rigid motion of a random scene changes no plate coordinates; mirroring it negates the directions.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/scene/scene_document.h"

namespace hrt {
namespace {

class RandomScenes : public testing::Test {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  Json translation(double size_m) {
    return {uniform(-size_m, size_m), uniform(-size_m, size_m), uniform(-size_m, size_m)};
  }

  Json rotation() {
    std::normal_distribution<double> normal;
    double q[4];
    double squared_norm = 0.0;
    for (double& component : q) {
      component = normal(random_);
      squared_norm += component * component;
    }
    const double norm = std::sqrt(squared_norm);
    return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
  }

  // Returns a root, and as its children the plate, a real and three virtual targets at random positions.
  Json nodes() {
    Json result = {node("Root", {}, {{"children", {1, 2, 3, 4, 5}}}),
                   plate({{"translation", translation(0.5)}, {"rotation", rotation()}})};
    const Json at_plate = result[1]["translation"];
    const auto near_plate = [&] {
      Json place = translation(0.1);
      for (std::size_t i = 0; i < 3; ++i) place[i] = place[i].get<double>() + at_plate[i].get<double>();
      return place;
    };
    result.push_back(node("Real", haptic("real"), {{"translation", near_plate()}}));
    for (const char* name : {"A", "B", "C"}) {
      result.push_back(node(name, haptic("virtual"), {{"translation", near_plate()}}));
    }
    return result;
  }

  std::mt19937_64 random_{20210};
};

constexpr int trials = 200;

TEST_F(RandomScenes, RigidMotionChangesNoDirection) {
  for (int trial = 0; trial < trials; ++trial) {
    Json file = nodes();
    const Scene still = load(document(file));
    file[0]["translation"] = translation(20.0);
    file[0]["rotation"] = rotation();
    const Scene moved = load(document(file));
    ASSERT_EQ(moved.targets.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      // Rounding errors at 20 m are 4e-15 m, which is 2e-10 degrees at the minimum distance of 1 mm.
      EXPECT_NEAR(direction_deg(moved, moved.targets[i]), direction_deg(still, still.targets[i]), 1e-9);
      EXPECT_NEAR(distance_m(moved, moved.targets[i]), distance_m(still, still.targets[i]), 1e-13);
      EXPECT_NEAR(moved.targets[i].position_m.y, still.targets[i].position_m.y, 1e-13);
    }
  }
}

TEST_F(RandomScenes, MirroringNegatesDirections) {
  for (int trial = 0; trial < trials; ++trial) {
    const Scene scene = load(document(nodes()));
    Json mirrored = {node("Root", {}, {{"scale", {-1.0, 1.0, 1.0}}, {"children", {1, 2, 3, 4, 5}}}), plate()};
    for (const SceneTarget& target : scene.targets) {
      const Vec3 p = target.position_m;
      mirrored.push_back(
          node(target.name.c_str(), haptic(target.served_by ? "virtual" : "real"), {{"translation", {p.x, p.y, p.z}}}));
    }
    const Scene seen = load(document(mirrored));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(direction_deg(seen, seen.targets[i]), -direction_deg(scene, scene.targets[i]), 1e-10);
      EXPECT_NEAR(distance_m(seen, seen.targets[i]), distance_m(scene, scene.targets[i]), 1e-15);
    }
  }
}

}  // namespace
}  // namespace hrt
