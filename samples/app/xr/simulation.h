// A runtime that simulates its user (XR_HRTX_ridged_plate): instructs the person, turns the simulated
// plate, reads the truth about the reach.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <cstdint>

#include "samples/app/xr/openxr_hrtx_ridged_plate.h"
#include "samples/app/xr/session.h"

namespace hrt::app {

/// The extension's functions for one session. Every call throws XrFailure. One thread.
class Simulation {
 public:
  Simulation(const XrRuntime& runtime, const XrHeadlessSession& session);

  /// The plate's mount is the origin of this space, in the room: it stays there when the space moves.
  void place_plate(XrSpace space, double radius_m);

  /// From now on person and noise come from this seed; the next reach has this number, from 0.
  void seed(std::uint64_t seed, std::uint32_t next_reach);

  /// The person is instructed now to slide from `start_m` in plate coordinates.
  void instruct(Hand hand, const std::array<double, 3>& start_m, double goal_direction_deg, double path_length_m);

  struct Truth {
    double finger_direction_deg;     ///< P now
    double perceived_direction_deg;  ///< felt now
    double peak_felt_error_deg;      ///< largest difference between felt and goal direction so far
    double leftmost_direction_deg;   ///< farther to the left, or to the right, no plate can hold the finger
    double rightmost_direction_deg;
    double tactile_weight;        ///< the share of touch in the felt direction
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
