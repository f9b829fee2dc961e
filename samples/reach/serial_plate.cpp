#include "samples/reach/serial_plate.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "samples/reach/exit_code.h"

namespace hrt::reach {
namespace {

using namespace std::chrono_literals;

constexpr auto greeting_limit = 2000ms;
constexpr auto greeting_period = 200ms;  // a plate that starts up may not hear the first one
constexpr auto beat_period = 50ms;       // half of the protocol's limit
constexpr auto silence_limit = 500ms;
constexpr std::size_t most_unsent = 1024;
constexpr int most_reads = 64;  // at a time, however much the plate sends

std::string set_line(double orientation_deg) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), orientation_deg, std::chars_format::fixed, 2).ptr;
  return "SET " + std::string(text.data(), end);
}

bool wait_for(int line, short event, std::chrono::milliseconds limit) {
  pollfd wanted{line, event, 0};
  return poll(&wanted, 1, static_cast<int>(limit.count())) > 0;
}

}  // namespace

SerialPlate::SerialPlate(std::filesystem::path device) : device_(std::move(device)) {
  try {
    open_line();
    greet();
  } catch (...) {
    if (line_ >= 0) close(line_);
    throw;
  }
}

SerialPlate::~SerialPlate() {
  try {
    say("STOP");
    while (!unsent_.empty() && wait_for(line_, POLLOUT, 100ms)) flush();
  } catch (const Failure&) {
    // It no longer hears; without a heartbeat it stops by itself.
  }
  close(line_);
}

void SerialPlate::open_line() {
  line_ = open(device_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (line_ < 0) fail(std::string("cannot be opened: ") + std::strerror(errno));
  termios settings{};
  if (tcgetattr(line_, &settings) != 0) fail("is not a serial line");
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
  if (cfsetspeed(&settings, B115200) != 0 || tcsetattr(line_, TCSANOW, &settings) != 0)
    fail(std::string("cannot be set up: ") + std::strerror(errno));
  if (ioctl(line_, TIOCEXCL) != 0) fail("is in use");
  tcflush(line_, TCIOFLUSH);
}

void SerialPlate::greet() {
  const Clock::time_point began = Clock::now();
  heard_ = began;
  while (!greeted_) {
    if (Clock::now() - began > greeting_limit) fail("does not answer as a plate");
    say("HELLO 1");
    const Clock::time_point again = Clock::now() + greeting_period;
    while (!greeted_ && Clock::now() < again) {
      wait_for(line_, POLLIN, 10ms);
      listen();
    }
  }
}

void SerialPlate::service(XrTime) {
  listen();
  if (Clock::now() - heard_ > silence_limit) fail("has not been heard for half a second");
  beat_if_due();
  flush();
}

void SerialPlate::command(XrTime, double orientation_deg) {
  const double within_deg = orientation_within(greeting_.least_deg, greeting_.most_deg, orientation_deg,
                                               orientation_deg_.value_or(orientation_deg));
  std::string line = set_line(within_deg);
  if (line == last_set_) return;
  last_set_ = std::move(line);
  say(last_set_);
}

std::optional<double> SerialPlate::orientation_deg(XrTime) {
  return orientation_deg_;
}

void SerialPlate::stop(XrTime) {
  last_set_.clear();
  say("STOP");
}

void SerialPlate::listen() {
  std::array<char, 256> bytes{};
  for (int i = 0; i < most_reads; ++i) {
    const ssize_t count = read(line_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (count <= 0) fail("is unplugged");
    for (ssize_t k = 0; k < count; ++k) {
      const std::optional<std::string_view> line = reader_.take(bytes[static_cast<std::size_t>(k)]);
      if (!line) continue;
      const std::optional<std::string_view> body = decode_line(*line);
      if (const auto message = body ? parse_plate_message(*body) : std::nullopt) take(*message);
    }
  }
}

void SerialPlate::take(const PlateMessage& message) {
  heard_ = Clock::now();
  if (const auto* greeting = std::get_if<PlateGreeting>(&message)) {
    greeting_ = *greeting;
    greeted_ = true;
  } else if (const auto* report = std::get_if<PlateReport>(&message)) {
    orientation_deg_ = report->orientation_deg;
  } else {
    switch (std::get<PlateStopped>(message).reason) {
      case StopReason::host:
        break;
      case StopReason::heartbeat:
        last_set_.clear();  // so that the next command is sent even if it is the same
        break;
      case StopReason::limit:
        fail("refused an angle beyond its limits");
      case StopReason::fault:
        fail("reports a fault");
    }
  }
}

void SerialPlate::beat_if_due() {
  if (Clock::now() - said_ >= beat_period) say("BEAT");
}

void SerialPlate::say(std::string_view body) {
  unsent_ += encode_line(body);
  if (unsent_.size() > most_unsent) fail("takes nothing in");
  said_ = Clock::now();
  flush();
}

void SerialPlate::flush() {
  while (!unsent_.empty()) {
    const ssize_t count = write(line_, unsent_.data(), unsent_.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (count <= 0) fail("is unplugged");
    unsent_.erase(0, static_cast<std::size_t>(count));
  }
}

// The last chance to stop the plate.
void SerialPlate::fail(const std::string& what) {
  if (line_ >= 0 && unsent_.empty()) {
    const std::string stop = encode_line("STOP");
    [[maybe_unused]] const ssize_t ignored = write(line_, stop.data(), stop.size());
  }
  throw Failure(ExitCode::plate, "the plate at " + device_.string() + " " + what);
}

}  // namespace hrt::reach
