// Events of a script in a session.
#pragma once

#include <openxr/openxr.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "samples/app/text/json_file.h"
#include "samples/mock_runtime/calls/faults.h"
#include "samples/mock_runtime/world/pose.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

enum class HandFault { lost, frozen, unturned, jump };
struct HandEvent {
  HandFault fault;
  bool begins = true;  ///< false: the fault ends
  XrHandEXT hand = XR_HAND_LEFT_EXT;
  Eigen::Vector3d jump_m = Eigen::Vector3d::Zero();  ///< along the axes of LOCAL space
};
/// The headset loses or regains tracking of the room.
struct HeadEvent {
  bool lost = false;
};
struct StateEvent {
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
};
/// The user recentres the view.
struct Recenter {
  XrReferenceSpaceType space = XR_REFERENCE_SPACE_TYPE_LOCAL;  ///< LOCAL or STAGE
  XrDuration delay_ns = 0;                                     ///< time from the event to the change
  Pose pose;                                                   ///< pose of the new origin in the old space
  bool pose_valid = true;                                      ///< the application receives the pose
};
/// Sets the predicted display time of the frame of that xrWaitFrame; 0 is an invalid time.
struct FrameTime {
  XrTime time = 0;
};
/// Takes a picture of the next frame that the application ends.
struct TakePicture {};
struct RepeatState {};
struct LoseSession {};
struct LoseInstance {};
struct InstanceLossPending {};

using Happening = std::variant<HandEvent, HeadEvent, StateEvent, Recenter, FrameTime, TakePicture, RepeatState,
                               LoseSession, LoseInstance, InstanceLossPending>;

/// An event in a session.
struct ScriptEvent {
  std::uint64_t session;  ///< number of its session, from 1; 0: every session
  std::int64_t frame;     ///< number of its xrWaitFrame, from 1; 0: at time_ns
  std::int64_t time_ns;   ///< time since the session was created
  Happening what;
};

// Readers of values that script.schema.json allows. `where` is the place of a value, for rules beyond the schema.
inline std::int64_t nanoseconds(const Json& ms) { return std::llround(ms.get<double>() * 1e6); }
Eigen::Vector3d read_vector(const Json& xyz);
PersonSettings read_person(const Json& object, const std::string& where);
TrackerSettings read_tracker(const Json& tracker);
PlateDynamics read_servo(const Json& servo);
PlateSettings read_plate(const Json& plate);
/// `tracked`: default for a hand without a path, slides or a member "tracked".
HandSettings read_hand(const Json& object, const std::string& where, bool tracked);
std::vector<Keyframe> read_path(const Json& path, const std::string& where, const Eigen::Quaterniond& orientation);
ScriptEvent read_event(const Json& object, const std::string& where);
CallFault read_call(const Json& object, const std::string& where);

}  // namespace hrt::mock
