// One reach: the fingertip moves from the start to the real target; in every frame the plugin computes an
// orientation, and the plate turns to it.
#pragma once

#include "samples/app/run/stage.h"

namespace hrt::app {

struct ReachResult {
  double final_direction_deg;  ///< bearing of the fingertip's end; paper's controller: P of its last step
  double peak_felt_error_deg;  ///< ground truth of the simulation, else the estimate; 0 if unknown
  double miss_deg;             ///< bearing of the fingertip's end, from the start, minus the real target's
  double miss_m;               ///< distance along the plate from the fingertip's end to the real target
  bool is_truth;               ///< the fields above and the next two are ground truth of the simulation
  double tactile_weight;       ///< w_T, share of touch in the perceived direction; 0 if unknown
  double holdable_gap_deg;     ///< largest feasible gap on the real target's side; 0 if unknown
  bool can_be_held;            ///< the controller has not set HRT_COMMAND_UNREACHABLE
  hrt_reach_summary summary;   ///< summary of the plugin
  bool changed_hands;          ///< the hand changed within the reach
  int frames;
  int dropouts;            ///< frames without a tracked fingertip
  double saturated_share;  ///< fraction of controller steps at the bound or rate limit of the plate
};

/// Makes one reach. Throws Failure and XrFailure; XrLost if the session was lost and the reach must be repeated;
/// Failure (ExitCode::no_hand), with the reason, if no finger came to the start in time or the reach did not end in
/// time. Every failure stops the plate.
ReachResult run_reach(Stage& stage, const TargetPair& pair);

}  // namespace hrt::app
