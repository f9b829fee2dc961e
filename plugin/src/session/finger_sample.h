// Samples of the finger as they cross the boundary: checked, and taken to the plate.
#pragma once

#include "core/reach/finger_sample.h"
#include "haptic_retargeting/reach.h"
#include "scene/geometry.h"

namespace hrt::plugin {

/// The fields of a sample that hold the finger.
inline constexpr std::uint32_t finger_flags =
    HRT_SAMPLE_DIRECTION | HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION;

/// Fails naming the first field that is out of its range.
hrt_result check_sample(const hrt_sample& sample);

/// Where the skin that touches is, in the frame of the checked sample.
Vec3 skin_m(const hrt_session_config& config, const hrt_sample& checked_sample);

/// observe() of a sample that has a position.
void observe_position(const hrt_session_config& config, const hrt_sample& checked_sample, FingerSample* observed,
                      std::uint32_t* command_flags);

/// What the core makes of a checked sample, positions as contacts correct them; sets those flags of a command
/// that the sample alone decides.
inline FingerSample observe(const hrt_session_config& config, const hrt_sample& checked_sample,
                            std::uint32_t* command_flags) {
  FingerSample observed{.time_ns = checked_sample.time_ns};
  if (checked_sample.flags & HRT_SAMPLE_PLATE_ORIENTATION)
    observed.plate_orientation_deg = checked_sample.plate_orientation_deg;
  if (checked_sample.flags & HRT_SAMPLE_LIFTED) {
    observed.observation = Observation::lifted;
    *command_flags |= HRT_COMMAND_LIFTED;
  } else if (checked_sample.flags & HRT_SAMPLE_DIRECTION) {
    observed.observation = Observation::direction;
    observed.direction_deg = checked_sample.finger_direction_deg;
  } else if (checked_sample.flags & finger_flags) {
    observe_position(config, checked_sample, &observed, command_flags);
  }
  return observed;
}

}  // namespace hrt::plugin
