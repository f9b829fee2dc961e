// Action sets, actions, suggested bindings, and the input of a session.
#pragma once

#include <openxr/openxr.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "samples/mock_runtime/api/instance.h"
#include "samples/mock_runtime/playback/recording.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

class ActionSet : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_ACTION_SET;
  ActionSet(Instance* instance, const XrActionSetCreateInfo& info);

  std::string name;
  std::string localized_name;
  std::uint32_t priority;
  bool attached = false;  ///< to a session: immutable from then on
};

class Action : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_ACTION;
  Action(ActionSet* set, const XrActionCreateInfo& info);

  ActionSet& action_set() const { return static_cast<ActionSet&>(*parent()); }
  bool has_subaction(XrPath path) const;
  /// With its set's: "set/action".
  std::string full_name() const { return action_set().name + "/" + name; }

  std::string name;
  std::string localized_name;
  XrActionType action_type;
  std::vector<XrPath> subactions;
};

/// A simulated device's sources, by path.
struct Device {
  bool active = false;
  XrPath profile = XR_NULL_PATH;
  std::map<std::string, float> values;  ///< of boolean (0 or 1) and scalar sources
  std::map<std::string, Pose> poses;    ///< in the world
};

/// The input of a session.
class Input {
 public:
  Input(const Instance& instance, const World& world) : instance_(instance), world_(world) {}

  /// Attaches the session's action sets, with the bindings suggested so far. Called once.
  void attach(const std::vector<ActionSet*>& sets, const SuggestedBindings& suggestions);
  bool is_attached() const { return attached_; }
  bool is_attached(const ActionSet& set) const { return sets_.contains(set.id()); }

  /// By top level user path.
  std::map<std::string, Device, std::less<>> devices;

  /// An active action set and its one subaction path, or XR_NULL_PATH.
  using ActiveSet = std::pair<const ActionSet*, XrPath>;

  /// Copies the devices' state into the actions of the active sets. Returns true if an interaction profile
  /// has changed.
  bool sync(const std::vector<ActiveSet>& active);

  /// State at the last sync; XR_NULL_PATH: of all subaction paths together.
  ActionState state(const Action& action, XrPath subaction) const;

  /// In the world, the source that drives the action since the last sync; none without one.
  std::optional<Motion> motion(std::uint64_t action, XrPath subaction, XrTime time) const;

  /// The current profile of a top level user path, or XR_NULL_PATH.
  XrPath current_profile(const std::string& top_level) const;

  /// The paths that an action is bound to under the current profiles.
  std::vector<XrPath> bound_sources(const Action& action) const;

 private:
  struct Driver;  // one binding that a device can drive

  std::vector<Driver> drivers(const Action& action) const;
  bool update_profiles();

  const Instance& instance_;
  const World& world_;
  bool attached_ = false;
  std::set<std::uint64_t> sets_;
  SuggestedBindings suggestions_;
  std::map<std::string, XrPath> profiles_;
  std::map<std::pair<std::uint64_t, XrPath>, ActionState> states_;
  std::map<std::pair<std::uint64_t, XrPath>, std::string> pose_sources_;
  std::map<std::pair<std::uint64_t, XrPath>, std::string> pose_givers_;  // their top level user paths
};

}  // namespace hrt::mock
