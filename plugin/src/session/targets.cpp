#include "plugin/src/session/targets.h"

#include <atomic>
#include <cstring>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/utf8.h"
#include "plugin/src/session/session_config.h"

namespace hrt::plugin {

static_assert(Fields<hrt_target_config>::distance_m.low == min_distance_m);

namespace {

// The kind in the top byte keeps a target's id from being taken for a handle.
std::atomic<std::uint64_t> next_id{(std::uint64_t{0x7a} << 56) + 1};

hrt_result name_taken(const char* name) {
  return fail(HRT_ERROR_NAME_TAKEN, "name \"", name, "\" is that of another target of this session");
}

hrt_result no_such_target(std::uint64_t id) {
  return fail(HRT_ERROR_INVALID_HANDLE, "target ", id, " is not one of this session's");
}

}  // namespace

hrt_result check_target_fields(hrt_target_config* config) {
  using F = Fields<hrt_target_config>;
  HRT_RETURN_IF_FAILED(check_field(*config, F::role));
  HRT_RETURN_IF_FAILED(check_field(*config, F::place));
  HRT_RETURN_IF_FAILED(check_field(*config, F::reserved));
  if (config->place == HRT_PLACE_DIRECTION) {
    HRT_RETURN_IF_FAILED(check_field(*config, F::direction_deg));
    HRT_RETURN_IF_FAILED(check_field(*config, F::distance_m));
  } else {
    HRT_RETURN_IF_FAILED(check_field(*config, F::position_m));
  }
  HRT_RETURN_IF_FAILED(check_field(*config, F::radius_m));
  if (config->role == HRT_TARGET_REAL && config->served_by.value != 0)
    return fail(HRT_ERROR_OUT_OF_RANGE, "served_by is ", config->served_by.value, "; it must be 0 for a real target");
  return check_name("name", config->name);
}

hrt_result check_target_config(const hrt_session_config& session_config, hrt_target_config* config) {
  HRT_RETURN_IF_FAILED(check_target_fields(config));
  const TargetView seen = view(session_config, *config);
  if (seen.at_start)
    return fail(HRT_ERROR_OUT_OF_RANGE, "position_m is ", seen.distance_mm / mm_per_m,
                " m from the start in the plane of the plate; at least ", min_distance_m, " is needed");
  return HRT_OK;
}

Targets::Targets() : before_first_(next_id.load() - 1) {}

hrt_result Targets::add(const hrt_target_config& checked_config, std::uint64_t* out_id) {
  if (by_id_.size() >= HRT_TARGETS_MAX)
    return fail(HRT_ERROR_LIMIT_REACHED, "the session has ", HRT_TARGETS_MAX, " targets; remove one first");
  if (find(std::string_view(checked_config.name)) != 0) return name_taken(checked_config.name);
  const std::uint64_t id = next_id.fetch_add(1);
  const auto added = by_id_.emplace(id, checked_config).first;
  if (checked_config.name[0] != '\0') {
    try {
      by_name_.emplace(checked_config.name, id);
    } catch (...) {
      by_id_.erase(added);
      throw;
    }
  }
  real_count_ += checked_config.role == HRT_TARGET_REAL;
  *out_id = id;
  return HRT_OK;
}

hrt_result Targets::set(std::uint64_t id, const hrt_target_config& checked_config) {
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) return no_such_target(id);
  const std::string_view old_name = found->second.name;
  const std::string_view new_name = checked_config.name;
  if (new_name != old_name) {
    if (find(new_name) != 0) return name_taken(checked_config.name);
    if (!new_name.empty()) by_name_.emplace(new_name, id);
    if (!old_name.empty()) by_name_.erase(by_name_.find(old_name));
  }
  real_count_ += checked_config.role == HRT_TARGET_REAL;
  real_count_ -= found->second.role == HRT_TARGET_REAL;
  found->second = checked_config;
  return HRT_OK;
}

hrt_result Targets::remove(std::uint64_t id) {
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) return no_such_target(id);
  const auto named = by_name_.find(std::string_view(found->second.name));
  if (named != by_name_.end()) by_name_.erase(named);
  real_count_ -= found->second.role == HRT_TARGET_REAL;
  by_id_.erase(found);
  return HRT_OK;
}

const hrt_target_config* Targets::find(std::uint64_t id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &found->second;
}

std::uint64_t Targets::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? 0 : found->second;
}

TargetView view_from(const PlatePoint& start, const hrt_session_config& config, const hrt_target_config& target) {
  if (target.place == HRT_PLACE_DIRECTION)
    return {.direction_deg = target.direction_deg, .distance_mm = mm_per_m * target.distance_m, .at_start = false};
  const auto& p = target.position_m;
  const bool in_world = target.place == HRT_PLACE_WORLD_POSITION;
  const Pose plate = in_world ? plate_pose_of(config) : Pose{};
  const Vec3 given_m{p[0], p[1], p[2]};
  FingerOnPlate place{};
  locate_finger(surface_of(config), plate, in_world ? unscaled(config, plate.position_m, given_m) : given_m, place);
  const PlatePoint at = plate_point(place.position_m);
  const double far_mm = distance_mm(start, at);
  return {
      .direction_deg = bearing_deg(start, at), .distance_mm = far_mm, .at_start = far_mm < mm_per_m * min_distance_m};
}

TargetView view(const hrt_session_config& config, const hrt_target_config& target) {
  return view_from(start_of(config), config, target);
}

hrt_result find_target(const Targets& targets, const char* argument, hrt_target target, std::uint32_t role,
                       const hrt_target_config** out_config) {
  const hrt_target_config* found = targets.find(target.value);
  if (!found)
    return fail(HRT_ERROR_INVALID_HANDLE, argument, ": target ", target.value, " is not one of this session's");
  if (role != 0 && found->role != role)
    return fail(HRT_ERROR_OUT_OF_RANGE, argument, ": target ", target.value, " is a ",
                role == HRT_TARGET_REAL ? "virtual one; a real one is needed" : "real one; a virtual one is needed");
  *out_config = found;
  return HRT_OK;
}

hrt_result find_pair(const Targets& targets, hrt_target real_target, hrt_target virtual_target, Pair* out) {
  const hrt_target_config* real = nullptr;
  const hrt_target_config* virtual_config = nullptr;
  HRT_RETURN_IF_FAILED(find_target(targets, "real_target", real_target, HRT_TARGET_REAL, &real));
  HRT_RETURN_IF_FAILED(find_target(targets, "virtual_target", virtual_target, HRT_TARGET_VIRTUAL, &virtual_config));
  *out = {*real, *virtual_config};
  return HRT_OK;
}

}  // namespace hrt::plugin
