// One reach: the fingertip moves from the start to the real target; in every frame the plugin computes an
// orientation, and the plate turns to it.
#pragma once

#include "samples/app/run/stage.h"

namespace hrt::app {

struct ReachResult {
  double final_direction_deg;  ///< bearing of the fingertip's end; under the paper's controller P of its last step
  double peak_felt_error_deg;  ///< the simulation's truth, or else as estimated; 0 if unknown
  double miss_deg;             ///< bearing of the fingertip's end, from the start, less the real target's
  double miss_m;               ///< from where the fingertip ended to the real target's place, along the plate
  bool is_truth;               ///< the fields above and the next two are the simulation's truth
  double tactile_weight;       ///< share of touch in the felt direction; 0 if unknown
  double holdable_gap_deg;     ///< largest one, to the real target's side, that a plate can hold; 0 if unknown
  bool can_be_held;            ///< as the controller reports (HRT_COMMAND_UNREACHABLE)
  hrt_reach_summary summary;   ///< the plugin's
  bool changed_hands;          ///< within the reach, so that two fingers made it
  int frames;
  int dropouts;            ///< frames without a tracked fingertip
  double saturated_share;  ///< of the controller's steps, those held by the plate's bound or rate
};

/// Throws Failure, XrFailure; XrLost if the session was lost and the reach must be repeated. Failure with
/// ExitCode::no_hand: no finger came to the start, or the reach did not end, in time, and why. Every failure
/// stops the plate.
ReachResult run_reach(Stage& stage, const TargetPair& pair);

}  // namespace hrt::app
