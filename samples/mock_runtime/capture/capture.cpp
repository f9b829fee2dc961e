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
    XR_ERROR_VALIDATION_FAILURE,          XR_ERROR_HANDLE_INVALID,         XR_ERROR_SIZE_INSUFFICIENT,
    XR_ERROR_CALL_ORDER_INVALID,          XR_ERROR_SESSION_RUNNING,        XR_ERROR_SESSION_NOT_RUNNING,
    XR_ERROR_SESSION_NOT_READY,           XR_ERROR_SESSION_NOT_STOPPING,   XR_ERROR_PATH_INVALID,
    XR_ERROR_PATH_FORMAT_INVALID,         XR_ERROR_NAME_DUPLICATED,        XR_ERROR_NAME_INVALID,
    XR_ERROR_LOCALIZED_NAME_DUPLICATED,   XR_ERROR_LOCALIZED_NAME_INVALID, XR_ERROR_ACTIONSET_NOT_ATTACHED,
    XR_ERROR_ACTIONSETS_ALREADY_ATTACHED, XR_ERROR_ACTION_TYPE_MISMATCH,   XR_ERROR_POSE_INVALID};

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
  Record record("instance");
  record.add(text_in(properties.runtimeName), properties.runtimeVersion).open();
  for (std::uint32_t i = 0; i < info.enabledExtensionCount; ++i) record.add(info.enabledExtensionNames[i]);
  note(record.close());
  wake();
}

void Capture::instance_destroyed(XrResult, XrInstance) {
  instance_ = XR_NULL_HANDLE;
  in_session_ = false;
  spaces_.clear();
  actions_.clear();
  action_sets_.clear();
  paths_.clear();  // another instance has other ones
  trackers_.clear();
  if (file_ != nullptr) file_->flush();
}

std::uint64_t Capture::session_of_call() {
  const std::lock_guard lock(mutex);
  return sessions_ + (in_session_ ? 0 : 1);
}

void Capture::called(const char* function, std::uint64_t session, XrResult result) {
  const std::uint64_t call = ++calls_[{session, function}];
  if (XR_SUCCEEDED(result) || std::find(std::begin(mistakes), std::end(mistakes), result) != std::end(mistakes)) return;
  note(Record("failed").add(session, function, call, result));
}

void Capture::system_properties(XrResult, XrInstance, XrSystemId, const XrSystemProperties* properties) {
  const auto* hands = chained<XrSystemHandTrackingPropertiesEXT>(properties->next);
  const bool has_hands = hands == nullptr || hands->supportsHandTracking == XR_TRUE;
  note(Record("system").add(text_in(properties->systemName), has_hands));
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
  Record record = of_session("spaces");
  record.open();
  for (const XrReferenceSpaceType type : types) record.add(type);
  note(record.close());
}

void Capture::session_destroyed(XrResult, XrSession) {
  in_session_ = false;
  stages_ = frames_ = 0;
  spaces_.clear();
  trackers_.clear();
  wake();
}

void Capture::stage(const char* call) {
  note(of_session("call").add(call));
  ++stages_;
  frames_ = 0;
  wake();
}

// When it came: after so many calls that change the session's state, and so many frames since.
void Capture::event(XrResult result, XrInstance, const XrEventDataBuffer* buffer) {
  if (result != XR_SUCCESS) return;
  Record record("event");
  record.add(sessions_ + (in_session_ ? 0 : 1), stages_, frames_);
  const auto as = [&]<typename Event>() { return reinterpret_cast<const Event&>(*buffer); };
  switch (static_cast<int>(buffer->type)) {
    case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED: {
      const auto& event = as.operator()<XrEventDataSessionStateChanged>();
      record.add("state", event.state, event.time);
      break;
    }
    case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING: {
      const auto& event = as.operator()<XrEventDataReferenceSpaceChangePending>();
      record.add("space_change", event.referenceSpaceType, event.changeTime, event.poseValid == XR_TRUE);
      record.nest(event.poseInPreviousSpace);
      break;
    }
    case XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED:
      record.add("profile_change");
      break;
    case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
      record.add("instance_loss", as.operator()<XrEventDataInstanceLossPending>().lossTime);
      break;
    case XR_TYPE_EVENT_DATA_EVENTS_LOST:
      record.add("events_lost", as.operator()<XrEventDataEventsLost>().lostEventCount);
      break;
    default:
      record.add("other", buffer->type);
  }
  note(record);
}

void Capture::frame(XrResult, XrSession, const XrFrameWaitInfo*, const XrFrameState* state) {
  const bool renders = state->shouldRender == XR_TRUE;
  note(of_session("frame").add(state->predictedDisplayTime, state->predictedDisplayPeriod, renders));
  ++frames_;
  if (state->predictedDisplayTime > 0) present_ = state->predictedDisplayTime;
  wake();
}

void Capture::converted(XrResult, XrInstance, const timespec*, const XrTime* time) {
  if (!in_session_) return;
  note(of_session("converted").add(*time));
  present_ = *time;
  wake();
}

void Capture::converted_back(XrResult, XrInstance, XrTime time, const timespec* clock) {
  if (!in_session_) return;
  // Unsigned, since a runtime may return anything.
  const auto ns =
      static_cast<std::uint64_t>(clock->tv_sec) * 1'000'000'000 + static_cast<std::uint64_t>(clock->tv_nsec);
  note(of_session("timespec").add(time, static_cast<std::int64_t>(ns)));
}

// Spaces.

void Capture::define_space(XrSpace handle, const Record& description) {
  const auto [known, is_new] = known_spaces_.try_emplace(description.text(), known_spaces_.size());
  spaces_[handle] = known->second;
  if (is_new) note(description);
}

void Capture::reference_space(XrResult, XrSession, const XrReferenceSpaceCreateInfo* info, const XrSpace* space) {
  define_space(*space, Record("reference_space").add(info->referenceSpaceType).nest(info->poseInReferenceSpace));
}

void Capture::action_space(XrResult, XrSession, const XrActionSpaceCreateInfo* info, const XrSpace* space) {
  Record record("action_space");
  record.add(actions_[info->action], path_text(info->subactionPath)).nest(info->poseInActionSpace);
  define_space(*space, record);
}

void Capture::bounds(XrResult result, XrSession, XrReferenceSpaceType type, const XrExtent2Df* extent) {
  note(of_session("bounds").add(type, result == XR_SUCCESS, extent->width, extent->height));
}

void Capture::note_location(XrSpace space, XrSpace base, XrTime time, const XrSpaceLocation& location,
                            const XrSpaceVelocity* velocity) {
  const auto what = spaces_.find(space), in = spaces_.find(base);
  if (what == spaces_.end() || in == spaces_.end()) return;
  Record record = of_session("located");
  record.add(time, what->second, in->second, location.locationFlags).nest(location.pose);
  if (velocity != nullptr)
    record.add(velocity->velocityFlags).nest(velocity->linearVelocity, velocity->angularVelocity);
  note(record);
}

void Capture::located(XrResult, XrSpace space, XrSpace base, XrTime time, const XrSpaceLocation* location) {
  note_location(space, base, time, *location, chained<XrSpaceVelocity>(location->next));
}

void Capture::located_several(XrResult, XrSession, const XrSpacesLocateInfo* info, const XrSpaceLocations* locations) {
  const auto* velocities = chained<XrSpaceVelocities>(locations->next);
  for (std::uint32_t i = 0; i < info->spaceCount; ++i) {
    const XrSpaceLocationData& data = locations->locations[i];
    XrSpaceVelocity velocity{XR_TYPE_SPACE_VELOCITY};
    if (velocities != nullptr) {
      const auto& [flags, linear, angular] = velocities->velocities[i];
      velocity = {XR_TYPE_SPACE_VELOCITY, nullptr, flags, linear, angular};
    }
    note_location(info->spaces[i], info->baseSpace, info->time,
                  {XR_TYPE_SPACE_LOCATION, nullptr, data.locationFlags, data.pose},
                  velocities == nullptr ? nullptr : &velocity);
  }
}

void Capture::views(XrResult, XrSession, const XrViewLocateInfo* info, const XrViewState* state, std::uint32_t capacity,
                    const std::uint32_t* count, const XrView* views) {
  const auto in = spaces_.find(info->space);
  if (capacity == 0 || in == spaces_.end()) return;
  Record record = of_session("views");
  record.add(info->displayTime, in->second, state->viewStateFlags).open();
  for (std::uint32_t i = 0; i < *count; ++i) {
    const XrFovf& fov = views[i].fov;
    record.add(views[i].pose, fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown);
  }
  note(record.close());
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
  Record record = of_session("joints");
  const bool active = locations->isActive == XR_TRUE;
  record.add(info->time, hand->second, in->second, active, 0);
  if (active) {
    record.open();
    for (std::uint32_t i = 0; i < locations->jointCount; ++i) {
      const XrHandJointLocationEXT& joint = locations->jointLocations[i];
      record.add(joint.locationFlags, joint.pose, joint.radius);
    }
    record.close();
    if (const auto* velocities = chained<XrHandJointVelocitiesEXT>(locations->next)) {
      record.open();
      for (std::uint32_t i = 0; i < velocities->jointCount; ++i) {
        const XrHandJointVelocityEXT& joint = velocities->jointVelocities[i];
        record.add(joint.velocityFlags, joint.linearVelocity, joint.angularVelocity);
      }
      record.close();
    }
  }
  note(record);
}

// Actions.

const std::string& Capture::path_text(XrPath path) {
  const auto [known, is_new] = paths_.try_emplace(path);
  char text[XR_MAX_PATH_LENGTH] = "";
  std::uint32_t count = 0;
  if (is_new && path != XR_NULL_PATH && next.xrPathToString != nullptr &&
      XR_SUCCEEDED(next.xrPathToString(instance_, path, sizeof text, &count, text)))
    known->second = text;
  return known->second;
}

void Capture::action_set(XrResult, XrInstance, const XrActionSetCreateInfo* info, const XrActionSet* set) {
  action_sets_[*set] = text_in(info->actionSetName);
}

void Capture::action(XrResult, XrActionSet set, const XrActionCreateInfo* info, const XrAction* action) {
  actions_[*action] = action_sets_[set] + "/" + std::string(text_in(info->actionName));
}

void Capture::synced(XrResult result, XrSession, const XrActionsSyncInfo*) {
  note(of_session("synced").add(present_, result == XR_SUCCESS));
}

template <typename State>
void Capture::note_state(const XrActionStateGetInfo& info, const State& state, XrVector2f value) {
  Record record = of_session("action");
  record.add(present_, actions_[info.action], path_text(info.subactionPath), state.isActive == XR_TRUE);
  note(record.add(state.changedSinceLastSync == XR_TRUE, state.lastChangeTime, value.x, value.y));
}

void Capture::boolean_state(XrResult, XrSession, const XrActionStateGetInfo* info, const XrActionStateBoolean* state) {
  note_state(*info, *state, {state->currentState == XR_TRUE ? 1.0F : 0.0F, 0.0F});
}

void Capture::float_state(XrResult, XrSession, const XrActionStateGetInfo* info, const XrActionStateFloat* state) {
  note_state(*info, *state, {state->currentState, 0.0F});
}

void Capture::vector_state(XrResult, XrSession, const XrActionStateGetInfo* info, const XrActionStateVector2f* state) {
  note_state(*info, *state, state->currentState);
}

void Capture::pose_state(XrResult, XrSession, const XrActionStateGetInfo* info, const XrActionStatePose* state) {
  const XrActionStateFloat without_value{.isActive = state->isActive};
  note_state(*info, without_value, {0.0F, 0.0F});
}

void Capture::profile(XrResult, XrSession, XrPath top_level, const XrInteractionProfileState* state) {
  note(of_session("profile").add(present_, path_text(top_level), path_text(state->interactionProfile)));
}

// XR_HRTX_ridged_plate.

void Capture::plate_orientation(XrResult, XrSession, XrTime time, const double* orientation) {
  note(of_session("plate").add(time, *orientation));
}

void Capture::reach_truth(XrResult, XrSession, XrHandEXT hand, const XrReachTruthHRTX* truth) {
  Record record = of_session("truth");
  record.add(present_, hand);
  record.nest(truth->trueDirection, truth->perceivedDirection, truth->peakFeltError, truth->leftmostDirection,
              truth->rightmostDirection, truth->tactileWeight);
  note(record.nest(truth->indexTip).add(truth->isDone == XR_TRUE));
}

}  // namespace hrt::capture
