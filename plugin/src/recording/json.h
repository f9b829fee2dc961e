// Configurations and profiles as JSON, in full precision.
#pragma once

#include <string_view>

#include "haptic_retargeting/profile.h"
#include "haptic_retargeting/session.h"
#include "haptic_retargeting/setup.h"
#include "haptic_retargeting/target.h"
#include "plugin/src/abi/text.h"

namespace hrt::plugin {

using JsonText = Text<6144>;

/// Writes all fields of a configuration in one line.
void write_config(const hrt_session_config& config, JsonText& out);

/// Writes a target in one line.
void write_target(const hrt_target_config& target, JsonText& out);

/// Reads the fields that write_target() writes. Fails on other fields. Values are not checked.
hrt_result read_target(std::string_view text, hrt_target_config* out);

/// Write and read the configuration of a set-up in one line. Reading sets missing fields to their defaults and fails on
/// unknown ones. Values are not checked.
void write_setup_config(const hrt_setup_config& config, JsonText& out);
hrt_result read_setup_config(std::string_view text, hrt_setup_config* out);

/// Reads a configuration in the same way.
hrt_result read_config(std::string_view text, hrt_session_config* out);

/// Writes the fields of a configuration that profiles contain, and the conditions of measurement, in one line.
void write_profile(const hrt_session_config& config, const hrt_conditions& conditions, JsonText& out);

/// Reads a profile into a configuration. Missing fields are unchanged, except that those of the user and of correlated
/// noise are set to their defaults. `*conditions` is zero if the profile has no conditions. Values are not checked.
hrt_result read_profile(std::string_view text, hrt_session_config* config, hrt_conditions* conditions);

}  // namespace hrt::plugin
