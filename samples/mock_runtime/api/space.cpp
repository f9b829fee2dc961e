#include "samples/mock_runtime/api/space.h"

#include "samples/mock_runtime/abi/two_call.h"

namespace hrt::mock {
namespace {

// Area within a seated user's reach.
constexpr XrExtent2Df stage_bounds_m{2.0F, 2.0F};

std::vector<XrReferenceSpaceType> reference_spaces(const Session& session) {
  std::vector types{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL};
  if (runtime().script.stage) types.push_back(XR_REFERENCE_SPACE_TYPE_STAGE);
  if (session.instance().version_1_1() || session.instance().enabled(Extension::local_floor))
    types.push_back(XR_REFERENCE_SPACE_TYPE_LOCAL_FLOOR);
  return types;
}

void require_reference_space(const Session& session, XrReferenceSpaceType type) {
  const auto types = reference_spaces(session);
  require(std::find(types.begin(), types.end(), type) != types.end(), XR_ERROR_REFERENCE_SPACE_UNSUPPORTED,
          "reference spaces are VIEW, LOCAL, STAGE and, of OpenXR 1.1 or XR_EXT_local_floor, LOCAL_FLOOR");
}

// Clears chained velocities: they have no valid bit.
template <typename Location>
void write_location(const Space& space, const Space& base, XrTime time, Location& location) {
  const auto of = space.in_world(time), in = base.in_world(time);
  const bool seen = space.is_in_room() == base.is_in_room() || base.can_see_room();
  location.locationFlags = !of || !in ? 0 : seen ? all_location_flags : position_inferred;
  location.pose = to_xr(of && in ? inverse(*in) * *of : Pose{});
}

// Pose of eye 0 (left) or 1 (right).
Pose eye_in_world(Session& session, std::uint32_t eye, XrTime time) {
  constexpr double half_distance_m = 0.0315;
  return session.world().head(time) * Pose{.position_m = {eye == 0 ? -half_distance_m : half_distance_m, 0.0, 0.0}};
}

}  // namespace

Space& space_of(const Session& session, XrSpace handle) {
  auto& space = runtime().registry.get<Space>(handle);
  require(space.parent() == &session, XR_ERROR_VALIDATION_FAILURE, "the space is of another session");
  return space;
}

std::optional<Pose> Space::in_world(XrTime time) const {
  if (!reference_) return std::nullopt;
  World& world = session().world();
  const bool is_view = *reference_ == XR_REFERENCE_SPACE_TYPE_VIEW;
  return (is_view ? world.head(time) : world.origins.in_world(*reference_, time)) * offset_;
}

bool Space::is_in_room() const { return reference_ && *reference_ != XR_REFERENCE_SPACE_TYPE_VIEW; }

bool Space::can_see_room() const { return !session().world().head_is_lost(); }

void enumerate_reference_spaces(Session& session, std::uint32_t capacity, std::uint32_t* count,
                                XrReferenceSpaceType* types) {
  two_call(reference_spaces(session), capacity, count, types);
}

void create_reference_space(Session& session, const XrReferenceSpaceCreateInfo* info, XrSpace* space) {
  require_reference_space(session, info->referenceSpaceType);
  const Pose pose = checked_pose(info->poseInReferenceSpace);
  *space = handle_of<XrSpace>(runtime().registry.create<Space>(&session, info->referenceSpaceType, pose));
}

void create_action_space(Session& session, const XrActionSpaceCreateInfo* info, XrSpace* space) {
  const auto& action = runtime().registry.get<Action>(info->action);
  require(action.action_type == XR_ACTION_TYPE_POSE_INPUT, XR_ERROR_ACTION_TYPE_MISMATCH, "not a pose action");
  if (info->subactionPath != XR_NULL_PATH) {
    session.instance().paths.text(info->subactionPath);
    require(action.has_subaction(info->subactionPath), XR_ERROR_PATH_UNSUPPORTED,
            "the action has no such subaction path");
  }
  const Pose pose = checked_pose(info->poseInActionSpace);
  *space = handle_of<XrSpace>(runtime().registry.create<Space>(&session, std::nullopt, pose));
}

XrResult get_reference_space_bounds_rect(Session& session, XrReferenceSpaceType type, XrExtent2Df* bounds) {
  require_reference_space(session, type);
  const bool bounded = type == XR_REFERENCE_SPACE_TYPE_STAGE;
  *bounds = bounded ? stage_bounds_m : XrExtent2Df{0.0F, 0.0F};
  return bounded ? XR_SUCCESS : XR_SPACE_BOUNDS_UNAVAILABLE;
}

void locate_space(Space& space, Space& base, XrTime time, XrSpaceLocation* location) {
  require(space.parent() == base.parent(), XR_ERROR_VALIDATION_FAILURE, "the spaces are of different sessions");
  require(time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  if (auto* velocity = chained<XrSpaceVelocity>(location->next))
    *velocity = {.type = velocity->type, .next = velocity->next};
  write_location(space, base, time, *location);
}

void locate_spaces(Session& session, const XrSpacesLocateInfo* info, XrSpaceLocations* locations) {
  require(info->spaceCount > 0, XR_ERROR_VALIDATION_FAILURE, "spaceCount is 0");
  require_pointer(info->spaces, "spaces");
  require(locations->locationCount == info->spaceCount, XR_ERROR_VALIDATION_FAILURE, "locationCount is not spaceCount");
  require_pointer(locations->locations, "locations");
  auto* velocities = chained<XrSpaceVelocities>(locations->next);
  if (velocities != nullptr) {
    require(velocities->velocityCount == info->spaceCount, XR_ERROR_VALIDATION_FAILURE,
            "velocityCount is not spaceCount");
    require_pointer(velocities->velocities, "velocities");
    std::fill_n(velocities->velocities, velocities->velocityCount, XrSpaceVelocityData{});
  }
  const Space& base = space_of(session, info->baseSpace);
  require(info->time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  std::vector<const Space*> spaces;
  for (std::uint32_t i = 0; i < info->spaceCount; ++i) spaces.push_back(&space_of(session, info->spaces[i]));
  for (std::uint32_t i = 0; i < info->spaceCount; ++i)
    write_location(*spaces[i], base, info->time, locations->locations[i]);
}

void destroy_space(XrSpace handle) { runtime().registry.destroy(runtime().registry.get_even_lost<Space>(handle)); }

void locate_views(Session& session, const XrViewLocateInfo* info, XrViewState* state, std::uint32_t capacity,
                  std::uint32_t* count, XrView* views) {
  const Space& space = space_of(session, info->space);
  require_view_configuration(info->viewConfigurationType);
  require(info->displayTime > 0, XR_ERROR_TIME_INVALID, "times are positive");
  const auto in_world = space.in_world(info->displayTime);
  two_call(std::array{0U, 1U}, capacity, count, views, [&](XrView& view, std::uint32_t eye) {
    view.pose = to_xr(in_world ? inverse(*in_world) * eye_in_world(session, eye, info->displayTime) : Pose{});
    view.fov = field_of_view;
  });
  state->viewStateFlags = 0;
  if (!in_world) return;
  state->viewStateFlags =
      XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_TRACKED_BIT;
  if (!space.is_in_room() || space.can_see_room()) state->viewStateFlags |= XR_VIEW_STATE_POSITION_TRACKED_BIT;
}

}  // namespace hrt::mock
