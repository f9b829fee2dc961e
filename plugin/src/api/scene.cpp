#include "haptic_retargeting/scene.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include "generated/fields.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/file.h"
#include "plugin/src/abi/host.h"
#include "plugin/src/abi/text.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/sessions.h"
#include "plugin/src/api/write.h"
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

void copy(const Quaternion& from, double (&to)[4]) {
  to[0] = from.x;
  to[1] = from.y;
  to[2] = from.z;
  to[3] = from.w;
}

// Logs a warning if targets are further than ten plate radii from the plate: the file is probably not in metres.
void log_far_targets(const Scene& scene, std::string_view file) {
  const double far_m = 10.0 * scene.plate.radius_m;
  const auto is_far = [&](const SceneTarget& target) { return length(target.position_m) > far_m; };
  const auto first = std::find_if(scene.targets.begin(), scene.targets.end(), is_far);
  if (first == scene.targets.end()) return;
  Text<400> text;
  text << Shown{file} << ": " << std::count_if(first, scene.targets.end(), is_far)
       << " of the targets are further than ten plate radii (" << far_m << " m) from the plate, the first one \""
       << Shown{first->name} << "\" at " << length(first->position_m) << " m; check that the file is in metres";
  write_log(HRT_LOG_WARNING, text.c_str());
}

// Runs a loader, and adds the scene to the table of handles. Errors begin with the name of the file.
template <class Load>
hrt_result add_scene(hrt_scene* out_scene, std::string_view file, Load&& load) {
  if (!out_scene) return fail_of_null("out_scene");
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

// Copies the plate of a scene into the model, where its pose replaces a registered one. Fails if a value of the scene
// is out of range.
hrt_result with_plate_of(const Scene& scene, SessionModel model, SessionModel* out) {
  model.start_m = scene.start_m;
  model.mount.pose = scene.plate.pose;
  model.mount.scale = 1.0;
  model.mount.surface.radius_m = scene.plate.radius_m;
  if (scene.plate.max_speed_deg_s) model.control.plate.max_speed_deg_s = *scene.plate.max_speed_deg_s;
  model.control.frame.setZero();
  model.registration.made = false;
  model.registration.time_ns = 0;
  forget_contacts(&model);
  return read(to_c(model), out);
}

hrt_result read_target(const SceneTarget& target, const SessionModel& model, Target* out) {
  *out = {.role = target.kind == TargetKind::real_object ? TargetRole::real : TargetRole::virtual_target,
          .place = {.kind = TargetPlace::Kind::plate_position,
                    .position_m = target.position_m,
                    .radius_m = std::min(target.radius_m.value_or(0.0), Fields<hrt_target_config>::radius_m.high)}};
  std::memcpy(out->name.data(), target.name.data(), target.name.size());
  HRT_RETURN_IF_FAILED(read(to_c(*out), out));
  return check_target(model, *out);
}

hrt_result register_scene(const Scene& scene, RecordedSession& session, std::uint64_t capacity,
                          hrt_target* out_targets) {
  HRT_RETURN_IF_FAILED(session.session().check_idle());
  if (capacity > 0 && !out_targets) return fail_of_null("out_targets");
  if (out_targets && capacity < scene.targets.size())
    return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; allowed: 0, or at least ",
                scene.targets.size(), ", the number of targets in the scene");
  SessionModel model;
  HRT_RETURN_IF_FAILED(with_plate_of(scene, session.session().model(), &model));
  std::vector<Target> targets(scene.targets.size());
  std::vector<std::optional<std::size_t>> served_by;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    HRT_RETURN_IF_FAILED(read_target(scene.targets[i], model, &targets[i]));
    served_by.push_back(scene.targets[i].served_by);
  }
  std::vector<std::uint64_t> ids;
  HRT_RETURN_IF_FAILED(session.add_scene(model, targets, served_by, &ids));
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
    if (!path) return fail_of_null("path");
    if (!bytes) {
      File readable;  // an error of the operating system, not of the format
      HRT_RETURN_IF_FAILED(File::open(path, std::numeric_limits<std::uint64_t>::max(), &readable));
      return add_scene(out_scene, path, [&] { return hrt::load_scene(path_of(path)); });
    }
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
    hrt_scene_info info{};
    info.target_count = static_cast<std::uint32_t>(s.targets.size());
    copy(s.plate.pose.position_m, info.plate_position_m);
    copy(s.plate.pose.orientation, info.plate_rotation);
    info.plate_radius_m = s.plate.radius_m;
    info.plate_max_speed_deg_s = s.plate.max_speed_deg_s.value_or(0.0);
    copy(s.start_m, info.start_position_m);
    write_struct(info, out_info);
    return HRT_OK;
  });
}

hrt_result hrt_scene_get_target(hrt_scene scene, uint32_t index, hrt_scene_target* out_target) noexcept {
  return with_scene("hrt_scene_get_target", scene, [&](const hrt::Scene& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_target", out_target));
    if (index >= s.targets.size())
      return fail(HRT_ERROR_OUT_OF_RANGE, "index is ", index, "; allowed: below ", s.targets.size(),
                  ", the number of targets");
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
