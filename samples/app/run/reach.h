#pragma once

#include "samples/app/run/run_context.h"

namespace hrt::app {

struct ReachResult {
  double final_direction_deg;  ///< bearing of the end of the reach; paper's controller: last direction of motion
  double peak_felt_error_deg;  ///< ground truth of the simulation, else the estimate; 0 if unknown
  double miss_deg;             ///< bearing of the end of the reach minus that of the real target
  double miss_m;               ///< distance along the plate from the end of the reach to the real target
  bool is_truth;               ///< the fields above and the next two are ground truth of the simulation
  double tactile_weight;       ///< w_T; 0 if unknown
  double max_gap_deg;          ///< largest feasible gap on the real target's side; 0 if unknown
  bool is_feasible;            ///< at the end, the controller estimates a feasible gap: no HRT_COMMAND_UNREACHABLE
  hrt_reach_summary summary;
  bool changed_hands;  ///< the hand changed within the reach
  int frames;
  int dropouts;            ///< frames without a tracked fingertip
  double saturated_share;  ///< fraction of controller steps at the bound or rate limit of the plate
};

/// Makes one reach: in each frame the plugin computes an orientation, and the plate turns to it. A failure during the
/// reach stops the plate. Throws XrLost if the session was lost and the reach must be repeated; Failure
/// (ExitCode::no_hand), with the reason, if the reach did not begin or end in time; else Failure or XrFailure.
ReachResult run_reach(RunContext& context, const TargetPair& pair);

}  // namespace hrt::app
