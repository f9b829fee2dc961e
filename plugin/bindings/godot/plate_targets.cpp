// The node's targets, what can be held between them, and the scene that has them.
#include "plate_node.h"
#include "pose.h"

namespace hrt_godot {
namespace {

constexpr int64_t kNoTarget = 0;

/** A name that does not fit has no zero at its end, which the plugin refuses. */
hrt_target_config target_config(uint32_t role, const std::string& name) {
  hrt_target_config config = hrt_target_config_init();
  config.role = role;
  name.copy(config.name, sizeof config.name);
  return config;
}

hrt_target_config polar_target(uint32_t role, const std::string& name, double direction_deg, double distance_m) {
  hrt_target_config config = target_config(role, name);
  config.direction_deg = direction_deg;
  config.distance_m = distance_m;
  return config;
}

void place_at(const Vector3& world_position, hrt_target_config& config) {
  config.place = HRT_PLACE_WORLD_POSITION;
  copy(world_position, config.position_m);
}

hrt_target_config placed_target(uint32_t role, const std::string& name, const Vector3& world_position) {
  hrt_target_config config = target_config(role, name);
  place_at(world_position, config);
  return config;
}

}  // namespace

int64_t PlateNode::add_target(const hrt_target_config& config) {
  hrt_target target{};
  if (!configure() || !ok(hrt_target_add(session_, &config, &target))) return kNoTarget;
  return static_cast<int64_t>(target.value);
}

int64_t PlateNode::add_real_target(std::string name, double direction_deg, double distance_m) {
  return add_target(polar_target(HRT_TARGET_REAL, name, direction_deg, distance_m));
}

int64_t PlateNode::add_virtual_target(std::string name, double direction_deg, double distance_m) {
  return add_target(polar_target(HRT_TARGET_VIRTUAL, name, direction_deg, distance_m));
}

int64_t PlateNode::add_real_target_at(std::string name, Vector3 world_position) {
  return add_target(placed_target(HRT_TARGET_REAL, name, world_position));
}

int64_t PlateNode::add_virtual_target_at(std::string name, Vector3 world_position) {
  return add_target(placed_target(HRT_TARGET_VIRTUAL, name, world_position));
}

Error PlateNode::move_target_to(int64_t target, Vector3 world_position) {
  hrt_target_config config = hrt_target_config_init();
  if (!configure() || !ok(hrt_target_get(session_, target_of(target), &config))) return error();
  place_at(world_position, config);
  ok(hrt_target_set(session_, target_of(target), &config));
  return error();
}

Error PlateNode::remove_target(int64_t target) {
  ok(hrt_target_remove(session_, target_of(target)));
  return error();
}

Record PlateNode::get_gap(int64_t real, int64_t felt) {
  hrt_gap gap = hrt_gap_init();
  if (!configure() || !ok(hrt_gap_query(session_, target_of(real), target_of(felt), &gap))) return {};
  return to_record(&gap, gap_fields);
}

bool PlateNode::list_targets(uint32_t role, std::vector<hrt_target>& out_targets) {
  uint64_t count = 0;
  if (!ok(hrt_target_list(session_, role, 0, nullptr, &count))) return false;
  out_targets.resize(count);
  return ok(hrt_target_list(session_, role, count, out_targets.data(), &count));
}

Error PlateNode::assign_targets(bool exclusive) {
  std::vector<hrt_target> real, felt;
  if (!configure() || !list_targets(HRT_TARGET_REAL, real) || !list_targets(HRT_TARGET_VIRTUAL, felt)) return error();
  // One more than is filled, because the plugin reads the first one's size.
  std::vector<hrt_gap> assigned(felt.size() + 1, hrt_gap_init());
  if (ok(hrt_target_assign(session_, felt.data(), felt.size(), real.data(), real.size(),
                           exclusive ? HRT_ASSIGN_EXCLUSIVE : 0, felt.size(), assigned.data()))) {
    assigned.pop_back();
    assigned_ = std::move(assigned);
  }
  return error();
}

Record PlateNode::get_assigned(int64_t felt) {
  for (const hrt_gap& one : assigned_)
    if (one.virtual_target.value == target_of(felt).value) return to_record(&one, gap_fields);
  engine_.push_error("get_assigned: no assignment of this virtual target; call assign_targets() first");
  return {};
}

Error PlateNode::load_scene(std::string path) {
  hrt_scene scene{};
  if (!configure() || !ok(hrt_scene_load(path.c_str(), nullptr, 0, &scene))) return error();
  ok(hrt_scene_register(scene, session_, 0, nullptr));
  const Error registered = error();
  hrt_scene_destroy(scene);
  if (registered == Error::kOk) take_changes();
  return registered;
}

int64_t PlateNode::find_target(std::string name) {
  std::vector<hrt_target> targets;
  if (!configure() || !list_targets(0, targets)) return kNoTarget;
  for (const hrt_target target : targets) {
    hrt_target_config config = hrt_target_config_init();
    if (ok(hrt_target_get(session_, target, &config)) && name == config.name) return static_cast<int64_t>(target.value);
  }
  engine_.push_error(("find_target: no target has the name \"" + name + '"').c_str());
  return kNoTarget;
}

}  // namespace hrt_godot
