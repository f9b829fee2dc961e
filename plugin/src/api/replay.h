// Runs a recording again.
#pragma once

#include <string_view>

#include "haptic_retargeting/recording.h"

namespace hrt::plugin {

/// Fills `out` as hrt_recording_replay() promises.
hrt_result replay(std::string_view text, hrt_replay_report* out);

}  // namespace hrt::plugin
