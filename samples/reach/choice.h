// What a run reaches for, where, and with which controller.
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

/// The scene's targets, in a session of the plugin as the options have it.
TargetSet load_targets(const Plugin& plugin, const Options& options);

/// The reaches to make, in order. Throws Failure (ExitCode::scene) for a name that the scene lacks.
std::vector<TargetPair> choose(const TargetSet& targets, const Options& options);

/// Place of a scene's plate without a registration, as a runtime has it.
struct ScenePlace {
  XrReferenceSpaceType space;
  XrPosef pose;       ///< of the plate's mount in it
  std::string words;  ///< where that is, for a person
};

/// The scene's heights are above the floor. In a runtime without a floor they need the height of the eyes, at
/// which its LOCAL space begins: `eye_height_m`, or else the person's answer on the terminal. Throws Failure
/// (ExitCode::usage) without either.
ScenePlace place_of(const TargetSet& targets, const XrHeadlessSession& session, std::optional<double> eye_height_m,
                    Prompt& prompt);

/// The device's own limits replace the scene's.
void plan_with(const Plugin& plugin, hrt_session session, const hrt_plate_report& report);

/// Names the plate and the tracker of now to the plugin; warns on standard error if the session's profile was
/// measured with others.
void name_conditions(const Plugin& plugin, hrt_session session, const PlateChoice& plate, const std::string& tracker);

}  // namespace hrt::reach
