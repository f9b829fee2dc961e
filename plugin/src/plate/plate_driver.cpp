#include "plugin/src/plate/plate_driver.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

#if !defined(_WIN32)
#include <unistd.h>
#endif

#include "plugin/src/abi/quiet_thread.h"
#include "plugin/src/abi/text.h"
#include "plugin/src/plate/same_feel.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr auto pickup_period = 5ms;  // in which a command is seen
constexpr double arrived_deg = 5.0;  // from the command
constexpr double slow_share = 0.8;   // of the speed that was measured
constexpr auto deviates_after = 1s;  // of rest, and of error
constexpr double stay = std::numeric_limits<double>::quiet_NaN();

int this_process() {
#if defined(_WIN32)
  return 0;
#else
  return getpid();
#endif
}

// A line whose waits end when the plate is closed while it is being opened; the last words of an open plate
// are still said.
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

// A line for the host: whole characters, no control characters.
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
      process_(this_process()),
      wanted_deg_(stay) {
  static_assert(std::atomic<double>::is_always_lock_free && std::atomic<std::uint64_t>::is_always_lock_free);
  now_known_.report.struct_size = sizeof(hrt_plate_report);
  now_known_.report.state = HRT_PLATE_STATE_OPENING;
  published_.publish(now_known_);
  thread_ = std::make_unique<std::thread>(start_quiet_thread([this] { run(); }));
}

PlateDriver::~PlateDriver() {
  if (process_ != this_process()) {
    static_cast<void>(thread_.release());  // the thread is the parent's
    return;
  }
  ending_ = true;
  thread_->join();
}

void PlateDriver::set(double orientation_deg) {
  wanted_deg_.store(orientation_deg, std::memory_order_release);
  calls_.fetch_add(1, std::memory_order_release);
}

void PlateDriver::stop() { set(stay); }

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
      return std::make_unique<InterruptibleLine>(opener_(path, baud), [&] { return ending_ && !opened; });
    };
    const std::unique_ptr<Device> device = maker_(open_line, Start::hold);
    opened = true;
    serve(*device);
  } catch (const PlateFailure& failure) {
    fail(failure.fault(), failure.what());
  } catch (const std::bad_alloc&) {
    fail(Fault::internal, "cannot be driven: out of memory");
  } catch (const std::exception& error) {
    fail(Fault::internal, error.what());
  } catch (...) {
    fail(Fault::internal, "cannot be driven: an exception of unknown type");
  }
}

void PlateDriver::serve(Device& device) {
  write_text(now_known_.report.description, std::string_view(device.description()));
  host_heard_ = near_ = commanded_ = now();
  if (file_ && file_->description != device.description())
    throw PlateFailure(Fault::no_answer,
                       "is \"" + device.description() + "\", and its file is of \"" + file_->description + "\"");
  while (!ending_) {
    publish(device);
    device.wait(pickup_period);
    follow_host(device, now());
    if (file_) compare_with_file(device, now());
  }
}

void PlateDriver::follow_host(Device& device, Time now) {
  const std::uint32_t calls = calls_.load(std::memory_order_acquire);
  if (calls != calls_seen_) {
    calls_seen_ = calls;
    host_heard_ = now;
    host_is_silent_ = false;
  } else if (now - host_heard_ > std::chrono::nanoseconds(options_.host_timeout_ns) && !host_is_silent_) {
    host_is_silent_ = true;
    double before = wanted_deg_.load();
    wanted_deg_.compare_exchange_strong(before, stay);  // unless a command comes at this instant
  }
  const double wanted_deg = wanted_deg_.load(std::memory_order_acquire);
  if (!std::isnan(wanted_deg)) {
    const DeviceLimits limits = device.limits();
    const std::optional<double> place_deg = device.orientation_deg();
    const double within_deg =
        orientation_within(limits.min_deg, limits.max_deg, wanted_deg, place_deg.value_or(wanted_deg));
    if (holds_ || within_deg != now_known_.report.command_deg) commanded_ = now;
    device.turn_to(within_deg);
    if (place_deg && std::abs(*place_deg - within_deg) <= arrived_deg) has_arrived_ = true;
    now_known_.report.command_deg = within_deg;
    holds_ = false;
  } else if (!holds_) {
    device.stop();
    holds_ = true;
  }
}

// Slower than measured; or for a second, at rest, farther from its command than it ever was.
void PlateDriver::compare_with_file(const Device& device, Time now) {
  const hrt_plate_report& report = now_known_.report;
  const double error_deg = std::abs(device.orientation_deg().value_or(0.0) - report.command_deg);
  const bool rests = !holds_ && now - commanded_ > deviates_after && device.orientation_deg();
  if (!rests || error_deg <= file_->error_deg) near_ = now;
  deviates_ = now - near_ > deviates_after || device.limits().speed_deg_s < slow_share * file_->speed_deg_s;
}

void PlateDriver::publish(const Device& device) {
  hrt_plate_report& report = now_known_.report;
  const DeviceLimits limits = device.limits();
  report.state = HRT_PLATE_STATE_READY;
  report.flags = (device.orientation_deg() ? HRT_PLATE_REPORT_ORIENTATION : HRT_PLATE_REPORT_UNHOMED) |
                 (has_arrived_ ? 0U : HRT_PLATE_REPORT_FIRST_MOTION) |
                 (device.is_measured() ? HRT_PLATE_REPORT_MEASURED : 0U) |
                 (device.round_trip() ? HRT_PLATE_REPORT_ROUND_TRIP : 0U) | (holds_ ? 0U : HRT_PLATE_REPORT_COMMANDED) |
                 (file_ ? HRT_PLATE_REPORT_COMMISSIONED : 0U) | (deviates_ ? HRT_PLATE_REPORT_DEVIATES : 0U) |
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
  now_known_.reported_ns = device.reported().time_since_epoch() / 1ns;
  published_.publish(now_known_);
}

void PlateDriver::fail(Fault fault, const char* sentence) noexcept {
  hrt_plate_report& report = now_known_.report;
  report.state = HRT_PLATE_STATE_FAILED;
  report.fault = static_cast<std::uint32_t>(fault);
  report.flags &= ~(HRT_PLATE_REPORT_COMMANDED | HRT_PLATE_REPORT_HOST_SILENT);
  write_text(report.message, std::string_view("the plate at "), plugin::Shown{path_}, std::string_view(" "),
             std::string_view(sentence));
  published_.publish(now_known_);
}

}  // namespace hrt::plate
