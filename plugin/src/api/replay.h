// Replays a recording.
#pragma once

#include <string_view>

#include "haptic_retargeting/recording.h"

namespace hrt::plugin {

/// Replays the content of a recording: hrt_recording_replay().
hrt_result replay(std::string_view text, hrt_replay_report* out);

}  // namespace hrt::plugin
