#include "samples/mock_runtime/capture/capture.h"

#include <algorithm>
#include <iterator>

#include "samples/mock_runtime/abi/structure.h"

namespace hrt::capture {
namespace {

using mock::chained;
using mock::text_in;

// Errors that a mistake of the application causes: the playback finds it in the calls themselves.
constexpr XrResult mistakes[] = {
    XR_ERROR_VALIDATION_FAILURE, XR_ERROR_HANDLE_INVALID,       XR_ERROR_SIZE_INSUFFICIENT,
    XR_ERROR_CALL_ORDER_INVALID, XR_ERROR_SESSION_RUNNING,      XR_ERROR_SESSION_NOT_RUNNING,
    XR_ERROR_SESSION_NOT_READY,  XR_ERROR_SESSION_NOT_STOPPING, XR_ERROR_POSE_INVALID};

}  // namespace

void Capture::open(const std::string& path) {
  if (path == path_) return;
  file_ = std::make_unique<ScriptFile>(path);
  path_ = path;
  sessions_ = 0;
  calls_.clear();
  known_spaces_.clear();
}

void Capture::instance_created(XrInstance instance, const XrInstanceCreateInfo& info) {
  instance_ = instance;
  XrInstanceProperties properties{XR_TYPE_INSTANCE_PROPERTIES};
  if (next.xrGetInstanceProperties != nullptr) next.xrGetInstanceProperties(instance, &properties);
  const std::vector<std::string> extensions(info.enabledExtensionNames,
                                            info.enabledExtensionNames + info.enabledExtensionCount);
  note(array_of("instance", text_in(properties.runtimeName), properties.runtimeVersion, extensions));
  write();
}

void Capture::instance_destroyed(XrResult, XrInstance) {
  instance_ = XR_NULL_HANDLE;
  in_session_ = false;
  spaces_.clear();
  trackers_.clear();
  write();
}

std::uint64_t Capture::session_of_call() {
  const std::lock_guard lock(mutex);
  return sessions_ + (in_session_ ? 0 : 1);
}

void Capture::called(const char* function, std::uint64_t session, XrResult result) {
  const std::uint64_t call = ++calls_[{session, function}];
  if (XR_SUCCEEDED(result) || std::find(std::begin(mistakes), std::end(mistakes), result) != std::end(mistakes)) return;
  note(array_of("failed", session, function, call, result));
  write();
}

void Capture::system_properties(XrResult, XrInstance, XrSystemId, const XrSystemProperties* properties) {
  const auto* hands = chained<XrSystemHandTrackingPropertiesEXT>(properties->next);
  const bool has_hands = hands == nullptr || hands->supportsHandTracking == XR_TRUE;
  note(array_of("system", text_in(properties->systemName), has_hands));
}

void Capture::session_created(XrResult, XrInstance, const XrSessionCreateInfo*, const XrSession* session) {
  ++sessions_;
  in_session_ = true;
  stages_ = frames_ = 0;
  present_ = 0;
  std::uint32_t count = 0;
  if (next.xrEnumerateReferenceSpaces == nullptr ||
      XR_FAILED(next.xrEnumerateReferenceSpaces(*session, 0, &count, nullptr)))
    return;
  std::vector<XrReferenceSpaceType> types(count);
  if (XR_FAILED(next.xrEnumerateReferenceSpaces(*session, count, &count, types.data()))) return;
  note_of_session("spaces", std::vector<int>(types.begin(), types.end()));
}

void Capture::session_destroyed(XrResult, XrSession) {
  in_session_ = false;
  stages_ = frames_ = 0;
  spaces_.clear();
  trackers_.clear();
  write();
}

void Capture::stage(const char* call) {
  note_of_session("call", call);
  ++stages_;
  frames_ = 0;
  write();
}

// When it came: after so many calls that change the session's state, and so many frames since.
void Capture::event(XrResult result, XrInstance, const XrEventDataBuffer* buffer) {
  if (result != XR_SUCCESS) return;
  const auto note_event = [&](const auto&... values) {
    note(array_of("event", sessions_ + (in_session_ ? 0 : 1), stages_, frames_, values...));
  };
  const auto as = [&]<typename Event>() { return reinterpret_cast<const Event&>(*buffer); };
  switch (static_cast<int>(buffer->type)) {
    case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED: {
      const auto& event = as.operator()<XrEventDataSessionStateChanged>();
      return note_event("state", event.state, event.time);
    }
    case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING: {
      const auto& event = as.operator()<XrEventDataReferenceSpaceChangePending>();
      return note_event("space_change", event.referenceSpaceType, event.changeTime, event.poseValid == XR_TRUE,
                        array_of(event.poseInPreviousSpace));
    }
    case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
      return note_event("instance_loss", as.operator()<XrEventDataInstanceLossPending>().lossTime);
    default:
      return note_event("other", buffer->type);
  }
}

void Capture::frame(XrResult, XrSession, const XrFrameWaitInfo*, const XrFrameState* state) {
  note_of_session("frame", state->predictedDisplayTime, state->predictedDisplayPeriod, state->shouldRender == XR_TRUE);
  ++frames_;
  if (state->predictedDisplayTime > 0) present_ = state->predictedDisplayTime;
  write();
}

void Capture::converted(XrResult, XrInstance, const timespec*, const XrTime* time) {
  if (!in_session_) return;
  note_of_session("converted", *time);
  present_ = *time;
  write();
}

// Spaces.

void Capture::define_space(XrSpace handle, const Json& description) {
  const auto [known, is_new] = known_spaces_.try_emplace(description.dump(), known_spaces_.size());
  spaces_[handle] = known->second;
  if (is_new) note(description);
}

void Capture::reference_space(XrResult, XrSession, const XrReferenceSpaceCreateInfo* info, const XrSpace* space) {
  define_space(*space, array_of("reference_space", info->referenceSpaceType, array_of(info->poseInReferenceSpace)));
}

void Capture::located(XrResult, XrSpace space, XrSpace base, XrTime time, const XrSpaceLocation* location) {
  const auto what = spaces_.find(space), in = spaces_.find(base);
  if (what == spaces_.end() || in == spaces_.end()) return;
  Json record =
      array_of("located", sessions_, time, what->second, in->second, location->locationFlags, array_of(location->pose));
  if (const auto* velocity = chained<XrSpaceVelocity>(location->next))
    append(record, velocity->velocityFlags, array_of(velocity->linearVelocity, velocity->angularVelocity));
  note(record);
}

void Capture::views(XrResult, XrSession, const XrViewLocateInfo* info, const XrViewState* state, std::uint32_t capacity,
                    const std::uint32_t* count, const XrView* views) {
  const auto in = spaces_.find(info->space);
  if (capacity == 0 || in == spaces_.end()) return;
  Json given = Json::array();
  for (std::uint32_t i = 0; i < *count; ++i) {
    const XrFovf& fov = views[i].fov;
    append(given, views[i].pose, fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown);
  }
  note_of_session("views", info->displayTime, in->second, state->viewStateFlags, given);
}

// Hands.

void Capture::hand_tracker(XrResult, XrSession, const XrHandTrackerCreateInfoEXT* info,
                           const XrHandTrackerEXT* tracker) {
  trackers_[*tracker] = info->hand;
}

void Capture::joints(XrResult, XrHandTrackerEXT tracker, const XrHandJointsLocateInfoEXT* info,
                     const XrHandJointLocationsEXT* locations) {
  const auto in = spaces_.find(info->baseSpace);
  const auto hand = trackers_.find(tracker);
  if (in == spaces_.end() || hand == trackers_.end()) return;
  const bool active = locations->isActive == XR_TRUE;
  Json record = array_of("joints", sessions_, info->time, hand->second, in->second, active, 0);
  const auto append_joints = [&](std::uint32_t count, auto append_joint) {
    Json joints = Json::array();
    for (std::uint32_t i = 0; active && i < count; ++i) append_joint(joints, i);
    if (active) record.push_back(std::move(joints));
  };
  append_joints(locations->jointCount, [&](Json& to, std::uint32_t i) {
    const XrHandJointLocationEXT& joint = locations->jointLocations[i];
    append(to, joint.locationFlags, joint.pose, joint.radius);
  });
  if (const auto* velocities = chained<XrHandJointVelocitiesEXT>(locations->next))
    append_joints(velocities->jointCount, [&](Json& to, std::uint32_t i) {
      const XrHandJointVelocityEXT& joint = velocities->jointVelocities[i];
      append(to, joint.velocityFlags, joint.linearVelocity, joint.angularVelocity);
    });
  note(record);
}

// XR_HRTX_ridged_plate.

void Capture::plate_orientation(XrResult, XrSession, XrTime time, const double* orientation) {
  note_of_session("plate", time, *orientation);
}

void Capture::reach_truth(XrResult, XrSession, XrHandEXT hand, const XrReachTruthHRTX* truth) {
  note_of_session("truth", present_, hand,
                  array_of(truth->trueDirection, truth->perceivedDirection, truth->peakFeltError,
                           truth->leftmostDirection, truth->rightmostDirection, truth->tactileWeight),
                  array_of(truth->indexTip), truth->isDone == XR_TRUE);
}

}  // namespace hrt::capture
