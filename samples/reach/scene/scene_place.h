// Where the plate of a scene is for a runtime, if nobody has registered it.
#pragma once

#include <string>

#include "samples/reach/person/prompt.h"
#include "samples/reach/scene/targets.h"
#include "samples/reach/xr/session.h"

namespace hrt::reach {

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

}  // namespace hrt::reach
