#include "plugin/src/replay.h"

#include <bit>
#include <optional>

#include "plugin/src/checked.h"
#include "plugin/src/recording_format.h"
#include "plugin/src/session.h"

namespace hrt::plugin {
namespace {

/// FNV-1a, 64 bits.
class Hash {
 public:
  void add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) {
      hash_ = (hash_ ^ (value >> (8 * byte) & 0xff)) * 0x100000001b3;
    }
  }
  void add(const hrt_command& command) {
    add(std::uint64_t{command.flags});
    add(static_cast<std::uint64_t>(command.step));
    for (const double value : {command.plate_orientation_deg, command.finger_direction_deg,
                               command.perceived_direction_deg, command.aimed_direction_deg,
                               command.distance_to_go_m, command.tactile_weight, command.tactile_weight_sd})
      add(std::bit_cast<std::uint64_t>(value));
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

/// Makes the record's call, and puts what came out of it in place of what was recorded.
class Rerun {
 public:
  Rerun(Session& session, Hash& hash, Record& record) : session_(session), hash_(hash), record_(record) {}
  void operator()(ReachBegun& call) { record_.result = session_.begin(call.reach); }
  void operator()(Updated& call) {
    record_.result = session_.update(call.sample, &call.command);
    if (record_.result == HRT_OK) hash_.add(call.command);
  }
  void operator()(ReachEnded& call) { record_.result = session_.end(&call.summary); }
  void operator()(ConfigSet&) {}
  void operator()(TargetChanged&) {}

 private:
  Session& session_;
  Hash& hash_;
  Record& record_;
};

bool starts_with_and_drops(std::string_view& line, std::string_view prefix) {
  if (!line.starts_with(prefix)) return false;
  line.remove_prefix(prefix.size());
  return true;
}

class Replay {
 public:
  hrt_result run(std::string_view text, hrt_replay_report* out) {
    if (!starts_with_and_drops(text, recording_header()))
      return fail(HRT_ERROR_BAD_FORMAT, "the text does not begin as a recording of version 1 does");
    for (const char c : recording_header()) line_number_ += c == '\n' ? 1 : 0;
    while (!text.empty() && !finished_) {
      ++line_number_;
      const std::size_t end = text.find('\n');
      if (end == std::string_view::npos) break;  // cut off within a line
      if (const hrt_result result = take(text.substr(0, end)); result != HRT_OK) return at_line(result);
      text.remove_prefix(end + 1);
    }
    report_.hash = hash_.value();
    *out = report_;
    return HRT_OK;
  }

 private:
  hrt_result take(std::string_view line) {
    if (starts_with_and_drops(line, config_comment)) return take_config(line);
    if (line.starts_with(lost_comment)) {
      finished_ = true;
    } else if (line == end_comment) {
      finished_ = true;
      report_.complete = 1;
    } else if (!line.starts_with("#")) {
      return take_row(line);
    }
    return HRT_OK;
  }

  hrt_result take_config(std::string_view json) {
    hrt_session_config config{};
    HRT_RETURN_IF_FAILED(read_config(json, &config));
    if (session_) return session_->set_config(config);
    session_.emplace(config);
    return HRT_OK;
  }

  hrt_result take_row(std::string_view line) {
    if (!session_) return fail(HRT_ERROR_BAD_FORMAT, "a row before the configuration");
    Record record;
    HRT_RETURN_IF_FAILED(read_row(line, &record));
    std::visit(Rerun(*session_, hash_, record), record.call);
    ++report_.rows;
    // Numbers are written so that different bits give different texts.
    RecordText again;
    write_record(record, again);
    const std::string_view row = again.view().substr(0, again.view().size() - 1);
    if (row != line && report_.first_different_line == 0) report_.first_different_line = line_number_;
    return HRT_OK;
  }

  hrt_result at_line(hrt_result result) const {
    const Text<240> what = thread_error.text;
    std::string_view detail = what.view();
    detail.remove_prefix(std::min(detail.size(), std::string_view(thread_error.call).size() + 2));
    return fail(result == HRT_ERROR_OUT_OF_MEMORY ? result : HRT_ERROR_BAD_FORMAT, "line ", line_number_,
                ": ", detail);
  }

  std::optional<Session> session_;
  Hash hash_;
  hrt_replay_report report_{.struct_size = sizeof(hrt_replay_report),
                            .complete = 0,
                            .rows = 0,
                            .first_different_line = 0,
                            .hash = 0};
  std::uint64_t line_number_ = 0;
  bool finished_ = false;
};

}  // namespace

hrt_result replay(std::string_view text, hrt_replay_report* out) {
  return Replay().run(text, out);
}

}  // namespace hrt::plugin
