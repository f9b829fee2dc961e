// The settings of the simulated world; script.h reads them from JSON. The defaults are participants with a
// natural pace and an ideal tracker and servo.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/plate/plate_model.h"
#include "samples/mock_runtime/world/people.h"
#include "samples/mock_runtime/world/pose.h"

namespace hrt::mock {

/// Properties of the hand tracker.
struct TrackerSettings {
  double noise_m = 0.0;         ///< standard deviation of each coordinate, white, >= 0
  std::int64_t latency_ns = 0;  ///< a location at time t is that of t - latency, >= 0
  std::int64_t period_ns = 0;   ///< time between samples; 0: a sample for every requested time
};

/// Repeated slides over the placed plate without instructions, in plate coordinates.
struct SlideSettings {
  Eigen::Vector3d start_m;  ///< position of the index tip joint
  double direction_deg;     ///< goal direction
  double length_m;
  std::int64_t rest_ns;  ///< rest at the end, before the finger returns to the start
};

struct HandSettings {
  bool tracked = false;
  std::vector<Keyframe> path;  ///< index fingertip and wrist's axes in LOCAL; empty: at rest
  std::optional<SlideSettings> slides;
};

/// A plate that exists before the session begins.
struct PlateSettings {
  Pose pose;             ///< in LOCAL; its +Y is the normal, its -Z the mid-line
  std::string terminal;  ///< path of the pseudo-terminal that controls it; empty: no terminal
};

struct WorldSettings {
  std::uint64_t seed = 1;
  std::vector<PersonSettings> participants = {{}};  ///< entry n modulo their count makes reach n
  TrackerSettings tracker;
  PlateDynamics servo;
  std::optional<PlateSettings> plate;
  std::array<HandSettings, 2> hands = {{{}, {.tracked = true}}};  ///< left, right
  std::vector<Keyframe> head;                                     ///< path in LOCAL; empty: at the origin
};

}  // namespace hrt::mock
