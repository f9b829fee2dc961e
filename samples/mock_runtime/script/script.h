// A script in JSON: the simulation and its faults. README.md has the format.
#pragma once

#include <openxr/openxr.h>

#include <string_view>
#include <variant>
#include <vector>

#include "samples/mock_runtime/extensions.h"
#include "samples/mock_runtime/script/faults.h"
#include "samples/mock_runtime/world/clock.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

enum class HandFault { lose_tracking, regain_tracking, freeze, unfreeze, jump };
struct HandEvent {
  HandFault fault;
  XrHandEXT hand = XR_HAND_LEFT_EXT;
  Eigen::Vector3d jump_m = Eigen::Vector3d::Zero();  ///< along the axes of LOCAL space
};
struct StateEvent {
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
};
struct RepeatState {};
struct LoseSession {};
struct LoseInstance {};
struct InstanceLossPending {};

/// An event in a session.
struct ScriptEvent {
  std::int64_t frame;    ///< at the xrWaitFrame of this number, from 1; 0: at time_ns
  std::int64_t time_ns;  ///< after the session was created
  std::variant<HandEvent, StateEvent, RepeatState, LoseSession, LoseInstance, InstanceLossPending> what;
};

struct Script {
  Clock::Kind clock = Clock::Kind::manual;
  XrDuration frame_period = 11'111'111;  ///< 90 Hz
  bool frame_times = true;               ///< false: xrWaitFrame predicts the display time 0
  bool hand_tracking = true;             ///< of the system: XrSystemHandTrackingPropertiesEXT
  ExtensionSet withheld;                 ///< extensions that the runtime hides
  WorldSettings world;
  std::vector<ScriptEvent> events;
  std::vector<CallFault> calls;
};

/// Throws an Error that names place, mistake and allowed values.
Script parse_script(std::string_view json);

/// The script in the file that HRT_MOCK_SCRIPT names; the default script if unset. Throws as parse_script().
Script script_from_environment();

}  // namespace hrt::mock
