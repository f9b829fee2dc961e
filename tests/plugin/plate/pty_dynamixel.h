// The emulated servo at the other end of a pseudo-terminal, in real time.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>

#include "tests/plugin/plate/emulated_dynamixel.h"

namespace hrt::plate {

class PtyDynamixel {
 public:
  PtyDynamixel() {
    std::array<char, 128> name{};
    termios raw{};
    cfmakeraw(&raw);
    if (openpty(&master_, &slave_, name.data(), &raw, nullptr) != 0)
      throw std::runtime_error("no pseudo-terminal");
    for (const int end : {master_, slave_}) fcntl(end, F_SETFD, FD_CLOEXEC);
    fcntl(master_, F_SETFL, O_NONBLOCK);
    device_ = name.data();
    thread_ = std::thread([this] { live(); });
  }
  ~PtyDynamixel() {
    ending_ = true;
    thread_.join();
    close(master_);
    close(slave_);
  }
  PtyDynamixel(const PtyDynamixel&) = delete;
  PtyDynamixel& operator=(const PtyDynamixel&) = delete;

  const std::string& device() const { return device_; }
  /// Farthest from 0 so far.
  double max_turn_deg() const { return max_turn_deg_; }

 private:
  // If this machine was busy for longer than a slice may be, the servo misses that time: its watchdog would
  // stop it before it hears what has come meanwhile.
  void live() {
    constexpr auto max_slice = std::chrono::milliseconds(20);
    auto began = std::chrono::steady_clock::now();
    while (!ending_) {
      pollfd readable{master_, POLLIN, 0};
      poll(&readable, 1, 1);
      std::array<char, 256> bytes{};
      const ssize_t count = read(master_, bytes.data(), bytes.size());
      const auto behind = std::chrono::steady_clock::now() - began - servo_.now();
      if (behind > max_slice) began += behind - max_slice;
      const auto now = std::chrono::steady_clock::now() - began;
      servo_.run_until(now);
      if (count > 0) {
        const std::string answer = servo_.hear({bytes.data(), static_cast<std::size_t>(count)}, now);
        if (!answer.empty()) [[maybe_unused]]
          const ssize_t ignored = write(master_, answer.data(), answer.size());
      }
      max_turn_deg_ = std::max(max_turn_deg_.load(), std::abs(servo_.orientation_deg()));
    }
  }

  EmulatedDynamixel servo_;
  int master_ = -1, slave_ = -1;
  std::string device_;
  std::atomic<double> max_turn_deg_ = 0.0;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace hrt::plate
