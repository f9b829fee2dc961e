// From device state to action state: specification, "Input", "Suggested Bindings" and xrSyncActions.
#include "samples/mock_runtime/api/input.h"

#include <algorithm>
#include <cmath>

#include "samples/mock_runtime/input/paths.h"

namespace hrt::mock {
namespace {

// A float from here on counts as a pressed button.
constexpr float press_threshold = 0.5F;

// "/user/hand/left/input/trigger" of "/user/hand/left/input/trigger/value", for which action sets compete.
std::string identifier_of(const std::string& source) {
  return source.find("/input/") == std::string::npos ? source : source.substr(0, source.rfind('/'));
}

float value_of(const Device& device, const Source& source) {
  const auto found = device.values.find(source.path);
  return found == device.values.end() ? 0.0F : found->second;
}

XrVector2f value_of(const Device& device, const std::vector<Source>& sources, XrActionType type) {
  const float x = value_of(device, sources[0]);
  if (type == XR_ACTION_TYPE_BOOLEAN_INPUT) return {x > press_threshold ? 1.0F : 0.0F, 0.0F};
  return {x, sources.size() > 1 ? value_of(device, sources[1]) : 0.0F};
}

// Of a controller without a set pose: held before the user, to its side.
Pose unplaced_grip(XrHandEXT hand) {
  return local_space_in_world() * Pose{.position_m = {hand == XR_HAND_LEFT_EXT ? -0.2 : 0.2, -0.3, -0.4}};
}

// The pointing pose is ahead of the grip. Of the palm -Z is where the straight index finger points, and of
// the grip where the thumb is (XR_EXT_palm_pose): the finger leans this far from the controller's axis.
Pose source_in_grip(const std::string& source) {
  constexpr double palm_deg = -60.0;
  const auto is = [&](const char* kind) { return source.find(kind) != std::string::npos; };
  if (is("/aim/")) return {.position_m = {0.0, 0.0, -0.05}};
  if (is("/palm_ext/") || is("/grip_surface/")) return {.orientation = turn(palm_deg, Eigen::Vector3d::UnitX())};
  return {};
}

// Of several sources the one with the largest magnitude counts; for booleans that is "any".
float magnitude(const XrVector2f& value) { return std::hypot(value.x, value.y); }

}  // namespace

struct Input::Driver {
  const Device* device;
  std::string_view top_level;
  XrPath binding;
  std::vector<Source> sources;
};

void Input::attach(const std::vector<ActionSet*>& sets, const SuggestedBindings& suggestions) {
  attached_ = true;
  suggestions_ = suggestions;
  for (ActionSet* set : sets) {
    sets_.insert(set->id());
    set->attached = true;
  }
}

XrPath Input::current_profile(const std::string& top_level) const {
  const auto found = profiles_.find(top_level);
  return found == profiles_.end() ? XR_NULL_PATH : found->second;
}

bool Input::update_profiles() {
  std::map<std::string, XrPath> current;
  for (const auto& [top_level, device] : devices)
    if (device.active && suggestions_.contains(device.profile)) current[top_level] = device.profile;
  const bool changed = current != profiles_;
  profiles_ = std::move(current);
  return changed;
}

std::vector<Input::Driver> Input::drivers(const Action& action) const {
  std::vector<Driver> found;
  const PathTable& paths = instance_.paths;
  for (const auto& [top_level, profile_path] : profiles_) {
    const auto* profile = find_profile(paths.text(profile_path), instance_.sources());
    for (const Binding& binding : suggestions_.at(profile_path)) {
      const std::string& path = paths.text(binding.path);
      if (binding.action != action.id() || top_level_of(path) != top_level) continue;
      auto sources = resolve_binding(*profile, path, action.action_type);
      if (sources && !sources->empty())
        found.push_back({&devices.at(top_level), top_level_of(path), binding.path, std::move(*sources)});
    }
  }
  return found;
}

bool Input::sync(const std::vector<ActiveSet>& active) {
  const bool profiles_changed = update_profiles();
  const PathTable& paths = instance_.paths;
  const Registry& registry = runtime().registry;
  const auto is_active_for = [&](const ActiveSet& set, const Driver& driver) {
    return set.second == XR_NULL_PATH || paths.text(set.second) == driver.top_level;
  };

  // "If multiple action sets with bindings to the same input are active, only those of the highest priority".
  std::map<std::string, std::uint32_t> highest;
  for (const ActiveSet& set : active)
    for (const Action* action : registry.children<Action>(*set.first))
      for (const Driver& driver : drivers(*action)) {
        if (!is_active_for(set, driver)) continue;
        const std::string identifier = identifier_of(driver.sources[0].path);
        std::uint32_t& priority = highest.try_emplace(identifier, set.first->priority).first->second;
        priority = std::max(priority, set.first->priority);
      }

  const XrTime now = instance_.clock.now();
  auto previous = std::move(states_);
  states_.clear();
  pose_sources_.clear();
  for (const ActiveSet& set : active) {
    for (const Action* action : registry.children<Action>(*set.first)) {
      for (const Driver& driver : drivers(*action)) {
        if (!is_active_for(set, driver)) continue;
        if (highest.at(identifier_of(driver.sources[0].path)) > set.first->priority) continue;
        const XrVector2f value = value_of(*driver.device, driver.sources, action->action_type);
        std::vector<XrPath> subactions{XR_NULL_PATH};
        for (const XrPath subaction : action->subactions)
          if (paths.text(subaction) == driver.top_level) subactions.push_back(subaction);
        for (const XrPath subaction : subactions) {
          ActionState& state = states_[{action->id(), subaction}];
          if (!state.active || magnitude(value) > magnitude(state.value)) state.value = value;
          state.active = true;
          if (driver.sources[0].kind != SourceKind::pose) continue;
          // Of several devices that may give a pose the first one does, also while it is off.
          const auto& giver = pose_givers_.try_emplace({action->id(), subaction}, driver.top_level).first->second;
          if (giver == driver.top_level) pose_sources_.try_emplace({action->id(), subaction}, driver.sources[0].path);
        }
      }
    }
  }
  for (auto& [key, state] : states_) {
    const auto before = previous.find(key);
    const bool was_active = before != previous.end() && before->second.active;
    state.changed = was_active && (before->second.value.x != state.value.x || before->second.value.y != state.value.y);
    state.last_change = state.changed || !was_active ? now : before->second.last_change;
  }
  return profiles_changed;
}

ActionState Input::state(const Action& action, XrPath subaction) const {
  const auto found = states_.find({action.id(), subaction});
  return found == states_.end() ? ActionState{} : found->second;
}

std::optional<Motion> Input::motion(std::uint64_t action, XrPath subaction, XrTime time) const {
  const auto driver = pose_sources_.find({action, subaction});
  if (driver == pose_sources_.end()) return std::nullopt;
  const std::string& source = driver->second;
  const std::string_view top_level = top_level_of(source);
  const auto device = devices.find(top_level);
  if (device == devices.end() || !device->second.active) return std::nullopt;
  if (const auto pose = device->second.poses.find(source); pose != device->second.poses.end())
    return Motion{pose->second};
  const XrHandEXT hand = top_level.ends_with("/left") ? XR_HAND_LEFT_EXT : XR_HAND_RIGHT_EXT;
  const auto grip = world_.controller(hand, time);
  return grip ? *grip * source_in_grip(source) : Motion{unplaced_grip(hand) * source_in_grip(source)};
}

std::vector<XrPath> Input::bound_sources(const Action& action) const {
  std::vector<XrPath> found;
  for (const Driver& driver : drivers(action))
    if (std::find(found.begin(), found.end(), driver.binding) == found.end()) found.push_back(driver.binding);
  return found;
}

}  // namespace hrt::mock
