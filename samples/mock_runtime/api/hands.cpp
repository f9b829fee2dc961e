// XR_EXT_hand_tracking.
#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/world/hand_model.h"

namespace hrt::mock {
namespace {

// Joints that are not given have no valid bit.
void write_joints(const RecordedJoints& joints, XrHandJointLocationsEXT& locations,
                  XrHandJointVelocitiesEXT* velocities) {
  locations.isActive = joints.active ? XR_TRUE : XR_FALSE;
  for (std::size_t i = 0; i < XR_HAND_JOINT_COUNT_EXT; ++i) {
    locations.jointLocations[i] =
        i < joints.locations.size() ? joints.locations[i] : XrHandJointLocationEXT{0, to_xr(Pose{}), 0.0F};
    if (velocities != nullptr)
      velocities->jointVelocities[i] = i < joints.velocities.size() ? joints.velocities[i] : XrHandJointVelocityEXT{};
  }
}

RecordedJoints simulated_joints(const HandTracker& tracker, const Space& base, const XrHandJointsLocateInfoEXT& info) {
  Session& session = tracker.session();
  World& world = session.world();
  // "isActive [...] is false [if] the hand tracker did not detect the hand input or the application lost
  // input focus."
  const bool focused = session.state() == XR_SESSION_STATE_FOCUSED;
  const auto hand = world.hand(tracker.hand, info.time);
  const auto base_in_world = base.in_world(info.time);
  RecordedJoints given{focused && hand && base_in_world, {}, {}};
  if (!given.active) return given;
  const Pose from_world = inverse(*base_in_world);
  const HandJoints joints = place_hand(tracker.hand, hand->index_tip_m, hand->orientation);
  const XrSpaceLocationFlags position_tracked =
      base.is_in_room() && !base.can_see_room() ? 0 : XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  const Velocities kind = world.velocities();
  for (const auto& joint : joints) {
    given.locations.push_back({XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
                                   XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | position_tracked,
                               to_xr(from_world * joint.pose), static_cast<float>(joint.radius_m)});
    if (kind == Velocities::none) continue;
    XrHandJointVelocityEXT& velocity = given.velocities.emplace_back();
    velocity.velocityFlags = XR_SPACE_VELOCITY_LINEAR_VALID_BIT;
    if (kind != Velocities::linear) velocity.velocityFlags |= XR_SPACE_VELOCITY_ANGULAR_VALID_BIT;
    if (kind == Velocities::zero) continue;
    const Eigen::Vector3d linear = hand->index_tip_velocity_m_per_s +
                                   hand->angular_velocity_rad_per_s.cross(joint.pose.position_m - hand->index_tip_m);
    velocity.linearVelocity = to_xr(Eigen::Vector3d(from_world.orientation * linear));
    if (kind == Velocities::full)
      velocity.angularVelocity = to_xr(Eigen::Vector3d(from_world.orientation * hand->angular_velocity_rad_per_s));
  }
  return given;
}

}  // namespace

void create_hand_tracker(Session& session, const XrHandTrackerCreateInfoEXT* info, XrHandTrackerEXT* tracker) {
  require(info->hand == XR_HAND_LEFT_EXT || info->hand == XR_HAND_RIGHT_EXT, XR_ERROR_VALIDATION_FAILURE,
          "no such hand");
  require(info->handJointSet == XR_HAND_JOINT_SET_DEFAULT_EXT, XR_ERROR_VALIDATION_FAILURE, "no such joint set");
  require(runtime().script.hand_tracking, XR_ERROR_FEATURE_UNSUPPORTED, "the system has no hand tracking");
  *tracker = handle_of<XrHandTrackerEXT>(runtime().registry.create<HandTracker>(&session, info->hand));
}

void destroy_hand_tracker(XrHandTrackerEXT handle) {
  runtime().registry.destroy(runtime().registry.get_even_lost<HandTracker>(handle));
}

void locate_hand_joints(HandTracker& tracker, const XrHandJointsLocateInfoEXT* info,
                        XrHandJointLocationsEXT* locations) {
  const Space& base = space_of(tracker.session(), info->baseSpace);
  require(info->time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  require(locations->jointCount == XR_HAND_JOINT_COUNT_EXT, XR_ERROR_VALIDATION_FAILURE,
          "jointCount of the default set is 26");
  require_pointer(locations->jointLocations, "jointLocations");
  auto* velocities = chained<XrHandJointVelocitiesEXT>(locations->next);
  if (velocities != nullptr) {
    require(velocities->jointCount == XR_HAND_JOINT_COUNT_EXT, XR_ERROR_VALIDATION_FAILURE,
            "jointCount of the default set is 26");
    require_pointer(velocities->jointVelocities, "jointVelocities");
  }

  Session& session = tracker.session();
  const RecordedJoints joints = session.player ? session.player->joints(tracker.hand, base.name, info->time)
                                               : simulated_joints(tracker, base, *info);
  write_joints(joints, *locations, velocities);
}

}  // namespace hrt::mock
