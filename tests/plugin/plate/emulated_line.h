#pragma once

#include <algorithm>
#include <deque>
#include <string>

#include "plugin/include/plate_driver/line.h"
#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate {

/// Serial line to an emulated device, in simulated time, which passes in wait(), pause() and the destructor. Each byte
/// takes Device::byte_time(), and the device answers after Device::answer_delay() at the earliest.
template <class Device>
class EmulatedLine : public Line {
 public:
  explicit EmulatedLine(Device& device, const bool& is_unplugged = never)
      : device_(device), is_unplugged_(is_unplugged), now_(device.now()) {}

  /// Delivers the bytes that were sent, as an operating system does when a serial line is closed.
  ~EmulatedLine() override {
    while (!to_device_.empty() && !is_unplugged_) run();
  }
  EmulatedLine(const EmulatedLine&) = delete;
  EmulatedLine& operator=(const EmulatedLine&) = delete;

  Time now() const override { return Time(now_); }
  void receive(std::string& bytes) override {
    check();
    for (; has_arrived(); to_host_.pop_front()) bytes += to_host_.front().byte;
  }
  void send(std::string_view bytes) override {
    check();
    const auto begins = to_device_.empty() ? now_ : std::max(now_, to_device_.back().arrives);
    to_device_.push_back({begins + device_.byte_time() * bytes.size(), std::string(bytes)});
    exchange();
  }
  void flush() override {}
  bool has_unsent() const override { return !to_device_.empty(); }
  void wait(std::chrono::milliseconds limit) override {
    for (const auto end = now_ + limit; now_ < end && !has_arrived();) run();
  }
  /// Lets time pass in which the host does nothing.
  void pause(std::chrono::milliseconds time) {
    for (const auto end = now_ + time; now_ < end;) run();
  }

 private:
  struct Message {
    std::chrono::nanoseconds arrives;
    std::string bytes;
  };
  struct Byte {
    std::chrono::nanoseconds arrives;
    char byte;
  };
  static constexpr bool never = false;
  void check() const {
    if (is_unplugged_) throw PlateFailure(Fault::unplugged, "is unplugged");
  }
  bool has_arrived() const { return !to_host_.empty() && to_host_.front().arrives <= now_; }
  void run() {
    device_.run_until(now_ += std::chrono::microseconds(100));
    exchange();
  }
  void exchange() {
    for (; !to_device_.empty() && to_device_.front().arrives <= now_; to_device_.pop_front()) {
      device_.receive(to_device_.front().bytes, now_);
      free_at_ = std::max(free_at_, now_ + device_.answer_delay());
    }
    for (const char byte : device_.take_output()) {
      free_at_ = std::max(free_at_, now_) + device_.byte_time();
      to_host_.push_back({free_at_, byte});
    }
  }

  Device& device_;
  const bool& is_unplugged_;
  std::chrono::nanoseconds now_, free_at_{0};
  std::deque<Message> to_device_;
  std::deque<Byte> to_host_;
};

}  // namespace hrt::plate
