#include "samples/mock_runtime/api/space.h"

#include "samples/mock_runtime/api/chain.h"
#include "samples/mock_runtime/api/two_call.h"
#include "samples/mock_runtime/api/views.h"

namespace hrt::mock {
namespace {

// Within a seated user's reach.
constexpr XrExtent2Df stage_bounds_m{2.0F, 2.0F};
constexpr double half_eye_distance_m = 0.0315;
constexpr XrFovf field_of_view{-0.785F, 0.785F, 0.785F, -0.785F};

constexpr XrSpaceLocationFlags all_location_flags =
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
    XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;

void play_views(Player& player, const Space& space, const XrViewLocateInfo& info, XrViewState& state,
                std::uint32_t capacity, std::uint32_t* count, XrView* views) {
  // The count alone is no sample.
  const RecordedViews played = capacity > 0 ? player.views(space.name, info.displayTime) : RecordedViews{};
  two_call(std::array{std::size_t{0}, std::size_t{1}}, capacity, count, views,
           [&](XrView& view, std::size_t eye) {
             const bool given = eye < played.views.size();
             view.pose = given ? played.views[eye].pose : to_xr(Pose{});
             view.fov = given ? played.views[eye].fov : field_of_view;
           });
  state.viewStateFlags = played.flags;
}

std::vector<XrReferenceSpaceType> reference_spaces(const Session& session) {
  if (session.player && session.player->spaces()) return *session.player->spaces();
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

// A location of a recording, as far as it is asked for.
template <typename Location, typename Velocity>
void play_location(const RecordedLocation& recorded, Location& location, Velocity* velocity) {
  location.locationFlags = recorded.flags;
  location.pose = recorded.pose;
  if (velocity == nullptr) return;
  velocity->velocityFlags = recorded.velocity_flags;
  velocity->linearVelocity = recorded.linear;
  velocity->angularVelocity = recorded.angular;
}

XrSpaceLocationFlags flags_of(const Space& space, const Space& base) {
  const bool seen = space.stands_in_room() == base.stands_in_room() || base.can_see_room();
  return seen ? all_location_flags : all_location_flags & ~XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
}

template <typename Location>
void write_location(const std::optional<Motion>& motion, XrSpaceLocationFlags flags, Location& location) {
  location.locationFlags = motion ? flags : 0;
  location.pose = to_xr(motion ? motion->pose : Pose{});
}
template <typename Velocity>
void write_velocity(const std::optional<Motion>& motion, Velocity& velocity) {
  velocity.velocityFlags = motion ? XR_SPACE_VELOCITY_LINEAR_VALID_BIT | XR_SPACE_VELOCITY_ANGULAR_VALID_BIT
                                  : XrSpaceVelocityFlags{0};
  velocity.linearVelocity = velocity.angularVelocity = {0.0F, 0.0F, 0.0F};
  if (!motion) return;
  velocity.linearVelocity = to_xr(motion->velocity_m_per_s);
  velocity.angularVelocity = to_xr(motion->angular_velocity_rad_per_s);
}

}  // namespace

std::optional<Motion> Space::motion(XrTime time) const {
  if (const auto* action = std::get_if<ActionOrigin>(&origin)) {
    const auto motion = session().input.motion(action->action, action->subaction, time);
    return motion ? std::optional(*motion * offset) : std::nullopt;
  }
  const auto type = std::get<XrReferenceSpaceType>(origin);
  if (type == XR_REFERENCE_SPACE_TYPE_VIEW) return session().world().head(time) * offset;
  return Motion{session().world().origins.in_world(type, time) * offset};
}

bool Space::stands_in_room() const {
  const auto* type = std::get_if<XrReferenceSpaceType>(&origin);
  return type != nullptr && *type != XR_REFERENCE_SPACE_TYPE_VIEW;
}

bool Space::can_see_room() const {
  return !session().world().head_is_lost();
}

std::optional<Pose> Space::in_world(XrTime time) const {
  const auto moving = motion(time);
  return moving ? std::optional(moving->pose) : std::nullopt;
}

std::optional<Motion> locate(const Space& space, const Space& base, XrTime time) {
  const auto of = space.motion(time);
  const auto in = base.motion(time);
  if (!of || !in) return std::nullopt;
  return relative(*of, *in);
}

void enumerate_reference_spaces(XrSession handle, std::uint32_t capacity, std::uint32_t* count,
                                XrReferenceSpaceType* types) {
  two_call(reference_spaces(runtime().registry.get<Session>(handle)), capacity, count, types);
}

void create_reference_space(XrSession handle, const XrReferenceSpaceCreateInfo* info, XrSpace* space) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_REFERENCE_SPACE_CREATE_INFO, "createInfo");
  require_pointer(space, "space");
  require_reference_space(session, info->referenceSpaceType);
  const Pose pose = checked_pose(info->poseInReferenceSpace);
  const SpaceName name{info->referenceSpaceType, {}, {}, info->poseInReferenceSpace};
  *space = handle_of<XrSpace>(
      runtime().registry.create<Space>(&session, Space::Origin(info->referenceSpaceType), name, pose));
}

void create_action_space(XrSession handle, const XrActionSpaceCreateInfo* info, XrSpace* space) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_ACTION_SPACE_CREATE_INFO, "createInfo");
  require_pointer(space, "space");
  const auto& action = runtime().registry.get<Action>(info->action);
  require(action.action_type == XR_ACTION_TYPE_POSE_INPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
          "not a pose action");
  SpaceName name{.action = action.full_name(), .pose = info->poseInActionSpace};
  if (info->subactionPath != XR_NULL_PATH) {
    name.subaction = session.instance().paths.text(info->subactionPath);
    require(action.has_subaction(info->subactionPath), XR_ERROR_PATH_UNSUPPORTED,
            "the action has no such subaction path");
  }
  const Pose pose = checked_pose(info->poseInActionSpace);
  const Space::ActionOrigin origin{action.id(), info->subactionPath};
  *space = handle_of<XrSpace>(runtime().registry.create<Space>(&session, Space::Origin(origin), name, pose));
}

XrResult get_reference_space_bounds_rect(XrSession handle, XrReferenceSpaceType type, XrExtent2Df* bounds) {
  auto& session = runtime().registry.get<Session>(handle);
  require_pointer(bounds, "bounds");
  require_reference_space(session, type);
  if (const auto* played = session.player ? session.player->next_bounds(type) : nullptr) {
    *bounds = played->value_or(XrExtent2Df{});
    return *played ? XR_SUCCESS : XR_SPACE_BOUNDS_UNAVAILABLE;
  }
  const bool bounded = type == XR_REFERENCE_SPACE_TYPE_STAGE;
  *bounds = bounded ? stage_bounds_m : XrExtent2Df{0.0F, 0.0F};
  return bounded ? XR_SUCCESS : XR_SPACE_BOUNDS_UNAVAILABLE;
}

void locate_space(XrSpace handle, XrSpace base_handle, XrTime time, XrSpaceLocation* location) {
  auto& space = runtime().registry.get<Space>(handle);
  auto& base = runtime().registry.get<Space>(base_handle);
  require_struct(location, XR_TYPE_SPACE_LOCATION, "location");
  require(space.parent() == base.parent(), XR_ERROR_VALIDATION_FAILURE,
          "the spaces are of different sessions");
  require(time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  auto* velocity = chained<XrSpaceVelocity>(location->next, XR_TYPE_SPACE_VELOCITY);
  if (auto& player = space.session().player) {
    play_location(player->location(space.name, base.name, time), *location, velocity);
    return;
  }
  const auto located = locate(space, base, time);
  write_location(located, flags_of(space, base), *location);
  if (velocity != nullptr) write_velocity(located, *velocity);
}

void locate_spaces(XrSession handle, const XrSpacesLocateInfo* info, XrSpaceLocations* locations) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_SPACES_LOCATE_INFO, "locateInfo");
  require_struct(locations, XR_TYPE_SPACE_LOCATIONS, "spaceLocations");
  require(info->spaceCount > 0, XR_ERROR_VALIDATION_FAILURE, "spaceCount is 0");
  require_pointer(info->spaces, "spaces");
  require(locations->locationCount == info->spaceCount, XR_ERROR_VALIDATION_FAILURE,
          "locationCount is not spaceCount");
  require_pointer(locations->locations, "locations");
  auto* velocities = chained<XrSpaceVelocities>(locations->next, XR_TYPE_SPACE_VELOCITIES);
  if (velocities != nullptr) {
    require(velocities->velocityCount == info->spaceCount, XR_ERROR_VALIDATION_FAILURE,
            "velocityCount is not spaceCount");
    require_pointer(velocities->velocities, "velocities");
  }
  const auto of_session = [&](XrSpace space) -> const Space& {
    const auto& found = runtime().registry.get<Space>(space);
    require(found.parent() == &session, XR_ERROR_VALIDATION_FAILURE, "a space is of another session");
    return found;
  };
  const Space& base = of_session(info->baseSpace);
  require(info->time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  std::vector<const Space*> spaces;
  for (std::uint32_t i = 0; i < info->spaceCount; ++i) spaces.push_back(&of_session(info->spaces[i]));
  for (std::uint32_t i = 0; i < info->spaceCount; ++i) {
    if (session.player) {
      play_location(session.player->location(spaces[i]->name, base.name, info->time), locations->locations[i],
                    velocities == nullptr ? nullptr : &velocities->velocities[i]);
      continue;
    }
    const auto located = locate(*spaces[i], base, info->time);
    write_location(located, flags_of(*spaces[i], base), locations->locations[i]);
    if (velocities != nullptr) write_velocity(located, velocities->velocities[i]);
  }
}

void destroy_space(XrSpace handle) {
  runtime().registry.destroy(runtime().registry.get_even_lost<Space>(handle));
}

void locate_views(XrSession handle, const XrViewLocateInfo* info, XrViewState* state, std::uint32_t capacity,
                  std::uint32_t* count, XrView* views) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_VIEW_LOCATE_INFO, "viewLocateInfo");
  require_struct(state, XR_TYPE_VIEW_STATE, "viewState");
  auto& space = runtime().registry.get<Space>(info->space);
  require(space.parent() == &session, XR_ERROR_VALIDATION_FAILURE, "the space is of another session");
  require_view_configuration(info->viewConfigurationType);
  require(info->displayTime > 0, XR_ERROR_TIME_INVALID, "times are positive");
  for (std::uint32_t i = 0; i < capacity && views != nullptr; ++i)
    require_struct(&views[i], XR_TYPE_VIEW, "views");
  if (session.player) return play_views(*session.player, space, *info, *state, capacity, count, views);
  const auto in_world = space.in_world(info->displayTime);
  const Pose head = session.world().head(info->displayTime).pose;
  two_call(std::array{-half_eye_distance_m, half_eye_distance_m}, capacity, count, views,
           [&](XrView& view, double right_m) {
             const Pose eye = head * Pose{.position_m = {right_m, 0.0, 0.0}};
             view.pose = to_xr(in_world ? inverse(*in_world) * eye : Pose{});
             view.fov = field_of_view;
           });
  state->viewStateFlags =
      !in_world ? 0
                : XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT |
                      XR_VIEW_STATE_ORIENTATION_TRACKED_BIT |
                      (space.stands_in_room() && !space.can_see_room() ? XrViewStateFlags{0}
                                                                       : XR_VIEW_STATE_POSITION_TRACKED_BIT);
}

}  // namespace hrt::mock
