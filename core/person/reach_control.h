// The controller for people: the plate orientation that brings the finger to a place at arrival, without
// being felt.
//
// A felt shift Gamma that is constant relative to the motion makes the direction relax to G - Gamma at the
// rate k, whatever the illusion's curve. So the place of arrival is affine in Gamma:
//
//   1. carry the motion over the dead time, in which a command given now is not yet felt;
//   2. integrate the lateral path from there to arrival: miss(Gamma) = m + S Gamma;
//   3. least squares of the miss, and of the change of Gamma from what it is, which weighs more as S fades;
//   4. keep the predicted felt error phi + Gamma - G within its limit;
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

/// What the plate does before a command given now is felt.
struct PlateOutlook {
  const PlateTrace& past;
  double now_s;              ///< of the command, and of the trace's last entry
  double latency_s;          ///< until a command moves the plate
  double after_latency_deg;  ///< where it stands then, under the commands already given
};

struct ReachPlan {
  double plate_deg;       ///< wanted orientation of the ridge normal
  double felt_error_deg;  ///< felt less intended direction once the plate stands there
  double miss_mm;         ///< across the line to the real target at arrival, left positive, if the plate does so
  bool at_bound;          ///< more shift is wanted than the plate may give
};

/// Plans from `filter`, which stands at `filter_s` <= outlook.now_s. No heap, no lock, no exception.
ReachPlan plan_reach(const ReachControlConfig& config, const PersonFilter& filter, double filter_s, const ReachAim& aim,
                     const PlateOutlook& outlook);

/// Where the plate should stand before the person moves.
double ready_orientation_deg(const ReachControlConfig& config, const PersonFilter& resting, const ReachAim& aim);

}  // namespace hrt
