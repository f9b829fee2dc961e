// Where each slide begins: a finger at rest at the start.
#pragma once

#include "samples/reach/run/stage.h"

namespace hrt::reach {

/// Waits until one of the hands rests its fingertip at the start; returns that hand. Throws Failure
/// (ExitCode::no_hand) after the stage's time limit.
Hand await_finger_at_start(Stage& stage);

}  // namespace hrt::reach
