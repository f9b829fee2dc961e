// A registered plate in a JSON file, for the next run.
#pragma once

#include <filesystem>

#include "samples/reach/run/registration.h"

namespace hrt::reach {

/// Replaces the file as a whole; the pose is in the present coordinates of its space. Throws Failure
/// (ExitCode::output).
void write_registration(const std::filesystem::path& file, const RegisteredPlate& plate,
                        const XrHeadlessSession& session);

/// Throws Failure (ExitCode::registration) naming the member. The plugin checks the numbers when they are
/// used.
RegisteredPlate read_registration(const std::filesystem::path& file);

}  // namespace hrt::reach
