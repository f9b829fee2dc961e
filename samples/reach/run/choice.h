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
void plan_with(const Plugin& plugin, hrt_session session, const hrt_plate_report& report);

/// Names the plate and the tracker of now to the plugin; warns on standard error if the session's profile was
/// measured with others.
void name_conditions(const Plugin& plugin, hrt_session session, const PlateChoice& plate, const std::string& tracker);

}  // namespace hrt::reach
