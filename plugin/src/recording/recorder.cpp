#include "plugin/src/recording/recorder.h"

#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "plugin/src/abi/host.h"

namespace hrt::plugin {

static_assert(std::is_trivially_copyable_v<Record>, "push() must not allocate");

namespace {

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
constexpr bool has_threads = false;  // who calls writes the file, whenever the ring is full and at the end
#else
constexpr bool has_threads = true;
#endif

// Starts a thread that leaves the process's signals to the host's threads.
template <class Run>
std::thread start_thread(Run&& run) {
#if defined(_WIN32)
  return std::thread(run);
#else
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const auto restore = [](const sigset_t* mask) { pthread_sigmask(SIG_SETMASK, mask, nullptr); };
  const std::unique_ptr<const sigset_t, decltype(restore)> restored(&before, restore);  // also if it throws
  return std::thread(run);
#endif
}

}  // namespace

Recorder::Recorder(File file, std::string_view name, const hrt_session_config& config, const Targets& targets,
                   double plate_orientation_deg)
    : ring_(std::make_unique<Entry[]>(capacity)), file_(std::move(file)) {
  name_ << name;
  watch_forks();
  forks_ = forks();
  write(recording_header());
  write_record_of({.call = ConfigSet{config}});
  write_record_of({.call = PlateStands{plate_orientation_deg}});
  for (const auto& [id, target] : targets.all())
    write_record_of({.call = TargetChanged{TargetChanged::Change::added, targets.number(id), target}});
  if (const int error = system_error_.load(); error != 0)
    throw std::system_error(error, std::generic_category(), name_.c_str());
  if (has_threads) writer_ = start_thread([this] { write_all(); });
}

Recorder::~Recorder() {
  if (is_of_parent())
    abandon();
  else
    stop();
}

void Recorder::push(const Record& record) noexcept {
  const std::uint64_t pushed = pushed_.load(std::memory_order_relaxed);
  const std::uint64_t lost = lost_.load(std::memory_order_relaxed);
  if (!has_threads && pushed - taken_.load() == capacity) drain();
  if (is_of_parent() || pushed - taken_.load(std::memory_order_acquire) == capacity) {
    lost_.store(lost + 1, std::memory_order_relaxed);
    return;
  }
  Entry& entry = ring_[pushed % capacity];
  entry.record = record;
  entry.lost_before = lost - lost_noted_;
  lost_noted_ = lost;
  pushed_.store(pushed + 1, std::memory_order_release);
}

RecorderStatus Recorder::stop() {
  if (stopping_.exchange(true)) return status();
  if (writer_.joinable()) {
    writer_.join();
  } else {
    write_all();
  }
  file_.release();
  return status();
}

// The thread and the file are the parent's.
void Recorder::abandon() {
  std::construct_at(&writer_);
  const std::uint64_t lost = lost_.load();
  if (lost == 0) return;
  Text<96> text;
  text << lost << " calls are not recorded: they are of a child of the process that records";
  report(HRT_LOG_WARNING, text.view());
}

RecorderStatus Recorder::status() const {
  const std::uint64_t written = written_.load();
  const int error = system_error_.load();
  // After a failed write nothing more arrives, whether or not it found room.
  const std::uint64_t refused = error == 0 ? 0 : pushed_.load() - written;
  return {.written = written, .lost = lost_.load() + refused, .system_error = error};
}

void Recorder::write_all() {
  while (!stopping_.load(std::memory_order_acquire)) {
    drain();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  drain();
  write_lost(lost_.load() - lost_noted_);
  RecordText end;
  write_end(checksum_.value(), end);
  write(end.view());
}

// Hands what the ring holds to the operating system.
void Recorder::drain() {
  const std::uint64_t pushed = pushed_.load(std::memory_order_acquire);
  for (std::uint64_t taken = taken_.load(std::memory_order_relaxed); taken != pushed; ++taken) {
    const Entry& entry = ring_[taken % capacity];
    write_lost(entry.lost_before);
    write_record_of(entry.record);
    if (system_error_.load() == 0) written_.fetch_add(1);
    taken_.store(taken + 1, std::memory_order_release);
  }
}

void Recorder::write(std::string_view text) {
  if (system_error_.load() != 0) return;
  checksum_.add(text);
  const int error = file_.write(text);
  if (error == 0) return;
  system_error_.store(error);
  Text<240> reason;
  reason << "the recording ends here, control continues: " << std::strerror(error);
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
  line << lost_comment << count << " calls here: the disk was too slow";
  report(HRT_LOG_WARNING, line.view());
  line << "\n";
  write(line.view());
}

void Recorder::report(std::uint32_t level, std::string_view text) const {
  Text<400> line;
  line << name_.view() << ": " << text;
  line.make_printable();
  log(level, line.c_str());
}

}  // namespace hrt::plugin
