// Files that are never overwritten, with a function that is called at each step where a crash can occur.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace hrt::experiment {

/// Called with the name of a step, such as a write or a sync. Tests simulate a crash in it; XrSubject reads keys in it.
using Step = std::function<void(const char*)>;

/// File operations of a session. On failure they throw Refusal with the file and the system's reason.
class Disk {
 public:
  /// `syncs`: if false, omits fdatasync() and fsync(), for tests that end the process but not the computer.
  explicit Disk(Step step = {}, bool syncs = true) : step_(std::move(step)), syncs_(syncs) {}

  /// Creates a file with this content atomically, and syncs it. Returns false, without a change, if the file exists.
  bool create(const std::filesystem::path& file, std::string_view content) const;
  /// Appends to an open file, without a sync.
  void append(int file, const std::filesystem::path& name, std::string_view content) const;
  void sync(int file, const std::filesystem::path& name) const;
  /// Syncs a file that was not written by this class, such as a recording of the plugin.
  void sync(const std::filesystem::path& file) const;
  void make_folder(const std::filesystem::path& folder) const;

  void step(const char* name) const {
    if (step_) step_(name);
  }

 private:
  void check(bool done, const std::string& what, const std::filesystem::path& file) const;

  int sync(int file) const;

  Step step_;
  bool syncs_;
};

std::string content_of(const std::filesystem::path& file);

/// Returns the SHA-256 (FIPS 180-4) of the text, in hexadecimal.
std::string sha256_of(std::string_view text);

}  // namespace hrt::experiment
