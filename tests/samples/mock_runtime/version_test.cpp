// An application for OpenXR 1.1. The comment above each test quotes the tested sentence of the
// specification 1.1.
#include <algorithm>

#include "tests/samples/mock_runtime/negotiation.h"

namespace hrt::mock {
namespace {

class MockVersion : public MockNegotiation {
 protected:
  void create(XrVersion version) {
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
    ASSERT_XR(XR_SUCCESS, create_direct({XR_MND_HEADLESS_EXTENSION_NAME}, version));
    create_session();
  }
  void TearDown() override {
    destroy_direct();
    MockNegotiation::TearDown();
  }

  XrResult suggest(const std::string& profile, const std::string& source) {
    if (any == XR_NULL_HANDLE) any = make_action(make_set("set"), "any", XR_ACTION_TYPE_FLOAT_INPUT);
    return Application::suggest("/interaction_profiles/" + profile, {{any, path("/user/hand/" + source)}});
  }
  XrSpace space(XrReferenceSpaceType type, const XrVector3f& at = {}) {
    return create_space(type, {identity_pose.orientation, at});
  }

  static constexpr XrVersion version_1_1 = XR_MAKE_VERSION(1, 1, 41);
  XrAction any = XR_NULL_HANDLE;
};

// "LOCAL_FLOOR [...] establishes a world-locked origin [...] at the floor level": right below LOCAL.
TEST_F(MockVersion, LocalFloorIsBelowLocal) {
  create(version_1_1);
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
// time"; velocities are not known.
TEST_F(MockVersion, ManySpacesAreLocatedAtOnce) {
  create(version_1_1);
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
  EXPECT_EQ(velocity_data[1].velocityFlags, 0U);
  EXPECT_EQ(velocity_data[1].linearVelocity.x, 0.0F);
}

// "Interaction Profile Paths": sources that 1.1 adds, and sources that a profile has on one hand only or not at all.
TEST_F(MockVersion, PromotedProfilesHaveTheirSources) {
  create(version_1_1);
  for (const auto& [profile, source] :
       std::vector<std::pair<const char*, const char*>>{{"oculus/touch_controller", "left/input/trigger/proximity"},
                                                        {"valve/index_controller", "left/input/grip_surface/pose"},
                                                        {"bytedance/pico4_controller", "left/input/menu/click"},
                                                        {"bytedance/pico_g3_controller", "right/input/thumbstick"},
                                                        {"meta/touch_pro_controller", "right/output/haptic_thumb"}})
    EXPECT_XR(XR_SUCCESS, suggest(profile, source)) << profile << ' ' << source;
  for (const auto& [profile, source] : std::vector<std::pair<const char*, const char*>>{
           {"oculus/touch_controller", "right/input/x/click"},
           {"bytedance/pico4_controller", "right/input/menu/click"},
           {"bytedance/pico_g3_controller", "left/output/haptic"},
           {"meta/touch_controller_quest_1_rift_s", "left/input/thumbrest/touch"}})
    EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest(profile, source)) << profile << ' ' << source;
}

// Functions and profiles of OpenXR 1.1 are not available to an application for 1.0.
TEST_F(MockVersion, FunctionsAndProfilesAreThoseOfTheVersion) {
  create(XR_MAKE_VERSION(1, 0, 99));
  PFN_xrVoidFunction locate_spaces = nullptr;
  EXPECT_XR(XR_ERROR_FUNCTION_UNSUPPORTED, request.get_instance_proc_addr(instance, "xrLocateSpaces", &locate_spaces));
  EXPECT_XR(XR_SUCCESS, suggest("oculus/touch_controller", "right/input/thumbrest/touch"));
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest("oculus/touch_controller", "left/input/trigger/proximity"));
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest("hp/mixed_reality_controller", "left/input/x/click"));
}

}  // namespace
}  // namespace hrt::mock
