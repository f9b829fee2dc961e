#include "tests/samples/reach/pty_plate.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "samples/reach/plate_line.h"

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
  to_send_.push_back(encode_line(body));
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

void PtyPlate::hear(const std::string& body) {
  {
    const std::lock_guard lock(mutex_);
    heard_.push_back(body);
  }
  if (body == "HELLO 1" && behaviour_.answers && !silent_) {
    greeted_ = true;
    write_bytes(behaviour_.noise + encode_line(behaviour_.greeting));
  }
  if (body.rfind("SET ", 0) == 0) {
    allowed_ = true;
    orientation_deg_ = std::stod(body.substr(4));
  }
  if (body == "STOP") allowed_ = false;
}

void PtyPlate::live() {
  LineReader reader;
  auto last_heard = Clock::now(), last_report = Clock::now();
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
      const auto body = line ? decode_line(*line) : std::nullopt;
      if (!body) continue;
      last_heard = Clock::now();
      hear(std::string(*body));
    }
    const auto now = Clock::now();
    if (allowed_ && now - last_heard > heartbeat_limit) {
      allowed_ = false;
      if (!silent_) write_bytes(encode_line("STOPPED heartbeat"));
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
      write_bytes(behaviour_.noise +
                  encode_line("AT " + std::to_string(orientation_deg_.load()).substr(0, 8)));
    }
  }
}

}  // namespace hrt::reach
