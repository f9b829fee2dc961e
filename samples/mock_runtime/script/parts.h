// The parts of a script, one reader each.
#pragma once

#include "samples/mock_runtime/playback/members.h"
#include "samples/mock_runtime/script/event.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

PersonSettings read_person(Members& members);
TrackerSettings read_tracker(Members& members);
PlateDynamics read_servo(Members& members);
void read_hand(Members& members, HandSettings& hand);
void read_head(Members& members, std::vector<Keyframe>& path);
void read_controller(Members& members, ControllerSettings& controller);
/// The path of an interaction profile; empty for null, a device that is off.
std::string read_profile(Members& members);
ScriptEvent read_event(Members& members);
CallFault read_call(Members& members);

}  // namespace hrt::mock
