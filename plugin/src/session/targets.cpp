#include "plugin/src/session/targets.h"

#include <atomic>
#include <cmath>

#include "plugin/src/abi/error.h"

namespace hrt::plugin {
namespace {

// Ids are below 2^53, so that a double represents them exactly. They are greater than any index, and the top byte of a
// handle is not 0, so that neither an index nor a handle is accepted as an id.
std::atomic<std::uint64_t> next_id{(std::uint64_t{0x7a} << 44) + 1};

hrt_result name_taken(const Target& target) {
  return fail(HRT_ERROR_NAME_TAKEN, "name \"", target.name.data(),
              "\" is taken by another target of this session; choose another name");
}

hrt_result no_such_target(std::uint64_t id) {
  return fail(HRT_ERROR_INVALID_HANDLE, "target ", id,
              " does not exist in this session: it was removed or never added; pass an existing target");
}

}  // namespace

TargetView view_from(const PlatePoint& start, const PlateMount& mount, const TargetPlace& place) {
  if (place.kind == TargetPlace::Kind::direction) {
    const double far_mm = mm_per_m * place.distance_m;
    return {place.direction_deg, far_mm, point_ahead(start, place.direction_deg, far_mm), false};
  }
  const bool in_world = place.kind == TargetPlace::Kind::world_position;
  const PlatePoint point =
      plate_point(in_world ? plate_coordinates(mount.frame, mount.scale, place.position_m) : place.position_m);
  const double far_mm = distance_mm(start, point);
  return {bearing_deg(start, point), far_mm, point, far_mm < mm_per_m * min_distance_m};
}

hrt_result check_target(const SessionModel& model, const Target& target) {
  const TargetView seen = view(model, target.place);
  if (!seen.at_start) return HRT_OK;
  return fail(HRT_ERROR_OUT_OF_RANGE, "position_m is ", seen.distance_mm / mm_per_m,
              " m from the start in the plane of the plate; allowed: at least ", min_distance_m);
}

Targets::Targets() : before_first_(next_id.load() - 1) {}

hrt_result Targets::add(const Target& target, std::uint64_t* out_id) {
  if (by_id_.size() >= max_targets)
    return fail(HRT_ERROR_LIMIT_REACHED, "the session has ", max_targets, " targets, the maximum; remove one first");
  const std::string_view name = target.name.data();
  if (find(name) != 0) return name_taken(target);
  const std::uint64_t id = next_id.fetch_add(1);
  const auto added = by_id_.emplace(id, target).first;
  if (!name.empty()) {
    try {
      by_name_.emplace(name, id);
    } catch (...) {
      by_id_.erase(added);
      throw;
    }
  }
  real_count_ += target.role == TargetRole::real;
  *out_id = id;
  return HRT_OK;
}

hrt_result Targets::set(std::uint64_t id, const Target& target) {
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) return no_such_target(id);
  const std::string_view old_name = found->second.name.data(), new_name = target.name.data();
  if (new_name != old_name) {
    if (find(new_name) != 0) return name_taken(target);
    if (!new_name.empty()) by_name_.emplace(new_name, id);
    if (!old_name.empty()) by_name_.erase(by_name_.find(old_name));
  }
  real_count_ += target.role == TargetRole::real;
  real_count_ -= found->second.role == TargetRole::real;
  found->second = target;
  return HRT_OK;
}

bool Targets::may_be_in_radians() const {
  constexpr double right_angle = 1.6;
  int directed = 0;
  for (const auto& [id, target] : by_id_) {
    const double direction_deg = target.place.direction_deg;
    if (target.place.kind != TargetPlace::Kind::direction || std::abs(direction_deg) > right_angle) return false;
    directed += direction_deg != 0.0 ? 1 : 0;
  }
  return has_both_roles() && directed >= 2;
}

hrt_result Targets::remove(std::uint64_t id) {
  const auto found = by_id_.find(id);
  if (found == by_id_.end()) return no_such_target(id);
  const auto named = by_name_.find(std::string_view(found->second.name.data()));
  if (named != by_name_.end()) by_name_.erase(named);
  real_count_ -= found->second.role == TargetRole::real;
  by_id_.erase(found);
  return HRT_OK;
}

const Target* Targets::find(std::uint64_t id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &found->second;
}

hrt_result Targets::find(const char* argument, std::uint64_t id, TargetRole role, const Target** out) const {
  const Target* found = find(id);
  if (!found)
    return fail(HRT_ERROR_INVALID_HANDLE, argument, ": target ", id,
                " does not exist in this session: it was removed or never added; pass an existing target");
  if (role != TargetRole::any && found->role != role)
    return fail(HRT_ERROR_OUT_OF_RANGE, argument, ": target ", id, " is ",
                role == TargetRole::real ? "virtual; allowed: a real target" : "real; allowed: a virtual target");
  *out = found;
  return HRT_OK;
}

std::uint64_t Targets::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? 0 : found->second;
}

}  // namespace hrt::plugin
