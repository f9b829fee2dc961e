// A script in JSON, which sets the simulation and its faults. SCRIPTS.md describes the format.
#pragma once

#include <openxr/openxr.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "samples/app/text/json_file.h"
#include "samples/mock_runtime/calls/calls.h"
#include "samples/mock_runtime/functions.h"
#include "samples/mock_runtime/world/clock.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

class Session;

struct ScriptEvent {
  std::uint64_t session;  ///< number of the session, from 1; 0: every session
  std::int64_t frame;     ///< number of the frame, from 1; 0: the event occurs at time_ns
  std::int64_t time_ns;   ///< time since the session was created
  std::function<void(Session&)> execute;
};

struct Script {
  Clock::Kind clock = Clock::Kind::manual;
  XrDuration frame_period = 11'111'111;  ///< in ns; the default is that of 90 Hz
  bool frame_times = true;               ///< false: xrWaitFrame predicts the display time 0
  bool stage = true;                     ///< false: the runtime has no STAGE space
  bool hand_tracking = true;             ///< value in XrSystemHandTrackingPropertiesEXT
  std::int64_t picture_interval = 0;     ///< interval between pictures in frames; 0: not set
  bool has_picture_events = false;
  ExtensionSet withheld;
  WorldSettings world;
  std::vector<ScriptEvent> events;
  std::vector<CallFault> calls;

  /// True if the runtime does not offer an extension: the script withholds it, or it is XR_KHR_convert_timespec_time
  /// and the clock is manual, so that no system time corresponds to an XrTime.
  bool hides(std::size_t extension) const;
};

/// Parses and checks a script. Throws an Error that names the key, the mistake and the allowed values.
Script parse_script(std::string_view json);

/// Returns the content of the file that the environment variable HRT_MOCK_SCRIPT names; "{}", the default script, if
/// the variable is unset. Throws an Error if the file cannot be read.
std::string script_from_environment();

// Functions that read parts of a script which script.schema.json allows. Those with `where`, the path of the value
// (such as "script.events[0]"), throw Refusal if the value breaks a rule that the schema does not express.
std::int64_t nanoseconds(const Json& ms);
Eigen::Vector3d read_vector(const Json& xyz);
ScriptEvent read_event(const Json& object, const std::string& where);
CallFault read_call(const Json& object, const std::string& where);

}  // namespace hrt::mock
