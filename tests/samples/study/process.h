// Runs the real hrt-study as a child process.
#pragma once

#include "samples/study/cli/output.h"
#include "tests/samples/process.h"

namespace hrt::study {

using StudyRun = Outcome;

/// `modules`: PYTHONPATH, a folder whose modules replace python3's; `err` is a descriptor for its error output.
Process start_study(const std::vector<std::string>& arguments, const std::string& modules = {}, int err = -1);

/// Runs `hrt-study arguments...`.
StudyRun run_study(const std::vector<std::string>& arguments, const std::string& modules = {});

/// Names of all entries of a folder, hidden ones too, in order.
std::vector<std::string> entries(const std::filesystem::path& folder);

std::vector<std::string> lines(const std::string& text);

/// The fields of a line of CSV without quotes.
std::vector<std::string> fields(const std::string& line);

}  // namespace hrt::study
