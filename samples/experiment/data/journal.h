// The journal of a session: an append-only file of lines, each synced before the session continues.
//
//   {"number":7,"utc":"2026-11-24T17:10:53.123Z","monotonic_ns":123,"event":"reach","data":{...},"crc":"89abcdef"}
//
// `crc` is CRC-32 (IEEE 802.3) of the line before `,"crc"`. A line that a failed write has cut remains in the file; the
// next line is then the event "closed" of the same run of the program, or "opened" of a later run.
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
  std::int64_t utc_ms;   ///< milliseconds since 1970; can jump backwards
  std::int64_t monotonic_ns;
  std::string name;
  nlohmann::json data;
};

/// Wall clock and monotonic clock. Both are simulated in simulated sessions, so that journals are reproducible.
struct Now {
  std::int64_t utc_ms;
  std::int64_t monotonic_ns;
};

std::uint32_t crc32(std::string_view text);
/// Returns the time as text, "2026-11-24T17:10:53.123Z".
std::string utc_text(std::int64_t utc_ms);

/// Parses a journal. Skips damaged lines at the end, and before an event "opened" or "closed", where a write was
/// interrupted. Throws Refusal naming any other damaged line, or a line with a wrong number.
std::vector<Event> read_journal(const std::string& text, const std::string& name);

/// Writes a journal. The file is locked, so that only one process can write it.
class Journal {
 public:
  /// Reads or creates the file. Throws Refusal if it is damaged, is locked, or cannot be opened for writing.
  Journal(std::filesystem::path file, const Disk& disk, std::function<Now()> clock);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  const std::vector<Event>& events() const { return events_; }
  /// Appends an event and syncs it to the disk before it returns. Throws Refusal if either fails; after a failed sync,
  /// the event is in the journal.
  const Event& append(const std::string& name, nlohmann::json data);

 private:
  std::filesystem::path name_;
  const Disk& disk_;
  std::function<Now()> clock_;
  int file_;
  bool is_cut_ = false;  // the last line has no newline
  std::vector<Event> events_;
};

}  // namespace hrt::experiment
