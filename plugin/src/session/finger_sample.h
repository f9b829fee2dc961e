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

/// What the core makes of a checked sample, positions as contacts correct them; sets those flags of a command
/// that the sample alone decides.
FingerSample observe(const hrt_session_config& config, const hrt_sample& checked_sample, std::uint32_t* command_flags);

}  // namespace hrt::plugin
