#include <cstring>

#include "plugin/src/checked.h"
#include "plugin/src/session.h"

namespace hrt::plugin {
namespace {

constexpr hrt_target_config default_target_config{
    .struct_size = sizeof(hrt_target_config),
    .role = HRT_TARGET_REAL,
    .place = HRT_PLACE_DIRECTION,
    .reserved = 0,
    .direction_deg = 0.0,
    .distance_m = 0.1,
    .position_m = {0.0, 0.0, 0.0},
    .name = "",
};

// UTF-8 as RFC 3629 has it: shortest forms only, no surrogates, nothing above U+10FFFF.
bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t at) {
      return static_cast<unsigned char>(at < text.size() ? text[at] : 0);
    };
    const unsigned char lead = byte(i);
    const int tail = lead < 0x80   ? 0
                     : lead < 0xc2 ? -1
                     : lead < 0xe0 ? 1
                     : lead < 0xf0 ? 2
                     : lead < 0xf5 ? 3
                                   : -1;
    if (tail < 0) return false;
    for (int k = 1; k <= tail; ++k) {
      if ((byte(i + k) & 0xc0) != 0x80) return false;
    }
    const unsigned char second = byte(i + 1);
    if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) ||
        (lead == 0xf0 && second < 0x90) || (lead == 0xf4 && second > 0x8f))
      return false;
    i += static_cast<std::size_t>(tail) + 1;
  }
  return true;
}

hrt_result check_name(char (&name)[HRT_NAME_SIZE]) {
  const auto* end = static_cast<const char*>(std::memchr(name, '\0', sizeof name));
  if (!end) return fail(HRT_ERROR_OUT_OF_RANGE, "name is not ended by a zero within ", sizeof name, " bytes");
  const auto length = static_cast<std::size_t>(end - name);
  std::memset(name + length, 0, sizeof name - length);
  if (!is_utf8({name, length})) return fail(HRT_ERROR_OUT_OF_RANGE, "name is not UTF-8");
  for (std::size_t i = 0; i < length; ++i) {
    if (static_cast<unsigned char>(name[i]) < 0x20 || name[i] == 0x7f)
      return fail(HRT_ERROR_OUT_OF_RANGE, "name has a control character at byte ", i);
  }
  return HRT_OK;
}

hrt_result read_target_config(const hrt_session_config& session_config, const hrt_target_config* given,
                              hrt_target_config* config) {
  *config = default_target_config;
  HRT_RETURN_IF_FAILED(read_struct("config", given, config));
  HRT_RETURN_IF_FAILED(check_range<unsigned>("role", config->role, HRT_TARGET_REAL, HRT_TARGET_VIRTUAL));
  HRT_RETURN_IF_FAILED(
      check_range<unsigned>("place", config->place, HRT_PLACE_DIRECTION, HRT_PLACE_WORLD_POSITION));
  HRT_RETURN_IF_FAILED(check_zero("reserved", config->reserved));
  if (config->place == HRT_PLACE_DIRECTION) {
    HRT_RETURN_IF_FAILED(check_range("direction_deg", config->direction_deg, -180.0, 180.0));
    HRT_RETURN_IF_FAILED(
        check_range("distance_m", config->distance_m, least_distance_m, largest_coordinate_m));
  } else {
    HRT_RETURN_IF_FAILED(check_position("position_m", config->position_m));
    const Bearing bearing = view(session_config, *config);
    if (bearing.at_start)
      return fail(HRT_ERROR_OUT_OF_RANGE, "position_m is ", bearing.distance_m,
                  " m from the start in the plane of the plate; at least ", least_distance_m, " is needed");
  }
  return check_name(config->name);
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_target_config_default(hrt_target_config* out_config, uint32_t struct_size) noexcept {
  return guarded("hrt_target_config_default",
                 [&] { return write_default("out_config", default_target_config, out_config, struct_size); });
}

hrt_result hrt_target_add(hrt_session session, const hrt_target_config* config,
                          hrt_target* out_target) noexcept {
  return with_session("hrt_target_add", session, [&](Session& s) -> hrt_result {
    if (!out_target) return fail(HRT_ERROR_NULL_ARGUMENT, "out_target is null");
    hrt_target_config checked;
    HRT_RETURN_IF_FAILED(read_target_config(s.config(), config, &checked));
    HRT_RETURN_IF_FAILED(s.targets.add(checked, &out_target->value));
    s.record({.call = TargetChanged{TargetChanged::Change::added, out_target->value, checked}});
    return HRT_OK;
  });
}

hrt_result hrt_target_set(hrt_session session, hrt_target target, const hrt_target_config* config) noexcept {
  return with_session("hrt_target_set", session, [&](Session& s) -> hrt_result {
    hrt_target_config checked;
    HRT_RETURN_IF_FAILED(read_target_config(s.config(), config, &checked));
    HRT_RETURN_IF_FAILED(s.targets.set(target.value, checked));
    s.record({.call = TargetChanged{TargetChanged::Change::set, target.value, checked}});
    return HRT_OK;
  });
}

hrt_result hrt_target_get(hrt_session session, hrt_target target, hrt_target_config* out_config) noexcept {
  return with_session("hrt_target_get", session, [&](Session& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_config", out_config));
    const hrt_target_config* config = nullptr;
    HRT_RETURN_IF_FAILED(find_target(s.targets, "target", target, 0, &config));
    write_struct(*config, out_config);
    return HRT_OK;
  });
}

hrt_result hrt_target_remove(hrt_session session, hrt_target target) noexcept {
  return with_session("hrt_target_remove", session, [&](Session& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.targets.remove(target.value));
    s.record({.call = TargetChanged{TargetChanged::Change::removed, target.value, {}}});
    return HRT_OK;
  });
}

hrt_result hrt_target_find(hrt_session session, const char* name, hrt_target* out_target) noexcept {
  return with_session("hrt_target_find", session, [&](Session& s) -> hrt_result {
    if (!name) return fail(HRT_ERROR_NULL_ARGUMENT, "name is null");
    if (!out_target) return fail(HRT_ERROR_NULL_ARGUMENT, "out_target is null");
    const std::string_view wanted(name, strnlen(name, HRT_NAME_SIZE));
    const std::uint64_t id = s.targets.find(wanted);
    if (id == 0) return fail(HRT_ERROR_NOT_FOUND, "no target has the name \"", wanted, "\"");
    out_target->value = id;
    return HRT_OK;
  });
}

hrt_result hrt_target_list(hrt_session session, uint32_t role, uint32_t capacity, hrt_target* out_targets,
                           uint32_t* out_count) noexcept {
  return with_session("hrt_target_list", session, [&](Session& s) -> hrt_result {
    if (!out_count) return fail(HRT_ERROR_NULL_ARGUMENT, "out_count is null");
    HRT_RETURN_IF_FAILED(check_range<unsigned>("role", role, 0, HRT_TARGET_VIRTUAL));
    const auto listed = [role](const auto& entry) { return role == 0 || entry.second.role == role; };
    std::uint32_t count = 0;
    for (const auto& entry : s.targets.all()) count += listed(entry) ? 1 : 0;
    if (capacity > 0) {
      if (!out_targets) return fail(HRT_ERROR_NULL_ARGUMENT, "out_targets is null");
      if (capacity < count)
        return fail(HRT_ERROR_BUFFER_TOO_SMALL, "capacity is ", capacity, "; there are ", count, " targets");
      for (const auto& entry : s.targets.all()) {
        if (listed(entry)) (out_targets++)->value = entry.first;
      }
    }
    *out_count = count;
    return HRT_OK;
  });
}
