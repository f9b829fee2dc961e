// The journal of a session: lines that are only appended to, each synced before the session continues.
//
//   {"number":7,"utc":"2026-11-24T17:10:53.123Z","monotonic_ns":123,"event":"reach","data":{...},"crc":"89abcdef"}
//
// `crc` is CRC-32 (IEEE 802.3) of the line before `,"crc"`. What a crash has cut stays as it is: the next
// line is the event "opened" of another start.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "samples/experiment/data/disk.h"

namespace hrt::experiment {

struct Event {
  std::uint64_t number;  ///< from 1
  std::int64_t utc_ms;   ///< since 1970; may be set back
  std::int64_t monotonic_ns;
  std::string name;
  nlohmann::json data;
};

/// Two clocks. Simulated sessions have a simulated one, so their bytes are the same each time.
struct Now {
  std::int64_t utc_ms;
  std::int64_t monotonic_ns;
};

std::uint32_t crc32(std::string_view text);
/// The time as text, "2026-11-24T17:10:53.123Z".
std::string utc_text(std::int64_t utc_ms);

/// The events of a journal's text. Throws Refusal naming the line: a damaged one is allowed only where a
/// process was cut off, before an event "opened" or at the end.
std::vector<Event> read_journal(const std::string& text, const std::string& name);

/// The one writer of a journal.
class Journal {
 public:
  /// Creates the file, or continues it. Throws Refusal if it cannot be written, is damaged, or another
  /// process writes it.
  Journal(std::filesystem::path file, const Disk& disk, std::function<Now()> clock);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  const std::vector<Event>& events() const { return events_; }
  /// The event is on the disk when this returns.
  const Event& append(const std::string& name, nlohmann::json data);

 private:
  std::filesystem::path name_;
  const Disk& disk_;
  std::function<Now()> clock_;
  int file_;
  bool is_cut_ = false;  // the last line has no end
  std::vector<Event> events_;
};

}  // namespace hrt::experiment
