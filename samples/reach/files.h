// A user's profile in a file, and the plugin's recording of a run.
#pragma once

#include <filesystem>

#include "samples/app/base/plugin.h"

namespace hrt::reach {

using namespace app;

/// The plugin's session starts from the profile. Throws Failure (ExitCode::plugin).
void load_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file);

/// Replaces the file as a whole. Throws Failure (ExitCode::output).
void save_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file);

/// Opens the file at once, so that a wrong name is known before the first reach. All throw Failure
/// (ExitCode::output).
class RecordingFile {
 public:
  /// An empty name: no recording.
  RecordingFile(const Plugin& plugin, hrt_session session, std::filesystem::path file);

  /// Closes it. For the second time it does nothing.
  void finish();

 private:
  const Plugin& plugin_;
  hrt_session session_;
  std::filesystem::path file_;
};

}  // namespace hrt::reach
