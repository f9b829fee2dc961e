// Settings of the simulated world. By default, tracker and servo have no noise, no latency and unlimited speed.
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

struct TrackerSettings {
  double noise_m = 0.0;         ///< SD of the white noise of each coordinate
  std::int64_t latency_ns = 0;  ///< the tracker reports the location at t - latency_ns for time t
  std::int64_t period_ns = 0;   ///< time between samples; 0: a sample for every requested time
};

/// Slides over the plate that a hand repeats without instructions, in plate coordinates.
struct SlideSettings {
  Eigen::Vector3d start_m;  ///< position of the index tip joint
  double direction_deg;     ///< goal direction
  double length_m;
  std::int64_t rest_ns;  ///< rest at the end, before the finger returns to the start
};

struct HandSettings {
  bool tracked = false;
  std::vector<Keyframe> path;  ///< position of the index tip and orientation of the wrist in LOCAL; empty: at rest
  std::optional<SlideSettings> slides;
};

/// A plate that exists when the session is created.
struct PlateSettings {
  Pose pose;             ///< in LOCAL; +Y is the normal, -Z the mid-line away from the user
  std::string terminal;  ///< path of a pseudo-terminal that controls the plate; empty: no terminal
};

struct WorldSettings {
  std::uint64_t seed = 1;
  std::vector<PersonSettings> participants = {{}};  ///< reach n, from 0, is made by element n % size()
  TrackerSettings tracker;
  PlateDynamics servo;
  std::optional<PlateSettings> plate;
  std::array<HandSettings, 2> hands = {{{}, {.tracked = true}}};  ///< left, right
  std::vector<Keyframe> head;                                     ///< path in LOCAL; empty: at the origin
};

}  // namespace hrt::mock
