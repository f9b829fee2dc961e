#include "tests/samples/reach/pty_plate.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

#include "samples/plate/driver/plate_line.h"

namespace hrt::reach {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto report_period = 20ms;
constexpr auto heartbeat_limit = 300ms;

}  // namespace

bool eventually(const std::function<bool()>& condition) {
  const auto give_up = Clock::now() + 5s;
  while (!condition()) {
    if (Clock::now() > give_up) return false;
    std::this_thread::sleep_for(2ms);
  }
  return true;
}

PtyPlate::PtyPlate(Behaviour behaviour) : behaviour_(std::move(behaviour)) {
  char name[128];
  termios raw{};
  cfmakeraw(&raw);
  if (openpty(&master_, &slave_, name, &raw, nullptr) != 0) throw std::runtime_error("no pseudo-terminal");
  fcntl(master_, F_SETFL, O_NONBLOCK);
  // A program that the test starts must not keep the line up.
  fcntl(master_, F_SETFD, FD_CLOEXEC);
  fcntl(slave_, F_SETFD, FD_CLOEXEC);
  device_ = name;
  thread_ = std::thread([this] { live(); });
}

PtyPlate::~PtyPlate() {
  ending_ = true;
  thread_.join();
  if (!unplugged_) close(master_);
  close(slave_);
}

void PtyPlate::unplug() {
  unplugged_ = true;
  eventually([this] { return gone_.load(); });
}

void PtyPlate::send(const std::string& body) {
  const std::lock_guard lock(mutex_);
  to_send_.push_back(sealed(body));
}

void PtyPlate::restart() {
  greeted_ = false;
  allowed_ = false;
  send("BOOT");
}

bool PtyPlate::is_first_version() const {
  return behaviour_.greeting.rfind("PLATE 1", 0) == 0;
}

std::string PtyPlate::sealed(const std::string& body) const {
  return plate::encode_line(body, is_first_version() ? plate::Version::one : plate::Version::two);
}

std::string PtyPlate::place() const {
  std::array<char, 32> text{};
  const bool first = is_first_version();
  std::snprintf(text.data(), text.size(), first ? "AT %.2f" : "AT %+07.2f", orientation_deg_.load());
  return sealed(first ? text.data() : text.data() + sequence_);
}

void PtyPlate::turn(std::chrono::nanoseconds time) {
  if (!behaviour_.turns || !allowed_) return;
  const double most_deg = behaviour_.speed_deg_s * std::chrono::duration<double>(time).count();
  orientation_deg_ = orientation_deg_ + std::clamp(target_deg_ - orientation_deg_, -most_deg, most_deg);
}

std::vector<std::string> PtyPlate::heard() const {
  const std::lock_guard lock(mutex_);
  return heard_;
}

void PtyPlate::write_bytes(const std::string& bytes) {
  for (const char byte : bytes) {
    [[maybe_unused]] const ssize_t ignored = write(master_, &byte, 1);
    if (behaviour_.byte_delay > 0ms) std::this_thread::sleep_for(behaviour_.byte_delay);
  }
}

void PtyPlate::hear(std::string body) {
  const bool first = is_first_version();
  if (body.rfind("HELLO", 0) == 0) {
    if (body != (first ? "HELLO 1" : "HELLO 2") || !behaviour_.answers || silent_) return;
    greeted_ = true;
    write_bytes(behaviour_.noise + sealed(behaviour_.greeting));
    return;
  }
  if (!greeted_) return;
  if (body == "INFO") {
    write_bytes(sealed("INFO 0.1 000007"));
  } else if (!first) {
    sequence_ = body.substr(body.rfind(' '));
    body.resize(body.rfind(' '));
  }
  {
    const std::lock_guard lock(mutex_);
    heard_.push_back(body);
  }
  if (body.rfind("SET ", 0) == 0) {
    target_deg_ = std::stod(body.substr(4));
    if (target_deg_ != orientation_deg_) allowed_ = true;
  }
  if (body == "STOP") allowed_ = false;
  if (!first && behaviour_.reports && !silent_ && body != "INFO") write_bytes(place());
}

void PtyPlate::live() {
  plate::LineReader reader;
  std::this_thread::sleep_for(behaviour_.boot);
  char lost = 0;
  while (behaviour_.boot > 0ms && read(master_, &lost, 1) == 1) continue;
  auto last_heard = Clock::now(), last_report = Clock::now(), last_turn = Clock::now();
  while (!ending_) {
    if (unplugged_) {
      close(master_);
      gone_ = true;
      return;
    }
    pollfd readable{master_, POLLIN, 0};
    poll(&readable, 1, 2);
    char byte = 0;
    while (read(master_, &byte, 1) == 1) {
      const auto line = reader.take(byte);
      const auto decoded = line ? plate::decode_line(*line) : std::nullopt;
      if (!decoded) continue;
      last_heard = Clock::now();
      hear(std::string(decoded->body));
    }
    const auto now = Clock::now();
    turn(now - last_turn);
    last_turn = now;
    if (allowed_ && now - last_heard > heartbeat_limit) {
      allowed_ = false;
      ++heartbeat_stops_;
      if (!silent_) write_bytes(sealed("STOPPED heartbeat"));
    }
    std::vector<std::string> to_send;
    {
      const std::lock_guard lock(mutex_);
      to_send.swap(to_send_);
    }
    if (silent_) continue;
    for (const std::string& line : to_send) write_bytes(line);
    if (greeted_ && behaviour_.reports && now - last_report >= report_period) {
      last_report = now;
      write_bytes(behaviour_.noise + place());
    }
  }
}

}  // namespace hrt::reach
