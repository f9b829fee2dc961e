// The error codes of every function, without a loader in between. Each call has exactly one mistake.
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "samples/mock_runtime/functions.h"
#include "tests/samples/mock_runtime/negotiation.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

constexpr auto stereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;

template <typename T>
concept has_size = requires { sizeof(T); };
template <typename T>
constexpr bool is_handle = std::is_pointer_v<T> && !has_size<std::remove_pointer_t<T>>;

class MockErrors : public MockNegotiation {
 protected:
  void SetUp() override {
    MockNegotiation::SetUp();
    std::ofstream(folder / "script.json") << R"({"clock": "real-time", "frame_rate_hz": 1000})";
    setenv("HRT_MOCK_SCRIPT", (folder / "script.json").c_str(), 1);
    ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
    create_instance();
  }
  void TearDown() override {
    destroy_direct();
    unsetenv("HRT_MOCK_SCRIPT");
    MockNegotiation::TearDown();
  }

#define REFUSED(code, name, ...) EXPECT_XR(XR_ERROR_##code, XR(name)(__VA_ARGS__))
// Expects the error of a call that takes an object and an info and creates an object.
#define REFUSED_INFO(code, name, object, ...) EXPECT_XR(XR_ERROR_##code, result_of(XR(name), object, __VA_ARGS__))

  void create_instance() {
    const std::vector<const char*> names{
        "XR_MND_headless",       "XR_EXT_hand_tracking", "XR_KHR_convert_timespec_time",
        "XR_KHR_vulkan_enable2", "XR_HRTX_ridged_plate", "XR_HRTX_mock_control"};
    ASSERT_XR(XR_SUCCESS, create_direct(names, XR_MAKE_VERSION(1, 1, 0)));
  }
  // A session with all kinds of handles.
  void create_session(const std::string& script = "") {
    const std::string all = R"({"clock": "real-time", "frame_rate_hz": 1000)" + script + "}";
    ASSERT_XR(XR_SUCCESS, XR(xrApplyScriptHRTX)(instance, all.c_str()));
    Application::create_session();
    local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
    hand = create_hand_tracker();
    set = Application::make_set("set");
    ASSERT_XR(XR_SUCCESS, make_action("set", "set", XR_ACTION_TYPE_BOOLEAN_INPUT, &action));
  }

  XrResult make_action(const char* name, const char* localized, XrActionType type, XrAction* made,
                       std::vector<XrPath> subactions = {}) {
    const XrActionCreateInfo info = action_info(name, localized, type, subactions);
    return XR(xrCreateAction)(set, &info, made);
  }
  XrResult make_set(const char* name, const char* localized) {
    return result_of(XR(xrCreateActionSet), instance, set_info(name, localized));
  }

  // Calls every function through `call(name, function)`.
  template <typename Call>
  void for_each_function(Call call) {
#define HRT_CALL(name, implementation, extension, returned) call(std::string(#name), XR(name));
    HRT_MOCK_FUNCTIONS(HRT_CALL)
#undef HRT_CALL
  }
  // Calls a function with invalid handles, then with the object's own handle; all other arguments are zero.
  template <typename First, typename... Rest>
  void call_zeros(const std::string& name, XrResult (*function)(First, Rest...)) {
    if constexpr (is_handle<First>) {
      if (name == "xrGetInstanceProcAddr") return;
      for (const std::uintptr_t none : {std::uintptr_t{0}, std::uintptr_t{1}, std::uintptr_t{0x77}, ~std::uintptr_t{0},
                                        reinterpret_cast<std::uintptr_t>(instance) + 1000})
        EXPECT_XR(XR_ERROR_HANDLE_INVALID, function(reinterpret_cast<First>(none), Rest{}...)) << name << none;
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
      const bool survives = name.starts_with("xrDestroy") || name == "xrGetInstanceProcAddr" ||
                            name == "xrGetCallLogHRTX" || handle(First{}) == XR_NULL_HANDLE;
      if (survives || (loss == XR_ERROR_SESSION_LOST && !is_of_session)) return;
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
  Other handle(Other none) const {
    return none;
  }

  TemporaryFolder folder;
  XrActionSet set = XR_NULL_HANDLE;
  XrAction action = XR_NULL_HANDLE;
};

TEST_F(MockErrors, InstanceCalls) {
  std::uint32_t count = 0;
  XrExtensionProperties extension{XR_TYPE_EXTENSION_PROPERTIES};
  REFUSED(SIZE_INSUFFICIENT, xrEnumerateInstanceExtensionProperties, nullptr, 1, &count, &extension);
  REFUSED(API_LAYER_NOT_PRESENT, xrEnumerateInstanceExtensionProperties, "layer", 0, &count, nullptr);
  PFN_xrVoidFunction function = nullptr;
  REFUSED(FUNCTION_UNSUPPORTED, xrGetInstanceProcAddr, instance, "xrDance", &function);
  REFUSED(HANDLE_INVALID, xrGetInstanceProcAddr, XR_NULL_HANDLE, "xrPollEvent", &function);
  XrInstance second = XR_NULL_HANDLE;
  const auto create = [&](XrVersion version, const char* application) {
    XrInstanceCreateInfo info = instance_info({});
    info.applicationInfo.apiVersion = version;
    std::snprintf(info.applicationInfo.applicationName, XR_MAX_APPLICATION_NAME_SIZE, "%s", application);
    return XR(xrCreateInstance)(&info, &second);
  };
  EXPECT_XR(XR_ERROR_LIMIT_REACHED, create(XR_MAKE_VERSION(1, 0, 0), "second"));
  EXPECT_XR(XR_ERROR_API_VERSION_UNSUPPORTED, create(XR_MAKE_VERSION(2, 0, 0), "later"));
  EXPECT_XR(XR_ERROR_NAME_INVALID, create(XR_MAKE_VERSION(1, 0, 0), ""));
  const auto create_first = XR(xrCreateInstance);
  ASSERT_XR(XR_SUCCESS, XR(xrDestroyInstance)(instance));
  const std::vector<const char*> unknown{"XR_EXT_dance"};
  XrInstanceCreateInfo info = instance_info(unknown);
  EXPECT_XR(XR_ERROR_EXTENSION_NOT_PRESENT, create_first(&info, &second));
  const std::string good = read_file(folder / "script.json");
  std::ofstream(folder / "script.json") << "{";
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  info = instance_info({});
  EXPECT_XR(XR_ERROR_INITIALIZATION_FAILED, create_first(&info, &second));
  std::ofstream(folder / "script.json") << good;
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  create_instance();
}

TEST_F(MockErrors, SystemAndViewCalls) {
  std::uint32_t count = 0;
  const auto none = static_cast<XrSystemId>(99);
  const auto odd = static_cast<XrViewConfigurationType>(12345);
  REFUSED_INFO(FORM_FACTOR_UNSUPPORTED, xrGetSystem, instance,
               {XR_TYPE_SYSTEM_GET_INFO, nullptr, XR_FORM_FACTOR_HANDHELD_DISPLAY});
  XrSystemProperties properties{XR_TYPE_SYSTEM_PROPERTIES};
  REFUSED(SYSTEM_INVALID, xrGetSystemProperties, instance, none, &properties);
  REFUSED(SYSTEM_INVALID, xrEnumerateEnvironmentBlendModes, instance, none, odd, 0, &count, nullptr);
  REFUSED(VIEW_CONFIGURATION_TYPE_UNSUPPORTED, xrEnumerateEnvironmentBlendModes, instance, 1, odd, 0, &count, nullptr);
  REFUSED(SYSTEM_INVALID, xrEnumerateViewConfigurations, instance, none, 0, &count, nullptr);
  XrViewConfigurationProperties view{XR_TYPE_VIEW_CONFIGURATION_PROPERTIES};
  REFUSED(SYSTEM_INVALID, xrGetViewConfigurationProperties, instance, none, odd, &view);
  REFUSED(VIEW_CONFIGURATION_TYPE_UNSUPPORTED, xrGetViewConfigurationProperties, instance, 1, odd, &view);
  XrViewConfigurationView one{XR_TYPE_VIEW_CONFIGURATION_VIEW};
  REFUSED(SYSTEM_INVALID, xrEnumerateViewConfigurationViews, instance, none, odd, 0, &count, nullptr);
  REFUSED(VIEW_CONFIGURATION_TYPE_UNSUPPORTED, xrEnumerateViewConfigurationViews, instance, 1, odd, 0, &count, nullptr);
  REFUSED(SIZE_INSUFFICIENT, xrEnumerateViewConfigurationViews, instance, 1, stereo, 1, &count, &one);
  // The remaining mistake, with a valid system and views, is the missing count.
  REFUSED(VALIDATION_FAILURE, xrEnumerateEnvironmentBlendModes, instance, 1, stereo, 0, nullptr, nullptr);
  REFUSED(VALIDATION_FAILURE, xrEnumerateViewConfigurationViews, instance, 1, stereo, 0, nullptr, nullptr);
  REFUSED(VALIDATION_FAILURE, xrEnumerateViewConfigurations, instance, 1, 0, nullptr, nullptr);
  REFUSED_INFO(SYSTEM_INVALID, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, none});
  XrGraphicsRequirementsVulkanKHR vulkan{XR_TYPE_GRAPHICS_REQUIREMENTS_VULKAN_KHR};
  REFUSED(SYSTEM_INVALID, xrGetVulkanGraphicsRequirements2KHR, instance, none, &vulkan);
  VkPhysicalDevice device = nullptr;
  const XrVulkanGraphicsDeviceGetInfoKHR early{XR_TYPE_VULKAN_GRAPHICS_DEVICE_GET_INFO_KHR, nullptr, 1, nullptr};
  REFUSED(VALIDATION_FAILURE, xrGetVulkanGraphicsDevice2KHR, instance, &early, &device);
}

TEST_F(MockErrors, TimeAndPathCalls) {
  std::uint32_t count = 0;
  const timespec before{-1, 0};
  timespec back{};
  XrTime time = 0;
  REFUSED(TIME_INVALID, xrConvertTimespecTimeToTimeKHR, instance, &before, &time);
  REFUSED(TIME_INVALID, xrConvertTimeToTimespecTimeKHR, instance, 0, &back);
  XrPath atom = XR_NULL_PATH;
  for (const char* text : {"", "/", "a", "/a/", "/a//b", "/a/.", "/a/../b", "/A", "/a b", "/a\xc3\xa4"})
    REFUSED(PATH_FORMAT_INVALID, xrStringToPath, instance, text, &atom);
  const std::string longest = "/" + std::string(XR_MAX_PATH_LENGTH - 2, 'a');
  EXPECT_XR(XR_SUCCESS, XR(xrStringToPath)(instance, longest.c_str(), &atom));
  REFUSED(PATH_FORMAT_INVALID, xrStringToPath, instance, (longest + "a").c_str(), &atom);
  char text[4];
  REFUSED(PATH_INVALID, xrPathToString, instance, 12345, 0, &count, nullptr);
  REFUSED(SIZE_INSUFFICIENT, xrPathToString, instance, path("/user/hand/left"), 4, &count, text);
  REFUSED(VALIDATION_FAILURE, xrPathToString, instance, path("/user/hand/left"), 0, nullptr, nullptr);
}

// Names of action sets and of actions.
TEST_F(MockErrors, NamesOfActionsAndSets) {
  create_session();
  XrAction made = XR_NULL_HANDLE;
  for (const auto& [name, localized, code] : {std::tuple{"set", "Other", XR_ERROR_NAME_DUPLICATED},
                                              {"other", "set", XR_ERROR_LOCALIZED_NAME_DUPLICATED},
                                              {"", "Other", XR_ERROR_NAME_INVALID},
                                              {"other", "", XR_ERROR_LOCALIZED_NAME_INVALID},
                                              {"Other!", "Other", XR_ERROR_PATH_FORMAT_INVALID}}) {
    EXPECT_XR(code, make_set(name, localized)) << name;
    EXPECT_XR(code, make_action(name, localized, XR_ACTION_TYPE_BOOLEAN_INPUT, &made)) << name;
  }
}

TEST_F(MockErrors, SessionAndSpaceCalls) {
  create_session();
  std::uint32_t count = 0;
  REFUSED_INFO(LIMIT_REACHED, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, 1});
  const auto odd = static_cast<XrViewConfigurationType>(12345);
  const XrSessionBeginInfo wrong{XR_TYPE_SESSION_BEGIN_INFO, nullptr, odd};
  REFUSED(VIEW_CONFIGURATION_TYPE_UNSUPPORTED, xrBeginSession, session, &wrong);
  XrReferenceSpaceType type{};
  REFUSED(SIZE_INSUFFICIENT, xrEnumerateReferenceSpaces, session, 1, &count, &type);
  XrReferenceSpaceCreateInfo turned{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, XR_REFERENCE_SPACE_TYPE_LOCAL, {}};
  for (const XrPosef& pose : {XrPosef{}, XrPosef{{0.0F, 0.0F, 0.0F, 1.02F}, {}}, XrPosef{{NAN, 0.0F, 0.0F, 1.0F}, {}},
                              XrPosef{identity_pose.orientation, {INFINITY, 0.0F, 0.0F}}}) {
    turned.poseInReferenceSpace = pose;
    REFUSED_INFO(POSE_INVALID, xrCreateReferenceSpace, session, turned);
  }
  turned.referenceSpaceType = static_cast<XrReferenceSpaceType>(12345);
  REFUSED_INFO(REFERENCE_SPACE_UNSUPPORTED, xrCreateReferenceSpace, session, turned);
  XrExtent2Df extent{};
  REFUSED(REFERENCE_SPACE_UNSUPPORTED, xrGetReferenceSpaceBoundsRect, session, static_cast<XrReferenceSpaceType>(12345),
          &extent);
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
  for (const XrTime none : {0, -1}) REFUSED(TIME_INVALID, xrLocateSpace, local, local, none, &location);
  REFUSED(VALIDATION_FAILURE, xrLocateSpace, local, local, 1, nullptr);
  XrSpaceLocationData data{};
  XrSpaceLocations locations{XR_TYPE_SPACE_LOCATIONS, nullptr, 1, &data};
  XrSpacesLocateInfo locate{XR_TYPE_SPACES_LOCATE_INFO, nullptr, local, 0, 1, &local};
  REFUSED(TIME_INVALID, xrLocateSpaces, session, &locate, &locations);
  for (const std::uint32_t count_given : {0U, 2U}) {
    locate.spaceCount = count_given;
    REFUSED(VALIDATION_FAILURE, xrLocateSpaces, session, &locate, &locations);
  }
  XrViewState state{XR_TYPE_VIEW_STATE};
  XrView view{XR_TYPE_VIEW};
  XrViewLocateInfo views{XR_TYPE_VIEW_LOCATE_INFO, nullptr, odd, 1, local};
  REFUSED(VIEW_CONFIGURATION_TYPE_UNSUPPORTED, xrLocateViews, session, &views, &state, 0, &count, nullptr);
  views.viewConfigurationType = stereo;
  REFUSED(SIZE_INSUFFICIENT, xrLocateViews, session, &views, &state, 1, &count, &view);
  views.displayTime = 0;
  REFUSED(TIME_INVALID, xrLocateViews, session, &views, &state, 0, &count, nullptr);
  std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
  XrHandJointLocationsEXT located_joints{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, nullptr, XR_FALSE, XR_HAND_JOINT_COUNT_EXT,
                                         joints.data()};
  const XrHandJointsLocateInfoEXT joint_info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, local, 0};
  REFUSED(TIME_INVALID, xrLocateHandJointsEXT, hand, &joint_info, &located_joints);
  REFUSED_INFO(SWAPCHAIN_FORMAT_UNSUPPORTED, xrCreateSwapchain, session, {XR_TYPE_SWAPCHAIN_CREATE_INFO});
}

TEST_F(MockErrors, FrameCalls) {
  create_session();
  XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO, nullptr, 1, XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 0, nullptr};
  REFUSED(SESSION_NOT_RUNNING, xrEndFrame, session, &end);
  focus();
  REFUSED(VALIDATION_FAILURE, xrBeginSession, session, nullptr);
  const XrSessionBeginInfo twice{XR_TYPE_SESSION_BEGIN_INFO, nullptr, stereo};
  REFUSED(SESSION_RUNNING, xrBeginSession, session, &twice);
  REFUSED(SESSION_NOT_STOPPING, xrEndSession, session);
  REFUSED(CALL_ORDER_INVALID, xrBeginFrame, session, nullptr);
  XrFrameState frame{XR_TYPE_FRAME_STATE};
  REFUSED(CALL_ORDER_INVALID, xrEndFrame, session, &end);
  XrFrameBeginInfo odd_frame{XR_TYPE_FRAME_END_INFO};
  REFUSED(VALIDATION_FAILURE, xrBeginFrame, session, &odd_frame);
  XR(xrWaitFrame)(session, nullptr, &frame);
  XR(xrBeginFrame)(session, nullptr);
  XR(xrWaitFrame)(session, nullptr, &frame);
  EXPECT_XR(XR_FRAME_DISCARDED, XR(xrBeginFrame)(session, nullptr));
  end.displayTime = 0;
  REFUSED(TIME_INVALID, xrEndFrame, session, &end);
  end.displayTime = 1;
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_ADDITIVE;
  REFUSED(ENVIRONMENT_BLEND_MODE_UNSUPPORTED, xrEndFrame, session, &end);
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  EXPECT_XR(XR_SUCCESS, XR(xrEndFrame)(session, &end)) << "the refused calls have not ended the frame";
  XR(xrRequestExitSession)(session);
  XR(xrEndSession)(session);
  REFUSED(SESSION_NOT_READY, xrBeginSession, session, &twice);  // EXITING
}

TEST_F(MockErrors, Layers) {
  create_session();
  focus();
  XrFrameState frame{XR_TYPE_FRAME_STATE};
  XR(xrWaitFrame)(session, nullptr, &frame);
  XR(xrBeginFrame)(session, nullptr);
  XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO, nullptr, 1, XR_ENVIRONMENT_BLEND_MODE_OPAQUE, 1, nullptr};
  REFUSED(LAYER_INVALID, xrEndFrame, session, &end);
  XrCompositionLayerProjection layer{XR_TYPE_FRAME_STATE};
  std::array<const XrCompositionLayerBaseHeader*, XR_MIN_COMPOSITION_LAYERS_SUPPORTED + 1> layers{};
  end.layers = layers.data();
  REFUSED(LAYER_INVALID, xrEndFrame, session, &end);
  layers.fill(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer));
  REFUSED(LAYER_INVALID, xrEndFrame, session, &end);
  layer.type = XR_TYPE_COMPOSITION_LAYER_PROJECTION;
  REFUSED(HANDLE_INVALID, xrEndFrame, session, &end);
  layer.space = local;
  end.layerCount = layers.size();
  REFUSED(LAYER_LIMIT_EXCEEDED, xrEndFrame, session, &end);
  --end.layerCount;
  EXPECT_XR(XR_SUCCESS, XR(xrEndFrame)(session, &end));
}

TEST_F(MockErrors, PlateCalls) {
  create_session();
  XrPlatePlacementHRTX placement{XR_TYPE_PLATE_PLACEMENT_HRTX, nullptr, local, {}, 0.075};
  XrReachInstructionHRTX instruction{XR_TYPE_REACH_INSTRUCTION_HRTX, nullptr, XR_HAND_RIGHT_EXT, {}, 5.0, 0.1};
  REFUSED(CALL_ORDER_INVALID, xrInstructReachHRTX, session, &instruction);
  XrReachTruthHRTX truth{XR_TYPE_REACH_TRUTH_HRTX};
  REFUSED(CALL_ORDER_INVALID, xrGetReachTruthHRTX, session, XR_HAND_RIGHT_EXT, &truth);
  REFUSED(POSE_INVALID, xrPlacePlateHRTX, session, &placement);
  double orientation = 0.0;
  REFUSED(TIME_INVALID, xrGetPlateOrientationHRTX, session, 0, &orientation);
  REFUSED(VALIDATION_FAILURE, xrSetPlateOrientationHRTX, session, 1e9);
}

class MockActionErrors : public MockErrors {
 protected:
  void SetUp() override {
    MockErrors::SetUp();
    create_session();
    left = path("/user/hand/left");
    chest = path("/user/chest");
    simple = path("/interaction_profiles/khr/simple_controller");
    select = path("/user/hand/left/input/select/click");
    ASSERT_XR(XR_SUCCESS, make_action("button", "Button", XR_ACTION_TYPE_BOOLEAN_INPUT, &button, {left}));
    ASSERT_XR(XR_SUCCESS, make_action("pose", "Pose", XR_ACTION_TYPE_POSE_INPUT, &pose, {left}));
  }
  XrResult suggest(XrPath profile, XrPath source) {
    const XrActionSuggestedBinding binding{button, source};
    const XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING, nullptr, profile, 1,
                                                    &binding};
    return XR(xrSuggestInteractionProfileBindings)(instance, &info);
  }
  // Expects an error of every function that reads or vibrates an action, except a mismatch in the function of its type.
  void expect_refused(XrAction of, XrPath subaction, XrResult refused) {
    const auto expected = [&](bool own) {
      return own && refused == XR_ERROR_ACTION_TYPE_MISMATCH ? XR_SUCCESS : refused;
    };
    const XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, of, subaction};
    EXPECT_XR(expected(of == button), result_of(XR(xrGetActionStateBoolean), session, info));
    EXPECT_XR(refused, result_of(XR(xrGetActionStateFloat), session, info));
    EXPECT_XR(refused, result_of(XR(xrGetActionStateVector2f), session, info));
    EXPECT_XR(expected(of == pose), result_of(XR(xrGetActionStatePose), session, info));
    const XrHapticActionInfo haptic{XR_TYPE_HAPTIC_ACTION_INFO, nullptr, of, subaction};
    const XrHapticVibration vibration{XR_TYPE_HAPTIC_VIBRATION, nullptr, 1, 0.0F, 0.5F};
    EXPECT_XR(refused,
              XR(xrApplyHapticFeedback)(session, &haptic, reinterpret_cast<const XrHapticBaseHeader*>(&vibration)));
    EXPECT_XR(refused, XR(xrStopHapticFeedback)(session, &haptic));
  }
  void expect_of_paths(XrPath top_level, XrResult of_profile, XrPath source, XrResult of_name) {
    XrInteractionProfileState profile{XR_TYPE_INTERACTION_PROFILE_STATE};
    EXPECT_XR(of_profile, XR(xrGetCurrentInteractionProfile)(session, top_level, &profile));
    const XrInputSourceLocalizedNameGetInfo name{XR_TYPE_INPUT_SOURCE_LOCALIZED_NAME_GET_INFO, nullptr, source, 7};
    std::uint32_t count = 0;
    char text[2];
    EXPECT_XR(of_name, XR(xrGetInputSourceLocalizedName)(session, &name, 2, &count, text));
  }

  static constexpr auto never = static_cast<XrPath>(12345);
  XrPath left = XR_NULL_PATH, chest = XR_NULL_PATH, simple = XR_NULL_PATH, select = XR_NULL_PATH;
  XrAction button = XR_NULL_HANDLE, pose = XR_NULL_HANDLE;
};

TEST_F(MockActionErrors, ActionAndBindingCalls) {
  XrAction made = XR_NULL_HANDLE;
  const auto make = [&](const std::vector<XrPath>& subactions, XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT) {
    return make_action("other", "Other", type, &made, subactions);
  };
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, make({chest}));
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, make({left, left}));
  EXPECT_XR(XR_ERROR_PATH_INVALID, make({never}));
  EXPECT_XR(XR_ERROR_PATH_INVALID, make({XR_NULL_PATH}));
  EXPECT_XR(XR_ERROR_VALIDATION_FAILURE, make({}, static_cast<XrActionType>(77)));
  EXPECT_XR(XR_ERROR_PATH_INVALID, suggest(never, select));
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest(chest, select));
  for (const char* bad : {"/user/hand/left", "/user/hand/right/input", "/user/hand/left/input/trigger/value",
                          "/user/head/input/select/click", "/user/hand/right/input/select/click/invalid"})
    EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest(simple, path(bad))) << bad;
  EXPECT_XR(XR_SUCCESS, suggest(simple, select));

  XrActionSpaceCreateInfo info{XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, button, XR_NULL_PATH, identity_pose};
  REFUSED_INFO(ACTION_TYPE_MISMATCH, xrCreateActionSpace, session, info);
  info.action = pose;
  info.subactionPath = never;
  REFUSED_INFO(PATH_INVALID, xrCreateActionSpace, session, info);
  info.subactionPath = chest;
  REFUSED_INFO(PATH_UNSUPPORTED, xrCreateActionSpace, session, info);
  info.subactionPath = left;
  info.poseInActionSpace = {};
  REFUSED_INFO(POSE_INVALID, xrCreateActionSpace, session, info);
}

TEST_F(MockActionErrors, ActionStateCalls) {
  XrActiveActionSet active{set, XR_NULL_PATH};
  const XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 1, &active};
  REFUSED(ACTIONSET_NOT_ATTACHED, xrSyncActions, session, &sync);  // nothing is attached
  for (const XrAction of : {button, pose}) expect_refused(of, XR_NULL_PATH, XR_ERROR_ACTIONSET_NOT_ATTACHED);
  expect_of_paths(left, XR_ERROR_ACTIONSET_NOT_ATTACHED, select, XR_ERROR_ACTIONSET_NOT_ATTACHED);
  EXPECT_XR(XR_SUCCESS, attach({set}));
  EXPECT_XR(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, attach({set}));
  XrAction late = XR_NULL_HANDLE;
  EXPECT_XR(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, make_action("late", "Late", XR_ACTION_TYPE_POSE_INPUT, &late));
  EXPECT_XR(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, suggest(simple, select));
  active.subactionPath = never;
  REFUSED(PATH_INVALID, xrSyncActions, session, &sync);
  active.subactionPath = chest;
  REFUSED(PATH_UNSUPPORTED, xrSyncActions, session, &sync);
  for (const XrAction of : {button, pose}) {
    expect_refused(of, XR_NULL_PATH, XR_ERROR_ACTION_TYPE_MISMATCH);
    expect_refused(of, never, XR_ERROR_PATH_INVALID);
    expect_refused(of, chest, XR_ERROR_PATH_UNSUPPORTED);
  }
  expect_of_paths(left, XR_SUCCESS, select, XR_ERROR_SIZE_INSUFFICIENT);
  expect_of_paths(never, XR_ERROR_PATH_INVALID, never, XR_ERROR_PATH_INVALID);
  expect_of_paths(chest, XR_ERROR_PATH_UNSUPPORTED, chest, XR_ERROR_PATH_UNSUPPORTED);
}

// Invalid handles and missing outputs, in a session that is ready.
TEST_F(MockErrors, InvalidHandlesAndNullPointers) {
  create_session();
  for_each_function([&](const std::string& name, auto function) { call_zeros(name, function); });
}

// Every function of a lost session or instance returns the loss, except those that destroy.
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
  ASSERT_XR(XR_SUCCESS, XR(xrApplyScriptHRTX)(instance, R"({"clock": "real-time", "hand_tracking": false})"));
  Application::create_session();
  REFUSED_INFO(FEATURE_UNSUPPORTED, xrCreateHandTrackerEXT, session,
               {XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr, XR_HAND_RIGHT_EXT, XR_HAND_JOINT_SET_DEFAULT_EXT});
  destroy_direct();
  ASSERT_XR(XR_SUCCESS, create_direct({}, XR_MAKE_VERSION(1, 0, 20)));  // without XR_MND_headless
  REFUSED_INFO(GRAPHICS_DEVICE_INVALID, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, 1});
}

}  // namespace
}  // namespace hrt::mock
