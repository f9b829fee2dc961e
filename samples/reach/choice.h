// Choices of a run: targets, controller, position and limits of the plate, names of the devices.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "samples/app/person/prompt.h"
#include "samples/app/plate/plate.h"
#include "samples/app/run/options.h"
#include "samples/app/scene/targets.h"

namespace hrt::reach {

using namespace app;

/// Creates a session of the plugin, configured by the options, with the targets of the scene.
TargetSet load_targets(const Plugin& plugin, const Options& options);

/// Returns the reaches to make, in order. Throws Failure (ExitCode::scene) if the scene lacks a requested target, or
/// has no virtual target.
std::vector<TargetPair> choose(const TargetSet& targets, const Options& options);

/// Assumed pose of an unregistered plate in a space of the runtime.
struct ScenePlace {
  XrReferenceSpaceType space;
  XrPosef pose;       ///< pose of the plate's mount in that space
  std::string words;  ///< description of the position, to be printed and spoken
};

/// Returns the assumed pose. Heights in the scene are above the floor. Without a floor space, the origin of LOCAL is at
/// the eyes, whose height is `eye_height_m` or the person's answer. Throws Failure (ExitCode::usage) without either.
ScenePlace place_of(const TargetSet& targets, const XrHeadlessSession& session, std::optional<double> eye_height_m,
                    Prompt& prompt);

/// Sets the plate's limits and latency in the session's configuration to those that the device reports. A latency of 0
/// is ignored; one that is too long for the plugin is reduced.
void plan_with(const Plugin& plugin, hrt_session session, const hrt_plate_report& report);

/// Passes the names of the plate and the tracker to the plugin. Warns on standard error if the profile in use was
/// measured with other devices.
void name_conditions(const Plugin& plugin, hrt_session session, const PlateChoice& plate, const std::string& tracker);

}  // namespace hrt::reach
