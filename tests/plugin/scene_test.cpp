// Scenes through the C interface, with samples/scenes/desk.gltf, whose numbers tests/scene checks.
#include <fstream>
#include <sstream>

#include "fixture.h"
#include "scene/scene.h"

namespace hrt::test {
namespace {

class SceneAbiTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    ASSERT_OK(hrt_scene_load(HRT_DESK_SCENE, nullptr, 0, &scene));
  }
  void TearDown() override {
    EXPECT_OK(hrt_scene_destroy(scene));
    SessionTest::TearDown();
  }

  hrt_scene_info info() const {
    auto info = output<hrt_scene_info>();
    EXPECT_OK(hrt_scene_get_info(scene, &info));
    return info;
  }

  hrt_scene_target target(std::uint32_t index) const {
    auto target = output<hrt_scene_target>();
    EXPECT_OK(hrt_scene_get_target(scene, index, &target));
    return target;
  }

  hrt_scene scene{};
};

TEST_F(SceneAbiTest, ReturnsTheContentOfTheScene) {
  const Scene expected = load_scene(std::filesystem::path(HRT_DESK_SCENE));
  const std::uint32_t count = info().target_count;
  ASSERT_EQ(count, expected.targets.size());
  ASSERT_GE(count, 4u);
  EXPECT_EQ(info().plate_radius_m, expected.plate.radius_m);
  EXPECT_EQ(info().plate_position_m[1], expected.plate.pose.position_m.y);
  EXPECT_EQ(info().start_position_m[2], expected.start_m.z);
  for (std::uint32_t i = 0; i < count; ++i) {
    EXPECT_EQ(target(i).name, expected.targets[i].name);
    EXPECT_EQ(target(i).direction_deg, direction_deg(expected, expected.targets[i]));
    EXPECT_EQ(target(i).role == HRT_TARGET_VIRTUAL, target(i).served_by >= 0);
  }
  auto beyond = output<hrt_scene_target>();
  expect_error(hrt_scene_get_target(scene, count, &beyond), HRT_ERROR_OUT_OF_RANGE, "index is");
}

TEST_F(SceneAbiTest, RegistersPlateAndTargetsInOneCall) {
  std::vector<hrt_target> ids(info().target_count);
  ASSERT_OK(hrt_scene_register(scene, session, ids.size(), ids.data()));
  const hrt_session_config config = config_of(session);
  EXPECT_TRUE(same(config.plate.rotation, info().plate_rotation));
  EXPECT_EQ(config.plate.radius_m, info().plate_radius_m);
  for (std::uint32_t i = 0; i < ids.size(); ++i) {
    auto registered = output<hrt_target_config>();
    ASSERT_OK(hrt_target_get(session, ids[i], &registered));
    EXPECT_STREQ(registered.name, target(i).name);
    if (target(i).role == HRT_TARGET_REAL) {
      EXPECT_EQ(registered.served_by.value, 0u);
      continue;
    }
    const auto real = static_cast<std::uint32_t>(target(i).served_by);
    EXPECT_EQ(registered.served_by.value, ids[real].value);
    EXPECT_NEAR(gap_of(ids[real], ids[i]).gap_deg, target(i).direction_deg - target(real).direction_deg, 1e-9);
  }
}

TEST_F(SceneAbiTest, RegistersAllOrNothing) {
  const hrt_scene_target last = target(info().target_count - 1);
  add(HRT_TARGET_REAL, 0.0, last.name);
  const hrt_session_config before = config_of(session);
  expect_error(hrt_scene_register(scene, session, 0, nullptr), HRT_ERROR_NAME_TAKEN, last.name);
  hrt_target small[1];
  expect_error(hrt_scene_register(scene, session, 1, small), HRT_ERROR_BUFFER_TOO_SMALL, "capacity");
  uint64_t count = 0;
  ASSERT_OK(hrt_target_list(session, 0, 0, nullptr, &count));
  EXPECT_EQ(count, 1u);
  EXPECT_TRUE(same(config_of(session), before));
}

TEST_F(SceneAbiTest, LoadsFromMemory) {
  std::ifstream file(HRT_DESK_SCENE, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  const std::string text = bytes.str();
  hrt_scene loaded{};
  ASSERT_OK(hrt_scene_load("desk", text.data(), text.size(), &loaded));
  EXPECT_NE(loaded.value, scene.value);
  ASSERT_OK(hrt_scene_destroy(loaded));
  expect_error(hrt_scene_destroy(loaded), HRT_ERROR_INVALID_HANDLE, "scene");
  expect_error(hrt_scene_load("half a desk", text.data(), text.size() / 2, &loaded), HRT_ERROR_BAD_FORMAT,
               "half a desk");
}

TEST_F(SceneAbiTest, TargetsBeyondTenPlateRadiiLogAWarning) {
  const auto log_of = [](const char* far_z) {
    const std::string text = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1,2]}],"nodes":[
      {"name":"plate","extras":{"haptic_role":"plate","haptic_radius_m":0.1}},
      {"name":"near","translation":[0,0,-0.9],"extras":{"haptic_role":"real"}},
      {"name":"far","translation":[0,0,)" +
                             std::string(far_z) + R"(],"extras":{"haptic_role":"real"}}]})";
    const Log log;
    hrt_scene loaded{};
    EXPECT_OK(hrt_scene_load("desk", text.data(), text.size(), &loaded));
    EXPECT_OK(hrt_scene_destroy(loaded));
    return log.text;
  };
  EXPECT_EQ(log_of("-0.99"), "");
  const std::string warning = log_of("-1.01");
  EXPECT_TRUE(warning.starts_with(std::to_string(HRT_LOG_WARNING) + " desk: 1 of the targets")) << warning;
  EXPECT_NE(warning.find("\"far\" at 1.01 m"), warning.npos) << warning;
}

TEST_F(SceneAbiTest, InvalidArgumentsAreRejected) {
  hrt_scene loaded{7};
  expect_error(hrt_scene_load("/no/such/file.gltf", nullptr, 0, &loaded), HRT_ERROR_SYSTEM, "/no/such/file.gltf");
  EXPECT_EQ(loaded.value, 7u);
  expect_error(hrt_scene_register(scene, {scene.value}, 0, nullptr), HRT_ERROR_INVALID_HANDLE, "session");
  expect_error(hrt_scene_register({session.value}, session, 0, nullptr), HRT_ERROR_INVALID_HANDLE, "scene");
  begin_reach();
  expect_error(hrt_scene_register(scene, session, 0, nullptr), HRT_ERROR_WRONG_STATE);
}

}  // namespace
}  // namespace hrt::test
