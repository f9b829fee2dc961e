// Line to an emulated device, in simulated time.
#pragma once

#include <algorithm>
#include <deque>
#include <string>

#include "plugin/include/plate_driver/line.h"
#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate {

/// Line in which time passes only in wait() and pause(). A byte takes byte_time() in both directions; a device answers
/// after answer_delay() at the earliest.
template <class Device>
class EmulatedLine : public Line {
 public:
  explicit EmulatedLine(Device& device, const bool& is_unplugged = never)
      : device_(device), is_unplugged_(is_unplugged), now_(device.now()) {}

  /// Delivers the bytes that were sent, as a system empties its buffers when a line is closed.
  ~EmulatedLine() override {
    while (!going_.empty() && !is_unplugged_) run();
  }
  EmulatedLine(const EmulatedLine&) = delete;
  EmulatedLine& operator=(const EmulatedLine&) = delete;

  Time now() const override { return Time(now_); }
  void receive(std::string& bytes) override {
    check();
    for (; has_arrived(); coming_.pop_front()) bytes += coming_.front().byte;
  }
  void send(std::string_view bytes) override {
    check();
    const auto begins = going_.empty() ? now_ : std::max(now_, going_.back().arrives);
    going_.push_back({begins + device_.byte_time() * bytes.size(), std::string(bytes)});
    exchange();
  }
  void flush() override {}
  bool has_unsent() const override { return !going_.empty(); }
  void wait(std::chrono::milliseconds limit) override {
    for (const auto end = now_ + limit; now_ < end && !has_arrived();) run();
  }
  /// Lets time pass while the host does nothing.
  void pause(std::chrono::milliseconds time) {
    for (const auto end = now_ + time; now_ < end;) run();
  }

 private:
  struct Going {
    std::chrono::nanoseconds arrives;
    std::string bytes;
  };
  struct Coming {
    std::chrono::nanoseconds arrives;
    char byte;
  };
  static constexpr bool never = false;
  void check() const {
    if (is_unplugged_) throw PlateFailure(Fault::unplugged, "is unplugged");
  }
  bool has_arrived() const { return !coming_.empty() && coming_.front().arrives <= now_; }
  void run() {
    device_.run_until(now_ += std::chrono::microseconds(100));
    exchange();
  }
  void exchange() {
    for (; !going_.empty() && going_.front().arrives <= now_; going_.pop_front()) {
      device_.receive(going_.front().bytes, now_);
      free_at_ = std::max(free_at_, now_ + device_.answer_delay());
    }
    for (const char byte : device_.take_output()) {
      free_at_ = std::max(free_at_, now_) + device_.byte_time();
      coming_.push_back({free_at_, byte});
    }
  }

  Device& device_;
  const bool& is_unplugged_;
  std::chrono::nanoseconds now_, free_at_{0};
  std::deque<Going> going_;
  std::deque<Coming> coming_;
};

}  // namespace hrt::plate
