// A second OpenXR runtime, for the tests of the capture: as little as an application needs that locates
// hands and has controllers. It shares no code with the mock runtime, and nothing here follows its rules:
// joints are closed formulas with bits that no arithmetic gives, clocks start late and jump, states come
// late.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

#include "samples/mock_runtime/openxr_all.h"

namespace {

struct LoaderInfo {
  std::uint32_t type, version;
  std::size_t size;
  std::uint32_t min, max;
  XrVersion min_api, max_api;
};
struct RuntimeRequest {
  std::uint32_t type, version;
  std::size_t size;
  std::uint32_t interface_version;
  XrVersion api_version;
  PFN_xrGetInstanceProcAddr get_instance_proc_addr;
};

constexpr XrTime epoch = 86'400'123'456'789;

struct {
  int polls = 0;  // in this session
  int frames = 0;
  bool running = false;
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
  XrSessionState asked = XR_SESSION_STATE_UNKNOWN;
  std::uint64_t handles = 100;
  std::map<std::uint64_t, XrReferenceSpaceCreateInfo> spaces;
  std::map<std::uint64_t, XrHandEXT> trackers;
  std::map<std::uint64_t, XrActionSpaceCreateInfo> action_spaces;
  std::map<std::string, XrPath> paths;
  int conversions = 0;
} the;

XrSession the_session() {
  return reinterpret_cast<XrSession>(std::uint64_t{7});
}

// 72 Hz, uneven, with a jump of two seconds.
XrTime time_of(int frame) {
  return epoch + frame * 13'888'888LL + (frame * 7919 % 1000) * 1000 + (frame > 30 ? 2'000'000'000 : 0);
}

float from_bits(std::uint32_t bits) {
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::uint32_t hash(std::uint64_t x) {
  x ^= x >> 33U;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33U;
  return static_cast<std::uint32_t>(x * 0xc4ceb9fe1a85ec53ULL >> 32U);
}

// What an application's calls do here if they do nothing, and if they only make something.
template <typename... Arguments>
XrResult succeed(Arguments...) {
  return XR_SUCCESS;
}
template <typename Parent, typename Info, typename Handle>
XrResult make(Parent, const Info*, Handle* made) {
  *made = reinterpret_cast<Handle>(++the.handles);
  return XR_SUCCESS;
}

XrResult enumerate_extensions(const char*, std::uint32_t capacity, std::uint32_t* count,
                              XrExtensionProperties* properties) {
  const char* names[] = {XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME,
                         XR_KHR_LOCATE_SPACES_EXTENSION_NAME, XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME};
  *count = 4;
  for (std::uint32_t i = 0; capacity >= 4 && i < 4; ++i)
    std::snprintf(properties[i].extensionName, sizeof properties[i].extensionName, "%s", names[i]);
  return XR_SUCCESS;
}

XrResult create_instance(const XrInstanceCreateInfo*, XrInstance* instance) {
  *instance = reinterpret_cast<XrInstance>(std::uint64_t{3});
  return XR_SUCCESS;
}
XrResult get_instance_properties(XrInstance, XrInstanceProperties* properties) {
  properties->runtimeVersion = XR_MAKE_VERSION(4, 5, 6);
  std::snprintf(properties->runtimeName, sizeof properties->runtimeName, "Other \"runtime\"");
  return XR_SUCCESS;
}
XrResult get_system(XrInstance, const XrSystemGetInfo*, XrSystemId* system) {
  *system = 42;
  return XR_SUCCESS;
}
XrResult get_system_properties(XrInstance, XrSystemId, XrSystemProperties* properties) {
  std::snprintf(properties->systemName, sizeof properties->systemName, "Other headset");
  for (auto* next = static_cast<XrBaseOutStructure*>(properties->next); next != nullptr; next = next->next)
    if (next->type == XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT)
      reinterpret_cast<XrSystemHandTrackingPropertiesEXT*>(next)->supportsHandTracking = XR_TRUE;
  return XR_SUCCESS;
}

XrResult report(XrEventDataBuffer* buffer, XrSessionState state) {
  XrEventDataSessionStateChanged event{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED, nullptr, the_session(),
                                       state, time_of(the.frames) + 17};
  std::memcpy(buffer, &event, sizeof event);
  the.state = state;
  return XR_SUCCESS;
}

// Each state comes some polls after its cause.
XrResult poll_event(XrInstance, XrEventDataBuffer* buffer) {
  if (++the.polls % 3 != 0) return XR_EVENT_UNAVAILABLE;
  if (the.state == XR_SESSION_STATE_UNKNOWN) return report(buffer, XR_SESSION_STATE_IDLE);
  if (the.state == XR_SESSION_STATE_IDLE)
    return report(buffer, the.asked == XR_SESSION_STATE_EXITING ? the.asked : XR_SESSION_STATE_READY);
  if (the.running && the.frames >= 1 && the.state == XR_SESSION_STATE_READY)
    return report(buffer, XR_SESSION_STATE_SYNCHRONIZED);
  if (the.frames >= 2 && the.state == XR_SESSION_STATE_SYNCHRONIZED && the.asked != XR_SESSION_STATE_STOPPING)
    return report(buffer, XR_SESSION_STATE_VISIBLE);
  if (the.frames >= 4 && the.state == XR_SESSION_STATE_VISIBLE && the.asked != XR_SESSION_STATE_STOPPING)
    return report(buffer, XR_SESSION_STATE_FOCUSED);
  if (the.asked == XR_SESSION_STATE_STOPPING && the.state != XR_SESSION_STATE_STOPPING)
    return report(buffer, XR_SESSION_STATE_STOPPING);
  static int changed = 0;
  if (the.frames >= 20 && changed++ == 0) {
    XrEventDataReferenceSpaceChangePending event{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING};
    event.session = the_session();
    event.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
    event.changeTime = time_of(23);
    event.poseValid = XR_FALSE;
    event.poseInPreviousSpace.position.y = from_bits(0x7fc12345);
    std::memcpy(buffer, &event, sizeof event);
    return XR_SUCCESS;
  }
  return XR_EVENT_UNAVAILABLE;
}

XrResult create_session(XrInstance, const XrSessionCreateInfo*, XrSession* session) {
  *session = the_session();
  the.state = the.asked = XR_SESSION_STATE_UNKNOWN;
  the.polls = the.frames = 0;
  return XR_SUCCESS;
}
XrResult begin_session(XrSession, const XrSessionBeginInfo*) {
  the.running = true;
  return XR_SUCCESS;
}
XrResult end_session(XrSession) {
  the.running = false;
  the.state = XR_SESSION_STATE_UNKNOWN;
  the.asked = XR_SESSION_STATE_EXITING;
  return XR_SUCCESS;
}
XrResult request_exit_session(XrSession) {
  the.asked = XR_SESSION_STATE_STOPPING;
  return XR_SUCCESS;
}

XrResult enumerate_reference_spaces(XrSession, std::uint32_t capacity, std::uint32_t* count,
                                    XrReferenceSpaceType* types) {
  *count = 2;
  if (capacity >= 2) {
    types[0] = XR_REFERENCE_SPACE_TYPE_LOCAL;
    types[1] = XR_REFERENCE_SPACE_TYPE_VIEW;
  }
  return XR_SUCCESS;
}
XrResult create_reference_space(XrSession, const XrReferenceSpaceCreateInfo* info, XrSpace* space) {
  the.spaces[++the.handles] = *info;
  *space = reinterpret_cast<XrSpace>(the.handles);
  return XR_SUCCESS;
}
XrResult destroy_space(XrSpace space) {
  the.spaces.erase(reinterpret_cast<std::uint64_t>(space));
  the.action_spaces.erase(reinterpret_cast<std::uint64_t>(space));
  return XR_SUCCESS;
}

// Where a space is in LOCAL, which the formulas below are in. Spaces are not turned here.
XrVector3f origin_of(XrSpace space, XrTime time) {
  if (const auto held = the.action_spaces.find(reinterpret_cast<std::uint64_t>(space));
      held != the.action_spaces.end()) {
    const XrVector3f& offset = held->second.poseInActionSpace.position;
    return {offset.x + static_cast<float>(held->second.subactionPath), offset.y,
            offset.z + from_bits(0x3e000000U + static_cast<std::uint32_t>(time % 8'000'000))};
  }
  const XrReferenceSpaceCreateInfo& info = the.spaces[reinterpret_cast<std::uint64_t>(space)];
  XrVector3f origin = info.poseInReferenceSpace.position;
  if (info.referenceSpaceType == XR_REFERENCE_SPACE_TYPE_VIEW)
    origin.y += 0.01F * std::sin(static_cast<float>((time - epoch) % 3'000'000'000) * 1e-9F);
  return origin;
}

// Now and then a space is lost, and its pose is anything.
XrResult locate(XrSpace space, XrSpace base, XrTime time, XrSpaceLocationData& location,
                XrSpaceVelocityData* velocity) {
  const XrVector3f a = origin_of(space, time), b = origin_of(base, time);
  const bool lost =
      the.action_spaces.count(reinterpret_cast<std::uint64_t>(space)) > 0 && the.frames % 7 == 3;
  location.locationFlags =
      lost ? 0 : XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
  location.pose = {{0.0F, 0.0F, -0.0F, 1.0F}, {a.x - b.x, a.y - b.y, a.z - b.z}};
  if (lost) location.pose.position.y = from_bits(0x7fc54321);
  if (velocity != nullptr)
    *velocity = {XR_SPACE_VELOCITY_ANGULAR_VALID_BIT,
                 {from_bits(0xffc00007), 0.0F, 0.0F},
                 {-0.0F, from_bits(hash(static_cast<std::uint64_t>(time))), 1e-42F}};
  return XR_SUCCESS;
}

XrResult locate_space(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* location) {
  XrSpaceLocationData data{};
  XrSpaceVelocityData velocity{};
  locate(space, base, time, data, &velocity);
  location->locationFlags = data.locationFlags;
  location->pose = data.pose;
  if (auto* next = static_cast<XrSpaceVelocity*>(location->next); next != nullptr) {
    next->velocityFlags = velocity.velocityFlags;
    next->linearVelocity = velocity.linearVelocity;
    next->angularVelocity = velocity.angularVelocity;
  }
  return XR_SUCCESS;
}

XrResult locate_spaces(XrSession, const XrSpacesLocateInfo* info, XrSpaceLocations* locations) {
  const auto* velocities = static_cast<XrSpaceVelocities*>(locations->next);
  for (std::uint32_t i = 0; i < info->spaceCount; ++i)
    locate(info->spaces[i], info->baseSpace, info->time, locations->locations[i],
           velocities == nullptr ? nullptr : &velocities->velocities[i]);
  return XR_SUCCESS;
}

// The room is measured again after 20 frames.
XrResult get_bounds(XrSession, XrReferenceSpaceType type, XrExtent2Df* bounds) {
  *bounds = {};
  if (type != XR_REFERENCE_SPACE_TYPE_LOCAL) return XR_SPACE_BOUNDS_UNAVAILABLE;
  *bounds = {the.frames < 20 ? 2.0F : 2.5F, from_bits(0x40490fdb)};
  return XR_SUCCESS;
}

XrResult locate_views(XrSession, const XrViewLocateInfo* info, XrViewState* state, std::uint32_t capacity,
                      std::uint32_t* count, XrView* views) {
  *count = 2;
  state->viewStateFlags = XR_VIEW_STATE_ORIENTATION_VALID_BIT;
  for (std::uint32_t i = 0; i < capacity && i < 2; ++i) {
    views[i].pose = {{0.0F, 0.0F, 0.0F, 1.0F}, origin_of(info->space, info->displayTime)};
    views[i].fov = {-0.7F - 0.1F * static_cast<float>(i), 0.8F, 0.9F, from_bits(0xbf4ccccd)};
  }
  return XR_SUCCESS;
}

XrResult wait_frame(XrSession, const XrFrameWaitInfo*, XrFrameState* state) {
  state->predictedDisplayTime = time_of(++the.frames);
  state->predictedDisplayPeriod = 13'888'888;
  state->shouldRender = the.frames % 2 == 0 ? XR_TRUE : XR_FALSE;
  return XR_SUCCESS;
}

XrResult create_hand_tracker(XrSession, const XrHandTrackerCreateInfoEXT* info, XrHandTrackerEXT* tracker) {
  the.trackers[++the.handles] = info->hand;
  *tracker = reinterpret_cast<XrHandTrackerEXT>(the.handles);
  return XR_SUCCESS;
}

// The wrist circles; a joint now and then has an orientation alone, and anything for a position.
XrResult locate_hand_joints(XrHandTrackerEXT tracker, const XrHandJointsLocateInfoEXT* info,
                            XrHandJointLocationsEXT* locations) {
  const XrHandEXT hand = the.trackers[reinterpret_cast<std::uint64_t>(tracker)];
  if (hand == XR_HAND_LEFT_EXT && the.frames % 25 == 13) return XR_ERROR_RUNTIME_FAILURE;
  locations->isActive =
      the.frames >= 3 && (hand == XR_HAND_RIGHT_EXT || the.frames % 4 != 0) ? XR_TRUE : XR_FALSE;
  const XrVector3f base = origin_of(info->baseSpace, info->time);
  const float seconds = static_cast<float>(info->time - epoch) * 1e-9F;
  auto* velocities = static_cast<XrHandJointVelocitiesEXT*>(locations->next);
  for (std::uint32_t i = 0; i < locations->jointCount; ++i) {
    XrHandJointLocationEXT& joint = locations->jointLocations[i];
    const float phase = seconds * 3.0F + static_cast<float>(i) * 0.2F + static_cast<float>(hand);
    joint.locationFlags = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
                          XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
    joint.pose = {{0.0F, std::sin(phase / 2.0F), -0.0F, std::cos(phase / 2.0F)},
                  {0.1F * std::cos(phase) - base.x, -0.3F - base.y, 0.1F * std::sin(phase) - base.z}};
    const std::uint64_t number = static_cast<std::uint64_t>(the.frames) * 64 + i;
    joint.radius = from_bits(hash(number));  // any bits at all
    if (i == 3) joint.radius = 7.038531e-26F;
    if (hash(number + 1'000'000) % 7 == 0) {
      joint.locationFlags = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
      joint.pose.position = {from_bits(0x7fc00001), from_bits(0xff800000), from_bits(0x00000001)};
    }
    if (velocities != nullptr)
      velocities->jointVelocities[i] = {XR_SPACE_VELOCITY_LINEAR_VALID_BIT,
                                        {-0.3F * std::sin(phase), 0.0F, 0.3F * std::cos(phase)},
                                        {from_bits(hash(number + 77)), 0.0F, -0.0F}};
  }
  return XR_SUCCESS;
}

// XrTime is five days behind the machine's clock, whose time is of no account here.
XrResult to_time(XrInstance, const timespec*, XrTime* time) {
  *time = time_of(the.frames) + ++the.conversions * 1001;
  return XR_SUCCESS;
}
XrResult to_timespec(XrInstance, XrTime time, timespec* clock) {
  const XrTime shifted = time + 5LL * 86'400'000'000'000;
  *clock = {shifted / 1'000'000'000, shifted % 1'000'000'000};
  return XR_SUCCESS;
}

XrResult string_to_path(XrInstance, const char* text, XrPath* path) {
  *path = the.paths.try_emplace(text, 70 + the.paths.size()).first->second;
  return XR_SUCCESS;
}
XrResult path_to_string(XrInstance, XrPath path, std::uint32_t capacity, std::uint32_t* count, char* buffer) {
  for (const auto& [text, known] : the.paths)
    if (known == path)
      *count = static_cast<std::uint32_t>(std::snprintf(buffer, capacity, "%s", text.c_str())) + 1;
  return XR_SUCCESS;
}

XrResult create_action_space(XrSession, const XrActionSpaceCreateInfo* info, XrSpace* space) {
  the.action_spaces[++the.handles] = *info;
  *space = reinterpret_cast<XrSpace>(the.handles);
  return XR_SUCCESS;
}
XrResult sync_actions(XrSession, const XrActionsSyncInfo*) {
  return the.frames < 4 || the.frames % 10 == 9 ? XR_SESSION_NOT_FOCUSED : XR_SUCCESS;
}

// Any bits, of each action, subaction path and frame.
std::uint32_t bits_of(const XrActionStateGetInfo* info, std::uint32_t more = 0) {
  return hash(static_cast<std::uint64_t>(the.frames) * 1'000'000 + info->subactionPath * 1000 +
              reinterpret_cast<std::uint64_t>(info->action) * 7 + more);
}
template <typename State>
void put_common(const XrActionStateGetInfo* info, State* state) {
  state->isActive = bits_of(info, 1) % 5 != 0 ? XR_TRUE : XR_FALSE;
  state->changedSinceLastSync = bits_of(info, 2) % 2;
  state->lastChangeTime = time_of(the.frames) - bits_of(info, 3);
}
XrResult get_boolean(XrSession, const XrActionStateGetInfo* info, XrActionStateBoolean* state) {
  put_common(info, state);
  state->currentState = bits_of(info) % 2;
  return XR_SUCCESS;
}
XrResult get_float(XrSession, const XrActionStateGetInfo* info, XrActionStateFloat* state) {
  put_common(info, state);
  state->currentState = from_bits(bits_of(info));
  return XR_SUCCESS;
}
XrResult get_vector(XrSession, const XrActionStateGetInfo* info, XrActionStateVector2f* state) {
  put_common(info, state);
  state->currentState = {from_bits(bits_of(info)), from_bits(bits_of(info, 4))};
  return XR_SUCCESS;
}
XrResult get_pose(XrSession, const XrActionStateGetInfo* info, XrActionStatePose* state) {
  state->isActive = bits_of(info) % 3 != 0 ? XR_TRUE : XR_FALSE;
  return XR_SUCCESS;
}
XrResult get_profile(XrSession, XrPath, XrInteractionProfileState* state) {
  state->interactionProfile = XR_NULL_PATH;
  if (the.frames < 5) return XR_SUCCESS;
  return string_to_path(XR_NULL_HANDLE,
                        the.frames < 25 ? "/interaction_profiles/khr/simple_controller"
                                        : "/interaction_profiles/other/of_no_registry",
                        &state->interactionProfile);
}

XrResult get_instance_proc_addr(XrInstance, const char* name, PFN_xrVoidFunction* function) {
  static const std::map<std::string, PFN_xrVoidFunction> functions{
#define HRT_FUNCTION(name, implementation) {#name, reinterpret_cast<PFN_xrVoidFunction>(&implementation)}
#define HRT_TEMPLATE(name, implementation) \
  {#name, reinterpret_cast<PFN_xrVoidFunction>(static_cast<PFN_##name>(&implementation))}
      HRT_FUNCTION(xrGetInstanceProcAddr, get_instance_proc_addr),
      HRT_FUNCTION(xrEnumerateInstanceExtensionProperties, enumerate_extensions),
      HRT_FUNCTION(xrCreateInstance, create_instance),
      HRT_TEMPLATE(xrDestroyInstance, succeed),
      HRT_FUNCTION(xrGetInstanceProperties, get_instance_properties),
      HRT_FUNCTION(xrGetSystem, get_system),
      HRT_FUNCTION(xrGetSystemProperties, get_system_properties),
      HRT_FUNCTION(xrPollEvent, poll_event),
      HRT_FUNCTION(xrCreateSession, create_session),
      HRT_TEMPLATE(xrDestroySession, succeed),
      HRT_FUNCTION(xrBeginSession, begin_session),
      HRT_FUNCTION(xrEndSession, end_session),
      HRT_FUNCTION(xrRequestExitSession, request_exit_session),
      HRT_FUNCTION(xrEnumerateReferenceSpaces, enumerate_reference_spaces),
      HRT_FUNCTION(xrCreateReferenceSpace, create_reference_space),
      HRT_FUNCTION(xrDestroySpace, destroy_space),
      HRT_FUNCTION(xrLocateSpace, locate_space),
      HRT_FUNCTION(xrLocateSpacesKHR, locate_spaces),
      HRT_FUNCTION(xrGetReferenceSpaceBoundsRect, get_bounds),
      HRT_FUNCTION(xrConvertTimespecTimeToTimeKHR, to_time),
      HRT_FUNCTION(xrConvertTimeToTimespecTimeKHR, to_timespec),
      HRT_FUNCTION(xrStringToPath, string_to_path),
      HRT_FUNCTION(xrPathToString, path_to_string),
      HRT_TEMPLATE(xrCreateActionSet, make),
      HRT_TEMPLATE(xrCreateAction, make),
      HRT_TEMPLATE(xrSuggestInteractionProfileBindings, succeed),
      HRT_TEMPLATE(xrAttachSessionActionSets, succeed),
      HRT_FUNCTION(xrCreateActionSpace, create_action_space),
      HRT_FUNCTION(xrSyncActions, sync_actions),
      HRT_FUNCTION(xrGetActionStateBoolean, get_boolean),
      HRT_FUNCTION(xrGetActionStateFloat, get_float),
      HRT_FUNCTION(xrGetActionStateVector2f, get_vector),
      HRT_FUNCTION(xrGetActionStatePose, get_pose),
      HRT_FUNCTION(xrGetCurrentInteractionProfile, get_profile),
      HRT_FUNCTION(xrLocateViews, locate_views),
      HRT_FUNCTION(xrWaitFrame, wait_frame),
      HRT_TEMPLATE(xrBeginFrame, succeed),
      HRT_TEMPLATE(xrEndFrame, succeed),
      HRT_FUNCTION(xrCreateHandTrackerEXT, create_hand_tracker),
      HRT_TEMPLATE(xrDestroyHandTrackerEXT, succeed),
      HRT_FUNCTION(xrLocateHandJointsEXT, locate_hand_joints),
#undef HRT_FUNCTION
#undef HRT_TEMPLATE
  };
  const auto found = functions.find(name);
  *function = found == functions.end() ? nullptr : found->second;
  return *function == nullptr ? XR_ERROR_FUNCTION_UNSUPPORTED : XR_SUCCESS;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) XrResult
xrNegotiateLoaderRuntimeInterface(const LoaderInfo*, RuntimeRequest* request) {
  request->interface_version = 1;
  request->api_version = XR_MAKE_VERSION(1, 0, 20);
  request->get_instance_proc_addr = &get_instance_proc_addr;
  return XR_SUCCESS;
}
