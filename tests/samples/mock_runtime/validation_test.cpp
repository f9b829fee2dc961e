// Debian's core validation layer finds nothing wrong with the runtime, nor with an application without
// mistakes.
#include <cstdio>
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
    for (const char* name :
         {"XR_ENABLE_API_LAYERS", "XR_CORE_VALIDATION_EXPORT_TYPE", "XR_CORE_VALIDATION_FILE_NAME"})
      unsetenv(name);
  }

  std::string messages() const { return validation_findings(folder / "report.txt"); }

  void use_actions() {
    XrActionSetCreateInfo set_info{XR_TYPE_ACTION_SET_CREATE_INFO};
    std::snprintf(set_info.actionSetName, sizeof(set_info.actionSetName), "set");
    std::snprintf(set_info.localizedActionSetName, sizeof(set_info.localizedActionSetName), "Set");
    XrActionSet set = XR_NULL_HANDLE;
    ASSERT_XR(XR_SUCCESS, xrCreateActionSet(instance, &set_info, &set));
    XrPath left = path("/user/hand/left");
    XrActionCreateInfo action_info{XR_TYPE_ACTION_CREATE_INFO};
    std::snprintf(action_info.actionName, sizeof(action_info.actionName), "grip");
    std::snprintf(action_info.localizedActionName, sizeof(action_info.localizedActionName), "Grip");
    action_info.actionType = XR_ACTION_TYPE_POSE_INPUT;
    action_info.countSubactionPaths = 1;
    action_info.subactionPaths = &left;
    XrAction grip = XR_NULL_HANDLE;
    ASSERT_XR(XR_SUCCESS, xrCreateAction(set, &action_info, &grip));
    const XrActionSuggestedBinding binding{grip, path("/user/hand/left/input/grip/pose")};
    const XrPath profile = path("/interaction_profiles/khr/simple_controller");
    const XrInteractionProfileSuggestedBinding suggested{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING,
                                                         nullptr, profile, 1, &binding};
    ASSERT_XR(XR_SUCCESS, xrSuggestInteractionProfileBindings(instance, &suggested));
    const XrSessionActionSetsAttachInfo attach{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, nullptr, 1, &set};
    ASSERT_XR(XR_SUCCESS, xrAttachSessionActionSets(session, &attach));
    ASSERT_XR(XR_SUCCESS, functions->set_device_active(session, profile, left, XR_TRUE));
    const XrActiveActionSet active{set, XR_NULL_PATH};
    const XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 1, &active};
    ASSERT_XR(XR_SUCCESS, xrSyncActions(session, &sync));
    XrActionStateGetInfo get{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, grip, left};
    XrActionStatePose state{XR_TYPE_ACTION_STATE_POSE};
    ASSERT_XR(XR_SUCCESS, xrGetActionStatePose(session, &get, &state));
    EXPECT_TRUE(state.isActive);
    const XrActionSpaceCreateInfo space_info{XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, grip, left,
                                             identity_pose};
    XrSpace space = XR_NULL_HANDLE;
    ASSERT_XR(XR_SUCCESS, xrCreateActionSpace(session, &space_info, &space));
  }

  TemporaryFolder folder;
};

TEST_F(MockValidation, LayerHasNothingToSayAboutAWholeSession) {
  begin_session();
  const XrSpace local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  const XrHandTrackerEXT tracker = create_hand_tracker();
  const XrPlatePlacementHRTX placement{XR_TYPE_PLATE_PLACEMENT_HRTX, nullptr, local, identity_pose, 0.075};
  ASSERT_XR(XR_SUCCESS, functions->place_plate(session, &placement));
  const XrReachInstructionHRTX instruction{
      XR_TYPE_REACH_INSTRUCTION_HRTX, nullptr, XR_HAND_RIGHT_EXT, {}, 5.0, 0.1};
  ASSERT_XR(XR_SUCCESS, functions->instruct_reach(session, &instruction));
  use_actions();
  for (int i = 0; i < 300; ++i) {
    EXPECT_TRUE(locate_hand(tracker, local, frame()).active);
    ASSERT_XR(XR_SUCCESS, functions->set_plate_orientation(session, 10.0));
    all_states();
  }
  XrReachTruthHRTX truth{XR_TYPE_REACH_TRUTH_HRTX};
  ASSERT_XR(XR_SUCCESS, functions->get_reach_truth(session, XR_HAND_RIGHT_EXT, &truth));
  EXPECT_TRUE(truth.isDone);
  ASSERT_XR(XR_SUCCESS, xrRequestExitSession(session));
  ASSERT_XR(XR_SUCCESS, xrEndSession(session));
  all_states();
  ASSERT_XR(XR_SUCCESS, functions->destroy_hand_tracker(tracker));
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
