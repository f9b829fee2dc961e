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

/// Expects that a run has ended with this code and returns its outcome. A failure shows the caller's line and the
/// output.
Outcome expect_exit(int exit_code, Outcome outcome, const char* file = __builtin_FILE(), int line = __builtin_LINE());

/// An empty folder, removed by the destructor.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path / name).string(); }

  std::filesystem::path path;
};

/// A child process. The caller must wait for its end.
class Process {
 public:
  /// Starts the program words[0] with `environment`, "NAME=value" each. `err`: descriptor for its error output;
  /// negative: a file that err() reads. `in`: descriptor of its input; negative: no input.
  Process(std::vector<std::string> words, std::vector<std::string> environment, int err = -1, int in = -1);

  void send_signal(int signal) const;
  /// Output of the process so far.
  std::string out() const;
  std::string err() const;

  /// Waits for the end of the process. Kills it after two minutes.
  Outcome wait() const;

 private:
  TemporaryFolder folder_;
  int child_ = 0;
};

/// Content of a file; empty if the file does not exist.
std::string read_file(const std::string& file);

/// Reports of Khronos' core validation layer, without the messages of newer versions about their start and end.
std::string validation_findings(const std::string& file);

}  // namespace hrt
