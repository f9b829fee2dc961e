// A user's profile in a file.
#pragma once

#include <filesystem>

#include "samples/reach/base/plugin.h"

namespace hrt::reach {

/// The plugin's session starts from the profile. Throws Failure (ExitCode::plugin).
void load_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file);

/// Replaces the file as a whole. Throws Failure (ExitCode::output).
void save_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file);

}  // namespace hrt::reach
