// One reach of a simulated participant: the fingertip rests for the reaction time, then slides over the plate.
//
// Positions are in plate coordinates: metres, x to the right, z towards the user. Directions are in degrees from the
// mid-line, counter-clockwise positive seen from above: direction d is (-sin d, -cos d).
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
  /// `start` is the time of the instruction. The seed and the number of the reach determine the noise.
  Reach(const DrawnPerson& person, const ReachInstruction& instruction, std::uint64_t seed, std::uint32_t number,
        XrTime start);

  /// Simulates all whole milliseconds up to `time`. The participant feels the plate orientation at the end of each
  /// millisecond. The caller must not advance `plate` to `time` before this call.
  void advance(XrTime time, const PlateModel& plate);

  /// Returns x and z of the fingertip at any time; a future position is predicted as if no further command arrived.
  Eigen::Vector2d position_m(XrTime time, const PlateModel& plate) const;

  double tactile_weight() const { return simulated_.illusion.tactile_weight; }
  /// Direction farthest to the left (`sign` > 0) or right in which a plate orientation of at most 75 degrees from the
  /// direction of motion can steer this participant. It applies half way, where the habit is 0.
  double outermost_direction_deg(double sign) const;
  /// Direction of motion: P in the paper.
  double true_direction_deg() const { return person_.direction_deg(); }
  double perceived_direction_deg() const { return goal_direction_deg_ + person_.felt_error_deg(); }
  /// Largest magnitude of the perceived-direction error so far, except at the onset and in slow motion.
  double peak_felt_error_deg() const { return peak_felt_error_deg_; }
  bool done() const { return person_.done(); }
  /// Time at which the finger came to rest. Requires that the reach is done.
  XrTime ended() const;

 private:
  XrTime millisecond_end(std::size_t millisecond) const;

  Person simulated_;
  SlidingPerson person_;
  double goal_direction_deg_;
  XrTime onset_;
  std::vector<Eigen::Vector2d> path_;  // positions at the start and after each millisecond
  double peak_felt_error_deg_ = 0.0;
};

}  // namespace hrt::mock
