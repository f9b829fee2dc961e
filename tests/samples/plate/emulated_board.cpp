#include "tests/samples/plate/emulated_board.h"

#include <avr_adc.h>
#include <avr_eeprom.h>
#include <avr_ioport.h>
#include <avr_timer.h>
#include <avr_uart.h>
#include <sim_avr.h>
#include <sim_elf.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace hrt::plate {
namespace {

constexpr std::uint32_t cpu_hz = 16'000'000;
// Cycles of a byte: 11 bits of 17 * 8 cycles, because simavr counts a parity bit that the line does not have.
constexpr std::uint64_t byte_cycles = 11 * 17 * 8;
constexpr std::uint64_t millisecond_cycles = cpu_hz / 1000;
constexpr std::uint32_t supply_mv = 5000;
constexpr std::uint32_t unused_flash = 0x7000;  // address below the bootloader
// Cycles (4 us) that run before simavr checks the peripherals, unless an event of a peripheral is due.
constexpr std::uint64_t free_cycles = 64;
constexpr std::size_t eicra = 0x69;  // register with the modes of the external interrupts

thread_local std::vector<std::string> logged;

void log_error(avr_t*, int level, const char* text, va_list values) {
  if (level > LOG_ERROR) return;
  char line[256];
  std::vsnprintf(line, sizeof line, text, values);
  logged.emplace_back(line);
}

// Does not sleep, because simulated time is not real time.
void do_not_sleep(avr_t*, avr_cycle_count_t) {}

std::chrono::nanoseconds time_of(std::uint64_t cycle) {
  return std::chrono::nanoseconds(cycle * 1'000'000'000 / cpu_hz);
}

}  // namespace

EmulatedBoard::EmulatedBoard(const std::vector<std::uint8_t>& eeprom) : avr_(avr_make_mcu_by_name("atmega328p")) {
  logged.clear();
  avr_global_logger_set(log_error);
  if (avr_ == nullptr || avr_init(avr_) != 0) throw std::runtime_error("simavr has no ATmega328P");
  elf_firmware_t firmware{};
  if (elf_read_firmware(HRT_FIRMWARE_ELF, &firmware) != 0) throw std::runtime_error("no firmware at " HRT_FIRMWARE_ELF);
  firmware.frequency = cpu_hz;
  avr_load_firmware(avr_, &firmware);
  avr_->frequency = cpu_hz;
  avr_->vcc = avr_->avcc = avr_->aref = supply_mv;
  avr_->sleep = do_not_sleep;

  if (!eeprom.empty()) {
    auto bytes = eeprom;
    avr_eeprom_desc_t all{bytes.data(), 0, static_cast<std::uint32_t>(bytes.size())};
    avr_ioctl(avr_, AVR_IOCTL_EEPROM_SET, &all);
  }
  std::uint32_t flags = 0;  // simavr's serial line neither sleeps nor copies the bytes to the terminal
  avr_ioctl(avr_, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
  start_line();
  open_emergency_stop(false);
  set_supply_mv(supply_mv);
  avr_irq_register_notify(avr_io_getirq(avr_, AVR_IOCTL_TIMER_GETIRQ('1'), TIMER_IRQ_OUT_COMP), take_edge, this);
  avr_irq_register_notify(avr_io_getirq(avr_, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), take_byte, this);
}

EmulatedBoard::~EmulatedBoard() {
  avr_terminate(avr_);
  std::free(avr_);
}

std::chrono::nanoseconds EmulatedBoard::now() const { return time_of(avr_->cycle); }

void EmulatedBoard::run_until(std::chrono::nanoseconds time) {
  const std::uint64_t end = static_cast<std::uint64_t>(time.count()) * (cpu_hz / 1'000'000) / 1000;
  while (avr_->cycle < end) {
    const int state = avr_run(avr_);
    if (state == cpu_Crashed || state == cpu_Done) throw std::runtime_error("the firmware has crashed");
  }
}

void EmulatedBoard::run_for(std::chrono::nanoseconds time) { run_until(now() + time); }

void EmulatedBoard::receive_line(std::string_view body) { send(encode_line(std::string(body))); }

std::string EmulatedBoard::take_output() {
  std::string output;
  output.swap(output_);
  return output;
}

std::vector<std::string> EmulatedBoard::take_lines() {
  std::vector<std::string> lines;
  LineError error = LINE_OK;
  for (const char byte : take_output())
    if (line_receive(&buffer_, byte, &error) && error == LINE_OK) lines.emplace_back(buffer_.text);
  return lines;
}

void EmulatedBoard::reset() {
  avr_reset(avr_);
  high_ = false;  // the pin floats in a reset
  start_line();
}

// Jumps to an endless loop, an rjmp to itself.
void EmulatedBoard::hang() {
  avr_->flash[unused_flash] = 0xFF;
  avr_->flash[unused_flash + 1] = 0xCF;
  avr_->pc = unused_flash;
}

void EmulatedBoard::open_emergency_stop(bool open) {
  avr_ioport_external_t pin{};
  pin.name = 'D';
  pin.mask = 1U << 2;
  pin.value = open ? 1U << 2 : 0U;
  avr_ioctl(avr_, AVR_IOCTL_IOPORT_SET_EXTERNAL('D'), &pin);
  avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_IOPORT_GETIRQ('D'), 2), open ? 1 : 0);
}

void EmulatedBoard::set_feedback_mv(std::uint32_t millivolts) {
  avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0), millivolts);
}

void EmulatedBoard::set_supply_mv(std::uint32_t millivolts) {
  avr_raise_irq(avr_io_getirq(avr_, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC1), millivolts / 2);
}

std::vector<std::uint8_t> EmulatedBoard::eeprom() const {
  std::vector<std::uint8_t> bytes(1024);
  avr_eeprom_desc_t all{bytes.data(), 0, static_cast<std::uint32_t>(bytes.size())};
  avr_ioctl(avr_, AVR_IOCTL_EEPROM_GET, &all);
  return bytes;
}

std::uint8_t EmulatedBoard::extended_fuse() const { return avr_->fuse[2]; }

const std::vector<std::string>& EmulatedBoard::simulator_errors() const { return logged; }

void EmulatedBoard::take_edge(avr_irq_t*, std::uint32_t value, void* board) {
  auto& self = *static_cast<EmulatedBoard*>(board);
  const bool high = (value & 1) != 0;
  if (high == self.high_) return;
  self.high_ = high;
  if (high) {
    self.rose_at_ = self.avr_->cycle;
    return;
  }
  self.pulses_.push_back({time_of(self.rose_at_), time_of(self.avr_->cycle) - time_of(self.rose_at_)});
  if (self.on_pulse) self.on_pulse(self.pulses_.back());
}

void EmulatedBoard::take_byte(avr_irq_t*, std::uint32_t value, void* board) {
  static_cast<EmulatedBoard*>(board)->output_ += static_cast<char>(value);
}

void EmulatedBoard::start_line() {
  avr_->run_cycle_limit = free_cycles;
  // Sets the external interrupt of pin D2 to falling edges. In its initial mode, low level, simavr checks the pin in
  // every cycle even if the interrupt is off, which is slow.
  avr_->data[eicra] = 2;
  avr_cycle_timer_register(avr_, byte_cycles, deliver_byte, this);
  avr_cycle_timer_register(avr_, millisecond_cycles, pass_millisecond, this);
}

// Delivers a byte. During a reset the receiver is off, and the byte is lost as on a real line.
std::uint64_t EmulatedBoard::deliver_byte(avr_t* avr, std::uint64_t when, void* board) {
  auto& self = *static_cast<EmulatedBoard*>(board);
  if (!self.to_board_.empty()) {
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT),
                  static_cast<unsigned char>(self.to_board_.front()));
    self.to_board_.erase(0, 1);
  }
  return when + byte_cycles;
}

std::uint64_t EmulatedBoard::pass_millisecond(avr_t*, std::uint64_t when, void* board) {
  auto& self = *static_cast<EmulatedBoard*>(board);
  if (self.on_millisecond) self.on_millisecond();
  return when + millisecond_cycles;
}

}  // namespace hrt::plate
