#include "samples/reach/targets.h"

#include <cstring>

#include "samples/reach/exit_code.h"
#include "scene/scene.h"

namespace hrt::reach {
namespace {

XrPosef to_xr(const Pose& pose) {
  return {{static_cast<float>(pose.orientation.x), static_cast<float>(pose.orientation.y),
           static_cast<float>(pose.orientation.z), static_cast<float>(pose.orientation.w)},
          {static_cast<float>(pose.position_m.x), static_cast<float>(pose.position_m.y),
           static_cast<float>(pose.position_m.z)}};
}

std::array<double, 3> to_array(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Scene load(const std::filesystem::path& file) {
  try {
    return load_scene(file);
  } catch (const SceneError& error) {
    throw Failure(ExitCode::scene, std::string("the scene cannot be loaded: ") + error.what());
  }
}

hrt_target add_target(const Plugin& plugin, hrt_session session, const SceneTarget& target) {
  hrt_target_config config;
  plugin.check(plugin.hrt_target_config_default(&config, sizeof config));
  config.role = target.kind == TargetKind::real_object ? HRT_TARGET_REAL : HRT_TARGET_VIRTUAL;
  config.place = HRT_PLACE_PLATE_POSITION;
  config.position_m[0] = target.position_m.x;
  config.position_m[1] = target.position_m.y;
  config.position_m[2] = target.position_m.z;
  std::strncpy(config.name, target.name.c_str(), HRT_NAME_SIZE - 1);
  hrt_target id{};
  plugin.check(plugin.hrt_target_add(session, &config, &id));
  return id;
}

}  // namespace

TargetSet load_targets(const Plugin& plugin, const std::filesystem::path& scene_file,
                       const hrt_session_config& config) {
  const Scene scene = load(scene_file);
  TargetSet set{.plate_pose = to_xr(scene.plate.pose),
                .plate_radius_m = scene.plate.radius_m,
                .start_m = to_array(scene.start_m)};

  hrt_session_config with_scene = config;
  with_scene.start_position_m[0] = scene.start_m.x;
  with_scene.start_position_m[1] = scene.start_m.y;
  with_scene.start_position_m[2] = scene.start_m.z;
  with_scene.plate_radius_m = scene.plate.radius_m;
  if (with_scene.plate_max_speed_deg_s == 0.0)
    with_scene.plate_max_speed_deg_s = scene.plate.max_speed_deg_s.value_or(0.0);
  plugin.check(plugin.hrt_session_create(&with_scene, &set.session));

  std::vector<hrt_target> ids;
  for (const SceneTarget& target : scene.targets) ids.push_back(add_target(plugin, set.session, target));
  for (std::size_t i = 0; i < scene.targets.size(); ++i) {
    const SceneTarget& seen = scene.targets[i];
    if (seen.kind != TargetKind::virtual_object) continue;
    const SceneTarget& touched = scene.targets[*seen.served_by];
    hrt_authority authority{.struct_size = sizeof authority};
    plugin.check(plugin.hrt_authority_query(set.session, ids[*seen.served_by], ids[i], &authority));
    set.pairs.push_back({.virtual_name = seen.name,
                         .real_name = touched.name,
                         .virtual_direction_deg = seen.direction_deg,
                         .real_direction_deg = touched.direction_deg,
                         .real_distance_m = touched.distance_m,
                         .real_radius_m = touched.radius_m.value_or(0.0),
                         .virtual_position_m = to_array(seen.position_m),
                         .real_position_m = to_array(touched.position_m),
                         .virtual_target = ids[i],
                         .real_target = ids[*seen.served_by],
                         .reachable = authority.reachable == 1,
                         .largest_gap_deg = authority.largest_gap_deg});
  }
  return set;
}

}  // namespace hrt::reach
