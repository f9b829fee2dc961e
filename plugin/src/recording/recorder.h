#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <thread>

#include "plugin/src/abi/file.h"
#include "plugin/src/abi/fork.h"
#include "plugin/src/abi/hash.h"
#include "plugin/src/abi/host.h"
#include "plugin/src/recording/format.h"

namespace hrt::plugin {

/// Writes records to a file. push() does not wait for the file: it adds a record to a ring buffer, from which a thread
/// takes it. Calls must not be concurrent.
class Recorder {
 public:
  /// Starts a recording by writing the state of the session. `name` identifies session and file in `log`, which must
  /// outlive this object. Throws std::system_error, std::bad_alloc.
  Recorder(File file, std::string_view name, const SessionLog& log, const hrt_session_config& config,
           std::span<const TargetChanged> targets, double plate_orientation_deg);
  ~Recorder();  ///< writes the remaining records and closes the file; in a forked child, writes nothing
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Adds a record, or counts it as lost if the thread is too slow. Real-time.
  void push(const Record& record) noexcept;

  /// True in a forked child: push() drops records, and of the other functions only the destructor may be called.
  bool belongs_to_parent_process() const { return forks_ != forks(); }

  /// Ends the recording as the destructor does, and returns the final state.
  hrt_recording_status stop();
  /// Waits until the operating system has accepted all records, or a write has failed.
  hrt_recording_status flush();
  hrt_recording_status status() const;

 private:
  struct Entry {
    Record record;
    std::uint64_t lost_before;  // records lost between the previous entry and this one
  };
  static constexpr std::size_t capacity = 8192;  // 80 s at 100 Hz

  void write_all();
  void drain();
  bool is_full() const;
  void write(std::string_view text);
  void write_record_of(const Record& record);
  void write_lost(std::uint64_t count);
  void report_lost(std::chrono::seconds after);
  void report(std::uint32_t level, std::string_view text) const;
  void abandon();

  std::unique_ptr<Entry[]> ring_;
  std::atomic<std::uint64_t> pushed_{0};  // records that the caller has added to the ring
  std::atomic<std::uint64_t> taken_{0};   // records that the writing thread has removed from the ring
  std::atomic<std::uint64_t> lost_{0};    // records that push() dropped
  std::atomic<std::uint64_t> written_{0};
  std::atomic<std::uint64_t> written_rows_{0};  // written records that are rows
  std::atomic<int> system_error_{0};
  std::atomic<bool> stopping_{false};
  std::atomic<std::uint64_t> lost_unnoted_{0};  // dropped records that no entry counts in lost_before yet
  std::atomic<bool> overrun_{false};            // true: no record is accepted until half of the ring is free
  std::uint64_t lost_unreported_ = 0;           // lost records that are not in the log yet
  std::chrono::steady_clock::time_point reported_;
  std::uint32_t forks_ = 0;
  File file_;
  Hash checksum_;
  Text<128> name_;
  const SessionLog& log_;
  std::thread writer_;
};

}  // namespace hrt::plugin
