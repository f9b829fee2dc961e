// Registration of the plate: a person touches its marks, and the plugin fits its pose to the touches.
#pragma once

#include <array>
#include <span>

#include "samples/reach/run/reach.h"
#include "samples/reach/scene/marks.h"

namespace hrt::reach {

/// A registered plate, in a reference space of the runtime.
struct RegisteredPlate {
  XrReferenceSpaceType space;
  hrt_registration registration;
  Mark check;  ///< touched before the reaches, to see whether the plate is where it was
  /// Of each hand whose skin the touches were of.
  std::array<hrt_fingertip, 2> fingertips{};
};

/// Asks for a touch of each mark on the terminal, in the session's steady space, until they fit: three times
/// at most. Places the session's plate space there. With `fingertips`, asks before for touches of the first
/// mark by each of the stage's hands, in different attitudes, and from then on locates their skin. Throws
/// Failure: ExitCode::registration if they never fit, no_hand if a touch does not come in time.
RegisteredPlate register_plate(Stage& stage, std::span<const Mark> marks, bool fingertips);

/// Places the session's plate space where the plate was registered, locates the skin of its hands, and asks
/// for a touch that checks it. Throws Failure: ExitCode::registration if the plate is elsewhere or the
/// runtime lacks its space, no_hand.
void check_plate(Stage& stage, const RegisteredPlate& plate);

}  // namespace hrt::reach
