// Configurations and profiles as JSON, in full precision.
#pragma once

#include <string_view>

#include "haptic_retargeting/profile.h"
#include "haptic_retargeting/session.h"
#include "haptic_retargeting/setup.h"
#include "haptic_retargeting/target.h"
#include "plugin/src/abi/text.h"

namespace hrt::plugin {

using JsonText = Text<8192>;

/// Write and read all fields of a configuration, a target or the configuration of a set-up in one line. Reading sets
/// missing fields to their defaults (those of a target to 0), and fails on unknown fields. Ranges are not checked.
template <class Struct>
void write_json(const Struct& values, JsonText& out);
template <class Struct>
hrt_result read_json(std::string_view text, Struct* out);

/// Writes the fields of a configuration that profiles contain, and the conditions of measurement, in one line.
void write_profile(const hrt_session_config& config, const hrt_conditions& conditions, JsonText& out);

/// Reads a profile into a configuration. Missing fields are unchanged, except that those with Field::optional are set
/// to their defaults. `*conditions` is zero if the profile has no conditions. Ranges are not checked.
hrt_result read_profile(std::string_view text, hrt_session_config* config, hrt_conditions* conditions);

}  // namespace hrt::plugin
