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

/// Every field of a configuration, in one line.
void write_config(const hrt_session_config& config, JsonText& out);

/// A target, in one line.
void write_target(const hrt_target_config& target, JsonText& out);

/// Reads what write_target() wrote, and no other field. Checked except for what depends on other targets or
/// on the session.
hrt_result read_target(std::string_view text, hrt_target_config* out);

/// A set-up's configuration, in one line; and reads it, and no other field; those that are missing take their
/// defaults. Checked.
void write_setup_config(const hrt_setup_config& config, JsonText& out);
hrt_result read_setup_config(std::string_view text, hrt_setup_config* out);

/// Reads what write_config() wrote, likewise.
hrt_result read_config(std::string_view text, hrt_session_config* out);

/// What is known of a participant, and under which conditions they were measured, in one line.
void write_profile(const hrt_session_config& config, const hrt_conditions& conditions, JsonText& out);

/// Takes a profile into a configuration; fields that it lacks stay. `*conditions` are the profile's; all 0
/// and empty if it names none. Checked.
hrt_result read_profile(std::string_view text, hrt_session_config* config, hrt_conditions* conditions);

}  // namespace hrt::plugin
