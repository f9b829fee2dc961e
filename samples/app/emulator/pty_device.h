#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <thread>

#include "samples/app/emulator/dynamixel.h"
#include "samples/app/emulator/hobby_plate.h"
#include "samples/app/emulator/pseudo_terminal.h"

namespace hrt::plate {

/// Emulated device behind a pseudo-terminal, in real time.
template <class Device>
class PtyDevice {
 public:
  template <class... Arguments>
  explicit PtyDevice(Arguments&&... arguments) : emulated_(std::forward<Arguments>(arguments)...) {
    thread_ = std::thread([this] { simulate(); });
  }
  ~PtyDevice() {
    ending_ = true;
    if (thread_.joinable()) thread_.join();
  }
  PtyDevice(const PtyDevice&) = delete;
  PtyDevice& operator=(const PtyDevice&) = delete;

  /// Path of the pseudo-terminal, which the host opens as a serial line.
  const std::string& device() const { return pty_.device(); }
  /// Simulates an unplugged line.
  void unplug() {
    ending_ = true;
    thread_.join();
    pty_.unplug();
  }
  /// Calls `action` with the device, between two steps of its simulation, and returns the result.
  template <class Action>
  auto with(Action action) {
    const std::lock_guard lock(mutex_);
    return std::invoke(action, emulated_);
  }

 private:
  // If this thread was delayed by more than max_slice, skips the time beyond max_slice. If it simulated that time, the
  // device's watchdog would stop the device before the device receives the bytes that have arrived meanwhile.
  void simulate() {
    using Clock = std::chrono::steady_clock;
    constexpr auto max_slice = std::chrono::milliseconds(20);
    auto began = Clock::now() - emulated_.now();
    while (!ending_) {
      const std::string bytes = pty_.take(1);
      const std::lock_guard lock(mutex_);
      const auto behind = Clock::now() - began - emulated_.now();
      if (behind > max_slice) began += behind - max_slice;
      const auto now = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - began);
      emulated_.receive(bytes, now);
      emulated_.run_until(now);
      pty_.type(emulated_.take_output());
    }
  }

  Device emulated_;
  std::mutex mutex_;  // protects emulated_
  Pty pty_;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

using PtyDynamixel = PtyDevice<EmulatedDynamixel>;

class PtyPlate : public PtyDevice<HobbyPlate> {
 public:
  explicit PtyPlate(const HobbyPlate::Traits& traits = {}) : PtyDevice(traits) {}

  // Functions that call those of HobbyPlate with the same names.
  void send(const std::string& body) {
    with([&](HobbyPlate& board) { board.send(body); });
  }
  std::vector<std::string> received_lines() { return with(&HobbyPlate::received_lines); }
  bool is_following() { return with(&HobbyPlate::is_following); }
  double orientation_deg() { return with(&HobbyPlate::orientation_deg); }
};

}  // namespace hrt::plate
