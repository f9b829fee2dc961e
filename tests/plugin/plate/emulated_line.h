// A line straight to an emulated device, in simulated time.
#pragma once

#include <algorithm>
#include <deque>

#include "plugin/src/plate/line.h"

namespace hrt::plate {

/// Time passes in wait() and pause() alone. A device hears bytes at once, answers no sooner than
/// answers_after() their number, and sends a byte in byte_time().
template <class Device>
class EmulatedLine : public Line {
 public:
  explicit EmulatedLine(Device& device) : device_(device), now_(device.now()) {}

  Time now() const override { return Time(now_); }
  void receive(std::string& bytes) override {
    for (; has_arrived(); coming_.pop_front()) bytes += coming_.front().byte;
  }
  void send(std::string_view bytes) override {
    device_.hear(bytes, now_);
    free_at_ = std::max(free_at_, now_ + device_.answers_after(bytes.size()));
    collect();
  }
  void flush() override {}
  bool has_unsent() const override { return false; }
  void wait(std::chrono::milliseconds limit) override {
    for (const auto end = now_ + limit; now_ < end && !has_arrived();) run();
  }
  /// The host does nothing.
  void pause(std::chrono::milliseconds time) {
    for (const auto end = now_ + time; now_ < end;) run();
  }

 private:
  struct Coming {
    std::chrono::nanoseconds arrives;
    char byte;
  };
  bool has_arrived() const { return !coming_.empty() && coming_.front().arrives <= now_; }
  void run() {
    device_.run_until(now_ += std::chrono::microseconds(100));
    collect();
  }
  void collect() {
    for (const char byte : device_.take_output()) {
      free_at_ = std::max(free_at_, now_) + device_.byte_time();
      coming_.push_back({free_at_, byte});
    }
  }

  Device& device_;
  std::chrono::nanoseconds now_, free_at_{0};
  std::deque<Coming> coming_;
};

}  // namespace hrt::plate
