#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/include/plate_driver/plate_text.h"
#include "plugin/src/plate/plate_line.h"

struct avr_t;
struct avr_irq_t;

namespace hrt::plate {

/// Pulse to the servo, in simulated time since power-on.
struct Pulse {
  std::chrono::nanoseconds start;
  std::chrono::nanoseconds width;

  double width_us() const { return static_cast<double>(width.count()) / 1000.0; }
};

/// Board of a plate in simavr, in simulated time: runs the ELF file of the firmware, with its serial line and its pins.
class EmulatedBoard {
 public:
  /// Powers the board on, with the contact of the emergency stop closed. An empty `eeprom` is an erased one.
  explicit EmulatedBoard(const std::vector<std::uint8_t>& eeprom = {});
  ~EmulatedBoard();
  EmulatedBoard(const EmulatedBoard&) = delete;
  EmulatedBoard& operator=(const EmulatedBoard&) = delete;

  std::chrono::nanoseconds now() const;
  void run_for(std::chrono::nanoseconds time);
  void run_until(std::chrono::nanoseconds time);

  /// Sends bytes to the board at the speed of the serial line. Ignores the time, which EmulatedLine passes.
  void receive(std::string_view bytes, std::chrono::nanoseconds) { send(bytes); }
  void send(std::string_view bytes) { to_board_.append(bytes); }
  /// EmulatedLine adds no delays, because simavr simulates the speed of the serial line.
  static std::chrono::nanoseconds byte_time() { return {}; }
  static std::chrono::nanoseconds answer_delay() { return {}; }
  void receive_line(std::string_view body);
  /// True while bytes are on the way to the board.
  bool is_sending() const { return !to_board_.empty(); }
  /// Returns the bytes that the board sent since the last call.
  std::string take_output();
  /// Returns the bodies of the valid lines that the board sent since the last call.
  std::vector<std::string> take_lines();

  /// Returns all pulses that have ended so far.
  const std::vector<Pulse>& pulses() const { return pulses_; }

  /// Resets the board, which keeps its EEPROM, as a brown-out or the opening of the serial line does.
  void reset();
  /// Simulates a main loop that hangs: jumps to an endless loop, in which interrupts still run.
  void hang();
  void open_emergency_stop(bool open);
  /// Sets the voltage at the sensor's pin.
  void set_feedback_mv(std::uint32_t millivolts);
  /// Sets the voltage of the servo's supply; a divider applies half of it to A1.
  void set_supply_mv(std::uint32_t millivolts);
  std::vector<std::uint8_t> eeprom() const;
  /// Returns the extended fuse that the ELF file declares.
  std::uint8_t extended_fuse() const;
  /// Returns the errors that simavr has logged.
  const std::vector<std::string>& simulator_errors() const;

  /// Functions that are called after every pulse and every millisecond, for a simulated servo.
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
  LineBuffer buffer_{};
  bool high_ = false;
  std::uint64_t rose_at_ = 0;
  std::vector<Pulse> pulses_;
};

}  // namespace hrt::plate
