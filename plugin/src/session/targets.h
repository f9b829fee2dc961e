#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "haptic_retargeting/base.h"
#include "plugin/src/session/session_model.h"

namespace hrt::plugin {

enum class TargetRole : std::uint8_t { any, real, virtual_target };

/// Position of a target: its direction and distance from the start, or coordinates on the plate or in the world.
struct TargetPlace {
  enum class Kind : std::uint8_t { none, direction, plate_position, world_position };
  Kind kind = Kind::direction;
  double direction_deg = 0.0;  ///< seen from the start, with `distance_m`
  double distance_m = 0.1;
  Vec3 position_m;        ///< in plate coordinates or in the world
  double radius_m = 0.0;  ///< radius of a real object; 0: unknown
};

struct Target {
  TargetRole role = TargetRole::real;
  TargetPlace place;
  std::array<char, 64> name{};  ///< terminated by a zero and padded with zeros
  std::uint64_t served_by = 0;  ///< id of the real target that is assigned to a virtual one; 0: none
};

/// A target seen from the start of a reach, in the plane of the plate.
struct TargetView {
  double direction_deg;  ///< in [-180, 180]
  double distance_mm;    ///< >= 0
  PlatePoint point;
  bool at_start;  ///< true if the distance is less than min_distance_m, so that the direction is undetermined
};
TargetView view_from(const PlatePoint& start, const PlateMount& mount, const TargetPlace& place);

/// The target seen from the configured start of the session.
inline TargetView view(const SessionModel& model, const TargetPlace& place) {
  return view_from(start_of(model), model.mount, place);
}

/// Fails if a target is too near to the configured start of the session.
hrt_result check_target(const SessionModel& model, const Target& target);

/// Targets by id. Ids are from one counter of the process: each is used once, and later targets have greater ids.
class Targets {
 public:
  static constexpr std::size_t max_targets = 1'000'000;

  Targets();
  hrt_result add(const Target& target, std::uint64_t* out_id);
  /// Replaces a target. Allocates nothing if the name is unchanged.
  hrt_result set(std::uint64_t id, const Target& target);
  /// Sets Target::served_by. Requires that `id` exists.
  void set_served_by(std::uint64_t id, std::uint64_t real_target) { by_id_.at(id).served_by = real_target; }
  hrt_result remove(std::uint64_t id);

  const Target* find(std::uint64_t id) const;
  /// Finds a target. Fails if it does not exist or has another role than `role`, unless that is TargetRole::any.
  /// `argument`: name of the id in error texts.
  hrt_result find(const char* argument, std::uint64_t id, TargetRole role, const Target** out) const;
  /// Returns the id of the target with this name, or 0.
  std::uint64_t find(std::string_view name) const;

  const std::map<std::uint64_t, Target>& all() const { return by_id_; }
  bool has_both_roles() const { return real_count_ > 0 && by_id_.size() > real_count_; }
  /// True if there are both roles, and all targets are given by directions of at most 1.6, at least two of them not 0.
  /// If these were degrees, targets at 100 mm from the start would be within 6 mm of each other.
  bool may_be_in_radians() const;

  /// Returns the number of a target in recordings: the difference between its id and the last id before this object was
  /// created; 0 if this object does not have the target.
  std::uint64_t number(std::uint64_t id) const { return by_id_.contains(id) ? id - before_first_ : 0; }

 private:
  std::map<std::uint64_t, Target> by_id_;
  std::map<std::string, std::uint64_t, std::less<>> by_name_;
  std::size_t real_count_ = 0;
  std::uint64_t before_first_;  // the last id that was assigned before this object was created
};

}  // namespace hrt::plugin
