#include "plugin/src/recording/recorder.h"

#include <cstring>
#include <system_error>
#include <utility>

#include "plugin/src/abi/host.h"
#include "plugin/src/abi/signals_blocked.h"

namespace hrt::plugin {

static_assert(std::is_trivially_copyable_v<Record>, "push() must not allocate");

namespace {

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
constexpr bool has_threads = false;  // push() writes the records if the ring is full, flush() and stop() the rest
#else
constexpr bool has_threads = true;
#endif

constexpr std::chrono::seconds seconds_between_reports{1};

}  // namespace

Recorder::Recorder(File file, std::string_view name, const SessionLog& log, const hrt_session_config& config,
                   std::span<const TargetChanged> targets, double plate_orientation_deg)
    : ring_(std::make_unique<Entry[]>(capacity)), file_(std::move(file)), log_(log) {
  name_ << name;
  watch_forks();
  forks_ = forks();
  const std::string header = recording_header();
  system_error_.store(file_.clear());  // after these allocations: if one fails, the file is unchanged
  write(header);
  write_record_of({.call = ConfigSet{config}});
  write_record_of({.call = InitialPlateOrientation{plate_orientation_deg}});
  for (const TargetChanged& target : targets) write_record_of({.call = target});
  if (const int error = system_error_.load(); error != 0)
    throw std::system_error(error, std::generic_category(), name_.c_str());
  if (has_threads) writer_ = start_thread_with_signals_blocked([this] { write_all(); });
}

// std::visit() does not throw, because a Record is never valueless.
// NOLINTNEXTLINE(bugprone-exception-escape)
Recorder::~Recorder() {
  if (belongs_to_parent_process())
    abandon();
  else
    stop();
}

void Recorder::push(const Record& record) noexcept {  // NOLINT(bugprone-exception-escape): see ~Recorder()
  if (!has_threads && is_full()) drain();
  if (belongs_to_parent_process() || overrun_.load() || is_full()) {
    overrun_.store(has_threads);
    lost_.fetch_add(1);
    lost_unnoted_.fetch_add(1);
    return;
  }
  const std::uint64_t n = pushed_.load(std::memory_order_relaxed);
  ring_[n % capacity] = {record, lost_unnoted_.exchange(0)};
  pushed_.store(n + 1, std::memory_order_release);
}

bool Recorder::is_full() const {
  return pushed_.load(std::memory_order_relaxed) - taken_.load(std::memory_order_acquire) == capacity;
}

hrt_recording_status Recorder::stop() {
  if (stopping_.exchange(true)) return status();
  if (writer_.joinable()) {
    writer_.join();
  } else {
    write_all();
  }
  file_.release();
  return status();
}

hrt_recording_status Recorder::flush() {
  if (!writer_.joinable()) drain();
  while (taken_.load(std::memory_order_acquire) != pushed_.load(std::memory_order_relaxed))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return status();
}

// In a forked child: overwrites the handle of the thread, which exists in the parent only, and logs lost calls.
void Recorder::abandon() {
  std::construct_at(&writer_);
  const std::uint64_t lost = lost_.load();
  if (lost == 0) return;
  Text<128> text;
  text << lost << " calls of a child process were not recorded; start a recording in the child process";
  report(HRT_LOG_WARNING, text.view());
}

hrt_recording_status Recorder::status() const {
  const std::uint64_t written = written_.load();
  const int error = system_error_.load();
  // After a failed write, no further record is written.
  const std::uint64_t refused = error == 0 ? 0 : pushed_.load() - written;
  return {.struct_size = sizeof(hrt_recording_status),
          .system_error = error,
          .rows_written = written_rows_.load(),
          .rows_lost = lost_.load() + refused};
}

void Recorder::write_all() {
  while (!stopping_.load(std::memory_order_acquire)) {
    drain();
    report_lost(seconds_between_reports);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  drain();
  write_lost(lost_unnoted_.exchange(0));
  report_lost(std::chrono::seconds(0));
  RecordText end;
  write_end(checksum_.value(), end);
  write(end.view());
}

void Recorder::drain() {
  for (std::uint64_t n = taken_.load(std::memory_order_relaxed);; taken_.store(++n, std::memory_order_release)) {
    const std::uint64_t held = pushed_.load(std::memory_order_acquire) - n;
    if (held <= capacity / 2) overrun_.store(false);
    if (held == 0) return;
    const Entry& entry = ring_[n % capacity];
    write_lost(entry.lost_before);
    write_record_of(entry.record);
    if (system_error_.load() != 0) continue;
    written_.fetch_add(1);
    if (is_row(entry.record)) written_rows_.fetch_add(1);
  }
}

void Recorder::write(std::string_view text) {
  if (system_error_.load() != 0) return;
  checksum_.add(text);
  const int error = file_.write(text);
  if (error == 0) return;
  system_error_.store(error);
  Text<240> reason;
  reason << "the recording has stopped (" << std::strerror(error)
         << "), but the session continues; start another recording";
  report(HRT_LOG_ERROR, reason.view());
}

void Recorder::write_record_of(const Record& record) {
  RecordText line;
  write_record(record, line);
  write(line.view());
}

void Recorder::write_lost(std::uint64_t count) {
  if (count == 0) return;
  Text<128> line;
  line << lost_comment << count << " calls here: the disk was too slow\n";
  write(line.view());
  lost_unreported_ += count;
}

// Logs the number of lost calls, if `after` has passed since the last report.
void Recorder::report_lost(std::chrono::seconds after) {
  if (lost_unreported_ == 0) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - reported_ < after) return;
  Text<128> line;
  line << std::exchange(lost_unreported_, 0)
       << " calls were not recorded, because the disk is too slow; use another disk";
  report(HRT_LOG_WARNING, line.view());
  reported_ = now;
}

void Recorder::report(std::uint32_t level, std::string_view text) const {
  Text<400> line;
  line << name_.view() << ": " << text;
  line.make_printable();
  write_log(level, line.c_str(), log_);
}

}  // namespace hrt::plugin
