// A script in JSON: the simulation and its faults. README.md has the format.
#pragma once

#include <openxr/openxr.h>

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "samples/mock_runtime/calls/faults.h"
#include "samples/mock_runtime/extensions.h"
#include "samples/mock_runtime/playback/recording.h"
#include "samples/mock_runtime/world/clock.h"
#include "samples/mock_runtime/world/pose.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

enum class HandFault { lose_tracking, regain_tracking, freeze, unfreeze, jump };
struct HandEvent {
  HandFault fault;
  XrHandEXT hand = XR_HAND_LEFT_EXT;
  Eigen::Vector3d jump_m = Eigen::Vector3d::Zero();  ///< along the axes of LOCAL space
};
/// The headset loses track of the room, or finds it again.
struct HeadEvent {
  bool lost = false;
};
struct StateEvent {
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
};
/// The user recentres.
struct Recenter {
  XrReferenceSpaceType space = XR_REFERENCE_SPACE_TYPE_LOCAL;  ///< or STAGE
  XrDuration delay_ns = 0;                                     ///< from the event to the change
  Pose pose;                                                   ///< of the new origin in the old space
  bool pose_valid = true;                                      ///< the application is given the pose
};
/// A device is put on, changed or, without a profile, put away.
struct DeviceEvent {
  std::string device;   ///< "/user/hand/left"
  std::string profile;  ///< interaction profile path; empty: off
};
/// A button, trigger or stick of a device moves.
struct InputEvent {
  std::string device;
  std::vector<std::pair<std::string, float>> values;  ///< of sources: "/user/hand/left/input/trigger/value"
};
/// The user puts the headset on or takes it off.
struct PresenceEvent {
  bool present = true;
};
struct RepeatState {};
struct LoseSession {};
struct LoseInstance {};
struct InstanceLossPending {};

/// An event in a session.
struct ScriptEvent {
  Scope scope;
  std::int64_t frame;    ///< at the xrWaitFrame of this number, from 1; 0: at time_ns
  std::int64_t time_ns;  ///< after the session was created
  std::variant<HandEvent, HeadEvent, StateEvent, Recenter, DeviceEvent, InputEvent, PresenceEvent,
               RepeatState, LoseSession, LoseInstance, InstanceLossPending>
      what;
};

struct Script {
  Clock::Kind clock = Clock::Kind::manual;
  XrDuration frame_period = 11'111'111;  ///< 90 Hz
  bool frame_times = true;               ///< false: xrWaitFrame predicts the display time 0
  /// The first frame since xrBeginSession with which the session gains focus; 0: with xrBeginSession.
  std::int64_t focus_frame = 0;
  bool stage = true;          ///< the runtime has the STAGE space
  bool hand_tracking = true;  ///< of the system: XrSystemHandTrackingPropertiesEXT
  ExtensionSet withheld;      ///< extensions that the runtime hides
  WorldSettings world;
  std::vector<ScriptEvent> events;
  std::vector<CallFault> calls;
  std::shared_ptr<const Recording> playback;  ///< in place of the simulation; may be null

  /// By Extension: withheld, not enabled in what is played back, or without a meaning: under the manual clock
  /// no time of the machine is an XrTime.
  bool hides(std::size_t extension) const;
};

/// Throws an Error that names place, mistake and allowed values.
Script parse_script(std::string_view json);

/// The text of the file that HRT_MOCK_SCRIPT names; that of the default script if unset. Throws an Error if
/// it cannot be read.
std::string script_from_environment();

}  // namespace hrt::mock
