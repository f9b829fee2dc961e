// Runs programs as people and scripts do, with their output in files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/samples/text.h"

namespace hrt {

struct Outcome {
  int exit_code = 0;  ///< minus the signal's number if a signal ended the program
  std::string out;
  std::string err;
};

/// Expects this exit code, and returns the outcome. A failure shows the caller's line and the output.
Outcome expect_exit(int exit_code, Outcome outcome, const char* file = __builtin_FILE(), int line = __builtin_LINE());

/// Creates an empty folder; the destructor removes the folder and its content.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path / name).string(); }

  std::filesystem::path path;
};

/// A child process. The caller must call wait().
class Process {
 public:
  /// Starts the program with the path words[0]; `environment` has strings "NAME=value". `err`: descriptor for the error
  /// output; negative: a file that err() reads. `in`: descriptor of the input; negative: no input.
  Process(std::vector<std::string> words, std::vector<std::string> environment, int err = -1, int in = -1);

  void send_signal(int signal) const;
  // Output and error output so far.
  std::string out() const;
  std::string err() const;

  /// Waits for the end of the process, and kills it after two minutes.
  Outcome wait() const;

 private:
  TemporaryFolder folder_;
  int child_ = 0;
};

/// Returns the content of a file; empty if the file cannot be read.
std::string read_file(const std::string& file);

/// Returns the findings in a report file of Khronos' core validation layer, without lines of the level VALID_DEBUG.
std::string validation_findings(const std::string& file);

}  // namespace hrt
