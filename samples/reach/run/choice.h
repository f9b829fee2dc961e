// What a run reaches for, and with which controller.
#pragma once

#include <vector>

#include "samples/reach/plate/plate.h"
#include "samples/reach/run/options.h"
#include "samples/reach/scene/targets.h"

namespace hrt::reach {

/// The scene's targets, in a session of the plugin as the options have it.
TargetSet load_targets(const Plugin& plugin, const Options& options);

/// The reaches to make, in order. Throws Failure (ExitCode::scene) for a name that the scene lacks.
std::vector<TargetPair> choose(const TargetSet& targets, const Options& options);

/// The device's own limits replace the scene's.
void plan_with(const Plugin& plugin, hrt_session session, const PlateLimits& limits);

}  // namespace hrt::reach
