// A second OpenXR runtime, for the tests of the capture: as little as an application needs that locates
// hands. It shares no code with the mock runtime, and nothing here follows its rules: joints are closed
// formulas with bits that no arithmetic gives, clocks start late and jump, states come late.
#include <openxr/openxr.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

namespace {

struct LoaderInfo {
  std::uint32_t type, version;
  std::size_t size;
  std::uint32_t least, most;
  XrVersion least_api, most_api;
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

XrResult enumerate_extensions(const char*, std::uint32_t capacity, std::uint32_t* count,
                              XrExtensionProperties* properties) {
  const char* names[] = {XR_MND_HEADLESS_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME};
  *count = 2;
  for (std::uint32_t i = 0; capacity >= 2 && i < 2; ++i)
    std::snprintf(properties[i].extensionName, sizeof properties[i].extensionName, "%s", names[i]);
  return XR_SUCCESS;
}

XrResult create_instance(const XrInstanceCreateInfo*, XrInstance* instance) {
  *instance = reinterpret_cast<XrInstance>(std::uint64_t{3});
  return XR_SUCCESS;
}
XrResult destroy_instance(XrInstance) {
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
XrResult destroy_session(XrSession) {
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
  return XR_SUCCESS;
}

// Where a space is in LOCAL, which the formulas below are in. Spaces are not turned here.
XrVector3f origin_of(XrSpace space, XrTime time) {
  const XrReferenceSpaceCreateInfo& info = the.spaces[reinterpret_cast<std::uint64_t>(space)];
  XrVector3f origin = info.poseInReferenceSpace.position;
  if (info.referenceSpaceType == XR_REFERENCE_SPACE_TYPE_VIEW)
    origin.y += 0.01F * std::sin(static_cast<float>((time - epoch) % 3'000'000'000) * 1e-9F);
  return origin;
}

XrResult locate_space(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* location) {
  const XrVector3f a = origin_of(space, time), b = origin_of(base, time);
  location->locationFlags = XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
  location->pose = {{0.0F, 0.0F, -0.0F, 1.0F}, {a.x - b.x, a.y - b.y, a.z - b.z}};
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
XrResult begin_frame(XrSession, const XrFrameBeginInfo*) {
  return XR_SUCCESS;
}
XrResult end_frame(XrSession, const XrFrameEndInfo*) {
  return XR_SUCCESS;
}

XrResult create_hand_tracker(XrSession, const XrHandTrackerCreateInfoEXT* info, XrHandTrackerEXT* tracker) {
  the.trackers[++the.handles] = info->hand;
  *tracker = reinterpret_cast<XrHandTrackerEXT>(the.handles);
  return XR_SUCCESS;
}
XrResult destroy_hand_tracker(XrHandTrackerEXT) {
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

XrResult get_instance_proc_addr(XrInstance, const char* name, PFN_xrVoidFunction* function) {
  static const std::map<std::string, PFN_xrVoidFunction> functions{
#define HRT_FUNCTION(name, implementation) {#name, reinterpret_cast<PFN_xrVoidFunction>(&implementation)}
      HRT_FUNCTION(xrGetInstanceProcAddr, get_instance_proc_addr),
      HRT_FUNCTION(xrEnumerateInstanceExtensionProperties, enumerate_extensions),
      HRT_FUNCTION(xrCreateInstance, create_instance),
      HRT_FUNCTION(xrDestroyInstance, destroy_instance),
      HRT_FUNCTION(xrGetInstanceProperties, get_instance_properties),
      HRT_FUNCTION(xrGetSystem, get_system),
      HRT_FUNCTION(xrGetSystemProperties, get_system_properties),
      HRT_FUNCTION(xrPollEvent, poll_event),
      HRT_FUNCTION(xrCreateSession, create_session),
      HRT_FUNCTION(xrDestroySession, destroy_session),
      HRT_FUNCTION(xrBeginSession, begin_session),
      HRT_FUNCTION(xrEndSession, end_session),
      HRT_FUNCTION(xrRequestExitSession, request_exit_session),
      HRT_FUNCTION(xrEnumerateReferenceSpaces, enumerate_reference_spaces),
      HRT_FUNCTION(xrCreateReferenceSpace, create_reference_space),
      HRT_FUNCTION(xrDestroySpace, destroy_space),
      HRT_FUNCTION(xrLocateSpace, locate_space),
      HRT_FUNCTION(xrLocateViews, locate_views),
      HRT_FUNCTION(xrWaitFrame, wait_frame),
      HRT_FUNCTION(xrBeginFrame, begin_frame),
      HRT_FUNCTION(xrEndFrame, end_frame),
      HRT_FUNCTION(xrCreateHandTrackerEXT, create_hand_tracker),
      HRT_FUNCTION(xrDestroyHandTrackerEXT, destroy_hand_tracker),
      HRT_FUNCTION(xrLocateHandJointsEXT, locate_hand_joints),
#undef HRT_FUNCTION
  };
  const auto found = functions.find(name);
  *function = found == functions.end() ? nullptr : found->second;
  return *function == nullptr ? XR_ERROR_FUNCTION_UNSUPPORTED : XR_SUCCESS;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) XrResult xrNegotiateLoaderRuntimeInterface(
    const LoaderInfo*, RuntimeRequest* request) {
  request->interface_version = 1;
  request->api_version = XR_CURRENT_API_VERSION;
  request->get_instance_proc_addr = &get_instance_proc_addr;
  return XR_SUCCESS;
}
