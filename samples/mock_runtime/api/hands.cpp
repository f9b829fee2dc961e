// XR_EXT_hand_tracking.
#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/world/hand_model.h"

namespace hrt::mock {
namespace {

void write_inactive(XrHandJointLocationsEXT& locations, XrHandJointVelocitiesEXT* velocities) {
  locations.isActive = XR_FALSE;
  std::fill_n(locations.jointLocations, XR_HAND_JOINT_COUNT_EXT, XrHandJointLocationEXT{0, to_xr(Pose{}), 0.0F});
  if (velocities != nullptr)
    std::fill_n(velocities->jointVelocities, XR_HAND_JOINT_COUNT_EXT, XrHandJointVelocityEXT{});
}

// Of a joint at a position in the world, seen along axes.
XrHandJointVelocityEXT velocity_at(const Eigen::Vector3d& position_m, const HandState& hand,
                                   const Eigen::Quaterniond& from_world, Velocities kind) {
  XrHandJointVelocityEXT velocity{};
  if (kind == Velocities::none) return velocity;
  velocity.velocityFlags = XR_SPACE_VELOCITY_LINEAR_VALID_BIT;
  if (kind != Velocities::linear) velocity.velocityFlags |= XR_SPACE_VELOCITY_ANGULAR_VALID_BIT;
  if (kind == Velocities::zero) return velocity;
  const Eigen::Vector3d linear =
      hand.index_tip_velocity_m_per_s + hand.angular_velocity_rad_per_s.cross(position_m - hand.index_tip_m);
  velocity.linearVelocity = to_xr(Eigen::Vector3d(from_world * linear));
  if (kind == Velocities::full)
    velocity.angularVelocity = to_xr(Eigen::Vector3d(from_world * hand.angular_velocity_rad_per_s));
  return velocity;
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

  World& world = tracker.session().world();
  // "isActive [...] is false [if] the hand tracker did not detect the hand input or the application lost
  // input focus."
  const bool focused = tracker.session().state() == XR_SESSION_STATE_FOCUSED;
  const auto hand = world.hand(tracker.hand, info->time);
  const auto base_in_world = base.in_world(info->time);
  if (!focused || !hand || !base_in_world) return write_inactive(*locations, velocities);
  locations->isActive = XR_TRUE;
  const Pose from_world = inverse(*base_in_world);
  const XrSpaceLocationFlags position_tracked =
      base.is_in_room() && !base.can_see_room() ? 0 : XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  const HandJoints joints = place_hand(tracker.hand, hand->index_tip_m, hand->orientation);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    locations->jointLocations[i] = {XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
                                        XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | position_tracked,
                                    to_xr(from_world * joints[i].pose), static_cast<float>(joints[i].radius_m)};
    if (velocities != nullptr)
      velocities->jointVelocities[i] =
          velocity_at(joints[i].pose.position_m, *hand, from_world.orientation, world.velocities());
  }
}

}  // namespace hrt::mock
