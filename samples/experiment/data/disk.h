// Files that are never replaced, and every step at which a crash can come.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace hrt::experiment {

/// Called before and after each write, sync, link and change of state, with its name. Tests end the process
/// here.
using Step = std::function<void(const char*)>;

/// The disk as a session uses it. Failures are Refusals that name the file and the system's reason.
class Disk {
 public:
  /// `syncs`: false where only the process can end, not the system.
  explicit Disk(Step step = {}, bool syncs = true) : step_(std::move(step)), syncs_(syncs) {}

  /// A new file with this content, whole and synced or not there at all. Returns false if there is one
  /// already, which stays.
  bool create(const std::filesystem::path& file, std::string_view content) const;
  /// Appends to an open file and syncs it.
  void append(int file, const std::filesystem::path& name, std::string_view content) const;
  /// Flushes to the disk what another writer has written.
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

/// The whole file. Throws Refusal.
std::string content_of(const std::filesystem::path& file);

/// SHA-256 (FIPS 180-4), in hexadecimal.
std::string sha256_of(std::string_view text);

}  // namespace hrt::experiment
