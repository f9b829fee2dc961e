// An application for OpenXR 1.1. Above each test stands the sentence that it tests, from the
// specification 1.1.
#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "tests/samples/mock_runtime/negotiation.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

class MockProfiles : public MockNegotiation {
 protected:
  XrResult suggest(XrAction action, const std::string& profile, const std::string& source) {
    return Application::suggest("/interaction_profiles/" + profile, {{action, path("/user/hand/" + source)}});
  }
};

class MockVersion11 : public MockProfiles {
 protected:
  void SetUp() override {
    MockNegotiation::SetUp();
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
    ASSERT_XR(XR_SUCCESS, create_direct({XR_MND_HEADLESS_EXTENSION_NAME}, XR_MAKE_VERSION(1, 1, 41)));
    create_session();
  }
  void TearDown() override {
    destroy_direct();
    MockNegotiation::TearDown();
  }

  XrSpace space(XrReferenceSpaceType type, const XrVector3f& at = {}) {
    return create_space(type, {identity_pose.orientation, at});
  }
};

// "LOCAL_FLOOR [...] establishes a world-locked origin [...] at the floor level": right below LOCAL.
TEST_F(MockVersion11, LocalFloorIsBelowLocal) {
  std::uint32_t count = 0;
  const auto enumerate = XR(xrEnumerateReferenceSpaces);
  ASSERT_XR(XR_SUCCESS, enumerate(session, 0, &count, nullptr));
  std::vector<XrReferenceSpaceType> types(count);
  ASSERT_XR(XR_SUCCESS, enumerate(session, count, &count, types.data()));
  EXPECT_EQ(std::count(types.begin(), types.end(), XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR), 1);
  const XrSpaceLocation location =
      located(space(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR), space(XR_REFERENCE_SPACE_TYPE_LOCAL), 1);
  EXPECT_NEAR(location.pose.position.y, -1.2F, 1e-6F);
}

// "xrLocateSpaces [...] provides the physical location of one or more spaces in a base space at a specified
// time"; velocities follow if they are chained.
TEST_F(MockVersion11, ManySpacesAreLocatedAtOnce) {
  const XrSpace base = space(XR_REFERENCE_SPACE_TYPE_LOCAL, {0.0F, 0.0F, -1.0F});
  const std::array spaces{space(XR_REFERENCE_SPACE_TYPE_LOCAL, {2.0F, 0.0F, 0.0F}),
                          space(XR_REFERENCE_SPACE_TYPE_STAGE)};
  std::array<XrSpaceLocationData, 2> data{};
  std::array<XrSpaceVelocityData, 2> velocity_data{};
  velocity_data[1].linearVelocity = {7.0F, 7.0F, 7.0F};
  XrSpaceVelocities velocities{XR_TYPE_SPACE_VELOCITIES, nullptr, 2, velocity_data.data()};
  XrSpaceLocations locations{XR_TYPE_SPACE_LOCATIONS, &velocities, 2, data.data()};
  const XrSpacesLocateInfo info{XR_TYPE_SPACES_LOCATE_INFO, nullptr, base, 1, 2, spaces.data()};
  ASSERT_XR(XR_SUCCESS, XR(xrLocateSpaces)(session, &info, &locations));
  EXPECT_EQ(data[0].locationFlags, 15U);
  EXPECT_NEAR(data[0].pose.position.x, 2.0F, 1e-6F);
  EXPECT_NEAR(data[0].pose.position.z, 1.0F, 1e-6F);
  EXPECT_NEAR(data[1].pose.position.y, -1.2F, 1e-6F);
  EXPECT_EQ(velocity_data[1].velocityFlags, 3U);
  EXPECT_EQ(velocity_data[1].linearVelocity.x, 0.0F);
}

// "Interaction Profile Paths": each profile that 1.1 adds, with sources that distinguish it, and those of
// which the profiles of 1.0 have more in 1.1.
TEST_F(MockVersion11, PromotedProfilesHaveTheirSources) {
  const XrAction any = make_action(make_set("set"), "any", XR_ACTION_TYPE_FLOAT_INPUT);
  const std::vector<std::pair<const char*, std::vector<const char*>>> profiles{
      {"oculus/touch_controller", {"left/input/trigger/proximity", "right/input/grip_surface/pose"}},
      {"valve/index_controller", {"left/input/grip_surface/pose"}},
      {"bytedance/pico_neo3_controller", {"left/input/x/touch", "right/input/menu/click"}},
      {"bytedance/pico4_controller", {"left/input/menu/click", "right/input/squeeze/click"}},
      {"bytedance/pico_g3_controller",
       {"left/input/trigger/click", "right/input/trigger/value", "left/input/menu/click", "right/input/thumbstick",
        "left/input/thumbstick/x", "right/input/thumbstick/y", "left/input/thumbstick/click",
        "right/input/grip_surface/pose"}},
      {"hp/mixed_reality_controller", {"left/input/y/click", "right/input/squeeze/value"}},
      {"htc/vive_cosmos_controller", {"left/input/shoulder/click", "right/input/system/click"}},
      {"htc/vive_focus3_controller", {"left/input/squeeze/touch", "right/input/thumbrest/touch"}},
      {"meta/touch_controller_rift_cv1", {"left/input/x/click"}},
      {"meta/touch_controller_quest_1_rift_s", {"right/input/b/touch"}},
      {"meta/touch_controller_quest_2", {"left/input/thumb_resting_surfaces/proximity"}},
      {"meta/touch_plus_controller", {"left/input/trigger/force", "right/input/trigger_curl/value"}},
      {"meta/touch_pro_controller", {"left/input/stylus/force", "right/output/haptic_thumb"}},
      {"ml/ml2_controller", {"left/input/home/click", "right/input/trackpad/force"}},
      {"samsung/odyssey_controller", {"left/input/squeeze/click", "right/input/trackpad/touch"}}};
  for (const auto& [profile, sources] : profiles)
    for (const std::string source : sources)
      EXPECT_XR(XR_SUCCESS, suggest(any, profile, source)) << profile << ' ' << source;
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest(any, "bytedance/pico4_controller", "right/input/menu/click"));
  for (const char* absent : {"input/thumbstick/touch", "input/squeeze/value", "output/haptic"})
    EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest(any, "bytedance/pico_g3_controller", std::string("left/") + absent))
        << absent;
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest(any, "meta/touch_plus_controller", "left/input/stylus/force"));
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED,
            suggest(any, "meta/touch_controller_quest_1_rift_s", "left/input/thumbrest/touch"));
}

// Of an application for 1.0.
class MockPromoted : public MockProfiles {
 protected:
  void SetUp() override {
    MockNegotiation::SetUp();
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  }
  XrResult create(const std::vector<const char*>& names, XrVersion version = XR_MAKE_VERSION(1, 0, 0)) {
    return create_direct(names, version);
  }
};

// XR_EXT_palm_pose: "/user/hand/left/input/palm_ext/pose", "only usable if the extension is enabled";
// XR_KHR_maintenance1: "grip_surface" likewise, on all profiles that have a grip.
TEST_F(MockPromoted, PosesOfThePalmAreThereWithTheirExtensions) {
  for (const auto& [extension, pose] :
       {std::pair{"XR_EXT_palm_pose", "palm_ext"}, {"XR_KHR_maintenance1", "grip_surface"}})
    for (const bool enabled : {false, true}) {
      std::vector<const char*> names;
      if (enabled) names.push_back(extension);
      ASSERT_XR(XR_SUCCESS, create(names));
      const XrAction action = make_action(make_set("set"), "only", XR_ACTION_TYPE_POSE_INPUT);
      for (const char* profile : {"khr/simple_controller", "valve/index_controller"})
        EXPECT_XR(enabled ? XR_SUCCESS : XR_ERROR_PATH_UNSUPPORTED,
                  suggest(action, profile, std::string("left/input/") + pose + "/pose"));
      destroy_direct();
    }
}

// Each extension that OpenXR 1.1 promotes can be withheld.
TEST_F(MockPromoted, CanBeWithheld) {
  const TemporaryFolder folder;
  for (const std::string name :
       {"XR_EXT_local_floor", "XR_KHR_locate_spaces", "XR_KHR_maintenance1", "XR_EXT_palm_pose"}) {
    std::ofstream(folder / "script.json") << R"({"withhold_extensions": [")" << name << "\"]}";
    EXPECT_XR(XR_SUCCESS, create({name.c_str()}));
    destroy_direct();
    setenv("HRT_MOCK_SCRIPT", (folder / "script.json").c_str(), 1);
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
    EXPECT_XR(XR_ERROR_EXTENSION_NOT_PRESENT, create({name.c_str()})) << name;
    unsetenv("HRT_MOCK_SCRIPT");
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  }
}

}  // namespace
}  // namespace hrt::mock
