#include "samples/reach/output/recording_file.h"

#include <string>
#include <utility>

#include "samples/reach/base/exit_code.h"

namespace hrt::reach {

RecordingFile::RecordingFile(const Plugin& plugin, hrt_session session, std::filesystem::path file)
    : plugin_(plugin), session_(session), file_(std::move(file)) {
  if (!file_.empty() && plugin.hrt_recording_start(session, file_.c_str()) != HRT_OK)
    throw Failure(ExitCode::output, plugin.hrt_last_error());
}

void RecordingFile::finish() {
  const std::filesystem::path file = std::exchange(file_, {});
  if (file.empty()) return;
  hrt_recording_status status{.struct_size = sizeof status};
  plugin_.check(plugin_.hrt_recording_stop(session_, &status));
  if (status.rows_lost > 0 || status.system_error != 0)
    throw Failure(ExitCode::output, file.string() + " is not complete: " + std::to_string(status.rows_lost) +
                                        " rows could not be written");
}

}  // namespace hrt::reach
