// Runs the real hrt-study as a child process, as a person or a script would.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "samples/study/output.h"

namespace hrt::study {

struct StudyRun {
  int exit_code;  ///< minus the signal's number if one ended it
  std::string out;
  std::string err;
};

/// Runs `hrt-study arguments...` with standard output and error in files. A non-empty `search_path` replaces
/// PATH.
StudyRun run_study(const std::vector<std::string>& arguments, const std::string& search_path = {});

/// Starts it with its output thrown away; the caller waits for the returned process.
pid_t start_study(const std::vector<std::string>& arguments);

/// Names of all entries of a folder, hidden ones too, in order.
std::vector<std::string> entries(const std::filesystem::path& folder);

std::vector<std::string> lines(const std::string& text);

/// The fields of a line of CSV without quotes.
std::vector<std::string> fields(const std::string& line);

/// An empty folder that is removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path / name).string(); }

  std::filesystem::path path;
};

}  // namespace hrt::study
