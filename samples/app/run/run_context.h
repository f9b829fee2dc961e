// Environment of reaches and set-ups (session, plate, hands), and the steps that they share.
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
  bool tracked;  ///< false: `position_m` is that of the last tracked frame, or the start
  std::array<double, 3> position_m;
  double bearing_deg;            ///< direction of the finger, seen from the start
  double felt_direction_deg;     ///< perceived direction: ground truth of the simulation, else the plugin's estimate
  double plate_orientation_deg;  ///< measured orientation, else the commanded one
  double distance_to_go_m;       ///< from the fingertip to the real target
  bool lifted;                   ///< the fingertip is above the plate, or does not touch the touch frame
  bool saturated;
  bool arrived;      ///< HRT_COMMAND_ARRIVED
  bool is_feasible;  ///< the gap is feasible, by the controller's estimate of the user
};

struct RunContext {
  const Plugin& plugin;
  const TargetSet& targets;
  XrHeadlessSession& session;
  Simulation* simulation;  ///< simulated user, instructed through the runtime; null: a person, instructed by tell_user
  Plate& plate;
  std::vector<Hand> hands;   ///< hands that may reach
  XrDuration time_limit_ns;  ///< limit of each wait for the user, and of the reach
  std::function<void(const TargetPair&, const Moment&)> on_frame;  ///< called in each frame of a reach
  std::function<void(const std::string&)> tell_user;
  /// Called with help for the user during a wait; may ignore the text.
  std::function<void(const std::string&)> hint;
  /// Called in every frame to handle the user's keys. May throw, which ends the wait or the reach.
  std::function<void(XrTime)> handle_keys;
  TouchFrame* touch = nullptr;  ///< touch frame that tracks the fingertip; null: the session tracks it
  /// Offset from the joint to the skin that touches, in the joint's axes; 0: unknown.
  Point skin_m{};
};

constexpr double tip_height_m = 0.008;         ///< height of the joint inside the finger during a touch
constexpr double lifted_height_m = 0.025;      ///< a fingertip higher than this does not touch the plate
constexpr double start_radius_m = 0.015;       ///< distance within which a finger is at the start
constexpr XrDuration settle_ns = 300'000'000;  ///< time after which a finger counts as at rest or off the plate

/// Identity pose: a plate space at this pose has world coordinates.
constexpr XrPosef world{{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};

double distance_along_plate_m(const Point& a, const Point& b);

/// Returns text such as "within 30 s".
std::string within_s(XrDuration limit_ns);

hrt_session_config config_of(const RunContext& context);

/// Returns the contact with the touch frame, if one is used. Otherwise returns the position of the skin that touches if
/// its offset from the joint is known, else that of the joint.
Fingertip locate(const RunContext& context, Hand hand, XrTime time);

/// Sample of a frame for the plugin, in plate coordinates.
hrt_sample sample_of(XrTime time, const Fingertip& tip, std::optional<double> plate_orientation_deg);
/// Sample of a joint in world coordinates. Requires the plate space at `world`.
hrt_sample world_sample_of(XrTime time, const Fingertip& joint, std::optional<double> plate_orientation_deg);

/// Instructs the simulated participant to slide from the start. Requires that context.simulation is not null.
void instruct(RunContext& context, Hand hand, double direction_deg, double distance_m);

/// Waits for the next frame, services the plate and handles the user's keys.
XrTime next_frame(RunContext& context);

}  // namespace hrt::app
