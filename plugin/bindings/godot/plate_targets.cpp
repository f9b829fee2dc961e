// Targets of the node, their gaps, and scenes.
#include "plate_node.h"

namespace hrt_godot {
namespace {

hrt_target_config polar(double direction_deg, double distance_m) {
  hrt_target_config config = hrt_target_config_init();
  config.direction_deg = direction_deg;
  config.distance_m = distance_m;
  return config;
}

hrt_target_config placed(const Vector3& world_position, hrt_target_config config = hrt_target_config_init()) {
  config.place = HRT_PLACE_WORLD_POSITION;
  Vector3::Map(config.position_m) = world_position;
  return config;
}

}  // namespace

hrt_target PlateNode::add_target(uint32_t role, const std::string& name, hrt_target_config config) {
  config.role = role;
  // A name that is too long has no terminating zero, which the plugin refuses.
  name.copy(config.name, sizeof config.name);
  hrt_target target{};
  if (configure()) ok(hrt_target_add(session_, &config, &target));
  return target;
}

hrt_target PlateNode::add_real_target(std::string name, double direction_deg, double distance_m) {
  return add_target(HRT_TARGET_REAL, name, polar(direction_deg, distance_m));
}

hrt_target PlateNode::add_virtual_target(std::string name, double direction_deg, double distance_m) {
  return add_target(HRT_TARGET_VIRTUAL, name, polar(direction_deg, distance_m));
}

hrt_target PlateNode::add_real_target_at(std::string name, Vector3 world_position) {
  return add_target(HRT_TARGET_REAL, name, placed(world_position));
}

hrt_target PlateNode::add_virtual_target_at(std::string name, Vector3 world_position) {
  return add_target(HRT_TARGET_VIRTUAL, name, placed(world_position));
}

Error PlateNode::move_target_to(hrt_target target, Vector3 world_position) {
  hrt_target_config config = hrt_target_config_init();
  if (!configure() || !ok(hrt_target_get(session_, target, &config))) return error();
  config = placed(world_position, config);
  return report(hrt_target_set(session_, target, &config));
}

Error PlateNode::remove_target(hrt_target target) { return report(hrt_target_remove(session_, target)); }

Record PlateNode::get_gap(hrt_target real_target, hrt_target virtual_target) {
  hrt_gap gap = hrt_gap_init();
  if (!configure() || !ok(hrt_gap_query(session_, real_target, virtual_target, &gap))) return {};
  return to_record(gap);
}

bool PlateNode::list_targets(uint32_t role, std::vector<hrt_target>& out_targets) {
  uint64_t count = 0;
  if (!ok(hrt_target_list(session_, role, 0, nullptr, &count))) return false;
  out_targets.resize(count);
  return ok(hrt_target_list(session_, role, count, out_targets.data(), &count));
}

Error PlateNode::assign_targets(bool exclusive) {
  std::vector<hrt_target> reals, virtuals;
  if (!configure() || !list_targets(HRT_TARGET_REAL, reals) || !list_targets(HRT_TARGET_VIRTUAL, virtuals))
    return error();
  std::vector<hrt_gap> assigned(virtuals.size(), hrt_gap_init());
  if (ok(hrt_gap_assign(session_, virtuals.data(), virtuals.size(), reals.data(), reals.size(),
                        exclusive ? HRT_ASSIGN_EXCLUSIVE : 0, virtuals.size(), assigned.data())))
    assigned_ = std::move(assigned);
  return error();
}

Record PlateNode::get_assigned(hrt_target virtual_target) {
  for (const hrt_gap& one : assigned_)
    if (one.virtual_target.value == virtual_target.value) return to_record(one);
  engine_.push_error("get_assigned: no assignment of this virtual target; call assign_targets() first");
  return {};
}

Error PlateNode::load_scene(std::string path) {
  hrt_scene scene{};
  if (!configure() || !ok(hrt_scene_load(engine_.system_path(path).c_str(), nullptr, 0, &scene))) return error();
  const Error registered = report(hrt_scene_register(scene, session_, 0, nullptr));
  hrt_scene_destroy(scene);
  if (registered == Error::kOk) take_changes();
  return registered;
}

hrt_target PlateNode::find_target(std::string name) {
  std::vector<hrt_target> targets;
  if (!configure() || !list_targets(0, targets)) return {};
  for (const hrt_target target : targets) {
    hrt_target_config config = hrt_target_config_init();
    if (ok(hrt_target_get(session_, target, &config)) && name == config.name) return target;
  }
  engine_.push_error(("find_target: no target has the name \"" + name + "\"; add the target first").c_str());
  return {};
}

hrt_target PlateNode::get_served_by(hrt_target virtual_target) {
  hrt_target_config config = hrt_target_config_init();
  if (!configure() || !ok(hrt_target_get(session_, virtual_target, &config))) return {};
  return config.served_by;
}

}  // namespace hrt_godot
