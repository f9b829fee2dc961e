#include "samples/app/emulator/hobby_plate.h"

#include <array>

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr auto frame = 20ms;            // period of the pulses
constexpr std::size_t number_size = 6;  // a space and five digits

// The plate whose firmware is running. The firmware's callbacks need it, because they have no argument for user data.
thread_local HobbyPlate* active_plate = nullptr;

}  // namespace

std::string line_of(const std::string& body) {
  std::array<char, LINE_SIZE> line{};
  return {line.data(), line_encode(line.data(), body.c_str())};
}

bool HobbyPlate::send_line(const char* line, std::uint8_t length) {
  if (!active_plate->has_room) return false;
  const std::string_view text(line, length);
  if (text.starts_with("STOPPED heartbeat")) ++active_plate->heartbeat_stops_;
  const Traits& traits = active_plate->traits_;
  if (!traits.answers) return true;
  constexpr std::string_view own = "INFO " PLATE_FIRMWARE_VERSION;
  if (text.starts_with(own)) {
    active_plate->send("INFO " + traits.firmware +
                       std::string(text.substr(own.size(), 7)));  // a space and the serial number
  } else {
    active_plate->output_ += text;
  }
  return true;
}

void HobbyPlate::save(const std::uint8_t*) {
  ++active_plate->saves_;
  active_plate->is_saving_ = true;
}

HobbyPlate::HobbyPlate(Traits traits)
    : servo(traits.servo, traits.orientation_deg), traits_(std::move(traits)), output_(traits_.noise) {
  restart();
}

void HobbyPlate::restart() {
  static constexpr PlateBoard board{send_line, save};
  plate_start(&plate_, &board, &traits_.settings);
}

void HobbyPlate::receive(std::string_view bytes, Time now) {
  run_until(now);
  if (now < traits_.boot_time) return;
  active_plate = this;
  for (const char byte : bytes) {
    plate_receive(&plate_, byte);
    LineError error = LINE_OK;
    if (!line_receive(&reader_, byte, &error) || error != LINE_OK) continue;
    // Removes the sequence number and the token at the end, which have five digits each.
    std::string_view body = reader_.text;
    for (int i = 0; i < 2 && body.size() > 9; ++i) {
      const std::string_view last = body.substr(body.size() - number_size);
      if (last[0] == ' ' && last.find_first_not_of("0123456789", 1) == last.npos) body.remove_suffix(number_size);
    }
    received_.emplace_back(body);
  }
}

void HobbyPlate::run_until(Time now) {
  while (now_ < now) {
    const Time next = (now_ / 1ms + 1) * 1ms;
    const bool ticks = next <= now;
    now_ = std::min(now, next);
    servo.run_until(now_);
    if (ticks && now_ >= traits_.boot_time) tick();
  }
}

void HobbyPlate::tick() {
  active_plate = this;
  const double pin_mv = has_sensor ? servo.sensor_mv() : 0.0;
  inputs_.adc = static_cast<std::int16_t>(std::clamp(std::lround(pin_mv * 1023.0 / 5000.0), 0L, 1023L));
  inputs_.adc = static_cast<std::int16_t>(inputs_.adc - inputs_.adc % converter_step);
  inputs_.supply_adc = static_cast<std::int16_t>(std::lround(servo.supply * 5.0 / 2.0 * 1023.0 / 5.0));
  plate_tick(&plate_, &inputs_);
  if (std::exchange(is_saving_, false)) {
    traits_.settings = plate_.settings;
    plate_saved(&plate_, true);
  }
  const std::uint16_t ticks = plate_pulse_ticks(&plate_);
  if (now_ % frame == 0ms && ticks != 0) servo.receive_pulse(ticks / 2.0, now_);
}

std::vector<std::string> HobbyPlate::take_lines() {
  std::vector<std::string> lines;
  LineBuffer reader{};
  LineError error = LINE_OK;
  for (const char byte : take_output())
    if (line_receive(&reader, byte, &error) && error == LINE_OK) lines.emplace_back(reader.text);
  return lines;
}

}  // namespace hrt::plate
