// One reach of a simulated person: the fingertip rests for the reaction time, then slides over the plate.
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
  /// Instructed at `start`. `number` counts the reaches of a session and, with the seed, fixes the noise.
  Reach(const DrawnPerson& person, const ReachInstruction& instruction, std::uint64_t seed, std::uint32_t number,
        XrTime start);

  /// Simulates the milliseconds that end up to `time`; the person feels the plate at the end of each. `plate`
  /// is as of the last call.
  void advance(XrTime time, const PlateModel& plate);

  /// The fingertip's x and z at any time; a future time is predicted without further plate commands.
  Eigen::Vector2d position_m(XrTime time, const PlateModel& plate) const;

  double tactile_weight() const { return simulated_.illusion.tactile_weight; }
  /// The outermost direction, to the left (`sign` > 0) or right, on which a plate within 75 degrees of the
  /// motion can hold the finger in mid-path.
  double outermost_direction_deg(double sign) const;
  /// P, and the felt direction.
  double true_direction_deg() const { return person_.direction_deg(); }
  double perceived_direction_deg() const { return goal_direction_deg_ + person_.felt_error_deg(); }
  /// Largest felt less virtual direction so far, while the finger moves.
  double peak_felt_error_deg() const { return peak_felt_error_deg_; }
  bool done() const { return person_.done(); }
  /// Since when the finger is where it is, if the reach is done.
  XrTime ended() const;

 private:
  XrTime millisecond_end(std::size_t millisecond) const;

  Person simulated_;
  SlidingPerson person_;
  double goal_direction_deg_;
  XrTime moves_;                       // when the finger begins to
  std::vector<Eigen::Vector2d> path_;  // at the start, and at the end of each millisecond
  double peak_felt_error_deg_ = 0.0;
};

}  // namespace hrt::mock
