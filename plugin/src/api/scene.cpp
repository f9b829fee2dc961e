#include "haptic_retargeting/scene.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/entry.h"
#include "plugin/src/abi/file.h"
#include "plugin/src/abi/host.h"
#include "plugin/src/abi/text.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/recorded_session.h"
#include "plugin/src/api/write.h"
#include "scene/scene.h"

namespace hrt::plugin {
namespace {

using Scenes = HandleTable<Scene, HRT_SCENES_MAX, 0x5c>;
constinit Scenes scenes("scene");

// Logs a warning if targets are further than ten plate radii from the plate: the file is probably not in metres.
void log_far_targets(const Scene& scene, std::string_view file) {
  const double far_m = 10.0 * scene.plate.radius_m;
  const auto is_far = [&](const SceneTarget& target) { return length(target.position_m) > far_m; };
  const auto first = std::find_if(scene.targets.begin(), scene.targets.end(), is_far);
  if (first == scene.targets.end()) return;
  Text<400> text;
  text << Shown{file} << ": " << std::count_if(first, scene.targets.end(), is_far)
       << " of the targets are further than ten plate radii (" << far_m << " m) from the plate, for example \""
       << Shown{first->name} << "\" at " << length(first->position_m) << " m; check that the file is in metres";
  write_log(HRT_LOG_WARNING, text.c_str());
}

hrt_result register_scene(const Scene& scene, RecordedSession& session, std::uint64_t capacity,
                          hrt_target* out_targets) {
  HRT_RETURN_IF_FAILED(session.session().check_idle());
  if (capacity > 0 && !out_targets) return fail_of_null("out_targets");
  if (out_targets && capacity < scene.targets.size())
    return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; allowed: at least ", scene.targets.size(),
                ", the number of targets in the scene, or 0 with out_targets null");
  HRT_RETURN_IF_FAILED(check_value("plate_radius_m", Fields<hrt_session_config>::plate_radius_m, scene.plate.radius_m));
  SessionModel model = session.session().model();
  model.start_m = scene.start_m;
  model.mount.set_pose(scene.plate.pose);
  model.mount.scale = 1.0;
  model.mount.surface.radius_m = scene.plate.radius_m;
  if (scene.plate.max_speed_deg_s) model.control.plate.max_speed_deg_s = *scene.plate.max_speed_deg_s;
  model.control.frame.setZero();
  model.control.touched = {.home = plate_point(scene.start_m)};
  model.registration.made = false;
  model.registration.time_ns = 0;
  std::vector<Target> targets;
  for (const SceneTarget& from : scene.targets) {
    HRT_RETURN_IF_FAILED(check_distance_from_plate(from.position_m, from.name));
    targets.push_back(
        {.role = from.is_real ? TargetRole::real : TargetRole::virtual_target,
         .place = {.kind = TargetPlace::Kind::plate_position,
                   .position_m = from.position_m,
                   .radius_m = std::min(from.radius_m.value_or(0.0), Fields<hrt_target_config>::radius_m.high)},
         .name = {},
         .served_by = from.served_by ? *from.served_by + 1 : 0});
    std::memcpy(targets.back().name.data(), from.name.data(), from.name.size());
  }
  return session.add_scene(model, targets, out_targets);
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_scene_load(const char* path, const void* bytes, uint64_t length, hrt_scene* out_scene) noexcept {
  return guarded("hrt_scene_load", [&]() -> hrt_result {
    if (!path) return fail_of_null("path");
    if (!out_scene) return fail_of_null("out_scene");
    File readable;  // a file that cannot be read is an error of the operating system, not of the format
    if (!bytes) HRT_RETURN_IF_FAILED(File::open(path, std::numeric_limits<std::uint64_t>::max(), &readable));
    try {
      const std::string_view file(static_cast<const char*>(bytes), bytes ? static_cast<std::size_t>(length) : 0);
      auto scene = std::make_unique<hrt::Scene>(bytes ? hrt::load_scene(file, path) : hrt::load_scene(path_of(path)));
      for (const hrt::SceneTarget& target : scene->targets) {
        if (target.name.size() >= HRT_NAME_SIZE)
          return fail(HRT_ERROR_BAD_FORMAT, Shown{path}, ": the target name ", hrt::in_quotes(target.name), " has ",
                      target.name.size(), " bytes; allowed: up to ", HRT_NAME_SIZE - 1);
      }
      log_far_targets(*scene, path);
      const std::uint64_t handle = scenes.insert(std::move(scene));
      if (handle == 0)
        return fail(HRT_ERROR_LIMIT_REACHED, "there are ", HRT_SCENES_MAX, " scenes, the maximum; destroy one first");
      out_scene->value = handle;
      return HRT_OK;
    } catch (const hrt::SceneError& error) {  // a text that begins with the path is shown with a truncated path
      const std::string_view what = error.what();
      if (!what.starts_with(path)) return fail(HRT_ERROR_BAD_FORMAT, what);
      return fail(HRT_ERROR_BAD_FORMAT, Shown{path}, what.substr(std::strlen(path)));
    }
  });
}

hrt_result hrt_scene_destroy(hrt_scene scene) noexcept { return scenes.destroy("hrt_scene_destroy", scene.value); }

hrt_result hrt_scene_get_info(hrt_scene scene, hrt_scene_info* out_info) noexcept {
  return scenes.with("hrt_scene_get_info", scene.value, [&](const hrt::Scene& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_info", out_info));
    hrt_scene_info info{};
    info.target_count = static_cast<std::uint32_t>(s.targets.size());
    write(s.plate.pose.position_m, info.plate_position_m);
    const hrt::Quaternion& q = s.plate.pose.orientation;
    info.plate_rotation[0] = q.x;
    info.plate_rotation[1] = q.y;
    info.plate_rotation[2] = q.z;
    info.plate_rotation[3] = q.w;
    info.plate_radius_m = s.plate.radius_m;
    info.plate_max_speed_deg_s = s.plate.max_speed_deg_s.value_or(0.0);
    write(s.start_m, info.start_position_m);
    write_struct(info, out_info);
    return HRT_OK;
  });
}

hrt_result hrt_scene_get_target(hrt_scene scene, uint32_t index, hrt_scene_target* out_target) noexcept {
  return scenes.with("hrt_scene_get_target", scene.value, [&](const hrt::Scene& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_target", out_target));
    if (index >= s.targets.size())
      return fail(HRT_ERROR_OUT_OF_RANGE, "index is ", index, "; allowed: below ", s.targets.size(),
                  ", the number of targets");
    const hrt::SceneTarget& from = s.targets[index];
    hrt_scene_target target{};
    target.role = from.is_real ? HRT_TARGET_REAL : HRT_TARGET_VIRTUAL;
    target.served_by = from.served_by ? static_cast<std::int32_t>(*from.served_by) : -1;
    write(from.position_m, target.position_m);
    write(from.world_position_m, target.world_position_m);
    target.direction_deg = hrt::direction_deg(s, from);
    target.distance_m = hrt::distance_m(s, from);
    target.radius_m = from.radius_m.value_or(0.0);
    std::memcpy(target.name, from.name.data(), from.name.size());
    write_struct(target, out_target);
    return HRT_OK;
  });
}

hrt_result hrt_scene_register(hrt_scene scene, hrt_session session, uint64_t capacity,
                              hrt_target* out_targets) noexcept {
  return scenes.with("hrt_scene_register", scene.value, [&](const hrt::Scene& loaded) -> hrt_result {
    return sessions.with("hrt_scene_register", session.value, [&](RecordedSession& s) -> hrt_result {
      s.log_findings(session.value);
      return register_scene(loaded, s, capacity, out_targets);
    });
  });
}
