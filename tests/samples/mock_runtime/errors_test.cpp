// The error codes of every function, against those that OpenXR's registry lists for it
// (calls/registry_errors.h): each is provoked here, where nothing else of the call is wrong, or stands below
// with the reason why this runtime does not produce it; none is produced that is not listed.
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "samples/mock_runtime/calls/registry_errors.h"
#include "samples/mock_runtime/functions.h"
#include "tests/samples/mock_runtime/negotiation.h"
#include "tests/samples/process.h"

namespace hrt::mock {
namespace {

constexpr auto stereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;

using Codes = std::map<std::string, std::set<std::string>>;  // by function, without "XR_ERROR_"

template <typename T>
concept has_size = requires { sizeof(T); };
template <typename T>
constexpr bool is_handle = std::is_pointer_v<T> && !has_size<std::remove_pointer_t<T>>;

// "*": every function that has the code.
struct Reason {
  const char* functions;
  const char* codes;
  const char* why;
};
constexpr Reason reasons[] = {
    {"*", "RUNTIME_FAILURE OUT_OF_MEMORY", "on a script's order only: neither happens by itself"},
    {"*", "FUNCTION_UNSUPPORTED", "without its extension a function has no address, so nobody can call it"},
    {"xrEnumerateInstanceExtensionProperties xrCreateInstance", "RUNTIME_UNAVAILABLE", "a loader finds no runtime"},
    {"xrCreateInstance", "API_LAYER_NOT_PRESENT", "a loader finds the layers"},
    {"xrCreateInstance", "EXTENSION_DEPENDENCY_NOT_ENABLED", "no extension here needs another one"},
    {"xrGetInstanceProcAddr", "INSTANCE_LOST", "a lost instance is destroyed through functions that it gives"},
    {"xrGetSystem", "FORM_FACTOR_UNAVAILABLE", "on a script's order only: the display is always there"},
    {"xrCreateSession", "INITIALIZATION_FAILED", "on a script's order only"},
    {"xrCreateSession", "GRAPHICS_REQUIREMENTS_CALL_MISSING", "graphics_test.cpp gives it"},
    {"xrCreateReferenceSpace xrCreateActionSpace xrCreateSwapchain xrCreateActionSet xrCreateAction "
     "xrCreateHandTrackerEXT",
     "LIMIT_REACHED", "there is no limit"},
    {"xrStringToPath", "PATH_COUNT_EXCEEDED", "there is no limit"},
    {"xrEnumerateApiLayerProperties xrEnumerateSwapchainFormats", "SIZE_INSUFFICIENT", "the list is empty"},
    {"xrEnumerateEnvironmentBlendModes xrEnumerateViewConfigurations", "SIZE_INSUFFICIENT", "the list has one element"},
    {"xrLocateSpaces xrLocateSpacesKHR", "SIZE_INSUFFICIENT", "counts that differ are invalid; there is no capacity"},
    {"xrEndFrame", "POSE_INVALID SWAPCHAIN_RECT_INVALID", "graphics_test.cpp gives them"},
    {"xrCreateSwapchain", "FEATURE_UNSUPPORTED", "graphics_test.cpp gives it"},
    {"xrEnumerateSwapchainImages xrAcquireSwapchainImage xrWaitSwapchainImage xrReleaseSwapchainImage",
     "CALL_ORDER_INVALID INSTANCE_LOST SESSION_LOST SIZE_INSUFFICIENT VALIDATION_FAILURE",
     "a headless session has no swapchains; graphics_test.cpp has some"},
    {"xrCreateVulkanInstanceKHR xrCreateVulkanDeviceKHR", "LIMIT_REACHED", "there is no limit"},
    {"xrGetVulkanInstanceExtensionsKHR xrGetVulkanDeviceExtensionsKHR", "SIZE_INSUFFICIENT",
     "the list has one element"},
    {"xrCreateVulkanInstanceKHR xrGetVulkanGraphicsDevice2KHR xrCreateVulkanDeviceKHR", "SYSTEM_INVALID",
     "the system is in a structure, for which call_all() gives null"},
    {"xrEndSession xrRequestExitSession xrSetSimulationSeedHRTX", "VALIDATION_FAILURE",
     "a handle is all that is given"},
    {"xrSetInputDeviceActiveEXT xrSetInputDeviceStateBoolEXT xrSetInputDeviceStateFloatEXT "
     "xrSetInputDeviceStateVector2fEXT xrSetInputDeviceLocationEXT",
     "VALIDATION_FAILURE", "handles, paths and poses have errors of their own, and values are taken as they are"},
    {"xrEnumerateBoundSourcesForAction", "PATH_INVALID", "no path is given"},
};

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
    unsetenv("HRT_MOCK_SCRIPT");
    MockNegotiation::TearDown();
  }

#define CALL(name, ...) note(#name, XR(name)(__VA_ARGS__))
#define REFUSED(code, name, ...) EXPECT_XR(XR_ERROR_##code, CALL(name, __VA_ARGS__))
// Of a call that takes an object and an info, and makes something.
#define REFUSED_INFO(code, name, object, ...) \
  EXPECT_XR(XR_ERROR_##code, note(#name, result_of(XR(name), object, __VA_ARGS__)))
  XrResult note(const char* function, XrResult result) {
    if (XR_FAILED(result)) produced[function].insert(result_name(result).substr(9));
    return result;
  }

  void create_instance() {
    const std::vector<const char*> names{
        "XR_MND_headless",      "XR_EXT_hand_tracking", "XR_KHR_convert_timespec_time", "XR_EXT_conformance_automation",
        "XR_KHR_locate_spaces", "XR_KHR_vulkan_enable", "XR_KHR_vulkan_enable2",        "XR_KHR_opengl_enable",
        "XR_HRTX_ridged_plate", "XR_HRTX_mock_control"};
    ASSERT_XR(XR_SUCCESS, create_direct(names, XR_MAKE_VERSION(1, 1, 0)));
  }
  // A session with all kinds of handles, and the script's faults in its first frame.
  void create_session(const char* script) {
    const std::string all = std::string(R"({"clock": "real-time", "frame_rate_hz": 1000)") + script + "}";
    ASSERT_XR(XR_SUCCESS, XR(xrApplyScriptHRTX)(instance, all.c_str()));
    Application::create_session();
    local = create_space(XR_REFERENCE_SPACE_TYPE_LOCAL);
    const XrHandTrackerCreateInfoEXT of_hand{XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr, XR_HAND_RIGHT_EXT,
                                             XR_HAND_JOINT_SET_DEFAULT_EXT};
    CALL(xrCreateHandTrackerEXT, session, &of_hand, &hand);
    set = Application::make_set(("set" + std::to_string(++sets)).c_str());
    ASSERT_XR(XR_SUCCESS, make_action("act", "Act", XR_ACTION_TYPE_BOOLEAN_INPUT, &action));
  }
  void destroy_session() { EXPECT_XR(XR_SUCCESS, CALL(xrDestroySession, session)); }

  XrResult make_action(const char* name, const char* localized, XrActionType type, XrAction* made,
                       std::vector<XrPath> subactions = {}) {
    const XrActionCreateInfo info = action_info(name, localized, type, subactions);
    return CALL(xrCreateAction, set, &info, made);
  }
  XrResult make_set(const char* name, const char* localized) {
    return note("xrCreateActionSet", result_of(XR(xrCreateActionSet), instance, set_info(name, localized)));
  }

  // Calls every function with this handle and zeros; with handles that are none if `null`.
  void call_all(bool null) {
#define HRT_CALL(name, implementation, extension, returned) call_zeros(#name, XR(name), null);
    HRT_MOCK_FUNCTIONS(HRT_CALL)
#undef HRT_CALL
  }
  template <typename First, typename... Rest>
  void call_zeros(const char* name, XrResult (*function)(First, Rest...), bool null) {
    const bool destroys = std::string(name).starts_with("xrDestroy");
    if (!null && destroys) return;
    const XrResult result = note(name, function(null ? First{} : handle(First{}), Rest{}...));
    if constexpr (std::is_same_v<First, XrInstance>) {
      EXPECT_LT(result, XR_SUCCESS) << name << " succeeds without its outputs";
    }
    if constexpr (is_handle<First>) {
      if (!null || std::string(name) == "xrGetInstanceProcAddr") return;
      for (const std::uintptr_t none : {std::uintptr_t{0}, std::uintptr_t{1}, std::uintptr_t{0x77}, ~std::uintptr_t{0},
                                        reinterpret_cast<std::uintptr_t>(instance) + 1000})
        EXPECT_XR(XR_ERROR_HANDLE_INVALID, function(reinterpret_cast<First>(none), Rest{}...)) << name << none;
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

  void provoke_at_instance();
  void provoke_in_session();
  void provoke_actions();

  TemporaryFolder folder;
  Codes produced;
  int sets = 0;
  XrActionSet set = XR_NULL_HANDLE;
  XrAction action = XR_NULL_HANDLE;
};

void MockErrors::provoke_at_instance() {
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
    return CALL(xrCreateInstance, &info, &second);
  };
  EXPECT_XR(XR_ERROR_LIMIT_REACHED, create(XR_MAKE_VERSION(1, 0, 0), "second"));
  EXPECT_XR(XR_ERROR_API_VERSION_UNSUPPORTED, create(XR_MAKE_VERSION(2, 0, 0), "later"));
  EXPECT_XR(XR_ERROR_NAME_INVALID, create(XR_MAKE_VERSION(1, 0, 0), ""));
  const auto create_first = XR(xrCreateInstance);
  ASSERT_XR(XR_SUCCESS, CALL(xrDestroyInstance, instance));
  const std::vector<const char*> unknown{"XR_EXT_dance"};
  XrInstanceCreateInfo info = instance_info(unknown);
  EXPECT_XR(XR_ERROR_EXTENSION_NOT_PRESENT, note("xrCreateInstance", create_first(&info, &second)));
  const std::string good = read_file(folder / "script.json");
  std::ofstream(folder / "script.json") << "{";
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  info = instance_info({});
  note("xrCreateInstance", create_first(&info, &second));
  std::ofstream(folder / "script.json") << good;
  ASSERT_XR(XR_SUCCESS, negotiate(&loader, &request));
  create_instance();

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
  // Of valid systems and views what is left is the missing count.
  REFUSED(VALIDATION_FAILURE, xrEnumerateEnvironmentBlendModes, instance, 1, stereo, 0, nullptr, nullptr);
  REFUSED(VALIDATION_FAILURE, xrEnumerateViewConfigurationViews, instance, 1, stereo, 0, nullptr, nullptr);
  REFUSED(VALIDATION_FAILURE, xrEnumerateViewConfigurations, instance, 1, 0, nullptr, nullptr);
  REFUSED_INFO(SYSTEM_INVALID, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, none});
  XrGraphicsRequirementsVulkanKHR vulkan{XR_TYPE_GRAPHICS_REQUIREMENTS_VULKAN_KHR};
  REFUSED(SYSTEM_INVALID, xrGetVulkanGraphicsRequirements2KHR, instance, none, &vulkan);
  REFUSED(SYSTEM_INVALID, xrGetVulkanGraphicsRequirementsKHR, instance, none, &vulkan);
  XrGraphicsRequirementsOpenGLKHR opengl{XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR};
  REFUSED(SYSTEM_INVALID, xrGetOpenGLGraphicsRequirementsKHR, instance, none, &opengl);
  VkPhysicalDevice device = nullptr;
  REFUSED(SYSTEM_INVALID, xrGetVulkanGraphicsDeviceKHR, instance, none, nullptr, &device);
  REFUSED(VALIDATION_FAILURE, xrGetVulkanInstanceExtensionsKHR, instance, 1, 0, nullptr, nullptr);
  REFUSED(VALIDATION_FAILURE, xrGetVulkanDeviceExtensionsKHR, instance, 1, 0, nullptr, nullptr);
  const timespec before{-1, 0};
  timespec back{};
  XrTime time = 0;
  REFUSED(TIME_INVALID, xrConvertTimespecTimeToTimeKHR, instance, &before, &time);
  REFUSED(TIME_INVALID, xrConvertTimeToTimespecTimeKHR, instance, 0, &back);
  XrPath atom = XR_NULL_PATH;
  REFUSED(PATH_FORMAT_INVALID, xrStringToPath, instance, "no path", &atom);
  char text[4];
  REFUSED(PATH_INVALID, xrPathToString, instance, 12345, 0, &count, nullptr);
  REFUSED(SIZE_INSUFFICIENT, xrPathToString, instance, path("/user/hand/left"), 4, &count, text);
  REFUSED(VALIDATION_FAILURE, xrPathToString, instance, path("/user/hand/left"), 0, nullptr, nullptr);
  EXPECT_XR(XR_SUCCESS, make_set("taken", "Taken"));
  EXPECT_XR(XR_ERROR_NAME_DUPLICATED, make_set("taken", "Other"));
  EXPECT_XR(XR_ERROR_LOCALIZED_NAME_DUPLICATED, make_set("other", "Taken"));
  EXPECT_XR(XR_ERROR_NAME_INVALID, make_set("", "Other"));
  EXPECT_XR(XR_ERROR_LOCALIZED_NAME_INVALID, make_set("other", ""));
  EXPECT_XR(XR_ERROR_PATH_FORMAT_INVALID, make_set("Other!", "Other"));
}

void MockErrors::provoke_in_session() {
  std::uint32_t count = 0;
  REFUSED_INFO(LIMIT_REACHED, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, 1});
  const auto odd = static_cast<XrViewConfigurationType>(12345);
  const XrSessionBeginInfo wrong{XR_TYPE_SESSION_BEGIN_INFO, nullptr, odd};
  REFUSED(VIEW_CONFIGURATION_TYPE_UNSUPPORTED, xrBeginSession, session, &wrong);
  XrReferenceSpaceType type{};
  REFUSED(SIZE_INSUFFICIENT, xrEnumerateReferenceSpaces, session, 1, &count, &type);
  XrReferenceSpaceCreateInfo turned{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, XR_REFERENCE_SPACE_TYPE_LOCAL, {}};
  REFUSED_INFO(POSE_INVALID, xrCreateReferenceSpace, session, turned);
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
  const XrSpacesLocateInfo locate{XR_TYPE_SPACES_LOCATE_INFO, nullptr, local, 0, 1, &local};
  REFUSED(TIME_INVALID, xrLocateSpaces, session, &locate, &locations);
  REFUSED(TIME_INVALID, xrLocateSpacesKHR, session, &locate, &locations);
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
  CALL(xrWaitFrame, session, nullptr, &frame);
  CALL(xrBeginFrame, session, nullptr);
  end.displayTime = 0;
  REFUSED(TIME_INVALID, xrEndFrame, session, &end);
  end.displayTime = 1;
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_ADDITIVE;
  REFUSED(ENVIRONMENT_BLEND_MODE_UNSUPPORTED, xrEndFrame, session, &end);
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  end.layerCount = 1;
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
  EXPECT_XR(XR_SUCCESS, CALL(xrEndFrame, session, &end)) << "what was refused has not ended the frame";
  CALL(xrRequestExitSession, session);
  CALL(xrEndSession, session);
  REFUSED(SESSION_NOT_READY, xrBeginSession, session, &twice);  // EXITING

  // The plate.
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

void MockErrors::provoke_actions() {
  std::uint32_t count = 0;
  const XrPath left = path("/user/hand/left"), right = path("/user/hand/right"), chest = path("/user/chest");
  const auto never = static_cast<XrPath>(12345);
  XrAction made = XR_NULL_HANDLE;
  const auto make = [&](const char* name, const char* localized, const std::vector<XrPath>& subactions = {}) {
    return make_action(name, localized, XR_ACTION_TYPE_BOOLEAN_INPUT, &made, subactions);
  };
  EXPECT_XR(XR_ERROR_NAME_DUPLICATED, make("act", "Other"));
  EXPECT_XR(XR_ERROR_LOCALIZED_NAME_DUPLICATED, make("other", "Act"));
  EXPECT_XR(XR_ERROR_NAME_INVALID, make("", "Other"));
  EXPECT_XR(XR_ERROR_LOCALIZED_NAME_INVALID, make("other", ""));
  EXPECT_XR(XR_ERROR_PATH_FORMAT_INVALID, make("Other!", "Other"));
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, make("other", "Other", {chest}));
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, make("other", "Other", {left, left}));
  EXPECT_XR(XR_ERROR_PATH_INVALID, make("other", "Other", {never}));
  EXPECT_XR(XR_ERROR_PATH_INVALID, make("other", "Other", {XR_NULL_PATH}));
  EXPECT_XR(XR_ERROR_VALIDATION_FAILURE, make_action("other", "Other", static_cast<XrActionType>(77), &made));
  XrAction button = XR_NULL_HANDLE, pose = XR_NULL_HANDLE, shake = XR_NULL_HANDLE;
  ASSERT_XR(XR_SUCCESS, make_action("button", "Button", XR_ACTION_TYPE_BOOLEAN_INPUT, &button, {left, right}));
  ASSERT_XR(XR_SUCCESS, make_action("pose", "Pose", XR_ACTION_TYPE_POSE_INPUT, &pose, {left, right}));
  ASSERT_XR(XR_SUCCESS, make_action("shake", "Shake", XR_ACTION_TYPE_VIBRATION_OUTPUT, &shake, {left, right}));
  const auto suggest = [&](XrPath profile, XrPath source) {
    const XrActionSuggestedBinding bindings[]{{button, source}, {button, path("/user/hand/right/input/menu/click")}};
    const XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING, nullptr, profile, 2,
                                                    bindings};
    return CALL(xrSuggestInteractionProfileBindings, instance, &info);
  };
  const XrPath simple = path("/interaction_profiles/khr/simple_controller");
  const XrPath select = path("/user/hand/left/input/select/click");
  EXPECT_XR(XR_ERROR_PATH_INVALID, suggest(never, select));
  EXPECT_XR(XR_ERROR_PATH_UNSUPPORTED, suggest(chest, select));
  EXPECT_XR(XR_SUCCESS, suggest(simple, select));

  XrActionSpaceCreateInfo space_info{XR_TYPE_ACTION_SPACE_CREATE_INFO, nullptr, button, XR_NULL_PATH, identity_pose};
  REFUSED_INFO(ACTION_TYPE_MISMATCH, xrCreateActionSpace, session, space_info);
  space_info.action = pose;
  space_info.subactionPath = never;
  REFUSED_INFO(PATH_INVALID, xrCreateActionSpace, session, space_info);
  space_info.subactionPath = chest;
  REFUSED_INFO(PATH_UNSUPPORTED, xrCreateActionSpace, session, space_info);
  space_info.subactionPath = left;
  space_info.poseInActionSpace = {};
  REFUSED_INFO(POSE_INVALID, xrCreateActionSpace, session, space_info);

  XrActiveActionSet active{set, XR_NULL_PATH};
  const XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO, nullptr, 1, &active};
  // A mismatch is none for the action's own type.
  const auto states = [&](XrAction of, XrPath subaction, XrResult refused) {
    const auto expected = [&](bool own) {
      return own && refused == XR_ERROR_ACTION_TYPE_MISMATCH ? XR_SUCCESS : refused;
    };
    const XrActionStateGetInfo info{XR_TYPE_ACTION_STATE_GET_INFO, nullptr, of, subaction};
    const auto get = [&](const char* name, auto call) { return note(name, result_of(call, session, info)); };
    EXPECT_XR(expected(of == button), get("xrGetActionStateBoolean", XR(xrGetActionStateBoolean)));
    EXPECT_XR(refused, get("xrGetActionStateFloat", XR(xrGetActionStateFloat)));
    EXPECT_XR(refused, get("xrGetActionStateVector2f", XR(xrGetActionStateVector2f)));
    EXPECT_XR(expected(of == pose), get("xrGetActionStatePose", XR(xrGetActionStatePose)));
    const XrHapticActionInfo haptic{XR_TYPE_HAPTIC_ACTION_INFO, nullptr, of, subaction};
    const XrHapticVibration vibration{XR_TYPE_HAPTIC_VIBRATION, nullptr, 1, 0.0F, 0.5F};
    EXPECT_XR(refused,
              CALL(xrApplyHapticFeedback, session, &haptic, reinterpret_cast<const XrHapticBaseHeader*>(&vibration)));
    EXPECT_XR(refused, CALL(xrStopHapticFeedback, session, &haptic));
  };
  const auto others = [&](XrPath top_level, XrResult of_profile, XrPath source, XrResult of_name) {
    XrInteractionProfileState profile{XR_TYPE_INTERACTION_PROFILE_STATE};
    EXPECT_XR(of_profile, CALL(xrGetCurrentInteractionProfile, session, top_level, &profile));
    const XrInputSourceLocalizedNameGetInfo name{XR_TYPE_INPUT_SOURCE_LOCALIZED_NAME_GET_INFO, nullptr, source, 7};
    char text[2];
    EXPECT_XR(of_name, CALL(xrGetInputSourceLocalizedName, session, &name, 2, &count, text));
    const XrBoundSourcesForActionEnumerateInfo bound{XR_TYPE_BOUND_SOURCES_FOR_ACTION_ENUMERATE_INFO, nullptr, button};
    XrPath one = XR_NULL_PATH;
    CALL(xrEnumerateBoundSourcesForAction, session, &bound, 1, &count, &one);
  };
  REFUSED(ACTIONSET_NOT_ATTACHED, xrSyncActions, session, &sync);  // nothing is attached
  for (const XrAction of : {button, pose}) states(of, XR_NULL_PATH, XR_ERROR_ACTIONSET_NOT_ATTACHED);
  others(left, XR_ERROR_ACTIONSET_NOT_ATTACHED, select, XR_ERROR_ACTIONSET_NOT_ATTACHED);
  const XrSessionActionSetsAttachInfo attach{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO, nullptr, 1, &set};
  ASSERT_XR(XR_SUCCESS, CALL(xrAttachSessionActionSets, session, &attach));
  REFUSED(ACTIONSETS_ALREADY_ATTACHED, xrAttachSessionActionSets, session, &attach);
  EXPECT_XR(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, make("late", "Late"));
  EXPECT_XR(XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, suggest(simple, select));
  active.subactionPath = never;
  REFUSED(PATH_INVALID, xrSyncActions, session, &sync);
  active.subactionPath = chest;
  REFUSED(PATH_UNSUPPORTED, xrSyncActions, session, &sync);
  for (const XrAction of : {button, pose}) {
    states(of, XR_NULL_PATH, XR_ERROR_ACTION_TYPE_MISMATCH);
    states(of, never, XR_ERROR_PATH_INVALID);
    states(of, chest, XR_ERROR_PATH_UNSUPPORTED);
  }
  focus();
  for (const XrPath side : {left, right}) CALL(xrSetInputDeviceActiveEXT, session, simple, side, XR_TRUE);
  active.subactionPath = XR_NULL_PATH;
  CALL(xrSyncActions, session, &sync);
  others(left, XR_SUCCESS, select, XR_ERROR_SIZE_INSUFFICIENT);
  for (const auto& [bad, code] : {std::pair{never, XR_ERROR_PATH_INVALID}, {chest, XR_ERROR_PATH_UNSUPPORTED}}) {
    others(bad, code, bad, code);
    EXPECT_XR(code, CALL(xrSetInputDeviceActiveEXT, session, simple, bad, XR_TRUE));
    EXPECT_XR(code, CALL(xrSetInputDeviceStateBoolEXT, session, left, bad, XR_TRUE));
    EXPECT_XR(code, CALL(xrSetInputDeviceStateFloatEXT, session, left, bad, 1.0F));
    EXPECT_XR(code, CALL(xrSetInputDeviceStateVector2fEXT, session, left, bad, {}));
    EXPECT_XR(code, CALL(xrSetInputDeviceLocationEXT, session, left, bad, local, identity_pose));
  }
  REFUSED(POSE_INVALID, xrSetInputDeviceLocationEXT, session, left, path("/user/hand/left/input/grip/pose"), local, {});
}

TEST_F(MockErrors, AreThoseOfTheRegistryAndNoOthers) {
  provoke_at_instance();
  create_session("");
  call_all(true);
  call_all(false);  // READY
  provoke_in_session();
  destroy_session();
  create_session("");
  provoke_actions();
  call_all(false);  // running
  destroy_session();
  create_session(R"(, "hand_tracking": false)");
  destroy_session();
  for (const char* loss : {"lose_session", "lose_instance"}) {
    create_session((std::string(R"(, "events": [{"frame": 1, "do": ")") + loss + "\"}]").c_str());
    focus();
    XrFrameState frame{XR_TYPE_FRAME_STATE};
    CALL(xrWaitFrame, session, nullptr, &frame);
    call_all(false);
    destroy_session();
  }
  ASSERT_XR(XR_SUCCESS, CALL(xrDestroyInstance, instance));
  ASSERT_XR(XR_SUCCESS, create_direct({}, XR_MAKE_VERSION(1, 0, 20)));  // without XR_MND_headless
  REFUSED_INFO(GRAPHICS_DEVICE_INVALID, xrCreateSession, instance, {XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, 1});
  EXPECT_XR(XR_SUCCESS, CALL(xrDestroyInstance, instance));

  const auto words = [](std::string_view text) {
    std::istringstream stream{std::string(text)};
    std::set<std::string> found;
    for (std::string word; stream >> word;) found.insert(word);
    return found;
  };
  constexpr const char* names[] = {
#define HRT_NAME(name, implementation, extension, returned) #name,
      HRT_MOCK_FUNCTIONS(HRT_NAME)
#undef HRT_NAME
  };
  std::set<const Reason*> used;
  for (std::size_t id = 0; id < static_cast<std::size_t>(FunctionId::count); ++id) {
    const std::string function = names[id];
    const std::set<std::string> listed = words(registry_errors(static_cast<FunctionId>(id)));
    if (listed.empty()) continue;
    for (const std::string& code : produced[function])
      EXPECT_TRUE(listed.contains(code)) << function << " gives " << code << ", which the registry does not list";
    for (const std::string& code : listed) {
      const Reason* reason = nullptr;
      for (const Reason& each : reasons)
        if ((words(each.functions).contains(function) || words(each.functions).contains("*")) &&
            words(each.codes).contains(code))
          reason = &each;
      const bool given = produced[function].contains(code);
      EXPECT_TRUE(given || reason != nullptr) << function << " never gives " << code;
      if (reason != nullptr && !given) used.insert(reason);
    }
  }
  for (const Reason& each : reasons) EXPECT_TRUE(used.contains(&each)) << each.functions << ": " << each.codes;
}

}  // namespace
}  // namespace hrt::mock
