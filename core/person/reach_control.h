// The controller for people: the plate orientation that steers the finger to a position at arrival, within a limit of
// the perceived-direction error.
//
// If the perceived shift Gamma is constant relative to the motion, the direction relaxes to G - Gamma at the rate k,
// for any curve of the illusion. The position of arrival is therefore affine in Gamma:
//
//   1. predict the motion over the dead time, in which a command given now has no effect yet;
//   2. integrate the lateral path from there to arrival: miss(Gamma) = m + M Gamma;
//   3. minimise the squares of the miss and of the change of Gamma, which weighs more as M decreases;
//   4. limit the predicted perceived-direction error phi + Gamma - G;
//   5. invert the illusion on its rising branch, within the bound about the motion.
#pragma once

#include "core/person/person_filter.h"
#include "core/plate/plate_model.h"

namespace hrt {

struct ReachControlConfig {
  /// The ridge normal stays within this of the motion, and within the peak of the person's illusion; (0, 89].
  double bound_deg = 75.0;
  /// The plate does not ask for more felt error than this, > 0.
  double max_felt_error_deg = 5.0;
};

/// The real target, relative to where the finger rested.
struct ReachAim {
  PlatePoint target;
  /// Start of the line to the target across which the miss is measured: where the finger was when it was last aimed.
  PlatePoint from;
};

/// Motion of the plate before a new command takes effect.
struct PlateOutlook {
  const PlateTrace& past;
  double now_s;              ///< time of the command, and of the trace's last entry
  double latency_s;          ///< time until a command moves the plate
  double after_latency_deg;  ///< plate orientation at that time, under the commands already given
};

struct ReachPlan {
  double plate_deg;       ///< required direction of the ridge normal
  double felt_error_deg;  ///< perceived minus intended direction once the plate has the commanded orientation
  double miss_mm;         ///< across the line to the real target at arrival, left positive, if the plate does so
  bool at_bound;          ///< the plan requires a larger shift than the plate can give
};

/// Plans from the state of `filter` at `filter_s` <= outlook.now_s. Uses no heap, lock or exception.
ReachPlan plan_reach(const ReachControlConfig& config, const PersonFilter& filter, double filter_s, const ReachAim& aim,
                     const PlateOutlook& outlook);

/// Plate orientation that the start of the motion requires, before the person moves.
double ready_orientation_deg(const ReachControlConfig& config, const PersonFilter& resting, const ReachAim& aim);

}  // namespace hrt
