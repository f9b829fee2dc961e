// The board of a plate in simavr: the firmware's own ELF, its serial line, its servo pin, in simulated time.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/src/plate/plate_line.h"

struct avr_t;
struct avr_irq_t;

namespace hrt::plate {

/// One pulse to the servo, in simulated time since power-on.
struct Pulse {
  std::chrono::nanoseconds start;
  std::chrono::nanoseconds width;

  double width_us() const { return static_cast<double>(width.count()) / 1000.0; }
};

class EmulatedBoard {
 public:
  /// Power-on with this EEPROM (empty: erased), and the emergency stop's contact closed.
  explicit EmulatedBoard(const std::vector<std::uint8_t>& eeprom = {});
  ~EmulatedBoard();
  EmulatedBoard(const EmulatedBoard&) = delete;
  EmulatedBoard& operator=(const EmulatedBoard&) = delete;

  std::chrono::nanoseconds now() const;
  void run_for(std::chrono::nanoseconds time);
  void run_until(std::chrono::nanoseconds time);

  /// Bytes for the board, which get there at the line's speed, whatever the time.
  void hear(std::string_view bytes, std::chrono::nanoseconds) { send(bytes); }
  void send(std::string_view bytes) { to_board_.append(bytes); }
  /// Its bytes, too, come at the line's speed.
  static std::chrono::nanoseconds byte_time() { return {}; }
  static std::chrono::nanoseconds answer_delay() { return {}; }
  /// A line of protocol 2 with this body.
  void say(std::string_view body);
  /// True if bytes are on their way to the board.
  bool is_sending() const { return !to_board_.empty(); }
  /// What the board sent since the last call.
  std::string take_output();
  /// The bodies of the valid lines that ended since then.
  std::vector<std::string> take_lines();

  /// All pulses that have ended so far.
  const std::vector<Pulse>& pulses() const { return pulses_; }

  /// A reset that keeps the memory, as by a brown-out or the host's opening of the line.
  void reset();
  /// The main loop does nothing more.
  void hang();
  void open_emergency_stop(bool open);
  /// Voltage at the potentiometer's pin.
  void set_feedback_mv(std::uint32_t millivolts);
  /// Voltage of the servo's supply, of which a divider shows half at A1.
  void set_supply_mv(std::uint32_t millivolts);
  std::vector<std::uint8_t> eeprom() const;
  /// Its extended fuse, as the ELF declares it.
  std::uint8_t extended_fuse() const;
  /// What simavr had to complain about.
  const std::vector<std::string>& complaints() const;

  /// Run after every pulse, and every millisecond: for a servo.
  std::function<void(const Pulse&)> on_pulse;
  std::function<void()> on_millisecond;

 private:
  static void take_edge(avr_irq_t* irq, std::uint32_t value, void* board);
  static void take_byte(avr_irq_t* irq, std::uint32_t value, void* board);
  static std::uint64_t deliver_byte(avr_t* avr, std::uint64_t when, void* board);
  static std::uint64_t pass_millisecond(avr_t* avr, std::uint64_t when, void* board);
  void start_line();

  avr_t* avr_;
  std::string to_board_;
  std::string output_;
  LineReader reader_;
  bool high_ = false;
  std::uint64_t rose_at_ = 0;
  std::vector<Pulse> pulses_;
};

}  // namespace hrt::plate
