// The parts of a script, one reader each.
#pragma once

#include "samples/mock_runtime/playback/members.h"
#include "samples/mock_runtime/script/event.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

PersonSettings read_person(Members& members);
TrackerSettings read_tracker(Members& members);
PlateDynamics read_servo(Members& members);
PlateSettings read_plate(Members& members);
void read_hand(Members& members, HandSettings& hand);
void read_head(Members& members, std::vector<Keyframe>& path);
void read_controller(Members& members, ControllerSettings& controller);
/// The path of an interaction profile; empty for null, a device that is off.
std::string read_profile(Members& members);
/// A pose in LOCAL: `position_m`, and `orientation` if it is there.
Pose read_pose(Members& members, const Eigen::Quaterniond& otherwise);
ScriptEvent read_event(Members& members);
/// What an event lets happen: its `do`, and what goes with that.
Happening read_happening(Members& members);
CallFault read_call(Members& members);

}  // namespace hrt::mock
