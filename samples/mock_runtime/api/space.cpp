#include "samples/mock_runtime/api/space.h"

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/world/hand_model.h"

namespace hrt::mock {
namespace {

constexpr XrExtent2Df stage_bounds_m{2.0F, 2.0F};

std::vector<XrReferenceSpaceType> reference_spaces(const Session& session) {
  std::vector types{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL};
  if (runtime().script.stage) types.push_back(XR_REFERENCE_SPACE_TYPE_STAGE);
  if (session.instance().enabled(Extension::local_floor)) types.push_back(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR);
  return types;
}

void require_reference_space(const Session& session, XrReferenceSpaceType type) {
  const auto types = reference_spaces(session);
  require(std::find(types.begin(), types.end(), type) != types.end(), XR_ERROR_REFERENCE_SPACE_UNSUPPORTED,
          "referenceSpaceType is {}; supported are VIEW, LOCAL, STAGE (unless the script removes it), and LOCAL_FLOOR "
          "with XR_EXT_local_floor",
          name_of(type));
}

// Returns the pose of eye 0 (left) or 1 (right). The eyes are 63 mm apart.
Pose eye_in_world(Session& session, std::uint32_t eye, XrTime time) {
  constexpr double half_distance_m = 0.0315;
  return session.world().head(time) * Pose{.position_m = {eye == 0 ? -half_distance_m : half_distance_m, 0.0, 0.0}};
}

}  // namespace

Space& space_of(const Session& session, XrSpace handle) {
  auto& space = runtime().registry.get<Space>(handle);
  require_valid(space.parent() == &session, "the space belongs to another session; create it in this session");
  return space;
}

std::optional<Pose> Space::in_world(XrTime time) const {
  if (!reference_) return std::nullopt;
  World& world = session().world();
  const bool is_view = *reference_ == XR_REFERENCE_SPACE_TYPE_VIEW;
  return (is_view ? world.head(time) : world.origins.in_world(*reference_, time)) * offset_;
}

bool Space::is_fixed_to_room() const { return reference_ && *reference_ != XR_REFERENCE_SPACE_TYPE_VIEW; }

bool Space::head_is_tracked() const { return !session().world().head_is_lost(); }

void xrEnumerateReferenceSpaces(Session& session, std::uint32_t capacity, std::uint32_t* count,
                                XrReferenceSpaceType* types) {
  two_call(reference_spaces(session), capacity, count, types);
}

void xrCreateReferenceSpace(Session& session, const XrReferenceSpaceCreateInfo* info, XrSpace* space) {
  require_reference_space(session, info->referenceSpaceType);
  const Pose pose = checked_pose(info->poseInReferenceSpace);
  *space = handle_of<XrSpace>(runtime().registry.create<Space>(&session, info->referenceSpaceType, pose));
}

void xrCreateActionSpace(Session& session, const XrActionSpaceCreateInfo* info, XrSpace* space) {
  const auto& action = runtime().registry.get<Action>(info->action);
  require_type(action, XR_ACTION_TYPE_POSE_INPUT);
  const Pose pose = checked_pose(info->poseInActionSpace);
  *space = handle_of<XrSpace>(runtime().registry.create<Space>(&session, std::nullopt, pose));
}

XrResult xrGetReferenceSpaceBoundsRect(Session& session, XrReferenceSpaceType type, XrExtent2Df* bounds) {
  require_reference_space(session, type);
  const bool bounded = type == XR_REFERENCE_SPACE_TYPE_STAGE;
  *bounds = bounded ? stage_bounds_m : XrExtent2Df{0.0F, 0.0F};
  return bounded ? XR_SUCCESS : XR_SPACE_BOUNDS_UNAVAILABLE;
}

// The runtime computes no velocities: an XrSpaceVelocity in the chain receives no valid bit.
void xrLocateSpace(Space& space, Space& base, XrTime time, XrSpaceLocation* location) {
  require_valid(space.parent() == base.parent(),
                "space and baseSpace belong to different sessions; create both in one session");
  require_time(time);
  if (auto* velocity = chained<XrSpaceVelocity>(location->next))
    *velocity = {.type = velocity->type, .next = velocity->next};
  const auto located = space.in_world(time), origin = base.in_world(time);
  const bool tracked = space.is_fixed_to_room() == base.is_fixed_to_room() || base.head_is_tracked();
  location->locationFlags = !located || !origin ? 0 : tracked ? all_location_flags : position_inferred;
  location->pose = to_xr(located && origin ? inverse(*origin) * *located : Pose{});
}

void xrDestroySpace(XrSpace handle) { runtime().registry.destroy<Space>(handle); }

void xrLocateViews(Session& session, const XrViewLocateInfo* info, XrViewState* state, std::uint32_t capacity,
                   std::uint32_t* count, XrView* views) {
  const Space& space = space_of(session, info->space);
  require_view_configuration(info->viewConfigurationType);
  require_time(info->displayTime);
  const auto in_world = space.in_world(info->displayTime);
  two_call(std::array{0U, 1U}, capacity, count, views, [&](XrView& view, std::uint32_t eye) {
    view.pose = to_xr(in_world ? inverse(*in_world) * eye_in_world(session, eye, info->displayTime) : Pose{});
    view.fov = field_of_view;
  });
  state->viewStateFlags = 0;
  if (!in_world) return;
  state->viewStateFlags =
      XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_TRACKED_BIT;
  if (!space.is_fixed_to_room() || space.head_is_tracked()) state->viewStateFlags |= XR_VIEW_STATE_POSITION_TRACKED_BIT;
}

namespace {

void require_joint_count(std::uint32_t count) {
  require_valid(count == XR_HAND_JOINT_COUNT_EXT, "jointCount is {}; must be {}, the size of the default set", count,
                XR_HAND_JOINT_COUNT_EXT);
}

}  // namespace

void require_hand(XrHandEXT hand) {
  require_valid(hand == XR_HAND_LEFT_EXT || hand == XR_HAND_RIGHT_EXT, "hand is {}; must be 1 (left) or 2 (right)",
                static_cast<int>(hand));
}

void xrCreateHandTrackerEXT(Session& session, const XrHandTrackerCreateInfoEXT* info, XrHandTrackerEXT* tracker) {
  require_hand(info->hand);
  require_valid(info->handJointSet == XR_HAND_JOINT_SET_DEFAULT_EXT, "handJointSet is {}; must be 0, the default set",
                static_cast<int>(info->handJointSet));
  require(runtime().script.hand_tracking, XR_ERROR_FEATURE_UNSUPPORTED,
          "the script sets hand_tracking to false; check XrSystemHandTrackingPropertiesEXT before this call");
  *tracker = handle_of<XrHandTrackerEXT>(runtime().registry.create<HandTracker>(&session, info->hand));
}

void xrDestroyHandTrackerEXT(XrHandTrackerEXT handle) { runtime().registry.destroy<HandTracker>(handle); }

void xrLocateHandJointsEXT(HandTracker& tracker, const XrHandJointsLocateInfoEXT* info,
                           XrHandJointLocationsEXT* locations) {
  const Space& base = space_of(tracker.session(), info->baseSpace);
  require_time(info->time);
  require_joint_count(locations->jointCount);
  require_pointer(locations->jointLocations, "jointLocations");
  auto* velocities = chained<XrHandJointVelocitiesEXT>(locations->next);
  if (velocities != nullptr) {
    require_joint_count(velocities->jointCount);
    require_pointer(velocities->jointVelocities, "jointVelocities");
    std::fill_n(velocities->jointVelocities, velocities->jointCount, XrHandJointVelocityEXT{});
  }

  World& world = tracker.session().world();
  // XR_EXT_hand_tracking: "isActive [...] is false [if] the hand tracker did not detect the hand input or the
  // application lost input focus."
  const bool focused = tracker.session().state() == XR_SESSION_STATE_FOCUSED;
  const auto hand = world.hand(tracker.hand, info->time);
  const auto base_in_world = base.in_world(info->time);
  locations->isActive = XrBool32{focused && hand && base_in_world};
  std::fill_n(locations->jointLocations, locations->jointCount, XrHandJointLocationEXT{0, to_xr(Pose{}), 0.0F});
  if (locations->isActive == XR_FALSE) return;
  const Pose from_world = inverse(*base_in_world);
  const XrSpaceLocationFlags flags =
      base.is_fixed_to_room() && !base.head_is_tracked() ? position_inferred : all_location_flags;
  const HandJoints joints = place_hand(tracker.hand, hand->index_tip_m, hand->orientation);
  std::transform(joints.begin(), joints.end(), locations->jointLocations, [&](const HandJoint& joint) {
    return XrHandJointLocationEXT{flags, to_xr(from_world * joint.pose), static_cast<float>(joint.radius_m)};
  });
}

}  // namespace hrt::mock
