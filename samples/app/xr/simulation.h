// A runtime that simulates its user (XR_HRTX_ridged_plate): instructs the simulated participant, turns the plate and
// reads the ground truth of the reach.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <cstdint>

#include "samples/app/xr/openxr_hrtx_ridged_plate.h"
#include "samples/app/xr/session.h"

namespace hrt::app {

/// Functions of the extension for one session. Every call may throw XrFailure. For use by one thread.
class Simulation {
 public:
  Simulation(const XrRuntime& runtime, const XrHeadlessSession& session);

  /// Places the plate's mount at the present origin of `space`. The mount does not move with the space.
  void place_plate(XrSpace space, double radius_m);

  /// Sets the seed of participants and noise, and the number of the next reach, from 0.
  void seed(std::uint64_t seed, std::uint32_t next_reach);

  /// Instructs the participant to slide from `start_m`, in plate coordinates.
  void instruct(Hand hand, const std::array<double, 3>& start_m, double goal_direction_deg, double path_length_m);

  struct Truth {
    double finger_direction_deg;     ///< present direction of motion
    double perceived_direction_deg;  ///< present perceived direction
    double peak_felt_error_deg;      ///< largest perceived-direction error so far, while the finger moved
    double leftmost_direction_deg;   ///< this and the next field: range of feasible directions
    double rightmost_direction_deg;
    double tactile_weight;        ///< w_T, fraction of touch in the perceived direction
    std::array<double, 3> tip_m;  ///< in plate coordinates, without the tracker's errors
    bool done;                    ///< the motion has ended
  };
  Truth truth(Hand hand) const;

  void set_plate_orientation(double orientation_deg);
  double plate_orientation_deg(XrTime time) const;

 private:
  XrSession session_;
  PFN_xrPlacePlateHRTX place_plate_;
  PFN_xrSetSimulationSeedHRTX set_seed_;
  PFN_xrInstructReachHRTX instruct_reach_;
  PFN_xrGetReachTruthHRTX get_reach_truth_;
  PFN_xrSetPlateOrientationHRTX set_plate_orientation_;
  PFN_xrGetPlateOrientationHRTX get_plate_orientation_;
};

}  // namespace hrt::app
