#include "samples/reach/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "samples/app/base/exit_code.h"
#include "samples/app/text/whole_file.h"

namespace hrt::reach {

void load_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw Failure(ExitCode::plugin, "--profile: " + file.string() + " cannot be read: " + std::strerror(errno) +
                                        "; check the path and its permissions");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (plugin.hrt_profile_load(session, text.data(), text.size()) != HRT_OK)
    throw Failure(ExitCode::plugin, "--profile: " + file.string() + " is not a profile: " + plugin.hrt_last_error() +
                                        "; give a file that --calibrate wrote");
}

void save_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file) {
  std::uint64_t length = 0;
  plugin.check(plugin.hrt_profile_save(session, 0, nullptr, &length));
  std::string text(length + 1, '\0');
  plugin.check(plugin.hrt_profile_save(session, text.size(), text.data(), &length));
  text.back() = '\n';
  if (const int error = write_whole_file(file, text); error != 0)
    throw Failure(ExitCode::output, file.string() + " cannot be written: " + std::strerror(error) +
                                        "; select another file (--calibrate)");
}

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
  if (status.rows_lost == 0 && status.system_error == 0) return;
  const std::string why =
      status.system_error != 0 ? std::strerror(status.system_error) : "the disk was too slow for the recording";
  throw Failure(ExitCode::output, file.string() + " is incomplete: " + why + "; " + std::to_string(status.rows_lost) +
                                      " rows are lost; record to a faster or larger disk (--record)");
}

}  // namespace hrt::reach
