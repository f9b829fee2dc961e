// XR_EXT_hand_tracking, with XR_EXT_hand_joints_motion_range and XR_EXT_hand_tracking_data_source.
#include <algorithm>
#include <optional>

#include "samples/mock_runtime/abi/chain.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/world/hand_model.h"

namespace hrt::mock {
namespace {

using DataSources = std::vector<XrHandTrackingDataSourceEXT>;

class HandTracker : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_HAND_TRACKER_EXT;
  HandTracker(Session* session, XrHandEXT side, std::optional<DataSources> requested)
      : Object(object_type, session), hand(side), sources(std::move(requested)) {}
  Session& session() const { return static_cast<Session&>(*parent()); }

  bool takes(XrHandTrackingDataSourceEXT source) const {
    return !sources || sources->empty() ||
           std::find(sources->begin(), sources->end(), source) != sources->end();
  }

  XrHandEXT hand;
  std::optional<DataSources> sources;  // none: the application did not name any
};

// XR_EXT_hand_tracking_data_source: the sources that an application names.
std::optional<DataSources> requested_sources(const Instance& instance, const void* next) {
  const auto* info =
      chained<XrHandTrackingDataSourceInfoEXT>(next, XR_TYPE_HAND_TRACKING_DATA_SOURCE_INFO_EXT);
  if (info == nullptr || !instance.enabled(Extension::data_source)) return std::nullopt;
  if (info->requestedDataSourceCount > 0) require_pointer(info->requestedDataSources, "requestedDataSources");
  DataSources sources;
  for (std::uint32_t i = 0; i < info->requestedDataSourceCount; ++i) {
    const XrHandTrackingDataSourceEXT source = info->requestedDataSources[i];
    require(source == XR_HAND_TRACKING_DATA_SOURCE_UNOBSTRUCTED_EXT ||
                source == XR_HAND_TRACKING_DATA_SOURCE_CONTROLLER_EXT,
            XR_ERROR_VALIDATION_FAILURE, "no such data source");
    require(std::find(sources.begin(), sources.end(), source) == sources.end(), XR_ERROR_VALIDATION_FAILURE,
            "a data source is requested twice");
    sources.push_back(source);
  }
  return sources;
}

// XR_EXT_hand_joints_motion_range: whether the fingers must fit around a controller.
bool conforms(const Instance& instance, const void* next) {
  const auto* info = chained<XrHandJointsMotionRangeInfoEXT>(next, XR_TYPE_HAND_JOINTS_MOTION_RANGE_INFO_EXT);
  if (info == nullptr || !instance.enabled(Extension::motion_range)) return false;
  require(info->handJointsMotionRange == XR_HAND_JOINTS_MOTION_RANGE_UNOBSTRUCTED_EXT ||
              info->handJointsMotionRange == XR_HAND_JOINTS_MOTION_RANGE_CONFORMING_TO_CONTROLLER_EXT,
          XR_ERROR_VALIDATION_FAILURE, "no such motion range");
  return info->handJointsMotionRange == XR_HAND_JOINTS_MOTION_RANGE_CONFORMING_TO_CONTROLLER_EXT;
}

bool holds_controller(const Session& session, XrHandEXT hand) {
  const auto device =
      session.input.devices.find(hand == XR_HAND_LEFT_EXT ? "/user/hand/left" : "/user/hand/right");
  return device != session.input.devices.end() && device->second.active;
}

// Around a controller's handle.
constexpr Fingers grasp{.curl = std::array{0.3, 0.4, 0.55, 0.6, 0.6}};

// The hand in the world. Around a controller its fingers are bent otherwise, with the wrist in its place.
HandJoints joints_of(XrHandEXT side, const HandState& state, const Fingers& fingers, bool around_controller) {
  HandJoints joints = place_hand(shape_hand(side, fingers), state.index_tip_m, state.orientation);
  if (!around_controller) return joints;
  const Pose wrist = {state.orientation, joints[XR_HAND_JOINT_WRIST_EXT].pose.position_m};
  HandJoints held = shape_hand(side, grasp);
  for (HandJoint& joint : held) joint.pose = wrist * joint.pose;
  return held;
}

// Joints that are not given have no valid bit.
void write_joints(const RecordedJoints& joints, XrHandJointLocationsEXT& locations,
                  XrHandJointVelocitiesEXT* velocities, XrHandTrackingDataSourceStateEXT* state) {
  if (state != nullptr) {
    state->isActive = joints.active ? XR_TRUE : XR_FALSE;
    state->dataSource = static_cast<XrHandTrackingDataSourceEXT>(joints.source);
  }
  locations.isActive = joints.active ? XR_TRUE : XR_FALSE;
  for (std::size_t i = 0; i < XR_HAND_JOINT_COUNT_EXT; ++i) {
    locations.jointLocations[i] =
        i < joints.locations.size() ? joints.locations[i] : XrHandJointLocationEXT{0, to_xr(Pose{}), 0.0F};
    if (velocities != nullptr)
      velocities->jointVelocities[i] =
          i < joints.velocities.size() ? joints.velocities[i] : XrHandJointVelocityEXT{};
  }
}

RecordedJoints simulated_joints(const HandTracker& tracker, const Space& base,
                                const XrHandJointsLocateInfoEXT& info) {
  Session& session = tracker.session();
  World& world = session.world();
  const bool around_controller =
      conforms(session.instance(), info.next) && holds_controller(session, tracker.hand);
  // "isActive [...] is false [if] the hand tracker did not detect the hand input or the application lost
  // input focus."
  const bool focused = session.state() == XR_SESSION_STATE_FOCUSED;
  const auto hand = world.hand(tracker.hand, info.time);
  const auto base_in_world = base.in_world(info.time);
  const auto source = world.hand_source(tracker.hand) == HandSource::controller
                          ? XR_HAND_TRACKING_DATA_SOURCE_CONTROLLER_EXT
                          : XR_HAND_TRACKING_DATA_SOURCE_UNOBSTRUCTED_EXT;
  RecordedJoints given{focused && hand && base_in_world && tracker.takes(source), source, {}, {}};
  if (!given.active) return given;
  const Pose from_world = inverse(*base_in_world);
  const HandJoints joints = joints_of(tracker.hand, *hand, hand->fingers, around_controller);
  // Where bending fingers alone would bring them.
  const HandJoints soon = joints_of(tracker.hand, *hand, hand->fingers_soon, around_controller);
  const XrSpaceLocationFlags position_tracked =
      base.stands_in_room() && !base.can_see_room() ? 0 : XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  const Velocities kind = world.velocities();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    given.locations.push_back({XR_SPACE_LOCATION_ORIENTATION_VALID_BIT |
                                   XR_SPACE_LOCATION_POSITION_VALID_BIT |
                                   XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | position_tracked,
                               to_xr(from_world * joints[i].pose), static_cast<float>(joints[i].radius_m)});
    if (kind == Velocities::none) continue;
    XrHandJointVelocityEXT& velocity = given.velocities.emplace_back();
    velocity.velocityFlags = XR_SPACE_VELOCITY_LINEAR_VALID_BIT;
    if (kind != Velocities::linear) velocity.velocityFlags |= XR_SPACE_VELOCITY_ANGULAR_VALID_BIT;
    if (kind == Velocities::zero) continue;
    const Eigen::Vector3d linear =
        hand->index_tip_velocity_m_per_s +
        hand->angular_velocity_rad_per_s.cross(joints[i].pose.position_m - hand->index_tip_m) +
        (soon[i].pose.position_m - joints[i].pose.position_m) / soon_s;
    velocity.linearVelocity = to_xr(Eigen::Vector3d(from_world.orientation * linear));
    if (kind == Velocities::full)
      velocity.angularVelocity =
          to_xr(Eigen::Vector3d(from_world.orientation * hand->angular_velocity_rad_per_s));
  }
  return given;
}

}  // namespace

void create_hand_tracker(XrSession handle, const XrHandTrackerCreateInfoEXT* info,
                         XrHandTrackerEXT* tracker) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT, "createInfo");
  require_pointer(tracker, "handTracker");
  require(info->hand == XR_HAND_LEFT_EXT || info->hand == XR_HAND_RIGHT_EXT, XR_ERROR_VALIDATION_FAILURE,
          "no such hand");
  require(info->handJointSet == XR_HAND_JOINT_SET_DEFAULT_EXT, XR_ERROR_VALIDATION_FAILURE,
          "no such joint set");
  require(runtime().script.hand_tracking, XR_ERROR_FEATURE_UNSUPPORTED, "the system has no hand tracking");
  auto sources = requested_sources(session.instance(), info->next);
  *tracker = handle_of<XrHandTrackerEXT>(
      runtime().registry.create<HandTracker>(&session, info->hand, std::move(sources)));
}

void destroy_hand_tracker(XrHandTrackerEXT handle) {
  runtime().registry.destroy(runtime().registry.get_even_lost<HandTracker>(handle));
}

void locate_hand_joints(XrHandTrackerEXT handle, const XrHandJointsLocateInfoEXT* info,
                        XrHandJointLocationsEXT* locations) {
  auto& tracker = runtime().registry.get<HandTracker>(handle);
  require_struct(info, XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT, "locateInfo");
  require_struct(locations, XR_TYPE_HAND_JOINT_LOCATIONS_EXT, "locations");
  auto& base = runtime().registry.get<Space>(info->baseSpace);
  require(base.parent() == tracker.parent(), XR_ERROR_VALIDATION_FAILURE, "the space is of another session");
  require(info->time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  require(locations->jointCount == XR_HAND_JOINT_COUNT_EXT, XR_ERROR_VALIDATION_FAILURE,
          "jointCount of the default set is 26");
  require_pointer(locations->jointLocations, "jointLocations");
  auto* velocities = chained<XrHandJointVelocitiesEXT>(locations->next, XR_TYPE_HAND_JOINT_VELOCITIES_EXT);
  if (velocities != nullptr) {
    require(velocities->jointCount == XR_HAND_JOINT_COUNT_EXT, XR_ERROR_VALIDATION_FAILURE,
            "jointCount of the default set is 26");
    require_pointer(velocities->jointVelocities, "jointVelocities");
  }

  Session& session = tracker.session();
  auto* state =
      chained<XrHandTrackingDataSourceStateEXT>(locations->next, XR_TYPE_HAND_TRACKING_DATA_SOURCE_STATE_EXT);
  if (!session.instance().enabled(Extension::data_source)) state = nullptr;
  require(state == nullptr || tracker.sources, XR_ERROR_VALIDATION_FAILURE,
          "the tracker was created without XrHandTrackingDataSourceInfoEXT");
  const RecordedJoints joints = session.player ? session.player->joints(tracker.hand, base.name, info->time)
                                               : simulated_joints(tracker, base, *info);
  write_joints(joints, *locations, velocities, state);
}

}  // namespace hrt::mock
