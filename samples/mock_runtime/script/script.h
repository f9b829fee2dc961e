// A script in JSON: settings of the simulation and its faults. SCRIPTS.md has the format.
#pragma once

#include <openxr/openxr.h>

#include <string>
#include <string_view>
#include <vector>

#include "samples/mock_runtime/extensions.h"
#include "samples/mock_runtime/script/event.h"
#include "samples/mock_runtime/world/clock.h"
#include "samples/mock_runtime/world/settings.h"

namespace hrt::mock {

struct Script {
  Clock::Kind clock = Clock::Kind::manual;
  XrDuration frame_period = 11'111'111;  ///< 90 Hz
  bool frame_times = true;               ///< false: xrWaitFrame predicts the display time 0
  bool stage = true;                     ///< the runtime has the STAGE space
  bool hand_tracking = true;             ///< value in XrSystemHandTrackingPropertiesEXT
  std::int64_t pictures = 0;             ///< interval of pictures in frames; 0: only frames that events select
  ExtensionSet withheld;                 ///< extensions that the runtime hides
  WorldSettings world;
  std::vector<ScriptEvent> events;
  std::vector<CallFault> calls;

  bool has_picture_events() const;

  /// True if the script withholds the extension, or if it converts system times under the manual clock.
  bool hides(std::size_t extension) const;
};

/// Checks a script by script.schema.json and more, such as names of functions. Throws an Error that names place,
/// mistake and allowed values.
Script parse_script(std::string_view json);

/// Reads the file that HRT_MOCK_SCRIPT names; returns the default script if the variable is unset. Throws an Error if
/// the file cannot be read.
std::string script_from_environment();

}  // namespace hrt::mock
