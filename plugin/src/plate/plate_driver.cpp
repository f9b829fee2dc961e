#include "plugin/src/plate/plate_driver.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

#if !defined(_WIN32)
#include <pthread.h>
#endif

#include "plugin/src/abi/signals_blocked.h"
#include "plugin/src/abi/text.h"
#include "plugin/src/plate/same_ridges.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr auto update_period = 5ms;  // longest wait for the device until the next command is read
constexpr double arrived_deg = 5.0;  // a plate that is nearer to its command has reached it
constexpr double no_command = std::numeric_limits<double>::quiet_NaN();

std::atomic<std::uint32_t> forks{0};

// Counts forks in the child process, so that is_inherited() needs no system call to detect that it runs in a child.
void count_forks() {
#if !defined(_WIN32)
  [[maybe_unused]] static const int counted = pthread_atfork(nullptr, nullptr, [] { ++forks; });
#endif
}

// Serial line whose wait() throws if the plate is closed while it is being opened. A plate that is open is closed
// without this exception, because the destructor of the device still sends a stop.
class InterruptibleLine : public Line {
 public:
  InterruptibleLine(std::unique_ptr<Line> line, std::function<bool()> is_interrupted)
      : line_(std::move(line)), is_interrupted_(std::move(is_interrupted)) {}

  void receive(std::string& bytes) override { line_->receive(bytes); }
  void send(std::string_view bytes) override { line_->send(bytes); }
  void flush() override { line_->flush(); }
  bool has_unsent() const override { return line_->has_unsent(); }
  void wait(std::chrono::milliseconds limit) override {
    if (is_interrupted_()) throw PlateFailure(Fault::internal, "is closed");
    line_->wait(limit);
  }

 private:
  std::unique_ptr<Line> line_;
  std::function<bool()> is_interrupted_;
};

// Writes a text into a field of the report. Replaces control characters by '?', and cuts off what does not fit.
template <std::size_t size, class... Parts>
void write_text(char (&to)[size], const Parts&... parts) {
  plugin::Text<size> text;
  (text << ... << parts);
  text.make_printable();
  std::memcpy(to, text.c_str(), text.view().size() + 1);
}

}  // namespace

PlateDriver::PlateDriver(DeviceMaker maker, LineOpener opener, std::string path, std::optional<PlateFile> file,
                         const hrt_plate_options& options)
    : maker_(std::move(maker)),
      opener_(std::move(opener)),
      path_(std::move(path)),
      file_(std::move(file)),
      options_(options),
      forks_(forks),
      wanted_deg_(no_command) {
  static_assert(std::atomic<double>::is_always_lock_free && std::atomic<std::uint64_t>::is_always_lock_free);
  count_forks();
  state_.report.struct_size = sizeof(hrt_plate_report);
  state_.report.state = HRT_PLATE_STATE_OPENING;
  published_.publish(state_);
  thread_ = std::make_unique<std::thread>(start_thread_with_signals_blocked([this] { run(); }));
}

PlateDriver::~PlateDriver() {
  if (is_inherited()) {
    static_cast<void>(thread_.release());  // the thread runs in the parent only
    return;
  }
  is_closing_ = true;
  thread_->join();
}

void PlateDriver::set(double orientation_deg) {
  wanted_deg_.store(orientation_deg, std::memory_order_release);
  calls_.fetch_add(1, std::memory_order_release);
}

void PlateDriver::stop() { set(no_command); }

bool PlateDriver::is_inherited() const { return forks_ != forks.load(std::memory_order_relaxed); }

hrt_plate_report PlateDriver::report() const {
  calls_.fetch_add(1, std::memory_order_relaxed);
  const Published published = published_.read();
  hrt_plate_report report = published.report;
  if ((report.flags & HRT_PLATE_REPORT_ORIENTATION) != 0)
    report.age_ns = std::max<std::int64_t>(0, now().time_since_epoch() / 1ns - published.reported_ns);
  return report;
}

void PlateDriver::run() noexcept {
  try {
    bool opened = false;
    const auto open_line = [&](const std::string& path, int baud) -> std::unique_ptr<Line> {
      return std::make_unique<InterruptibleLine>(opener_(path, baud), [&] { return is_closing_ && !opened; });
    };
    const std::unique_ptr<Device> device = maker_(open_line, Start::hold);
    opened = true;
    operate(*device);
  } catch (const PlateFailure& failure) {
    fail(failure.fault(), failure.what());
  } catch (const std::bad_alloc&) {
    fail(Fault::internal, "cannot be operated: memory is exhausted. Free memory, and open the plate again");
  } catch (const std::exception& error) {
    plugin::Text<200> text;
    text << "cannot be operated: " << error.what() << ". Open the plate again";
    fail(Fault::internal, text.c_str());
  } catch (...) {
    fail(Fault::internal, "cannot be operated: an unknown exception occurred. Open the plate again");
  }
}

void PlateDriver::operate(Device& device) {
  write_text(state_.report.description, std::string_view(device.description()));
  if (file_) check_file(device);
  if (file_) watch_.emplace(*file_);
  last_call_ = now();
  while (!is_closing_) {
    publish(device);
    device.wait(update_period);
    update_command(device, now());
    if (watch_) watch_->update(now(), device, is_holding_ ? std::nullopt : std::optional(state_.report.command_deg));
  }
}

void PlateDriver::update_command(Device& device, Time now) {
  const std::uint32_t calls = calls_.load(std::memory_order_acquire);
  if (calls != calls_seen_) {
    calls_seen_ = calls;
    last_call_ = now;
    host_is_silent_ = false;
  } else if (now - last_call_ > std::chrono::nanoseconds(options_.host_timeout_ns) && !host_is_silent_) {
    host_is_silent_ = true;
    double before = wanted_deg_.load();
    wanted_deg_.compare_exchange_strong(before, no_command);  // keeps a command that arrives at this moment
  }
  const double wanted_deg = wanted_deg_.load(std::memory_order_acquire);
  if (!std::isnan(wanted_deg)) {
    const DeviceLimits limits = device.limits();
    const std::optional<double> present_deg = device.orientation_deg();
    const double within_deg =
        nearest_with_same_ridges(limits.min_deg, limits.max_deg, wanted_deg, present_deg.value_or(wanted_deg));
    device.turn_to(within_deg);
    if (present_deg && std::abs(*present_deg - within_deg) <= arrived_deg) has_arrived_ = true;
    state_.report.command_deg = within_deg;
    is_holding_ = false;
  } else if (!is_holding_) {
    device.stop();
    is_holding_ = true;
  }
}

void PlateDriver::check_file(Device& device) const {
  if (file_->description != device.description())
    throw PlateFailure(Fault::no_answer, "is \"" + device.description() + "\", but its file describes \"" +
                                             file_->description +
                                             "\". Commission this plate, or connect the plate of the file");
  const std::vector<std::string> settings = settings_of(device.details());
  for (const std::string& line : file_->settings)
    if (std::find(settings.begin(), settings.end(), line) == settings.end())
      throw PlateFailure(Fault::no_answer,
                         "does not have \"" + line + "\", which its file lists. Commission the plate again");
}

void PlateDriver::publish(const Device& device) {
  hrt_plate_report& report = state_.report;
  const DeviceLimits limits = device.limits();
  report.state = HRT_PLATE_STATE_READY;
  report.flags =
      (device.orientation_deg() ? HRT_PLATE_REPORT_ORIENTATION : HRT_PLATE_REPORT_UNHOMED) |
      (has_arrived_ ? 0U : HRT_PLATE_REPORT_FIRST_MOTION) | (device.is_measured() ? HRT_PLATE_REPORT_MEASURED : 0U) |
      (device.round_trip() ? HRT_PLATE_REPORT_ROUND_TRIP : 0U) | (is_holding_ ? 0U : HRT_PLATE_REPORT_COMMANDED) |
      (file_ ? HRT_PLATE_REPORT_COMMISSIONED : 0U) | (watch_ && watch_->deviates() ? HRT_PLATE_REPORT_DEVIATES : 0U) |
      (host_is_silent_ ? HRT_PLATE_REPORT_HOST_SILENT : 0U);
  report.orientation_deg = device.orientation_deg().value_or(0.0);
  report.latency_ns = limits.latency.count();
  if (file_) report.latency_ns = std::llround(file_->latency_ms * 1e6) + device.round_trip().value_or(0ns).count() / 2;
  report.round_trip_ns = device.round_trip().value_or(0ns).count();
  report.max_speed_deg_s = file_ ? std::min(limits.speed_deg_s, file_->speed_deg_s) : limits.speed_deg_s;
  report.max_acceleration_deg_s2 = file_ ? file_->acceleration_deg_s2 : 0.0;
  report.lower_stop_deg = limits.min_deg;
  report.upper_stop_deg = limits.max_deg;
  report.refused_messages = device.refusals();
  state_.reported_ns = device.reported().time_since_epoch() / 1ns;
  published_.publish(state_);
}

void PlateDriver::fail(Fault fault, const char* sentence) noexcept {
  hrt_plate_report& report = state_.report;
  report.state = HRT_PLATE_STATE_FAILED;
  report.fault = static_cast<std::uint32_t>(fault);
  report.flags &= ~(HRT_PLATE_REPORT_COMMANDED | HRT_PLATE_REPORT_HOST_SILENT);
  write_text(report.message, std::string_view("the plate at "), plugin::Shown{path_}, std::string_view(" "),
             std::string_view(sentence));
  published_.publish(state_);
}

}  // namespace hrt::plate
