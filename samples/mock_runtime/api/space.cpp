#include "samples/mock_runtime/api/space.h"

#include "samples/mock_runtime/api/two_call.h"
#include "samples/mock_runtime/api/views.h"

namespace hrt::mock {
namespace {

constexpr std::array reference_spaces{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL,
                                      XR_REFERENCE_SPACE_TYPE_STAGE};
// Within a seated user's reach.
constexpr XrExtent2Df stage_bounds_m{2.0F, 2.0F};
constexpr double half_eye_distance_m = 0.0315;
constexpr XrFovf field_of_view{-0.785F, 0.785F, 0.785F, -0.785F};

constexpr XrSpaceLocationFlags all_location_flags =
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
    XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;

void require_reference_space(XrReferenceSpaceType type) {
  const bool present =
      std::find(reference_spaces.begin(), reference_spaces.end(), type) != reference_spaces.end();
  if (present) return;
  switch (type) {
    case XR_REFERENCE_SPACE_TYPE_UNBOUNDED_MSFT:
    case XR_REFERENCE_SPACE_TYPE_COMBINED_EYE_VARJO:
      throw Error{XR_ERROR_REFERENCE_SPACE_UNSUPPORTED, "reference spaces are VIEW, LOCAL and STAGE"};
    default:
      throw Error{XR_ERROR_VALIDATION_FAILURE, "no such reference space type"};
  }
}

}  // namespace

std::optional<Pose> Space::in_world(XrTime) const {
  if (const auto* action = std::get_if<ActionOrigin>(&origin)) {
    const auto pose = session().input.pose(action->action, action->subaction);
    return pose ? std::optional(*pose * offset) : std::nullopt;
  }
  if (std::get<XrReferenceSpaceType>(origin) == XR_REFERENCE_SPACE_TYPE_STAGE) return offset;
  return local_space_in_world() * offset;  // VIEW too: the user looks straight ahead
}

std::optional<Pose> locate(const Space& space, const Space& base, XrTime time) {
  const auto of = space.in_world(time);
  const auto in = base.in_world(time);
  if (!of || !in) return std::nullopt;
  return inverse(*in) * *of;
}

XrResult enumerate_reference_spaces(XrSession handle, std::uint32_t capacity, std::uint32_t* count,
                                    XrReferenceSpaceType* types) {
  runtime().registry.get<Session>(handle);
  two_call(reference_spaces, capacity, count, types);
  return XR_SUCCESS;
}

XrResult create_reference_space(XrSession handle, const XrReferenceSpaceCreateInfo* info, XrSpace* space) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_REFERENCE_SPACE_CREATE_INFO, "createInfo");
  require_pointer(space, "space");
  require_reference_space(info->referenceSpaceType);
  const Pose pose = checked_pose(info->poseInReferenceSpace);
  *space = handle_of<XrSpace>(
      runtime().registry.create<Space>(&session, Space::Origin(info->referenceSpaceType), pose));
  return XR_SUCCESS;
}

XrResult create_action_space(XrSession handle, const XrActionSpaceCreateInfo* info, XrSpace* space) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_ACTION_SPACE_CREATE_INFO, "createInfo");
  require_pointer(space, "space");
  const auto& action = runtime().registry.get<Action>(info->action);
  require(action.action_type == XR_ACTION_TYPE_POSE_INPUT, XR_ERROR_ACTION_TYPE_MISMATCH,
          "not a pose action");
  if (info->subactionPath != XR_NULL_PATH) {
    session.instance().paths.text(info->subactionPath);
    require(action.has_subaction(info->subactionPath), XR_ERROR_PATH_UNSUPPORTED,
            "the action has no such subaction path");
  }
  const Pose pose = checked_pose(info->poseInActionSpace);
  const Space::ActionOrigin origin{action.id(), info->subactionPath};
  *space = handle_of<XrSpace>(runtime().registry.create<Space>(&session, Space::Origin(origin), pose));
  return XR_SUCCESS;
}

XrResult get_reference_space_bounds_rect(XrSession handle, XrReferenceSpaceType type, XrExtent2Df* bounds) {
  runtime().registry.get<Session>(handle);
  require_pointer(bounds, "bounds");
  require_reference_space(type);
  const bool bounded = type == XR_REFERENCE_SPACE_TYPE_STAGE;
  *bounds = bounded ? stage_bounds_m : XrExtent2Df{0.0F, 0.0F};
  return bounded ? XR_SUCCESS : XR_SPACE_BOUNDS_UNAVAILABLE;
}

XrResult locate_space(XrSpace handle, XrSpace base_handle, XrTime time, XrSpaceLocation* location) {
  auto& space = runtime().registry.get<Space>(handle);
  auto& base = runtime().registry.get<Space>(base_handle);
  require_struct(location, XR_TYPE_SPACE_LOCATION, "location");
  require(space.parent() == base.parent(), XR_ERROR_VALIDATION_FAILURE,
          "the spaces are of different sessions");
  require(time > 0, XR_ERROR_TIME_INVALID, "times are positive");
  const auto pose = locate(space, base, time);
  location->locationFlags = pose ? all_location_flags : 0;
  location->pose = to_xr(pose.value_or(Pose{}));
  for (auto* next = static_cast<XrBaseOutStructure*>(location->next); next != nullptr; next = next->next) {
    if (next->type != XR_TYPE_SPACE_VELOCITY) continue;
    auto& velocity = *reinterpret_cast<XrSpaceVelocity*>(next);
    velocity.velocityFlags = pose ? XR_SPACE_VELOCITY_LINEAR_VALID_BIT | XR_SPACE_VELOCITY_ANGULAR_VALID_BIT
                                  : XrSpaceVelocityFlags{0};
    velocity.linearVelocity = velocity.angularVelocity = {0.0F, 0.0F, 0.0F};
  }
  return XR_SUCCESS;
}

XrResult destroy_space(XrSpace handle) {
  runtime().registry.destroy(runtime().registry.get_even_lost<Space>(handle));
  return XR_SUCCESS;
}

XrResult locate_views(XrSession handle, const XrViewLocateInfo* info, XrViewState* state,
                      std::uint32_t capacity, std::uint32_t* count, XrView* views) {
  auto& session = runtime().registry.get<Session>(handle);
  require_struct(info, XR_TYPE_VIEW_LOCATE_INFO, "viewLocateInfo");
  require_struct(state, XR_TYPE_VIEW_STATE, "viewState");
  auto& space = runtime().registry.get<Space>(info->space);
  require(space.parent() == &session, XR_ERROR_VALIDATION_FAILURE, "the space is of another session");
  require_view_configuration(info->viewConfigurationType);
  require(info->displayTime > 0, XR_ERROR_TIME_INVALID, "times are positive");
  for (std::uint32_t i = 0; i < capacity && views != nullptr; ++i)
    require_struct(&views[i], XR_TYPE_VIEW, "views");
  const auto in_world = space.in_world(info->displayTime);
  two_call(std::array{-half_eye_distance_m, half_eye_distance_m}, capacity, count, views,
           [&](XrView& view, double right_m) {
             const Pose eye = local_space_in_world() * Pose{.position_m = {right_m, 0.0, 0.0}};
             view.pose = to_xr(in_world ? inverse(*in_world) * eye : Pose{});
             view.fov = field_of_view;
           });
  state->viewStateFlags = !in_world ? 0
                                    : XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT |
                                          XR_VIEW_STATE_ORIENTATION_TRACKED_BIT |
                                          XR_VIEW_STATE_POSITION_TRACKED_BIT;
  return XR_SUCCESS;
}

}  // namespace hrt::mock
