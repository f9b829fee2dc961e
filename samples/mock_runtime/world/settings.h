// The settings of the simulated world; script.h reads them from JSON. The defaults are people at a natural
// pace and an ideal tracker and servo.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "core/plate_model.h"
#include "samples/mock_runtime/world/people.h"

namespace hrt::mock {

/// Content of XrHandJointVelocitiesEXT: nothing valid, valid zeros, valid linear ones only, or all.
enum class Velocities { none, zero, linear, full };

/// The hand tracker.
struct TrackerSettings {
  double noise_m = 0.0;         ///< standard deviation of each coordinate, white, >= 0
  std::int64_t latency_ns = 0;  ///< a location at time t is that of t - latency, >= 0
  std::int64_t period_ns = 0;   ///< between samples; 0: a sample for every requested time
  Velocities velocities = Velocities::full;
};

/// Where an index fingertip is at a time.
struct Keyframe {
  std::int64_t time_ns;            ///< since the session was created
  Eigen::Vector3d index_tip_m;     ///< in LOCAL space
  Eigen::Quaterniond orientation;  ///< of the wrist, in LOCAL space
};

struct HandSettings {
  bool tracked = false;
  std::vector<Keyframe> path;  ///< in order of time; empty: at rest
};

struct WorldSettings {
  std::uint64_t seed = 1;
  std::vector<PersonSettings> participants = {{}};  ///< reach n is by entry n modulo their count
  TrackerSettings tracker;
  PlateDynamics servo;
  std::array<HandSettings, 2> hands = {{{}, {.tracked = true}}};  ///< left, right
};

}  // namespace hrt::mock
