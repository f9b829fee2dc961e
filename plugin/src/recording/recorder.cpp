#include "plugin/src/recording/recorder.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>

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

void append(const Record& record, std::FILE* file) {
  RecordText line;
  write_record(record, line);
  std::fwrite(line.c_str(), 1, line.view().size(), file);
}

}  // namespace

Recorder::Recorder(const char* path, const hrt_session_config& config, const Targets& targets,
                   double plate_orientation_deg)
    : ring_(std::make_unique<Entry[]>(capacity)), file_(open_file(path, FileMode::write)) {
  std::fwrite(recording_header().data(), 1, recording_header().size(), file_.get());
  append({.call = ConfigSet{config}}, file_.get());
  append({.call = PlateStands{plate_orientation_deg}}, file_.get());
  for (const auto& [id, target] : targets.all())
    append({.call = TargetChanged{TargetChanged::Change::added, targets.number(id), target}}, file_.get());
  if (std::fflush(file_.get()) != 0 || std::ferror(file_.get())) throw file_error(path);
  if (has_threads) writer_ = start_thread([this] { write_all(); });
}

Recorder::~Recorder() {
  stop();
}

void Recorder::push(const Record& record) noexcept {
  const std::uint64_t pushed = pushed_.load(std::memory_order_relaxed);
  const std::uint64_t lost = lost_.load(std::memory_order_relaxed);
  if (!has_threads && pushed - taken_.load() == capacity) drain();
  if (pushed - taken_.load(std::memory_order_acquire) == capacity) {
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
  return status();
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
  write(end_comment);
  write("\n");
  drain();
}

// Writes what the ring holds, and hands it to the operating system.
void Recorder::drain() {
  RecordText line;
  const std::uint64_t pushed = pushed_.load(std::memory_order_acquire);
  for (std::uint64_t taken = taken_.load(std::memory_order_relaxed); taken != pushed; ++taken) {
    const Entry& entry = ring_[taken % capacity];
    write_lost(entry.lost_before);
    line.clear();
    write_record(entry.record, line);
    write(line.view());
    ++in_flight_;
    taken_.store(taken + 1, std::memory_order_release);
  }
  if (system_error_.load() != 0) return;
  if (std::fflush(file_.get()) != 0) return give_up(errno);
  written_.fetch_add(in_flight_);
  in_flight_ = 0;
}

void Recorder::write(std::string_view text) {
  if (system_error_.load() != 0) return;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) give_up(errno);
}

void Recorder::write_lost(std::uint64_t count) {
  if (count == 0) return;
  Text<128> line;
  line << lost_comment << count << " calls here: the disk was too slow";
  log(HRT_LOG_WARNING, line.c_str());
  line << "\n";
  write(line.view());
}

void Recorder::give_up(int error) {
  system_error_.store(error == 0 ? EIO : error);
  Text<240> text;
  text << "the recording ends here, control continues: " << std::strerror(error);
  log(HRT_LOG_ERROR, text.c_str());
}

}  // namespace hrt::plugin
