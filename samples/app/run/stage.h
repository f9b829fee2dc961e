// What a slide goes through, and what all slides need: frames, a finger at rest.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "samples/app/finger/touch_frame.h"
#include "samples/app/plate/plate.h"
#include "samples/app/scene/targets.h"
#include "samples/app/xr/session.h"
#include "samples/app/xr/simulation.h"

namespace hrt::app {

using Point = std::array<double, 3>;

/// The state after one frame. Positions in plate coordinates.
struct Moment {
  XrTime time;
  bool tracked;                      ///< without it, `position_m` is of the last frame that was
  std::array<double, 3> position_m;  ///< of the fingertip, as tracked
  double bearing_deg;                ///< of the finger, seen from the start
  double felt_direction_deg;         ///< the simulation's truth, or else the plugin's estimate
  double plate_orientation_deg;      ///< measured, or else commanded
  double distance_to_go_m;
  bool lifted;  ///< the fingertip is above the plate
  bool saturated;
  bool arrived;      ///< HRT_COMMAND_ARRIVED
  bool can_be_held;  ///< the real direction, by the controller's estimate of the user
};

/// Everything that a slide goes through.
struct Stage {
  const Plugin& plugin;
  const TargetSet& targets;
  XrHeadlessSession& session;
  Simulation* simulation;  ///< null: a person, instructed on the terminal
  Plate& plate;
  std::vector<Hand> hands;                                         ///< any of which may reach
  XrDuration time_limit_ns;                                        ///< for coming to the start, and for the reach
  std::function<void(const TargetPair&, const Moment&)> on_frame;  ///< of a reach
  std::function<void(const std::string&)> tell_user;
  /// Help while something is awaited; may be left unsaid.
  std::function<void(const std::string&)> hint;
  /// In every frame: what the user wants meanwhile. May throw, which ends what is being awaited.
  std::function<void(XrTime)> attend;
  TouchFrame* touch = nullptr;  ///< that tracks the fingertip; null: the session does
  /// From the joint to the skin that touches, in the joint's axes; 0: unknown.
  Point skin_m{};
};

constexpr double tip_height_m = 0.008;         ///< of the joint, which is inside the finger, above the plate
constexpr double lifted_height_m = 0.025;      ///< a fingertip higher than this does not touch the plate
constexpr double start_radius_m = 0.015;       ///< a finger this near the start is there
constexpr XrDuration settle_ns = 300'000'000;  ///< what does not change in this time is at rest

/// Where the plate's space is placed to have the world's coordinates.
constexpr XrPosef world{{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};

double distance_along_plate_m(const Point& a, const Point& b);

/// "within 30 s", for sentences.
std::string within_s(XrDuration limit_ns);

/// The session's configuration.
hrt_session_config config_of(const Stage& stage);

/// The fingertip: the skin that touches if its offset from the joint is known, else the joint.
Fingertip locate(const Stage& stage, Hand hand, XrTime time);

/// What the plugin is given of a frame.
hrt_sample sample_of(XrTime time, const Fingertip& tip, std::optional<double> plate_orientation_deg);
/// The same of a joint in the world, where the plate's space has been placed.
hrt_sample world_sample_of(XrTime time, const Fingertip& joint, std::optional<double> plate_orientation_deg);

/// Has the simulated user slide from the start.
void instruct(Stage& stage, Hand hand, double direction_deg, double distance_m);

/// The next frame, with the plate served and the user attended to.
XrTime next_frame(Stage& stage);

}  // namespace hrt::app
