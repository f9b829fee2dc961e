// Debian's core validation layer finds nothing wrong with the runtime, nor with an application without
// mistakes.
#include <cstdlib>

#include "tests/samples/mock_runtime/support.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

class MockValidation : public MockRuntime {
 protected:
  void SetUp() override {
    setenv("XR_ENABLE_API_LAYERS", "XR_APILAYER_LUNARG_core_validation", 1);
    setenv("XR_CORE_VALIDATION_EXPORT_TYPE", "text", 1);
    setenv("XR_CORE_VALIDATION_FILE_NAME", (folder / "report.txt").c_str(), 1);
    MockRuntime::SetUp();
  }
  void TearDown() override {
    MockRuntime::TearDown();
    for (const char* name : {"XR_ENABLE_API_LAYERS", "XR_CORE_VALIDATION_EXPORT_TYPE", "XR_CORE_VALIDATION_FILE_NAME"})
      unsetenv(name);
  }

  std::string messages() const { return validation_findings(folder / "report.txt"); }

  void use_actions() {
    const char* const profile = "/interaction_profiles/khr/simple_controller";
    const XrActionSet set = make_set("set");
    const XrPath left = path("/user/hand/left");
    const XrAction grip = make_action(set, "grip", XR_ACTION_TYPE_POSE_INPUT, {left});
    ASSERT_XR(XR_SUCCESS, suggest(profile, {{grip, path("/user/hand/left/input/grip/pose")}}));
    ASSERT_XR(XR_SUCCESS, attach({set}));
    ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceActiveEXT)(session, path(profile), left, XR_TRUE));
    ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
    EXPECT_TRUE(output(xrGetActionStatePose, session, {XR_TYPE_ACTION_STATE_GET_INFO, nullptr, grip, left}).isActive);
    create_action_space(grip, left);
  }

  TemporaryFolder folder;
};

TEST_F(MockValidation, LayerHasNothingToSayAboutAWholeSession) {
  begin_with("{}");
  place_plate(local);
  instruct();
  use_actions();
  for (int i = 0; i < 300; ++i) {
    EXPECT_TRUE(locate_hand(hand, local, frame()).active);
    ASSERT_XR(XR_SUCCESS, XR(xrSetPlateOrientationHRTX)(session, 10.0));
    all_states();
  }
  EXPECT_TRUE(truth().isDone);
  ASSERT_XR(XR_SUCCESS, xrRequestExitSession(session));
  ASSERT_XR(XR_SUCCESS, xrEndSession(session));
  all_states();
  ASSERT_XR(XR_SUCCESS, XR(xrDestroyHandTrackerEXT)(hand));
  ASSERT_XR(XR_SUCCESS, xrDestroySpace(local));
  ASSERT_XR(XR_SUCCESS, xrDestroySession(session));
  EXPECT_EQ(messages(), "");
  // That the layer is there at all, a mistake shows.
  XrEventDataBuffer wrong{XR_TYPE_FRAME_STATE};
  EXPECT_XR(XR_ERROR_VALIDATION_FAILURE, xrPollEvent(instance, &wrong));
  EXPECT_NE(messages(), "");
}

}  // namespace
}  // namespace hrt::mock
