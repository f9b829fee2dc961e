// The node's targets, what can be held between them, and the scene that has them.
#include "plate_node.h"

#include <algorithm>

#include "pose.h"

namespace hrt_godot {
namespace {

/** A name that does not fit has no zero at its end, which the plugin refuses. */
hrt_target_config target_config(uint32_t role, const std::string& name) {
  hrt_target_config config = hrt_target_config_init();
  config.role = role;
  name.copy(config.name, sizeof config.name);
  return config;
}

hrt_target_config polar_target(uint32_t role, const Value* arguments) {
  hrt_target_config config = target_config(role, to_text(arguments[0]));
  config.direction_deg = to_real(arguments[1]);
  config.distance_m = to_real(arguments[2]);
  return config;
}

void place_at(const Vector3& world_position, hrt_target_config& config) {
  config.place = HRT_PLACE_WORLD_POSITION;
  copy(world_position, config.position_m);
}

hrt_target_config placed_target(uint32_t role, const Value* arguments) {
  hrt_target_config config = target_config(role, to_text(arguments[0]));
  place_at(std::get<Vector3>(arguments[1]), config);
  return config;
}

}  // namespace

Value PlateNode::add_target(const hrt_target_config& config) {
  hrt_target target{};
  if (!configure() || !ok(hrt_target_add(session_, &config, &target))) return kNoTarget;
  return static_cast<int64_t>(target.value);
}

Value PlateNode::add_real_target(const Value* arguments) {
  return add_target(polar_target(HRT_TARGET_REAL, arguments));
}

Value PlateNode::add_virtual_target(const Value* arguments) {
  return add_target(polar_target(HRT_TARGET_VIRTUAL, arguments));
}

Value PlateNode::add_real_target_at(const Value* arguments) {
  return add_target(placed_target(HRT_TARGET_REAL, arguments));
}

Value PlateNode::add_virtual_target_at(const Value* arguments) {
  return add_target(placed_target(HRT_TARGET_VIRTUAL, arguments));
}

Value PlateNode::move_target_to(const Value* arguments) {
  hrt_target_config config = hrt_target_config_init();
  if (!configure() || !ok(hrt_target_get(session_, to_target(arguments[0]), &config)))
    return to_godot_error(result_);
  place_at(std::get<Vector3>(arguments[1]), config);
  ok(hrt_target_set(session_, to_target(arguments[0]), &config));
  return to_godot_error(result_);
}

Value PlateNode::remove_target(const Value* arguments) {
  ok(hrt_target_remove(session_, to_target(arguments[0])));
  return to_godot_error(result_);
}

Value PlateNode::get_gap(const Value* arguments) {
  hrt_gap gap = hrt_gap_init();
  if (!configure() || !ok(hrt_gap_query(session_, to_target(arguments[0]), to_target(arguments[1]), &gap)))
    return Record{};
  return to_record(&gap, gap_fields);
}

bool PlateNode::list_targets(uint32_t role, std::vector<hrt_target>& out_targets) {
  uint64_t count = 0;
  if (!ok(hrt_target_list(session_, role, 0, nullptr, &count))) return false;
  out_targets.resize(count);
  return ok(hrt_target_list(session_, role, count, out_targets.data(), &count));
}

Value PlateNode::assign_targets(const Value* arguments) {
  std::vector<hrt_target> real, felt;
  if (!configure() || !list_targets(HRT_TARGET_REAL, real) || !list_targets(HRT_TARGET_VIRTUAL, felt))
    return to_godot_error(result_);
  // One more than is filled, because the plugin reads the first one's size.
  std::vector<hrt_gap> assigned(felt.size() + 1, hrt_gap_init());
  const uint32_t flags = std::get<bool>(arguments[0]) ? HRT_ASSIGN_EXCLUSIVE : 0;
  if (ok(hrt_target_assign(session_, felt.data(), felt.size(), real.data(), real.size(), flags, felt.size(),
                           assigned.data()))) {
    assigned.pop_back();
    assigned_ = std::move(assigned);
  }
  return to_godot_error(result_);
}

Value PlateNode::get_assigned(const Value* arguments) {
  const auto found = std::find_if(assigned_.begin(), assigned_.end(), [&](const hrt_gap& one) {
    return one.virtual_target.value == to_target(arguments[0]).value;
  });
  if (found != assigned_.end()) return to_record(&*found, gap_fields);
  engine_.push_error("get_assigned: no assignment of this virtual target; call assign_targets() first");
  return Record{};
}

Value PlateNode::load_scene(const Value* arguments) {
  hrt_scene scene{};
  if (!configure() || !ok(hrt_scene_load(to_text(arguments[0]).c_str(), nullptr, 0, &scene)))
    return to_godot_error(result_);
  const bool registered = ok(hrt_scene_register(scene, session_, 0, nullptr));
  const hrt_result result = result_;
  hrt_scene_destroy(scene);
  if (registered) take_changes();
  return to_godot_error(result);
}

Value PlateNode::find_target(const Value* arguments) {
  std::vector<hrt_target> targets;
  if (!configure() || !list_targets(0, targets)) return kNoTarget;
  const std::string name = to_text(arguments[0]);
  for (const hrt_target target : targets) {
    hrt_target_config config = hrt_target_config_init();
    if (ok(hrt_target_get(session_, target, &config)) && name == config.name)
      return static_cast<int64_t>(target.value);
  }
  engine_.push_error(("find_target: no target has the name \"" + name + '"').c_str());
  return kNoTarget;
}

}  // namespace hrt_godot
