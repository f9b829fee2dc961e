// A thread that does something again and again.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace hrt::mock {

class Ticker {
 public:
  /// Calls `tick` about once a millisecond, from a thread of its own, until it is destroyed. `tick` must not
  /// wait for what the one who destroys it holds.
  explicit Ticker(std::function<void()> tick) : tick_(std::move(tick)), thread_([this] { run(); }) {}
  ~Ticker() {
    ending_ = true;
    thread_.join();
  }
  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;

 private:
  void run() const {
    for (; !ending_; std::this_thread::sleep_for(std::chrono::milliseconds(1))) tick_();
  }

  std::function<void()> tick_;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace hrt::mock
