// XR_EXT_hand_tracking.
#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/world/hand_model.h"

namespace hrt::mock {

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
    std::fill_n(velocities->jointVelocities, velocities->jointCount, XrHandJointVelocityEXT{});
  }

  World& world = tracker.session().world();
  // "isActive [...] is false [if] the hand tracker did not detect the hand input or the application lost
  // input focus."
  const bool focused = tracker.session().state() == XR_SESSION_STATE_FOCUSED;
  const auto hand = world.hand(tracker.hand, info->time);
  const auto base_in_world = base.in_world(info->time);
  locations->isActive = XrBool32{focused && hand && base_in_world};
  std::fill_n(locations->jointLocations, locations->jointCount, XrHandJointLocationEXT{0, to_xr(Pose{}), 0.0F});
  if (locations->isActive == XR_FALSE) return;
  const Pose from_world = inverse(*base_in_world);
  const XrSpaceLocationFlags flags = base.is_in_room() && !base.can_see_room() ? position_inferred : all_location_flags;
  const HandJoints joints = place_hand(tracker.hand, hand->index_tip_m, hand->orientation);
  std::transform(joints.begin(), joints.end(), locations->jointLocations, [&](const HandJoint& joint) {
    return XrHandJointLocationEXT{flags, to_xr(from_world * joint.pose), static_cast<float>(joint.radius_m)};
  });
}

}  // namespace hrt::mock
