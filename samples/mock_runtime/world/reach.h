// One reach of the simulated participant: the fingertip slides over the plate at a constant speed; each step
// of the participant's model sets its direction.
//
// Coordinates are the plate's (metres; x to the right, z towards the user), directions in degrees from
// the mid-line, counter-clockwise positive seen from above: direction d is (-sin d, -cos d).
#pragma once

#include <openxr/openxr.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/plate_model.h"
#include "core/simulation/participant.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

struct ReachInstruction {
  Eigen::Vector2d start_m;  ///< x, z
  double goal_direction_deg;
  double path_length_m;
};

class Reach {
 public:
  /// Starts at `start`. `number` counts the reaches of a session and, with the seed, fixes the noise.
  Reach(const ParticipantSettings& participant, const ReachInstruction& instruction, std::uint64_t seed,
        std::uint32_t number, XrTime start);

  /// Makes the steps that end up to `time`. During step k the finger moves along P_k; at its end the
  /// participant feels the plate and chooses P_k+1. `plate` stands at the time of the call before.
  void advance(XrTime time, const PlateModel& plate);

  /// Up to the end of the step under way; later times give that end.
  Eigen::Vector2d position_m(XrTime time) const;
  Eigen::Vector2d velocity_m_per_s(XrTime time) const;

  double tactile_weight() const { return settings_.parameters.tactile_weight; }
  /// P after the last step made, and what the participant felt in it.
  double true_direction_deg() const { return participant_.finger_direction_deg(); }
  double perceived_direction_deg() const { return participant_.perceived_direction_deg(); }
  std::uint32_t steps() const { return steps_; }
  bool done() const { return steps_ == total_steps_; }

 private:
  // One step's straight line.
  struct Leg {
    Eigen::Vector2d from_m;
    Eigen::Vector2d velocity_m_per_s;
  };

  XrTime step_end(std::uint32_t step) const;
  std::size_t leg_at(XrTime time) const;

  ParticipantSettings settings_;
  SimulatedParticipant participant_;
  std::uint64_t seed_;
  std::uint32_t number_;
  XrTime start_;
  XrDuration duration_;
  std::uint32_t total_steps_;
  std::uint32_t steps_ = 0;
  std::vector<Leg> legs_;  // of step 0 to the one under way
};

}  // namespace hrt::mock
