// Runs gnuplot as a child process.
#pragma once

#include <filesystem>
#include <string>

namespace hrt::study {

/// Runs gnuplot on `script` in `folder`. Throws std::runtime_error, one line, if gnuplot is missing or fails.
void run_gnuplot(const std::string& script, const std::filesystem::path& folder);

}  // namespace hrt::study
