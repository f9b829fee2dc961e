#include "samples/app/xr/session.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <thread>

#include "samples/app/base/exit_code.h"
#include "samples/app/base/interrupt.h"
#include "samples/app/base/say.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

using namespace std::chrono_literals;

constexpr auto poll_period = 2ms;                // period of event polling while there is no frame
constexpr auto own_frame_period = 11'111'111ns;  // 90 Hz, for a runtime whose frames have no times
constexpr int max_skipped_frames = 90;           // largest number of invalid frames in a row
constexpr XrDuration max_step_ns = 5'000'000'000, max_refused_ns = 1'000'000'000;
constexpr float max_position_m = 100.0f;  // a larger distance of a fingertip from the plate is impossible

[[noreturn]] void fail(const std::string& sentence) { throw Failure(ExitCode::runtime_failed, sentence); }

std::string within(std::chrono::milliseconds limit) {
  return format("within %g s", static_cast<double>(limit.count()) * 1e-3);
}

bool can_be_observed(const XrHandJointLocationEXT& joint) {
  constexpr XrSpaceLocationFlags needed = XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  return (joint.locationFlags & needed) == needed;
}

constexpr XrEnvironmentBlendMode blend_mode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
constexpr XrPosef identity{{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};

Eigen::Quaternionf orientation(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  return {q.w, q.x, q.y, q.z};
}

Eigen::Vector3f position(const XrPosef& pose) { return {pose.position.x, pose.position.y, pose.position.z}; }

// Normalises the rotation, since rounding errors of repeated products accumulate.
XrPosef pose_of(const Eigen::Quaternionf& turned, const Eigen::Vector3f& moved) {
  const Eigen::Quaternionf q = turned.normalized();
  return {{q.x(), q.y(), q.z(), q.w()}, {moved.x(), moved.y(), moved.z()}};
}

XrPosef product(const XrPosef& a, const XrPosef& b) {
  return pose_of(orientation(a) * orientation(b), orientation(a) * position(b) + position(a));
}

XrPosef inverse(const XrPosef& pose) {
  const Eigen::Quaternionf back = orientation(pose).conjugate();
  return pose_of(back, -(back * position(pose)));
}

// True for a valid pose of the runtime: finite numbers, and an orientation of about unit length.
bool is_pose(const XrPosef& pose) {
  return position(pose).allFinite() && std::abs(orientation(pose).squaredNorm() - 1.0f) < 0.02f;
}

}  // namespace

void SpaceMotion::announce(const XrEventDataReferenceSpaceChangePending& change) { pending_.push_back(change); }

SpaceMotion::Change SpaceMotion::advance(XrReferenceSpaceType space, XrTime time) {
  Change made = Change::none;
  std::erase_if(pending_, [&](const XrEventDataReferenceSpaceChangePending& change) {
    if (change.referenceSpaceType != space || change.changeTime > time) return false;
    if (change.poseValid != XR_TRUE || !is_pose(change.poseInPreviousSpace)) {
      first_.erase(space);
      made = Change::unknown;
      return true;
    }
    const XrPosef normalised = product(identity, change.poseInPreviousSpace);
    first_[space] = product(inverse(normalised), now(space, identity));
    if (made == Change::none) made = Change::moved;
    return true;
  });
  return made;
}

XrPosef SpaceMotion::now(XrReferenceSpaceType space, const XrPosef& pose_at_first) const {
  const auto moved = first_.find(space);
  return moved == first_.end() ? pose_at_first : product(moved->second, pose_at_first);
}

const char* name_of(XrReferenceSpaceType space) {
  if (space == XR_REFERENCE_SPACE_TYPE_STAGE) return "STAGE";
  return space == local_floor_space ? "LOCAL_FLOOR" : "LOCAL";
}

XrHeadlessSession::XrHeadlessSession(XrRuntime& runtime, SpaceMotion& motion, std::chrono::milliseconds limit)
    : XrHeadlessSession(&runtime, &motion, limit) {
  create_hand_tracker_ = runtime_.function<PFN_xrCreateHandTrackerEXT>("xrCreateHandTrackerEXT");
  destroy_hand_tracker_ = runtime_.function<PFN_xrDestroyHandTrackerEXT>("xrDestroyHandTrackerEXT");
  locate_hand_joints_ = runtime_.function<PFN_xrLocateHandJointsEXT>("xrLocateHandJointsEXT");
  if (runtime_.enabled(XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME))
    convert_timespec_ = runtime_.function<PFN_xrConvertTimespecTimeToTimeKHR>("xrConvertTimespecTimeToTimeKHR");

  // No graphics binding: a headless session (XR_MND_headless).
  const XrSessionCreateInfo session_info{XR_TYPE_SESSION_CREATE_INFO, nullptr, 0, runtime_.system()};
  CHECK_XR(xrCreateSession(runtime_.instance(), &session_info, &session_));

  find_spaces();

  for (const Hand hand : {Hand::left, Hand::right}) {
    const XrHandEXT side = hand == Hand::left ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT;
    const XrHandTrackerCreateInfoEXT tracker_info{XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, nullptr, side,
                                                  XR_HAND_JOINT_SET_DEFAULT_EXT};
    CHECK_XR_NAMED("xrCreateHandTrackerEXT",
                   create_hand_tracker_(session_, &tracker_info, &trackers_[static_cast<std::size_t>(hand)]));
  }
}

void XrHeadlessSession::find_spaces() {
  std::uint32_t count = 0;
  CHECK_XR(xrEnumerateReferenceSpaces(session_, 0, &count, nullptr));
  spaces_.resize(count);
  CHECK_XR(xrEnumerateReferenceSpaces(session_, count, &count, spaces_.data()));
  if (has_space(XR_REFERENCE_SPACE_TYPE_STAGE))
    steady_space_ = floor_space_ = XR_REFERENCE_SPACE_TYPE_STAGE;
  else if (!has_space(local_floor_space))
    return;
  else if (can_be_made(local_floor_space))
    floor_space_ = local_floor_space;
  else
    std::erase(spaces_, local_floor_space);
}

// An API layer that predates a space type may reject the type although the runtime supports it.
bool XrHeadlessSession::can_be_made(XrReferenceSpaceType type) const {
  const XrReferenceSpaceCreateInfo space_info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, type, identity};
  XrSpace space = XR_NULL_HANDLE;
  const XrResult made = CALL_XR(xrCreateReferenceSpace(session_, &space_info, &space));
  if (made == XR_ERROR_VALIDATION_FAILURE || made == XR_ERROR_REFERENCE_SPACE_UNSUPPORTED) return false;
  CHECK_XR_RESULT("xrCreateReferenceSpace", made);
  CALL_XR(xrDestroySpace(space));
  return true;
}

bool XrHeadlessSession::has_space(XrReferenceSpaceType space) const {
  return std::find(spaces_.begin(), spaces_.end(), space) != spaces_.end();
}

void XrHeadlessSession::place_plate(XrReferenceSpaceType space, const XrPosef& pose) {
  if (space != XR_REFERENCE_SPACE_TYPE_LOCAL && !has_space(space))
    throw Failure(ExitCode::registration, "the OpenXR runtime " + runtime_.name() + " has no " + name_of(space) +
                                              " space, in which the plate was registered; register the plate again "
                                              "(hrt-reach: --register)");
  plate_base_ = space;
  plate_pose_ = pose;
  make_plate_space();
}

void XrHeadlessSession::make_plate_space() {
  const XrReferenceSpaceCreateInfo space_info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO, nullptr, plate_base_,
                                              motion_.now(plate_base_, plate_pose_)};
  XrSpace placed = XR_NULL_HANDLE;
  CHECK_XR(xrCreateReferenceSpace(session_, &space_info, &placed));
  if (plate_space_ != XR_NULL_HANDLE) CALL_XR(xrDestroySpace(plate_space_));
  plate_space_ = placed;
}

// Applies the announced changes of the plate's space that are in effect at `time`.
void XrHeadlessSession::follow_spaces(XrTime time) {
  if (plate_space_ == XR_NULL_HANDLE) return;
  const SpaceMotion::Change change = motion_.advance(plate_base_, time);
  if (change == SpaceMotion::Change::none) return;
  if (change == SpaceMotion::Change::unknown)
    throw Failure(
        ExitCode::registration,
        std::string("the OpenXR runtime moved its ") + name_of(plate_base_) +
            " space, for instance because the view was centred again, and did not report by how much, so the pose "
            "of the plate is unknown; start again and register the plate (hrt-reach: --register FILE)");
  make_plate_space();
  ++recentrings_;
}

// Handles of a lost session or instance are destroyed too; the results of those calls are ignored.
XrHeadlessSession::~XrHeadlessSession() {
  if (left_out_.untimed + left_out_.stepped + left_out_.refused + left_out_.impossible > 0)
    say(
        format("Skipped faults of the OpenXR runtime: %d frames without a time, %d frames whose time steps by more "
               "than 5 s, %d refusals to locate a hand, %d impossible poses of a fingertip.\n",
               left_out_.untimed, left_out_.stepped, left_out_.refused, left_out_.impossible));
  for (const XrHandTrackerEXT tracker : trackers_)
    if (tracker != XR_NULL_HANDLE) CALL_XR_NAMED("xrDestroyHandTrackerEXT", destroy_hand_tracker_(tracker));
  if (plate_space_ != XR_NULL_HANDLE) CALL_XR(xrDestroySpace(plate_space_));
  if (session_ != XR_NULL_HANDLE) CALL_XR(xrDestroySession(session_));
}

XrTime XrHeadlessSession::next_frame() {
  const auto give_up = Clock::now() + limit_;
  for (;;) {
    poll_events();
    if (!running_) wait_until_running();
    const std::optional<XrTime> time = frame_of_runtime();
    if (time && *time > last_frame_ && !steps(*time)) {
      frame_began_ = Clock::now();
      follow_spaces(*time);
      return last_frame_ = *time;
    }
    if (Clock::now() > give_up) fail("the time of the OpenXR runtime does not advance: restart the runtime");
    if (!time) std::this_thread::sleep_for(poll_period);
  }
}

// True if the runtime's time advanced by over 5 s more than the real time. Throws XrLost after 90 such frames in a row.
bool XrHeadlessSession::steps(XrTime time) {
  const auto passed = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - frame_began_).count();
  const bool is_step =
      last_frame_ != 0 && time - last_frame_ > max_step_ns && time - last_frame_ - passed > max_step_ns;
  stepped_ = is_step ? stepped_ + 1 : 0;
  left_out_.stepped += is_step ? 1 : 0;
  if (stepped_ > max_skipped_frames)
    throw XrLost(XR_ERROR_TIME_INVALID, format("the runtime's time stepped by %.0f s between two frames",
                                               1e-9 * static_cast<double>(time - last_frame_)));
  return is_step;
}

// Waits for a frame of the runtime, and returns its time; nullopt: skip this frame. If the frames have no time (a
// headless session needs no frame loop), waits for the next period of 90 Hz, and returns the runtime's present time.
std::optional<XrTime> XrHeadlessSession::frame_of_runtime() {
  if (!frames_have_times_) {
    own_frame_ = std::max(own_frame_ + own_frame_period, Clock::now());  // 90 Hz independently of the work in a frame
    std::this_thread::sleep_until(own_frame_);
    return time_now();
  }
  XrFrameState frame{XR_TYPE_FRAME_STATE};
  const XrResult waited = CALL_XR(xrWaitFrame(session_, nullptr, &frame));
  if (waited == XR_ERROR_SESSION_NOT_RUNNING) return std::nullopt;  // an event with the new state follows
  const bool has_loop = waited != XR_ERROR_FUNCTION_UNSUPPORTED;
  if (has_loop) CHECK_XR_RESULT("xrWaitFrame", waited);
  const bool has_time = has_loop && frame.predictedDisplayTime > 0;
  untimed_ = has_time ? 0 : untimed_ + 1;
  // Some runtimes give no frame of a headless session a time. Otherwise, up to 90 frames in a row without one are
  // skipped.
  if (!has_loop || (!has_time && (last_frame_ == 0 || untimed_ > max_skipped_frames))) {
    frames_have_times_ = false;
    return time_now();
  }
  CHECK_XR(xrBeginFrame(session_, nullptr));
  const XrTime shown = has_time ? frame.predictedDisplayTime : last_frame_ + own_frame_period.count();
  const XrFrameEndInfo end_info{XR_TYPE_FRAME_END_INFO, nullptr, shown, blend_mode, 0, nullptr};
  const XrResult ended = CALL_XR(xrEndFrame(session_, &end_info));
  if (has_time || ended != XR_ERROR_TIME_INVALID) CHECK_XR_RESULT("xrEndFrame", ended);
  if (has_time) return frame.predictedDisplayTime;
  ++left_out_.untimed;
  return std::nullopt;
}

XrTime XrHeadlessSession::time_now() const {
  if (convert_timespec_ == nullptr)
    fail(
        "the OpenXR runtime gives its frames no time and does not support XR_KHR_convert_timespec_time: select "
        "another runtime");
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  XrTime time = 0;
  CHECK_XR_NAMED("xrConvertTimespecTimeToTimeKHR", convert_timespec_(runtime_.instance(), &now, &time));
  return time;
}

void XrHeadlessSession::wait_until_running() {
  const auto give_up = Clock::now() + limit_;
  while (!running_) {
    if (Clock::now() > give_up)
      fail("the OpenXR runtime did not start the session " + within(limit_) +
           ": check that its device is worn and connected, or allow more time (hrt-reach: --runtime-limit)");
    std::this_thread::sleep_for(poll_period);
    poll_events();
  }
}

void XrHeadlessSession::poll_events() {
  for (const auto give_up = Clock::now() + limit_;;) {
    throw_if_interrupted();
    if (Clock::now() > give_up)
      fail("the OpenXR runtime did not stop sending events " + within(limit_) + ": restart the runtime");
    XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
    if (CHECK_XR(xrPollEvent(runtime_.instance(), &event)) == XR_EVENT_UNAVAILABLE) return;
    if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING)
      throw XrLost(XR_ERROR_INSTANCE_LOST, "the runtime announced the loss of the instance");
    if (event.type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING) {
      const auto& change = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
      if (change.session == session_ && change.referenceSpaceType == plate_base_) motion_.announce(change);
    }
    if (event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) continue;
    const auto& change = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
    if (change.session == session_) change_state(change.state);
  }
}

// Begins or ends the session when the runtime requests it; a repeated request has no effect. Throws if the session is
// lost, or has exited without a request of end().
void XrHeadlessSession::change_state(XrSessionState state) {
  switch (state) {
    case XR_SESSION_STATE_READY:
      if (!running_) {
        const XrSessionBeginInfo begin_info{XR_TYPE_SESSION_BEGIN_INFO, nullptr,
                                            XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO};
        CHECK_XR(xrBeginSession(session_, &begin_info));
        running_ = true;
      }
      break;
    case XR_SESSION_STATE_STOPPING:
      if (running_) {
        CHECK_XR(xrEndSession(session_));
        running_ = false;
      }
      break;
    case XR_SESSION_STATE_LOSS_PENDING:
      throw XrLost(XR_SESSION_LOSS_PENDING, "the runtime announced the loss of the session");
    case XR_SESSION_STATE_EXITING:
      if (!ending_) fail("the OpenXR runtime ended the session: restart the runtime and this program");
      break;
    default:
      break;
  }
}

Fingertip XrHeadlessSession::locate(Hand hand, XrTime time) {
  std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
  XrHandJointLocationsEXT locations{XR_TYPE_HAND_JOINT_LOCATIONS_EXT, nullptr, XR_FALSE, XR_HAND_JOINT_COUNT_EXT,
                                    joints.data()};
  const XrHandJointsLocateInfoEXT locate_info{XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, nullptr, plate_space_, time};
  const XrResult located =
      CALL_XR_NAMED("xrLocateHandJointsEXT",
                    locate_hand_joints_(trackers_[static_cast<std::size_t>(hand)], &locate_info, &locations));
  if (located != XR_ERROR_TIME_INVALID) {
    refused_since_.reset();
  } else if (time - refused_since_.value_or(time) <= max_refused_ns) {
    if (!refused_since_) refused_since_ = time;
    ++left_out_.refused;
    return {};
  }
  CHECK_XR_RESULT("xrLocateHandJointsEXT", located);
  const XrHandJointLocationEXT& tip = joints[XR_HAND_JOINT_INDEX_TIP_EXT];
  if (locations.isActive != XR_TRUE || !can_be_observed(tip)) return {};
  const auto d = [](float value) { return static_cast<double>(value); };
  const XrVector3f& position = tip.pose.position;
  const XrQuaternionf& turn = tip.pose.orientation;
  const Eigen::Vector3f at(position.x, position.y, position.z);
  const bool has_rotation = (tip.locationFlags & XR_SPACE_LOCATION_ORIENTATION_VALID_BIT) != 0;
  const float square = Eigen::Vector4f(turn.x, turn.y, turn.z, turn.w).squaredNorm();
  if (!at.allFinite() || at.norm() > max_position_m || (has_rotation && !(std::abs(square - 1.0f) < 0.001f))) {
    ++left_out_.impossible;
    return {};
  }
  Fingertip seen{.tracked = true, .position_m = {d(position.x), d(position.y), d(position.z)}};
  if (has_rotation) seen.rotation = {d(turn.x), d(turn.y), d(turn.z), d(turn.w)};
  return seen;
}

void XrHeadlessSession::end() {
  if (!running_) return;
  ending_ = true;
  CHECK_XR(xrRequestExitSession(session_));
  const auto give_up = Clock::now() + limit_;
  while (running_) {
    poll_events();
    if (!running_) return;
    if (Clock::now() > give_up)
      fail("the OpenXR runtime did not stop the session " + within(limit_) + ": restart the runtime");
    frame_of_runtime();
  }
}

}  // namespace hrt::app
