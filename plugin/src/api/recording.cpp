#include "haptic_retargeting/recording.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/file.h"
#include "plugin/src/abi/hash.h"
#include "plugin/src/api/read.h"
#include "plugin/src/api/recorded_session.h"
#include "plugin/src/recording/format.h"

namespace hrt::plugin {
namespace {

constexpr std::size_t max_file = std::size_t{1} << 30;
constexpr std::size_t block_size = 65536;

hrt_result with_recording(const char* call, hrt_session session, hrt_recording_status* out_status,
                          hrt_recording_status (RecordedSession::*get)()) noexcept {
  return sessions.with(call, session.value, [&](RecordedSession& s) -> hrt_result {
    HRT_RETURN_IF_FAILED(s.check_recording());
    HRT_RETURN_IF_FAILED(check_output("out_status", out_status));
    write_struct((s.*get)(), out_status);
    return HRT_OK;
  });
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
              " bytes. It grew while it was read; stop its recording first");
}

bool starts_with_and_drops(std::string_view& line, std::string_view prefix) {
  if (!line.starts_with(prefix)) return false;
  line.remove_prefix(prefix.size());
  return true;
}

// Repeats the calls of a recording, and compares the rows that the repeated calls would write with the recorded ones.
class Replay {
 public:
  hrt_result run(std::string_view text, hrt_replay_report* out) {
    std::string with_line_feeds;
    if (text.substr(0, text.find('\n')).ends_with('\r')) {  // editors on Windows write CR LF
      with_line_feeds = text;
      std::erase(with_line_feeds, '\r');
      text = with_line_feeds;
    }
    HRT_RETURN_IF_FAILED(take_header(&text));
    while (!text.empty() && report_.ending != HRT_ENDING_LOST_ROWS) {
      ++line_number_;
      const std::size_t end = text.find('\n');
      if (end == std::string_view::npos) break;  // cut off within a line
      if (const hrt_result result = take(text.substr(0, end)); result != HRT_OK) return at_line(result);
      checksum_.add(text.substr(0, end + 1));
      text.remove_prefix(end + 1);
    }
    report_.hash = hash_.value();
    report_.complete = report_.ending == HRT_ENDING_COMPLETE ? 1 : 0;
    *out = report_;
    return HRT_OK;
  }

 private:
  hrt_result take_header(std::string_view* text) {
    if (!starts_with_and_drops(*text, recording_begin)) return refuse_header(*text);
    ++line_number_;
    checksum_.add(recording_begin);
    return HRT_OK;
  }

  static hrt_result refuse_header(std::string_view text) {
    std::uint64_t version = 0;
    if (starts_with_and_drops(text, "# haptic retargeting recording, version ") &&
        read_number(text.substr(0, text.find('\n')), &version) && version != 4)
      return fail(HRT_ERROR_BAD_FORMAT, "version ", version,
                  " of the recording is not supported; allowed: version 4. Record again");
    return fail(HRT_ERROR_BAD_FORMAT,
                "the file or text does not begin like a recording of version 4; pass a recording");
  }

  hrt_result take(std::string_view line) {
    if (ended_) return fail(HRT_ERROR_BAD_FORMAT, "this line follows the line \"# end\"; remove this line");
    if (starts_with_and_drops(line, config_comment)) return take_config(line);
    if (starts_with_and_drops(line, target_comment)) return take_target(line);
    if (starts_with_and_drops(line, plate_comment)) return take_plate(line);
    if (starts_with_and_drops(line, setup_comment)) return take_setup(line);
    if (starts_with_and_drops(line, end_comment)) {
      take_end(line);
    } else if (line.starts_with(lost_comment)) {
      report_.ending = HRT_ENDING_LOST_ROWS;
    } else if (!line.starts_with("#")) {
      return take_row(line);
    }
    return HRT_OK;
  }

  void take_end(std::string_view rest) {
    std::uint64_t checksum = 0;
    const bool is_same = read_number(rest, &checksum) && checksum == checksum_.value();
    report_.ending = is_same ? HRT_ENDING_COMPLETE : HRT_ENDING_ALTERED;
    ended_ = true;
  }

  hrt_result take_config(std::string_view json) {
    hrt_session_config config{};
    SessionModel model;
    HRT_RETURN_IF_FAILED(read_json(json, &config));
    HRT_RETURN_IF_FAILED(read(config, &model));
    if (session_) return session_->set_model(model);
    session_.emplace(model);
    return HRT_OK;
  }

  hrt_result check_session() const {
    if (session_) return HRT_OK;
    return fail(HRT_ERROR_BAD_FORMAT,
                "the line \"# config\" is missing before this line: the file was edited; record again");
  }

  hrt_result take_target(std::string_view rest) {
    HRT_RETURN_IF_FAILED(check_session());
    TargetChanged changed;
    Target target;
    HRT_RETURN_IF_FAILED(read_target_changed(rest, &changed));
    changed.config.served_by = this->target(changed.config.served_by.value);
    if (changed.change != TargetChanged::Change::removed) HRT_RETURN_IF_FAILED(read(changed.config, &target));
    std::uint64_t& id = target_ids_[changed.number];
    if ((changed.change == TargetChanged::Change::added) != (id == 0))
      return fail(HRT_ERROR_BAD_FORMAT, "target ", changed.number, id == 0 ? " does not exist" : " exists already",
                  ": the file was edited; record again");
    switch (changed.change) {
      case TargetChanged::Change::added:
        return session_->add_target(target, &id);
      case TargetChanged::Change::set:
        return session_->set_target(id, target);
      case TargetChanged::Change::removed:
        return session_->remove_target(std::exchange(id, 0));
    }
    return HRT_OK;
  }

  hrt_result take_plate(std::string_view rest) {
    HRT_RETURN_IF_FAILED(check_session());
    InitialPlateOrientation plate{};
    HRT_RETURN_IF_FAILED(read_initial_plate_orientation(rest, &plate));
    return session_->set_plate_orientation_deg(plate.orientation_deg);
  }

  hrt_result take_setup(std::string_view rest) {
    HRT_RETURN_IF_FAILED(check_session());
    SetupBegun begun{};
    HRT_RETURN_IF_FAILED(read_setup_begun(rest, &begun));
    return session_->begin_setup(begun.what, begun.config);
  }

  hrt_result take_row(std::string_view line) {
    if (!std::exchange(has_columns_, true)) return check_column_names(line);
    HRT_RETURN_IF_FAILED(check_session());
    Record record;
    HRT_RETURN_IF_FAILED(read_row(line, &record));
    std::visit([&](auto& call) { call_again(call, &record.result); }, record.call);
    ++report_.rows;
    RecordText again;
    write_record(record, again);
    const std::string_view row = again.view().substr(0, again.view().size() - 1);
    if (report_.first_different_line == 0 && !is_same_row(line, row)) report_.first_different_line = line_number_;
    return HRT_OK;
  }

  // The overloads of call_again() repeat a call, and replace the recorded result by the new one.
  void call_again(ReachBegun& call, hrt_result* result) {
    const hrt_reach_config config{.struct_size = sizeof config,
                                  .flags = call.flags,
                                  .real_target = target(call.real_number),
                                  .virtual_target = target(call.virtual_number),
                                  .plate_orientation_deg = call.plate_orientation_deg,
                                  .duration_s = call.duration_s};
    *result = session_->begin(&config);
    call.reach = session_->reach_geometry();
  }
  void call_again(Updated& call, hrt_result* result) {
    const bool awaited_finger = session_->session().awaits_finger();
    call.command.struct_size = sizeof call.command;
    *result = session_->update(&call.sample, &call.command);
    if (awaited_finger && !session_->session().awaits_finger()) call.reach = session_->reach_geometry();
    if (*result == HRT_OK) add(call.command, hash_);
  }
  void call_again(Retargeted& call, hrt_result* result) {
    *result = session_->retarget(target(call.real_number), target(call.virtual_number));
    call.reach = session_->reach_geometry();
  }
  void call_again(Touched& call, hrt_result* result) { *result = session_->touched(&call.contact); }
  void call_again(ReachCancelled&, hrt_result* result) { *result = session_->cancel(); }
  void call_again(ReachEnded& call, hrt_result* result) {
    call.summary.struct_size = sizeof call.summary;
    *result = session_->end(&call.summary);
  }
  void call_again(SetupUpdated& call, hrt_result* result) { *result = session_->update_setup(call.sample, &call.step); }
  void call_again(SetupFinished& call, hrt_result* result) { *result = session_->finish_setup(&call.result); }
  void call_again(SetupCancelled&, hrt_result* result) { *result = session_->cancel_setup(); }
  // The next four overloads are not called: read_row() returns no records of comments.
  static void call_again(const ConfigSet&, hrt_result*) {}
  static void call_again(const TargetChanged&, hrt_result*) {}
  static void call_again(const InitialPlateOrientation&, hrt_result*) {}
  static void call_again(const SetupBegun&, hrt_result*) {}

  hrt_target target(std::uint64_t number) const {
    const auto found = target_ids_.find(number);
    return {found == target_ids_.end() ? 0 : found->second};
  }

  hrt_result at_line(hrt_result result) const {
    return fail(result == HRT_ERROR_OUT_OF_MEMORY ? result : HRT_ERROR_BAD_FORMAT, "line ", line_number_, ": ",
                last_failure().view());
  }

  bool has_columns_ = false;
  std::optional<RecordedSession> session_;
  std::map<std::uint64_t, std::uint64_t> target_ids_;  // key: number in the recording; value: id, or 0 if removed
  Hash hash_;
  hrt_replay_report report_{.struct_size = sizeof(hrt_replay_report),
                            .complete = 0,
                            .rows = 0,
                            .first_different_line = 0,
                            .hash = 0,
                            .ending = HRT_ENDING_CUT,
                            .reserved = 0};
  Hash checksum_;  // checksum of the preceding lines
  std::uint64_t line_number_ = 0;
  bool ended_ = false;
};

}  // namespace
}  // namespace hrt::plugin

using namespace hrt::plugin;

hrt_result hrt_recording_start(hrt_session session, const char* path) noexcept {
  return sessions.with("hrt_recording_start", session.value, [&](RecordedSession& s) -> hrt_result {
    if (!path) return fail_of_null("path");
    return s.start_recording(path, session.value);
  });
}

hrt_result hrt_recording_get_status(hrt_session session, hrt_recording_status* out_status) noexcept {
  return with_recording("hrt_recording_get_status", session, out_status, &RecordedSession::recording_status);
}

hrt_result hrt_recording_flush(hrt_session session, hrt_recording_status* out_status) noexcept {
  return with_recording("hrt_recording_flush", session, out_status, &RecordedSession::flush_recording);
}

hrt_result hrt_recording_stop(hrt_session session, hrt_recording_status* out_status) noexcept {
  return with_recording("hrt_recording_stop", session, out_status, &RecordedSession::stop_recording);
}

hrt_result hrt_recording_replay(const char* path, const char* text, uint64_t length,
                                hrt_replay_report* out_report) noexcept {
  return guarded("hrt_recording_replay", [&]() -> hrt_result {
    if (!path && !text) return fail(HRT_ERROR_NULL_ARGUMENT, "path and text are null; pass one of them");
    HRT_RETURN_IF_FAILED(check_output("out_report", out_report));
    hrt_replay_report report{};
    std::string read;
    if (!text) HRT_RETURN_IF_FAILED(read_file(path, &read));
    const ThreadError before = thread_error;  // recorded calls that failed also fail in the replay, and set the error
    HRT_RETURN_IF_FAILED(Replay().run(text ? std::string_view(text, static_cast<std::size_t>(length)) : read, &report));
    thread_error = before;
    write_struct(report, out_report);
    return HRT_OK;
  });
}
