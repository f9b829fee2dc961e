// Actions, bindings and XR_EXT_conformance_automation. Above each test stands the sentence that it tests,
// from the OpenXR specification 1.0.

#include "tests/samples/mock_runtime/support.h"

namespace hrt::mock {
namespace {

class MockActions : public MockRuntime {
 protected:
  void SetUp() override {
    MockRuntime::SetUp();
    create_session();
    set = make_set("set");
    left = path("/user/hand/left");
    right = path("/user/hand/right");
  }

  // In focus, with these bindings.
  void bind(const char* profile, const std::vector<XrActionSuggestedBinding>& bindings) {
    ASSERT_XR(XR_SUCCESS, suggest(profile, bindings));
    ASSERT_XR(XR_SUCCESS, attach({set}));
    focus();
  }

  static constexpr const char* simple = "/interaction_profiles/khr/simple_controller";
  static constexpr const char* touch = "/interaction_profiles/oculus/touch_controller";
  XrActionSet set = XR_NULL_HANDLE;
  XrPath left = XR_NULL_PATH;
  XrPath right = XR_NULL_PATH;
};

// "The action state [...] is inactive [...] if [the] action set [is not] active, or the session is not
// focused": XR_SESSION_NOT_FOCUSED; the values are those of the last xrSyncActions; changedSinceLastSync and
// lastChangeTime.
TEST_F(MockActions, StatesAreThoseOfTheLastSyncInFocus) {
  const XrAction select = make_action(set, "select", XR_ACTION_TYPE_BOOLEAN_INPUT, {left, right});
  const XrPath click = path("/user/hand/left/input/select/click");
  ASSERT_XR(XR_SUCCESS, suggest(simple, {{select, click}}));
  ASSERT_XR(XR_SUCCESS, attach({set}));
  ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceActiveEXT)(session, path(simple), left, XR_TRUE));
  ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceStateBoolEXT)(session, left, click, XR_TRUE));
  EXPECT_XR(XR_SESSION_NOT_FOCUSED, sync({{set, XR_NULL_PATH}}));
  EXPECT_FALSE(boolean(select).isActive);
  focus();
  EXPECT_FALSE(boolean(select).isActive);
  ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
  EXPECT_TRUE(boolean(select).isActive);
  EXPECT_TRUE(boolean(select).currentState);
  EXPECT_TRUE(boolean(select, left).isActive);
  EXPECT_FALSE(boolean(select, right).isActive);
  ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceStateBoolEXT)(session, left, click, XR_FALSE));
  EXPECT_TRUE(boolean(select).currentState);
  ASSERT_XR(XR_SUCCESS, XR(xrAdvanceTimeHRTX)(instance, 1'000));
  ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
  const XrActionStateBoolean released = boolean(select);
  EXPECT_FALSE(released.currentState);
  EXPECT_TRUE(released.changedSinceLastSync);
  EXPECT_GT(released.lastChangeTime, 0);
  ASSERT_XR(XR_SUCCESS, XR(xrAdvanceTimeHRTX)(instance, 1'000));
  ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
  EXPECT_FALSE(boolean(select).changedSinceLastSync);
  EXPECT_EQ(boolean(select).lastChangeTime, released.lastChangeTime);
  ASSERT_XR(XR_SUCCESS, sync({}));
  EXPECT_FALSE(boolean(select).isActive);
}

// "Boolean [...] OR, float [...] the largest absolute value, vector [...] the longest"; a float source drives
// a boolean action by a threshold, a boolean source a float action as 0 or 1, x and y a vector.
TEST_F(MockActions, SourcesAreConvertedAndCombined) {
  const XrAction press = make_action(set, "press", XR_ACTION_TYPE_BOOLEAN_INPUT);
  const XrAction pull = make_action(set, "pull", XR_ACTION_TYPE_FLOAT_INPUT);
  const XrAction steer = make_action(set, "steer", XR_ACTION_TYPE_VECTOR2F_INPUT);
  const XrPath left_trigger = path("/user/hand/left/input/trigger/value");
  const XrPath right_trigger = path("/user/hand/right/input/trigger/value");
  const XrPath stick = path("/user/hand/left/input/thumbstick");
  bind(touch, {{press, path("/user/hand/left/input/trigger")},
               {press, path("/user/hand/right/input/a/click")},
               {pull, left_trigger},
               {pull, right_trigger},
               {steer, stick}});
  for (const XrPath user : {left, right})
    ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceActiveEXT)(session, path(touch), user, XR_TRUE));
  ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceStateFloatEXT)(session, left, left_trigger, 0.3F));
  ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceStateFloatEXT)(session, right, right_trigger, 0.4F));
  ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceStateVector2fEXT)(session, left, stick, {-0.5F, 0.25F}));
  ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
  EXPECT_FALSE(boolean(press).currentState);
  EXPECT_EQ(scalar(pull).currentState, 0.4F);
  const auto vector =
      output(xrGetActionStateVector2f, session, {XR_TYPE_ACTION_STATE_GET_INFO, nullptr, steer, XR_NULL_PATH});
  EXPECT_EQ(vector.currentState.x, -0.5F);
  EXPECT_EQ(vector.currentState.y, 0.25F);
  ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceStateFloatEXT)(session, left, left_trigger, 0.9F));
  ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
  EXPECT_TRUE(boolean(press).currentState);
  EXPECT_EQ(scalar(pull).currentState, 0.9F);
}

// "If multiple action sets [bind] the same input [...], the action set with the higher priority [is used and
// the others] must act as if they were inactive".
TEST_F(MockActions, HigherPriorityTakesASourceFromLower) {
  const XrActionSet above = make_set("above", 5);
  const XrAction low = make_action(set, "low", XR_ACTION_TYPE_BOOLEAN_INPUT);
  const XrAction high = make_action(above, "high", XR_ACTION_TYPE_BOOLEAN_INPUT);
  const XrPath click = path("/user/hand/left/input/select/click");
  ASSERT_XR(XR_SUCCESS, suggest(simple, {{low, click}, {high, click}}));
  ASSERT_XR(XR_SUCCESS, attach({set, above}));
  focus();
  ASSERT_XR(XR_SUCCESS, XR(xrSetInputDeviceActiveEXT)(session, path(simple), left, XR_TRUE));
  ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}, {above, XR_NULL_PATH}}));
  EXPECT_TRUE(boolean(high).isActive);
  EXPECT_FALSE(boolean(low).isActive);
  ASSERT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
  EXPECT_FALSE(boolean(high).isActive);
  EXPECT_TRUE(boolean(low).isActive);
}

// "Action spaces" without a subaction path: "pick one" device "and stick with it", and outlive their action.
TEST_F(MockActions, PoseOfAnyHandIsThatOfTheFirst) {
  const XrAction grip = make_action(set, "grip", XR_ACTION_TYPE_POSE_INPUT, {left, right});
  bind(simple, {{grip, path("/user/hand/left/input/grip/pose")}, {grip, path("/user/hand/right/input/grip/pose")}});
  local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
  const XrSpace space = create_action_space(grip, XR_NULL_PATH);
  const auto flags = [&](XrBool32 has_left, XrBool32 has_right) {
    EXPECT_XR(XR_SUCCESS, XR(xrSetInputDeviceActiveEXT)(session, path(simple), left, has_left));
    EXPECT_XR(XR_SUCCESS, XR(xrSetInputDeviceActiveEXT)(session, path(simple), right, has_right));
    EXPECT_XR(XR_SUCCESS, sync({{set, XR_NULL_PATH}}));
    return located(space, local, 1).locationFlags;
  };
  EXPECT_EQ(flags(XR_TRUE, XR_FALSE), 15U);
  EXPECT_EQ(flags(XR_FALSE, XR_TRUE), 0U);
  EXPECT_EQ(flags(XR_TRUE, XR_TRUE), 15U);
  EXPECT_XR(XR_SUCCESS, xrDestroyAction(grip));
  EXPECT_EQ(flags(XR_TRUE, XR_TRUE), 15U);
  EXPECT_EQ(flags(XR_FALSE, XR_TRUE), 0U);
}

}  // namespace
}  // namespace hrt::mock
