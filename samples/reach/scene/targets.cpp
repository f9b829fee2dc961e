#include "samples/reach/scene/targets.h"

#include "samples/reach/base/exit_code.h"

namespace hrt::reach {
namespace {

// A scene of the plugin, loaded until its targets are registered.
class LoadedScene {
 public:
  LoadedScene(const Plugin& plugin, const std::filesystem::path& file) : plugin_(plugin) {
    if (plugin.hrt_scene_load(file.c_str(), nullptr, 0, &scene_) != HRT_OK)
      throw Failure(ExitCode::scene, std::string("the scene cannot be loaded: ") + plugin.hrt_last_error());
  }
  ~LoadedScene() { plugin_.hrt_scene_destroy(scene_); }
  LoadedScene(const LoadedScene&) = delete;
  LoadedScene& operator=(const LoadedScene&) = delete;

  hrt_scene handle() const { return scene_; }

  hrt_scene_info info() const {
    hrt_scene_info info{.struct_size = sizeof info};
    plugin_.check(plugin_.hrt_scene_get_info(scene_, &info));
    return info;
  }

  hrt_scene_target target(std::uint32_t index) const {
    hrt_scene_target target{.struct_size = sizeof target};
    plugin_.check(plugin_.hrt_scene_get_target(scene_, index, &target));
    return target;
  }

 private:
  const Plugin& plugin_;
  hrt_scene scene_{};
};

std::array<double, 3> to_array(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

}  // namespace

XrPosef to_xr(const double (&position_m)[3], const double (&rotation)[4]) {
  const auto f = [](double value) { return static_cast<float>(value); };
  return {{f(rotation[0]), f(rotation[1]), f(rotation[2]), f(rotation[3])},
          {f(position_m[0]), f(position_m[1]), f(position_m[2])}};
}

TargetSet load_targets(const Plugin& plugin, const std::filesystem::path& scene_file,
                       const hrt_session_config& config) {
  const LoadedScene scene(plugin, scene_file);
  const hrt_scene_info info = scene.info();
  TargetSet set{.plate_pose = to_xr(info.plate_position_m, info.plate_rotation),
                .plate_radius_m = info.plate_radius_m,
                .start_m = to_array(info.start_position_m)};
  std::vector<hrt_target> ids(info.target_count);
  plugin.check(plugin.hrt_session_create(HRT_VERSION, &config, &set.session));
  plugin.check(plugin.hrt_scene_register(scene.handle(), set.session, info.target_count, ids.data()));

  for (std::uint32_t i = 0; i < info.target_count; ++i) {
    const hrt_scene_target seen = scene.target(i);
    if (seen.role != HRT_TARGET_VIRTUAL) continue;
    const auto serving = static_cast<std::uint32_t>(seen.served_by);
    const hrt_scene_target touched = scene.target(serving);
    set.pairs.push_back({.virtual_name = seen.name,
                         .real_name = touched.name,
                         .virtual_direction_deg = seen.direction_deg,
                         .real_direction_deg = touched.direction_deg,
                         .real_distance_m = touched.distance_m,
                         .real_radius_m = touched.radius_m,
                         .virtual_position_m = to_array(seen.position_m),
                         .real_position_m = to_array(touched.position_m),
                         .virtual_target = ids[i],
                         .real_target = ids[serving]});
  }
  return set;
}

}  // namespace hrt::reach
