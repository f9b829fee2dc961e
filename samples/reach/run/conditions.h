// What a profile is measured with: plate, tracker, and when.
#pragma once

#include <string>

#include "samples/reach/base/plugin.h"
#include "samples/reach/run/options.h"

namespace hrt::reach {

/// Names the plate and the tracker of now to the plugin; warns on standard error if the session's profile was
/// measured with others.
void name_conditions(const Plugin& plugin, hrt_session session, const PlateChoice& plate,
                     const std::string& tracker);

}  // namespace hrt::reach
