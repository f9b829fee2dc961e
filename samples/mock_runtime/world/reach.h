// One reach of a simulated participant: the fingertip rests for the reaction time, then slides over the plate.
//
// Coordinates are the plate's (metres; x to the right, z towards the user), directions in degrees from
// the mid-line, counter-clockwise positive seen from above: direction d is (-sin d, -cos d).
#pragma once

#include <openxr/openxr.h>

#include <Eigen/Core>
#include <vector>

#include "core/plate/plate_model.h"
#include "core/simulation/person.h"
#include "samples/mock_runtime/world/people.h"

namespace hrt::mock {

struct ReachInstruction {
  Eigen::Vector2d start_m;  ///< x, z
  double goal_direction_deg;
  double path_length_m;
};

class Reach {
 public:
  /// Begins with the instruction at `start`. The number of the reach and the seed determine the noise.
  Reach(const DrawnPerson& person, const ReachInstruction& instruction, std::uint64_t seed, std::uint32_t number,
        XrTime start);

  /// Simulates all whole milliseconds up to `time`; the participant feels the plate at the end of each. `plate` must
  /// have its state of the last call.
  void advance(XrTime time, const PlateModel& plate);

  /// The fingertip's x and z at any time; a future time is predicted without further plate commands.
  Eigen::Vector2d position_m(XrTime time, const PlateModel& plate) const;

  double tactile_weight() const { return simulated_.illusion.tactile_weight; }
  /// Outermost feasible direction to the left (`sign` > 0) or right, in mid-path, for a plate within 75 degrees of the
  /// motion.
  double outermost_direction_deg(double sign) const;
  /// P, the direction of motion; and below it the perceived direction.
  double true_direction_deg() const { return person_.direction_deg(); }
  double perceived_direction_deg() const { return goal_direction_deg_ + person_.felt_error_deg(); }
  /// Largest difference between perceived and virtual direction so far, while the finger moves.
  double peak_felt_error_deg() const { return peak_felt_error_deg_; }
  bool done() const { return person_.done(); }
  /// Time at which the finger came to rest. Requires that the reach is done.
  XrTime ended() const;

 private:
  XrTime millisecond_end(std::size_t millisecond) const;

  Person simulated_;
  SlidingPerson person_;
  double goal_direction_deg_;
  XrTime moves_;                       // time of motion onset
  std::vector<Eigen::Vector2d> path_;  // positions at the start and after each millisecond
  double peak_felt_error_deg_ = 0.0;
};

}  // namespace hrt::mock
