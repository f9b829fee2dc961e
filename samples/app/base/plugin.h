// The plugin, opened by dlopen(), as an engine opens it. The C headers serve for types and constants only.
#pragma once

#include <haptic_retargeting/gap.h>
#include <haptic_retargeting/haptic_retargeting.h>
#include <haptic_retargeting/person.h>
#include <haptic_retargeting/profile.h>
#include <haptic_retargeting/recording.h>
#include <haptic_retargeting/scene.h>
#include <haptic_retargeting/setup.h>

#include <filesystem>
#include <memory>

namespace hrt::app {

#define HRT_REACH_PLUGIN_FUNCTIONS(X) \
  X(hrt_result_string)                \
  X(hrt_last_error)                   \
  X(hrt_get_version)                  \
  X(hrt_session_create)               \
  X(hrt_session_destroy)              \
  X(hrt_session_get)                  \
  X(hrt_session_set)                  \
  X(hrt_scene_load)                   \
  X(hrt_scene_get_info)               \
  X(hrt_scene_get_target)             \
  X(hrt_scene_register)               \
  X(hrt_scene_destroy)                \
  X(hrt_gap_query)                    \
  X(hrt_reach_begin)                  \
  X(hrt_reach_update)                 \
  X(hrt_reach_touched)                \
  X(hrt_reach_cancel)                 \
  X(hrt_reach_end)                    \
  X(hrt_recording_start)              \
  X(hrt_recording_stop)               \
  X(hrt_setup_begin)                  \
  X(hrt_setup_update)                 \
  X(hrt_setup_finish)                 \
  X(hrt_setup_cancel)                 \
  X(hrt_profile_save)                 \
  X(hrt_profile_load)                 \
  X(hrt_profile_set_conditions)       \
  X(hrt_profile_get_conditions)

/// The opened library. Its functions have their C names: plugin.hrt_session_create(...).
class Plugin {
 public:
  /// Throws Failure (ExitCode::plugin) if the library cannot be opened or is too old or too new.
  explicit Plugin(const std::filesystem::path& library);

  /// Throws Failure (ExitCode::plugin) with the plugin's own text unless `result` is HRT_OK.
  void check(hrt_result result) const;

#define HRT_DECLARE(name) decltype(&::name) name = nullptr;
  HRT_REACH_PLUGIN_FUNCTIONS(HRT_DECLARE)
#undef HRT_DECLARE

 private:
  std::unique_ptr<void, int (*)(void*)> library_;
};

}  // namespace hrt::app
