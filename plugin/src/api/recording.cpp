#include <string>
#include <string_view>

#include "haptic_retargeting/recording.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/file.h"
#include "plugin/src/api/replay.h"
#include "plugin/src/api/sessions.h"
#include "plugin/src/recording/format.h"

namespace hrt::plugin {
namespace {

constexpr std::size_t max_file = std::size_t{1} << 30;
constexpr std::size_t block_size = 65536;

hrt_recording_status to_abi(const RecorderStatus& status) {
  return {
      .struct_size = sizeof(hrt_recording_status),
      .system_error = status.system_error,
      .rows_written = status.written,
      .rows_lost = status.lost,
  };
}

// Reads a file, of at most max_file bytes. If it does not begin like a recording, only its beginning is read.
hrt_result read_file(const char* path, std::string* out) {
  File file;
  HRT_RETURN_IF_FAILED(File::open(path, max_file, &file));
  for (std::size_t size = 0; size <= max_file;) {
    out->resize(size + block_size);
    const std::ptrdiff_t n = file.read({out->data() + size, block_size});
    if (n < 0) return fail_of_file(path);
    out->resize(size += static_cast<std::size_t>(n));
    if (n == 0 || (size >= recording_begin.size() && !out->starts_with(recording_begin))) return HRT_OK;
  }
  return fail(HRT_ERROR_SYSTEM, Shown{path}, ": the file is too large; allowed: up to ", max_file,
              " bytes");  // the file grew while it was read
}

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_recording_start(hrt_session session, const char* path) noexcept {
  return with_session("hrt_recording_start", session, [&](RecordedSession& s) -> hrt_result {
    if (!path) return fail_of_null("path");
    return s.start_recording(path, session.value);
  });
}

hrt_result hrt_recording_get_status(hrt_session session, hrt_recording_status* out_status) noexcept {
  return with_session("hrt_recording_get_status", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.check_recording());
    HRT_RETURN_IF_FAILED(check_output("out_status", out_status));
    write_struct(to_abi(s.recording_status()), out_status);
    return HRT_OK;
  });
}

hrt_result hrt_recording_flush(hrt_session session, hrt_recording_status* out_status) noexcept {
  return with_session("hrt_recording_flush", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.check_recording());
    HRT_RETURN_IF_FAILED(check_output("out_status", out_status));
    write_struct(to_abi(s.flush_recording()), out_status);
    return HRT_OK;
  });
}

hrt_result hrt_recording_stop(hrt_session session, hrt_recording_status* out_status) noexcept {
  return with_session("hrt_recording_stop", session, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.check_recording());
    HRT_RETURN_IF_FAILED(check_output("out_status", out_status));
    write_struct(to_abi(s.stop_recording()), out_status);
    return HRT_OK;
  });
}

hrt_result hrt_recording_replay(const char* path, const char* text, uint64_t length,
                                hrt_replay_report* out_report) noexcept {
  return guarded("hrt_recording_replay", [&]() -> hrt_result {
    if (!path && !text) return fail(HRT_ERROR_NULL_ARGUMENT, "path is null, and so is text");
    HRT_RETURN_IF_FAILED(check_output("out_report", out_report));
    hrt_replay_report report{};
    std::string read;
    if (!text) HRT_RETURN_IF_FAILED(read_file(path, &read));
    HRT_RETURN_IF_FAILED(replay(text ? std::string_view(text, static_cast<std::size_t>(length)) : read, &report));
    write_struct(report, out_report);
    return HRT_OK;
  });
}
