// Error codes of the functions, called without a loader, which would check some arguments itself.
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "samples/mock_runtime/functions.h"
#include "tests/samples/mock_runtime/support.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

constexpr auto stereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
constexpr auto unknown_view = static_cast<XrViewConfigurationType>(12345);
constexpr auto unknown_space = static_cast<XrReferenceSpaceType>(12345);

template <typename T>
concept has_size = requires { sizeof(T); };
template <typename T>
constexpr bool is_handle = std::is_pointer_v<T> && !has_size<std::remove_pointer_t<T>>;

#define EXPECT_ERROR(code, name, ...) EXPECT_XR(XR_ERROR_##code, XR(name)(__VA_ARGS__))
// For functions that take an object and an info structure and write one output.
#define EXPECT_INFO_ERROR(code, name, object, ...) EXPECT_XR(XR_ERROR_##code, result_of(XR(name), object, __VA_ARGS__))

class MockErrors : public MockNegotiation {
 protected:
  // XR_KHR_convert_timespec_time exists with the real-time clock only; frames of 1 ms keep the tests short.
  static constexpr const char* settings = R"("clock": "real-time", "frame_rate_hz": 1000)";

  void SetUp() override {
    MockNegotiation::SetUp();
    setenv("HRT_MOCK_SCRIPT", (folder / "script.json").c_str(), 1);
    start("");
  }
  void TearDown() override {
    EXPECT_XR(XR_SUCCESS, XR(xrDestroyInstance)(instance));
    unsetenv("HRT_MOCK_SCRIPT");
    MockNegotiation::TearDown();
  }

  // Creates an instance with a script that has `settings` and `keys`.
  void start(const std::string& keys) {
    if (instance != XR_NULL_HANDLE) {
      EXPECT_XR(XR_SUCCESS, XR(xrDestroyInstance)(instance));
    }
    std::ofstream(folder / "script.json") << '{' << settings << keys << '}';
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
    create_instance({"XR_MND_headless", "XR_EXT_hand_tracking", "XR_KHR_convert_timespec_time", "XR_KHR_vulkan_enable2",
                     "XR_HRTX_ridged_plate"});
  }
  void create_instance(const std::vector<const char*>& extensions) {
    const XrInstanceCreateInfo info = instance_info(extensions);
    ASSERT_XR(XR_SUCCESS, function_of<PFN_xrCreateInstance>(XR_NULL_HANDLE, "xrCreateInstance")(&info, &instance));
  }
  // Creates a session, and a handle of each type except XrSwapchain.
  void create_session(const std::string& keys = "") {
    start(keys);
    Application::create_session();
    local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
    hand = create_hand_tracker();
    set = output(XR(xrCreateActionSet), instance, {XR_TYPE_ACTION_SET_CREATE_INFO, nullptr, "set", "Set", 0});
    ASSERT_XR(XR_SUCCESS, make_action("button", XR_ACTION_TYPE_BOOLEAN_INPUT, &action));
  }
  void begin_frame() {
    XrFrameState frame{XR_TYPE_FRAME_STATE};
    EXPECT_XR(XR_SUCCESS, XR(xrWaitFrame)(session, nullptr, &frame));
    EXPECT_GE(XR(xrBeginFrame)(session, nullptr), XR_SUCCESS);
  }
  XrResult make_action(const char* name, XrActionType type, XrAction* made) {
    XrActionCreateInfo info{XR_TYPE_ACTION_CREATE_INFO};
    for (char* text : {info.actionName, info.localizedActionName})
      std::snprintf(text, XR_MAX_ACTION_NAME_SIZE, "%s", name);
    info.actionType = type;
    return XR(xrCreateAction)(set, &info, made);
  }

  template <typename Call>
  void for_each_function(Call call) {
#define HRT_CALL(extension, name) call(std::string(#name), XR(name));
    HRT_MOCK_FUNCTIONS(HRT_CALL)
#undef HRT_CALL
  }
  // Calls a function with invalid handles, and with a valid one unless it destroys objects; other arguments are zero.
  template <typename First, typename... Rest>
  void call_zeros(const std::string& name, XrResult (*function)(First, Rest...)) {
    if constexpr (is_handle<First>) {
      if (name == "xrGetInstanceProcAddr") return;
      for (const std::uintptr_t invalid : {std::uintptr_t{0}, std::uintptr_t{1}, std::uintptr_t{0x77},
                                           ~std::uintptr_t{0}, reinterpret_cast<std::uintptr_t>(instance) + 1000})
        EXPECT_XR(XR_ERROR_HANDLE_INVALID, function(reinterpret_cast<First>(invalid), Rest{}...)) << name << invalid;
    }
    if (name.starts_with("xrDestroy")) return;
    const XrResult result = function(handle(First{}), Rest{}...);
    if constexpr (std::is_same_v<First, XrInstance>) {
      EXPECT_LT(result, XR_SUCCESS) << name << " succeeds without its outputs";
    }
  }
  template <typename First, typename... Rest>
  void call_lost(const std::string& name, XrResult (*function)(First, Rest...), XrResult loss) {
    constexpr bool is_of_session =
        std::is_same_v<First, XrSession> || std::is_same_v<First, XrSpace> || std::is_same_v<First, XrHandTrackerEXT>;
    if constexpr (is_handle<First>) {
      const bool accepts_lost =
          name.starts_with("xrDestroy") || name == "xrGetInstanceProcAddr" || handle(First{}) == XR_NULL_HANDLE;
      if (accepts_lost || (loss == XR_ERROR_SESSION_LOST && !is_of_session)) return;
      EXPECT_XR(loss, function(handle(First{}), Rest{}...)) << name;
    }
  }
  XrInstance handle(XrInstance) const { return instance; }
  XrSession handle(XrSession) const { return session; }
  XrSpace handle(XrSpace) const { return local; }
  XrActionSet handle(XrActionSet) const { return set; }
  XrAction handle(XrAction) const { return action; }
  XrHandTrackerEXT handle(XrHandTrackerEXT) const { return hand; }
  template <typename Other>
  Other handle(Other zero) const {
    return zero;
  }

  TemporaryFolder folder;
  XrActionSet set = XR_NULL_HANDLE;
  XrAction action = XR_NULL_HANDLE;
};

TEST_F(MockErrors, InstanceFunctions) {
  std::uint32_t count = 0;
  XrExtensionProperties extension{XR_TYPE_EXTENSION_PROPERTIES};
  EXPECT_ERROR(SIZE_INSUFFICIENT, xrEnumerateInstanceExtensionProperties, nullptr, 1, &count, &extension);
  EXPECT_ERROR(API_LAYER_NOT_PRESENT, xrEnumerateInstanceExtensionProperties, "layer", 0, &count, nullptr);
  PFN_xrVoidFunction function = nullptr;
  EXPECT_ERROR(FUNCTION_UNSUPPORTED, xrGetInstanceProcAddr, instance, "xrDance", &function);
  EXPECT_ERROR(HANDLE_INVALID, xrGetInstanceProcAddr, XR_NULL_HANDLE, "xrPollEvent", &function);
  const auto create = [&, create_instance = XR(xrCreateInstance)](XrVersion version, const char* application,
                                                                  const std::vector<const char*>& extensions = {}) {
    XrInstanceCreateInfo info = instance_info(extensions);
    info.applicationInfo.apiVersion = version;
    std::snprintf(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE, "%s", application);
    XrInstance second = XR_NULL_HANDLE;
    return create_instance(&info, &second);
  };
  EXPECT_XR(XR_ERROR_LIMIT_REACHED, create(XR_MAKE_VERSION(1, 0, 0), "second"));
  EXPECT_XR(XR_ERROR_API_VERSION_UNSUPPORTED, create(XR_MAKE_VERSION(1, 1, 0), "newer"));
  EXPECT_XR(XR_ERROR_API_VERSION_UNSUPPORTED, create(XR_MAKE_VERSION(2, 0, 0), "newer"));
  EXPECT_XR(XR_ERROR_NAME_INVALID, create(XR_MAKE_VERSION(1, 0, 0), ""));
  ASSERT_XR(XR_SUCCESS, XR(xrDestroyInstance)(instance));
  EXPECT_XR(XR_ERROR_EXTENSION_NOT_PRESENT, create(XR_MAKE_VERSION(1, 0, 0), "unknown extension", {"XR_EXT_dance"}));
  create_instance({});
}

TEST_F(MockErrors, SystemFunctions) {
  std::uint32_t count = 0;
  const XrSystemId unknown = 99;
  EXPECT_INFO_ERROR(FORM_FACTOR_UNSUPPORTED, xrGetSystem, instance,
                    {XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HANDHELD_DISPLAY});
  XrSystemProperties properties{XR_TYPE_SYSTEM_PROPERTIES};
  EXPECT_ERROR(SYSTEM_INVALID, xrGetSystemProperties, instance, unknown, &properties);
  EXPECT_ERROR(SYSTEM_INVALID, xrEnumerateViewConfigurations, instance, unknown, 0, &count, nullptr);
  XrViewConfigurationProperties view{XR_TYPE_VIEW_CONFIGURATION_PROPERTIES};
  for (const auto& [id, type, expected] :
       {std::tuple{unknown, stereo, XR_ERROR_SYSTEM_INVALID},
        {XrSystemId{1}, unknown_view, XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED}}) {
    EXPECT_XR(expected, XR(xrEnumerateEnvironmentBlendModes)(instance, id, type, 0, &count, nullptr));
    EXPECT_XR(expected, XR(xrGetViewConfigurationProperties)(instance, id, type, &view));
    EXPECT_XR(expected, XR(xrEnumerateViewConfigurationViews)(instance, id, type, 0, &count, nullptr));
  }
  XrViewConfigurationView one{XR_TYPE_VIEW_CONFIGURATION_VIEW};
  EXPECT_ERROR(SIZE_INSUFFICIENT, xrEnumerateViewConfigurationViews, instance, 1, stereo, 1, &count, &one);
  EXPECT_ERROR(VALIDATION_FAILURE, xrEnumerateViewConfigurationViews, instance, 1, stereo, 0, nullptr, nullptr);
  EXPECT_INFO_ERROR(SYSTEM_INVALID, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, unknown});
  XrGraphicsRequirementsVulkanKHR vulkan{XR_TYPE_GRAPHICS_REQUIREMENTS_VULKAN_KHR};
  EXPECT_ERROR(SYSTEM_INVALID, xrGetVulkanGraphicsRequirements2KHR, instance, unknown, &vulkan);
  VkPhysicalDevice device = nullptr;
  const XrVulkanGraphicsDeviceGetInfoKHR no_instance{XR_TYPE_VULKAN_GRAPHICS_DEVICE_GET_INFO_KHR, nullptr, 1, nullptr};
  EXPECT_ERROR(VALIDATION_FAILURE, xrGetVulkanGraphicsDevice2KHR, instance, &no_instance, &device);
}

TEST_F(MockErrors, TimesAndPaths) {
  std::uint32_t count = 0;
  const timespec negative{-1, 0};
  timespec converted{};
  XrTime time = 0;
  EXPECT_ERROR(TIME_INVALID, xrConvertTimespecTimeToTimeKHR, instance, &negative, &time);
  EXPECT_ERROR(TIME_INVALID, xrConvertTimeToTimespecTimeKHR, instance, 0, &converted);
  XrPath made = XR_NULL_PATH;
  for (const char* text : {"", "/", "a", "/a/", "/a//b", "/a/.", "/a/../b", "/A", "/a b", "/a\xc3\xa4"})
    EXPECT_ERROR(PATH_FORMAT_INVALID, xrStringToPath, instance, text, &made);
  const std::string longest = "/" + std::string(XR_MAX_PATH_LENGTH - 2, 'a');
  EXPECT_XR(XR_SUCCESS, XR(xrStringToPath)(instance, longest.c_str(), &made));
  EXPECT_ERROR(PATH_FORMAT_INVALID, xrStringToPath, instance, (longest + "a").c_str(), &made);
  char text[4];
  EXPECT_ERROR(PATH_INVALID, xrPathToString, instance, 12345, 0, &count, nullptr);
  EXPECT_ERROR(SIZE_INSUFFICIENT, xrPathToString, instance, made, 4, &count, text);
}

TEST_F(MockErrors, SpacesAndViews) {
  create_session();
  std::uint32_t count = 0;
  EXPECT_INFO_ERROR(LIMIT_REACHED, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, 1});
  const XrSessionBeginInfo begin{XR_TYPE_SESSION_BEGIN_INFO, nullptr, unknown_view};
  EXPECT_ERROR(VIEW_CONFIGURATION_TYPE_UNSUPPORTED, xrBeginSession, session, &begin);
  XrReferenceSpaceType type{};
  EXPECT_ERROR(SIZE_INSUFFICIENT, xrEnumerateReferenceSpaces, session, 1, &count, &type);
  XrReferenceSpaceCreateInfo create{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, XR_REFERENCE_SPACE_TYPE_LOCAL, {}};
  for (const XrPosef& pose : {XrPosef{}, XrPosef{{0.0F, 0.0F, 0.0F, 1.02F}, {}}, XrPosef{{NAN, 0.0F, 0.0F, 1.0F}, {}},
                              XrPosef{identity_pose.orientation, {INFINITY, 0.0F, 0.0F}}}) {
    create.poseInReferenceSpace = pose;
    EXPECT_INFO_ERROR(POSE_INVALID, xrCreateReferenceSpace, session, create);
  }
  create.referenceSpaceType = unknown_space;
  EXPECT_INFO_ERROR(REFERENCE_SPACE_UNSUPPORTED, xrCreateReferenceSpace, session, create);
  XrExtent2Df extent{};
  EXPECT_ERROR(REFERENCE_SPACE_UNSUPPORTED, xrGetReferenceSpaceBoundsRect, session, unknown_space, &extent);
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
  for (const XrTime time : {0, -1}) EXPECT_ERROR(TIME_INVALID, xrLocateSpace, local, local, time, &location);
  XrViewState state{XR_TYPE_VIEW_STATE};
  XrView view{XR_TYPE_VIEW};
  XrViewLocateInfo locate{XR_TYPE_VIEW_LOCATE_INFO, nullptr, unknown_view, 1, local};
  EXPECT_ERROR(VIEW_CONFIGURATION_TYPE_UNSUPPORTED, xrLocateViews, session, &locate, &state, 0, &count, nullptr);
  locate.viewConfigurationType = stereo;
  EXPECT_ERROR(SIZE_INSUFFICIENT, xrLocateViews, session, &locate, &state, 1, &count, &view);
  locate.displayTime = 0;
  EXPECT_ERROR(TIME_INVALID, xrLocateViews, session, &locate, &state, 0, &count, nullptr);
  EXPECT_INFO_ERROR(SWAPCHAIN_FORMAT_UNSUPPORTED, xrCreateSwapchain, session, {XR_TYPE_SWAPCHAIN_CREATE_INFO});
}

// "The application must input jointCount as described by the XrHandJointSetEXT". A call that fails writes nothing.
TEST_F(MockErrors, HandJoints) {
  create_session();
  std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT + 1> joints{};
  XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, nullptr, 7, XR_HAND_JOINT_COUNT_EXT,
                                    joints.data()};
  XrHandJointsLocateInfoEXT info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, local, 0};
  EXPECT_ERROR(TIME_INVALID, xrLocateHandJointsEXT, hand, &info, &locations);
  info.time = 1;
  for (const std::uint32_t count : {0U, 25U, 27U}) {
    locations.jointCount = count;
    EXPECT_ERROR(VALIDATION_FAILURE, xrLocateHandJointsEXT, hand, &info, &locations);
  }
  locations.jointCount = XR_HAND_JOINT_COUNT_EXT;
  XrHandJointVelocitiesEXT velocities{XR_TYPE_HAND_JOINT_VELOCITIES_EXT, nullptr, 25, nullptr};
  locations.next = &velocities;
  EXPECT_ERROR(VALIDATION_FAILURE, xrLocateHandJointsEXT, hand, &info, &locations);
  EXPECT_EQ(locations.isActive, 7U);
  EXPECT_EQ(joints[0].locationFlags, 0U);
}

TEST_F(MockErrors, SessionStatesAndFrames) {
  create_session();
  XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO, nullptr, 1, XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 0, nullptr};
  EXPECT_ERROR(SESSION_NOT_RUNNING, xrEndFrame, session, &end);
  focus();
  const XrSessionBeginInfo begin{XR_TYPE_SESSION_BEGIN_INFO, nullptr, stereo};
  EXPECT_ERROR(SESSION_RUNNING, xrBeginSession, session, &begin);
  EXPECT_ERROR(SESSION_NOT_STOPPING, xrEndSession, session);
  EXPECT_ERROR(CALL_ORDER_INVALID, xrBeginFrame, session, nullptr);
  EXPECT_ERROR(CALL_ORDER_INVALID, xrEndFrame, session, &end);
  const XrFrameBeginInfo wrong_type{XR_TYPE_FRAME_END_INFO};
  EXPECT_ERROR(VALIDATION_FAILURE, xrBeginFrame, session, &wrong_type);
  begin_frame();
  XrFrameState frame{XR_TYPE_FRAME_STATE};
  EXPECT_XR(XR_SUCCESS, XR(xrWaitFrame)(session, nullptr, &frame));
  EXPECT_XR(XR_FRAME_DISCARDED, XR(xrBeginFrame)(session, nullptr));
  end.displayTime = 0;
  EXPECT_ERROR(TIME_INVALID, xrEndFrame, session, &end);
  end.displayTime = 1;
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_ADDITIVE;
  EXPECT_ERROR(ENVIRONMENT_BLEND_MODE_UNSUPPORTED, xrEndFrame, session, &end);
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  EXPECT_XR(XR_SUCCESS, XR(xrEndFrame)(session, &end)) << "the failed calls must not end the frame";
  EXPECT_XR(XR_SUCCESS, XR(xrRequestExitSession)(session));
  EXPECT_XR(XR_SUCCESS, XR(xrEndSession)(session));
  EXPECT_ERROR(SESSION_NOT_READY, xrBeginSession, session, &begin);  // the state is EXITING
}

TEST_F(MockErrors, LayersOfAHeadlessSession) {
  create_session();
  focus();
  begin_frame();
  XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO, nullptr, 1, XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 1, nullptr};
  EXPECT_ERROR(LAYER_INVALID, xrEndFrame, session, &end);
  XrCompositionLayerProjection layer{XR_TYPE_FRAME_STATE};
  std::array<const XrCompositionLayerBaseHeader*, XR_MIN_COMPOSITION_LAYERS_SUPPORTED + 1> layers{};
  end.layers = layers.data();
  EXPECT_ERROR(LAYER_INVALID, xrEndFrame, session, &end);
  layers.fill(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer));
  EXPECT_ERROR(LAYER_INVALID, xrEndFrame, session, &end);
  layer.type = XR_TYPE_COMPOSITION_LAYER_PROJECTION;
  EXPECT_ERROR(HANDLE_INVALID, xrEndFrame, session, &end);
  layer.space = local;
  end.layerCount = layers.size();
  EXPECT_ERROR(LAYER_LIMIT_EXCEEDED, xrEndFrame, session, &end);
  --end.layerCount;
  EXPECT_XR(XR_SUCCESS, XR(xrEndFrame)(session, &end));
}

TEST_F(MockErrors, PlateFunctions) {
  create_session();
  XrPlatePlacementHRTX placement{XR_TYPE_PLATE_PLACEMENT_HRTX, nullptr, local, {}, 0.075};
  XrReachInstructionHRTX instruction{XR_TYPE_REACH_INSTRUCTION_HRTX, nullptr, XR_HAND_RIGHT_EXT, {}, 5.0, 0.1};
  EXPECT_ERROR(CALL_ORDER_INVALID, xrInstructReachHRTX, session, &instruction);
  XrReachTruthHRTX truth{XR_TYPE_REACH_TRUTH_HRTX};
  EXPECT_ERROR(CALL_ORDER_INVALID, xrGetReachTruthHRTX, session, XR_HAND_RIGHT_EXT, &truth);
  EXPECT_ERROR(POSE_INVALID, xrPlacePlateHRTX, session, &placement);
  placement.pose = identity_pose;
  EXPECT_XR(XR_SUCCESS, XR(xrPlacePlateHRTX)(session, &placement));
  double orientation = 0.0;
  EXPECT_ERROR(TIME_INVALID, xrGetPlateOrientationHRTX, session, 0, &orientation);
  for (const double invalid : {1e9, static_cast<double>(NAN)}) {
    EXPECT_ERROR(VALIDATION_FAILURE, xrSetPlateOrientationHRTX, session, invalid);
    placement.radius = invalid;
    EXPECT_ERROR(VALIDATION_FAILURE, xrPlacePlateHRTX, session, &placement);
    for (double* field : {&instruction.goalDirection, &instruction.pathLength}) {
      const double valid = std::exchange(*field, invalid);
      EXPECT_ERROR(VALIDATION_FAILURE, xrInstructReachHRTX, session, &instruction);
      *field = valid;
    }
  }
  instruction.start.x = 11.0F;
  EXPECT_ERROR(VALIDATION_FAILURE, xrInstructReachHRTX, session, &instruction);
}

class MockActions : public MockErrors {
 protected:
  void SetUp() override {
    MockErrors::SetUp();
    create_session();
    ASSERT_XR(XR_SUCCESS, make_action("pose", XR_ACTION_TYPE_POSE_INPUT, &pose));
  }
  XrResult suggest(XrPath profile, XrPath source) {
    const XrActionSuggestedBinding binding{action, source};
    const XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING, nullptr, profile, 1,
                                                    &binding};
    return XR(xrSuggestInteractionProfileBindings)(instance, &info);
  }
  XrResult attach() {
    const XrSessionActionSetsAttachInfo info{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, nullptr, 1, &set};
    return XR(xrAttachSessionActionSets)(session, &info);
  }
  XrResult sync() {
    const XrActiveActionSet active{set, XR_NULL_PATH};
    const XrActionsSyncInfo info{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 1, &active};
    return XR(xrSyncActions)(session, &info);
  }
  // Expects an error of every function that reads the state of an action, or starts or stops haptics.
  // XR_ERROR_ACTION_TYPE_MISMATCH is not expected of the function for the type of the action.
  void expect_error(XrAction of, XrResult error) {
    const auto expected = [&](XrAction of_function) {
      return of == of_function && error == XR_ERROR_ACTION_TYPE_MISMATCH ? XR_SUCCESS : error;
    };
    const XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, of, XR_NULL_PATH};
    EXPECT_XR(expected(action), result_of(XR(xrGetActionStateBoolean), session, info));
    EXPECT_XR(error, result_of(XR(xrGetActionStateFloat), session, info));
    EXPECT_XR(error, result_of(XR(xrGetActionStateVector2f), session, info));
    EXPECT_XR(expected(pose), result_of(XR(xrGetActionStatePose), session, info));
    const XrHapticActionInfo haptic{XR_TYPE_HAPTIC_ACTION_INFO, nullptr, of, XR_NULL_PATH};
    const XrHapticVibration vibration{XR_TYPE_HAPTIC_VIBRATION, nullptr, 1, 0.0F, 0.5F};
    EXPECT_XR(error,
              XR(xrApplyHapticFeedback)(session, &haptic, reinterpret_cast<const XrHapticBaseHeader*>(&vibration)));
    EXPECT_XR(error, XR(xrStopHapticFeedback)(session, &haptic));
  }

  XrAction pose = XR_NULL_HANDLE;
};

TEST_F(MockActions, TypesPathsAndTheOrderOfCallsAreChecked) {
  const XrPath profile = path("/interaction_profiles/khr/simple_controller"),
               select = path("/user/hand/left/input/select/click"), unknown = 12345;
  EXPECT_XR(XR_ERROR_VALIDATION_FAILURE, make_action("other", static_cast<XrActionType>(77), &pose));
  EXPECT_INFO_ERROR(ACTION_TYPE_MISMATCH, xrCreateActionSpace, session,
                    {XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, action, XR_NULL_PATH, identity_pose});
  EXPECT_INFO_ERROR(POSE_INVALID, xrCreateActionSpace, session,
                    {XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, pose, XR_NULL_PATH, {}});
  EXPECT_XR(XR_ERROR_PATH_INVALID, suggest(unknown, select));
  EXPECT_XR(XR_ERROR_PATH_INVALID, suggest(profile, unknown));
  EXPECT_XR(XR_SUCCESS, suggest(profile, select));

  EXPECT_XR(XR_ERROR_ACTIONSET_NOT_ATTACHED, sync());
  for (const XrAction of : {action, pose}) expect_error(of, XR_ERROR_ACTIONSET_NOT_ATTACHED);
  EXPECT_XR(XR_SUCCESS, attach());
  EXPECT_XR(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, attach());
  EXPECT_XR(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, make_action("late", XR_ACTION_TYPE_POSE_INPUT, &pose));
  EXPECT_XR(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, suggest(profile, select));
  for (const XrAction of : {action, pose}) expect_error(of, XR_ERROR_ACTION_TYPE_MISMATCH);
}

// "The action state [...] is inactive" without a device that is bound to it: there are no controllers.
TEST_F(MockActions, StatesAreInactiveAndSpacesAreNotLocated) {
  EXPECT_XR(XR_SUCCESS, attach());
  EXPECT_XR(XR_SESSION_NOT_FOCUSED, sync());
  focus();
  EXPECT_XR(XR_SUCCESS, sync());
  XrActionStateBoolean state{XR_TYPE_ACTION_STATE_BOOLEAN, nullptr, XR_TRUE, XR_TRUE, 5, XR_TRUE};
  const XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, action, XR_NULL_PATH};
  ASSERT_XR(XR_SUCCESS, XR(xrGetActionStateBoolean)(session, &info, &state));
  EXPECT_FALSE(state.isActive);
  EXPECT_FALSE(state.currentState);
  EXPECT_EQ(state.lastChangeTime, 0);
  XrInteractionProfileState current{XR_TYPE_INTERACTION_PROFILE_STATE, nullptr, 77};
  ASSERT_XR(XR_SUCCESS, XR(xrGetCurrentInteractionProfile)(session, path("/user/hand/left"), &current));
  EXPECT_EQ(current.interactionProfile, XrPath{XR_NULL_PATH});
  const XrSpace space = output(XR(xrCreateActionSpace), session,
                               {XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, pose, XR_NULL_PATH, identity_pose});
  EXPECT_XR(XR_SUCCESS, XR(xrDestroyAction)(pose));
  EXPECT_EQ(located(space, local, 1).locationFlags, 0U);
}

TEST_F(MockErrors, InvalidHandlesAndNullPointers) {
  create_session();
  for_each_function([&](const std::string& name, auto function) { call_zeros(name, function); });
}

// Functions of a lost session or instance return the loss, except xrGetInstanceProcAddr and those that destroy objects.
TEST_F(MockErrors, LostSessionsAndInstances) {
  for (const auto& [event, loss] :
       {std::pair{"lose_session", XR_ERROR_SESSION_LOST}, {"lose_instance", XR_ERROR_INSTANCE_LOST}}) {
    create_session(R"(, "events": [{"frame": 1, "do": ")" + std::string(event) + "\"}]");
    focus();
    XrFrameState frame{XR_TYPE_FRAME_STATE};
    XR(xrWaitFrame)(session, nullptr, &frame);
    for_each_function(
        [&, expected = loss](const std::string& name, auto function) { call_lost(name, function, expected); });
    EXPECT_XR(XR_SUCCESS, XR(xrDestroySession)(session));
    EXPECT_XR(XR_SUCCESS, XR(xrDestroyActionSet)(set));
  }
}

TEST_F(MockErrors, SystemWithoutHandTrackingOrGraphics) {
  start(R"(, "hand_tracking": false)");
  Application::create_session();
  EXPECT_INFO_ERROR(FEATURE_UNSUPPORTED, xrCreateHandTrackerEXT, session,
                    {XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr, XR_HAND_RIGHT_EXT, XR_HAND_JOINT_SET_DEFAULT_EXT});
  EXPECT_XR(XR_SUCCESS, XR(xrDestroyInstance)(instance));
  create_instance({});  // without XR_MND_headless
  EXPECT_INFO_ERROR(GRAPHICS_DEVICE_INVALID, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, 1});
}

}  // namespace
}  // namespace hrt::mock
