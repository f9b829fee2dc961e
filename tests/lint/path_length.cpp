// Runs the two paths that tests/lint/path_length counts under callgrind: one update of a reach, and the registration of
// a scene from a glTF file.
#include <valgrind/callgrind.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "haptic_retargeting/haptic_retargeting.h"
#include "haptic_retargeting/scene.h"
#include "haptic_retargeting/setup.h"

namespace {

template <class Call>
hrt_result counted(Call&& call) {
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_TOGGLE_COLLECT;
  const hrt_result result = call();
  CALLGRIND_TOGGLE_COLLECT;
  CALLGRIND_STOP_INSTRUMENTATION;
  return result;
}

// Runs a reach by positions under HRT_GUIDANCE_ARRIVAL, every 11 ms. The last update, in the middle of the motion, is
// counted.
hrt_result update_once(hrt_session session) {
  hrt_reach_config reach = hrt_reach_config_init();
  hrt_target_config target = hrt_target_config_init();
  target.direction_deg = -5.0;
  hrt_result result = hrt_target_add(session, &target, &reach.real_target);
  target.role = HRT_TARGET_VIRTUAL;
  target.direction_deg = 5.0;
  if (result == HRT_OK) result = hrt_target_add(session, &target, &reach.virtual_target);
  if (result == HRT_OK) result = hrt_reach_begin(session, &reach);
  for (int i = 0; i < 100 && result == HRT_OK; ++i) {
    hrt_sample sample = hrt_sample_init();
    hrt_command command = hrt_command_init();
    const double u = std::fmin(std::fmax((i - 40) / 100.0, 0.0), 1.0);
    sample.flags = HRT_SAMPLE_WORLD_POSITION;
    sample.time_ns = INT64_C(11'000'000) * i;
    sample.finger_position_m[2] = 0.05 - 0.1 * u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
    const auto update = [&] { return hrt_reach_update(session, &sample, &command); };
    result = i == 99 ? counted(update) : update();
    if (result == HRT_OK && i == 99 && (command.flags & (HRT_COMMAND_HELD | HRT_COMMAND_PREDICTED)) != 0)
      result = HRT_ERROR_INTERNAL;
  }
  return result;
}

hrt_result register_scene(hrt_session session, const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  hrt_scene scene{};
  return counted([&] {
    const hrt_result result = hrt_scene_load(path, bytes.data(), bytes.size(), &scene);
    return result == HRT_OK ? hrt_scene_register(scene, session, 0, nullptr) : result;
  });
}

}  // namespace

int main(int argc, char** argv) {
  hrt_session session{};
  hrt_result result = hrt_session_create(HRT_VERSION, nullptr, &session);
  if (result == HRT_OK) result = argc > 1 ? register_scene(session, argv[1]) : update_once(session);
  if (result != HRT_OK) std::fprintf(stderr, "%s: %s\n", hrt_result_string(result), hrt_last_error());
  return result == HRT_OK ? 0 : 1;
}
