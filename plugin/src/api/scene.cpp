#include "haptic_retargeting/scene.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/file.h"
#include "plugin/src/abi/host.h"
#include "plugin/src/abi/text.h"
#include "plugin/src/api/sessions.h"
#include "plugin/src/session/contact.h"
#include "scene/scene.h"

namespace hrt::plugin {
namespace {

using Scenes = HandleTable<Scene, HRT_SCENES_MAX, 0x5c>;
constinit Scenes scenes;

void copy(Vec3 from, double (&to)[3]) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
}

// Warns of targets further than ten plate radii from the plate: the file may not be in metres.
void log_far_targets(const Scene& scene, std::string_view file) {
  const double far_m = 10.0 * scene.plate.radius_m;
  const auto is_far = [&](const SceneTarget& target) { return length(target.position_m) > far_m; };
  const auto first = std::find_if(scene.targets.begin(), scene.targets.end(), is_far);
  if (first == scene.targets.end()) return;
  Text<400> text;
  text << Shown{file} << ": " << std::count_if(first, scene.targets.end(), is_far)
       << " of the targets are further than ten plate radii (" << far_m << " m) from the plate, the first one \""
       << Shown{first->name} << "\" at " << length(first->position_m) << " m; is the file in metres?";
  write_log(HRT_LOG_WARNING, text.c_str());
}

// Runs a loader, whose errors begin with the name of the file.
template <class Load>
hrt_result add_scene(hrt_scene* out_scene, std::string_view file, Load&& load) {
  if (!out_scene) return fail(HRT_ERROR_NULL_ARGUMENT, "out_scene is null");
  try {
    auto scene = std::make_unique<Scene>(load());
    for (const SceneTarget& target : scene->targets) {
      if (target.name.size() >= HRT_NAME_SIZE)
        return fail(HRT_ERROR_BAD_FORMAT, "target name ", in_quotes(target.name), " has ", target.name.size(),
                    " bytes; allowed: up to ", HRT_NAME_SIZE - 1);
    }
    log_far_targets(*scene, file);
    const std::uint64_t handle = scenes.insert(std::move(scene));
    if (handle == 0) return fail(HRT_ERROR_LIMIT_REACHED, "there are ", HRT_SCENES_MAX, " scenes; destroy one first");
    out_scene->value = handle;
    return HRT_OK;
  } catch (const SceneError& error) {
    const std::string_view what = error.what();
    if (!what.starts_with(file)) return fail(HRT_ERROR_BAD_FORMAT, what);
    return fail(HRT_ERROR_BAD_FORMAT, Shown{file}, what.substr(file.size()));
  }
}

template <class Body>
hrt_result with_scene(const char* call, hrt_scene handle, Body&& body) noexcept {
  return with_lease(call, "scene", scenes, handle.value, body);
}

std::uint32_t role_of(const SceneTarget& target) {
  return target.kind == TargetKind::real_object ? HRT_TARGET_REAL : HRT_TARGET_VIRTUAL;
}

hrt_session_config with_plate_of(const Scene& scene, hrt_session_config config) {
  copy(scene.start_m, config.start_position_m);
  copy(scene.plate.pose.position_m, config.plate.position_m);
  const Quaternion& q = scene.plate.pose.orientation;
  config.plate.rotation[0] = q.x;
  config.plate.rotation[1] = q.y;
  config.plate.rotation[2] = q.z;
  config.plate.rotation[3] = q.w;
  config.plate.radius_m = scene.plate.radius_m;
  if (scene.plate.max_speed_deg_s) config.plate.max_speed_deg_s = *scene.plate.max_speed_deg_s;
  return config;
}

// The scene's pose takes the place of a registered one.
hrt_session_config unregistered(hrt_session_config config) {
  config.flags &= ~HRT_SESSION_REGISTERED;
  config.plate.scale = 1.0;
  write_frame_covariance(FrameCovariance::Zero(), &config);
  config.registration.time_ns = 0;
  forget_contacts(&config);
  return config;
}

hrt_target_config config_of(const SceneTarget& target) {
  hrt_target_config config{};
  config.struct_size = sizeof config;
  config.role = role_of(target);
  config.place = HRT_PLACE_PLATE_POSITION;
  copy(target.position_m, config.position_m);
  std::memcpy(config.name, target.name.data(), target.name.size());
  config.radius_m = std::min(target.radius_m.value_or(0.0), Fields<hrt_target_config>::radius_m.high);
  return config;
}

hrt_result register_scene(const Scene& scene, RecordedSession& session, std::uint64_t capacity,
                          hrt_target* out_targets) {
  HRT_RETURN_IF_FAILED(session.session().check_no_reach());
  if (capacity > 0 && !out_targets) return fail(HRT_ERROR_NULL_ARGUMENT, "out_targets is null");
  if (out_targets && capacity < scene.targets.size())
    return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; the scene has ", scene.targets.size(),
                " targets");
  const hrt_session_config config = unregistered(with_plate_of(scene, session.session().config()));
  HRT_RETURN_IF_FAILED(check_session_config(config));
  std::vector<hrt_target_config> targets;
  std::vector<std::optional<std::size_t>> served_by;
  for (const SceneTarget& target : scene.targets) {
    targets.push_back(config_of(target));
    served_by.push_back(target.served_by);
    HRT_RETURN_IF_FAILED(check_target_config(config, &targets.back()));
  }
  std::vector<std::uint64_t> ids;
  HRT_RETURN_IF_FAILED(session.add_scene(config, targets, served_by, &ids));
  if (out_targets) {
    for (const std::uint64_t id : ids) (out_targets++)->value = id;
  }
  return HRT_OK;
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_scene_load(const char* path, const void* bytes, uint64_t length, hrt_scene* out_scene) noexcept {
  return guarded("hrt_scene_load", [&]() -> hrt_result {
    if (!path) return fail(HRT_ERROR_NULL_ARGUMENT, "path is null");
    if (!bytes) return add_scene(out_scene, path, [&] { return hrt::load_scene(path_of(path)); });
    const std::span<const std::byte> file(static_cast<const std::byte*>(bytes), static_cast<std::size_t>(length));
    return add_scene(out_scene, path, [&] { return hrt::load_scene(file, path); });
  });
}

hrt_result hrt_scene_destroy(hrt_scene scene) noexcept {
  return destroy("hrt_scene_destroy", "scene", scenes, scene.value);
}

hrt_result hrt_scene_get_info(hrt_scene scene, hrt_scene_info* out_info) noexcept {
  return with_scene("hrt_scene_get_info", scene, [&](const hrt::Scene& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_info", out_info));
    const hrt_session_config plate = with_plate_of(s, {});
    hrt_scene_info info{};
    info.target_count = static_cast<std::uint32_t>(s.targets.size());
    std::memcpy(info.plate_position_m, plate.plate.position_m, sizeof info.plate_position_m);
    std::memcpy(info.plate_rotation, plate.plate.rotation, sizeof info.plate_rotation);
    info.plate_radius_m = plate.plate.radius_m;
    info.plate_max_speed_deg_s = plate.plate.max_speed_deg_s;
    std::memcpy(info.start_position_m, plate.start_position_m, sizeof info.start_position_m);
    write_struct(info, out_info);
    return HRT_OK;
  });
}

hrt_result hrt_scene_get_target(hrt_scene scene, uint32_t index, hrt_scene_target* out_target) noexcept {
  return with_scene("hrt_scene_get_target", scene, [&](const hrt::Scene& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_target", out_target));
    if (index >= s.targets.size())
      return fail(HRT_ERROR_OUT_OF_RANGE, "index is ", index, "; the scene has ", s.targets.size(), " targets");
    const hrt::SceneTarget& from = s.targets[index];
    hrt_scene_target target{};
    target.role = role_of(from);
    target.served_by = from.served_by ? static_cast<std::int32_t>(*from.served_by) : -1;
    copy(from.position_m, target.position_m);
    copy(from.world_position_m, target.world_position_m);
    target.direction_deg = from.direction_deg;
    target.distance_m = from.distance_m;
    target.radius_m = from.radius_m.value_or(0.0);
    std::memcpy(target.name, from.name.data(), from.name.size());
    write_struct(target, out_target);
    return HRT_OK;
  });
}

hrt_result hrt_scene_register(hrt_scene scene, hrt_session session, uint64_t capacity,
                              hrt_target* out_targets) noexcept {
  return with_scene("hrt_scene_register", scene, [&](const hrt::Scene& loaded) -> hrt_result {
    return with_session("hrt_scene_register", session, [&](RecordedSession& s) -> hrt_result {
      s.log_findings(session.value);
      return register_scene(loaded, s, capacity, out_targets);
    });
  });
}
