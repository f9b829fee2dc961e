// The controller for people. It computes the plate orientation that steers the finger to a position at arrival, within
// a limit of the perceived-direction error.
//
// If the perceived shift Gamma is constant relative to the motion, the steered direction psi relaxes to G - Gamma at
// the rate k, for any illusion curve. The position at arrival is therefore an affine function of Gamma:
//
//   1. predict the motion over the dead time, in which a command given now has no effect yet;
//   2. integrate the lateral path from there to arrival: miss(Gamma) = m + M Gamma;
//   3. minimise the sum of the squared miss and the weighted squared change of Gamma;
//   4. limit the predicted perceived-direction error psi + Gamma - G;
//   5. invert the illusion on its rising branch, within the bound about the motion.
#pragma once

#include "core/person/person_filter.h"
#include "core/plate/plate_model.h"

namespace hrt {

struct ReachControlConfig {
  /// Largest angle between ridge normal and motion, (0, 89]. The angle also stays below that of the illusion's maximum.
  double bound_deg = 75.0;
  /// Limit of the perceived-direction error that the plate causes, > 0.
  double max_felt_error_deg = 5.0;
};

/// The real target, relative to the rest position of the finger.
struct ReachAim {
  PlatePoint target;
  /// Start of the line to the target; the miss is measured across this line. The start of the reach, or the position of
  /// the finger at the last retarget.
  PlatePoint from;
};

/// Motion of the plate before a new command takes effect.
struct PlateOutlook {
  const PlateTrace& past;
  double now_s;              ///< time of the command and of the trace's last entry
  double latency_s;          ///< time until a command moves the plate
  double after_latency_deg;  ///< plate orientation after latency_s, under the commands already given
};

struct ReachPlan {
  double plate_deg;       ///< direction of the ridge normal to command
  double felt_error_deg;  ///< predicted perceived minus intended direction when the plate has that orientation
  double miss_mm;         ///< predicted lateral miss at arrival, left positive
  bool at_bound;          ///< the plan requires a larger shift than the plate can cause
};

/// Computes a plan from the state of `filter` at `filter_s` <= outlook.now_s. Uses no heap, lock or exception.
ReachPlan plan_reach(const ReachControlConfig& config, const PersonFilter& filter, double filter_s, const ReachAim& aim,
                     const PlateOutlook& outlook);

/// Returns the plate orientation that the plan requires at the onset.
double ready_orientation_deg(const ReachControlConfig& config, const PersonFilter& resting, const ReachAim& aim);

}  // namespace hrt
