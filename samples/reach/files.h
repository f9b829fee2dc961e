// A user's profile in a file, and the plugin's recording of a run.
#pragma once

#include <filesystem>

#include "samples/app/base/plugin.h"

namespace hrt::reach {

using namespace app;

/// Loads the profile into the plugin's session. Throws Failure (ExitCode::plugin) if the file cannot be read or is not
/// a profile.
void load_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file);

/// Writes the session's profile and replaces the file atomically. Throws Failure (ExitCode::output).
void save_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file);

/// The plugin's recording of a session. Functions throw Failure (ExitCode::output).
class RecordingFile {
 public:
  /// Opens the file and starts the recording. `file`: empty for no recording.
  RecordingFile(const Plugin& plugin, hrt_session session, std::filesystem::path file);

  /// Closes the file, and throws if it is incomplete. A second call has no effect.
  void finish();

 private:
  const Plugin& plugin_;
  hrt_session session_;
  std::filesystem::path file_;
};

}  // namespace hrt::reach
