// One reach: the fingertip moves from the start to the real target; in every frame the plugin computes an
// orientation, and the plate turns to it.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "samples/reach/plate.h"
#include "samples/reach/targets.h"
#include "samples/reach/xr/session.h"
#include "samples/reach/xr/simulation.h"

namespace hrt::reach {

/// The state after one frame. Positions in plate coordinates.
struct Moment {
  XrTime time;
  bool tracked;                      ///< without it, `position_m` is of the last frame that was
  std::array<double, 3> position_m;  ///< of the fingertip, as tracked
  double finger_direction_deg;       ///< in the last step, observed or predicted
  double felt_direction_deg;         ///< the simulation's truth, or else the plugin's estimate
  double plate_orientation_deg;      ///< measured, or else commanded
  double distance_to_go_m;
  bool saturated;
  bool can_be_held;  ///< the real direction, by the controller's estimate of the user
};

struct ReachResult {
  double final_direction_deg;  ///< P at the end: the simulation's truth, or else as observed
  double peak_felt_error_deg;  ///< the simulation's truth, or else as estimated; 0 if unknown
  double miss_deg;             ///< bearing of the fingertip's end, from the start, less the real target's
  double miss_m;               ///< from where the fingertip ended to the real target's place, along the plate
  bool is_truth;               ///< the fields above and the next two are the simulation's truth
  double tactile_weight;       ///< share of touch in the felt direction; 0 if unknown
  double holdable_gap_deg;  ///< largest one, to the real target's side, that a plate can hold; 0 if unknown
  double assumed_weight;    ///< the controller's estimate of that share at the end
  bool can_be_held;         ///< as the controller reports (HRT_COMMAND_UNREACHABLE)
  bool off_target;          ///< the controller reports HRT_COMMAND_OFF_TARGET
  bool misfit;              ///< the controller reports HRT_COMMAND_MISFIT
  bool changed_hands;       ///< within the reach, so that two fingers made it
  int frames;
  int dropouts;            ///< frames without a tracked fingertip
  double saturated_share;  ///< of the controller's steps, those held by the plate's bound or rate
  std::vector<Moment> moments;
};

/// Everything that a reach goes through.
struct Stage {
  const Plugin& plugin;
  const TargetSet& targets;
  XrHeadlessSession& session;
  Simulation* simulation;  ///< null: a person, instructed on the terminal
  Plate& plate;
  std::vector<Hand> hands;   ///< any of which may reach
  XrDuration time_limit_ns;  ///< for coming to the start, and for the reach
  std::function<void(const TargetPair&, const Moment&)> on_frame;
  std::function<void(const std::string&)> tell_user;
};

/// Throws Failure, XrFailure; XrLost if the session was lost and the reach must be repeated. Every failure
/// stops the plate.
ReachResult run_reach(Stage& stage, const TargetPair& pair);

}  // namespace hrt::reach
