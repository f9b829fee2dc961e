// Runs the real hrt-study as a child process.
#pragma once

#include "samples/study/cli/output.h"
#include "tests/samples/process.h"

namespace hrt::study {

using StudyRun = Outcome;

/// Starts hrt-study. `modules`: PYTHONPATH, a folder whose modules replace python3's; `err`: descriptor for the
/// program's error output.
Process start_study(const std::vector<std::string>& arguments, const std::string& modules = {}, int err = -1);

StudyRun run_study(const std::vector<std::string>& arguments, const std::string& modules = {});

/// Returns the sorted names of all entries of a folder, including hidden entries.
std::vector<std::string> entries(const std::filesystem::path& folder);

std::vector<std::string> lines(const std::string& text);

/// Returns the fields of a line of CSV that has no quotes.
std::vector<std::string> fields(const std::string& line);

}  // namespace hrt::study
