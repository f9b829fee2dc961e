#include "samples/app/emulator/dynamixel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrt::plate {
namespace {

using namespace dynamixel;
using namespace std::chrono_literals;

constexpr int eeprom_end = 64;
constexpr int homing_offset = 20, torque_enable = 64, bus_watchdog = 98, goal_current = 102, profile_acceleration = 108,
              profile_velocity = 112, goal_position = 116, present_position = 132;

// Entry of the control table that may be written, with its size in bytes and the range of its values.
struct Writable {
  int address;
  int size;
  std::int64_t min;
  std::int64_t max;
};

}  // namespace

EmulatedDynamixel::EmulatedDynamixel(std::uint8_t id, int model, const ServoTraits& traits) : motor(traits), id_(id) {
  set(0, 2, model);
  set(6, 1, 52);
  set(7, 1, id);
  set(8, 1, 1);
  set(9, 1, 250);
  set(11, 1, 3);
  set(38, 2, 1750);
  set(44, 4, 445);
  restart();
}

void EmulatedDynamixel::restart() {
  std::fill(table_.begin() + eeprom_end, table_.end(), std::uint8_t{0});
  set(68, 1, 2);
  set(144, 2, 50);  // 5 V
  set(146, 1, 31);
  set(goal_current, 2, get(38, 2));
  turns_ = static_cast<int>(std::floor((motor.plate_deg() + 180.0) / 360.0));
  motor.set_goal(std::nullopt, now_);
  set(goal_position, 4, present(motor.plate_deg()));
  set(present_position, 4, present(motor.plate_deg()));
}

// Returns the effective homing offset. In position mode the servo ignores offsets of more than a quarter turn.
std::int64_t EmulatedDynamixel::homing() const {
  const std::int64_t offset = get(homing_offset, 4);
  return get(11, 1) == 3 && std::abs(offset) > 1024 ? 0 : offset;
}

std::int64_t EmulatedDynamixel::present(double reading_deg) const {
  const double sign = (get(10, 1) & 1) != 0 ? -1.0 : 1.0;
  const auto steps = std::lround(sign * reading_deg * 4096.0 / 360.0) + 2048;
  // The servo counts turns from power-on.
  return steps - turns_ * 4096 + homing();
}

std::int64_t EmulatedDynamixel::get(int address, int size) const {
  return number_at(
      {reinterpret_cast<const char*>(&table_.at(static_cast<std::size_t>(address))), static_cast<std::size_t>(size)}, 0,
      size);
}

void EmulatedDynamixel::set(int address, int size, std::int64_t value) {
  const std::string bytes = little_endian(value, size);
  std::copy(bytes.begin(), bytes.end(), table_.begin() + address);
}

std::string EmulatedDynamixel::take_output() { return std::exchange(output_, {}); }

void EmulatedDynamixel::receive(std::string_view bytes, Time now) {
  run_until(now);
  reader_.append(bytes);
  if (echoes) output_ += bytes;
  while (const auto packet = reader_.next()) {
    if (packet->id != id_ || packet->instruction == status) continue;
    received_ = now;
    if (is_silent) continue;
    std::string reply = answer(*packet);
    if (damages_length && ++answers_ % 25 == 0) reply[5] = static_cast<char>(damages_length);
    if (damages_answers && ++answers_ % 2 == 0) reply.back() = static_cast<char>(reply.back() ^ 0x55);
    output_ += reply;
  }
}

std::string EmulatedDynamixel::answer(const Packet& packet) {
  Packet reply{.id = id_, .instruction = status};
  const std::string& given = packet.parameters;
  auto error = StatusError::none;
  if (forced_error != 0) {
    error = static_cast<StatusError>(forced_error);
  } else if (packet.instruction == ping) {
    reply.parameters = little_endian(get(0, 2), 2) + little_endian(get(6, 1), 1);
  } else if (packet.instruction == dynamixel::read && given.size() == 4) {
    const auto address = static_cast<std::size_t>(number_at(given, 0, 2)),
               size = static_cast<std::size_t>(number_at(given, 2, 2));
    if (address + size > table_.size()) {
      error = StatusError::access;
    } else {
      reply.parameters.assign(table_.begin() + static_cast<std::ptrdiff_t>(address),
                              table_.begin() + static_cast<std::ptrdiff_t>(address + size));
    }
  } else if (packet.instruction == dynamixel::write && given.size() > 2) {
    error = write(given);
  } else {
    error = StatusError::instruction;
  }
  reply.error = static_cast<std::uint8_t>(error) | (get(70, 1) != 0 ? Packet::alert : 0);
  return encode(reply);
}

StatusError EmulatedDynamixel::write(std::string_view parameters) {
  const int address = static_cast<int>(number_at(parameters, 0, 2)), size = static_cast<int>(parameters.size()) - 2;
  const std::int64_t value = number_at(parameters, 2, size);
  const std::int64_t max_current = get(38, 2);
  const std::array<Writable, 9> writable = {{{10, 1, 0, 13},
                                             {11, 1, 0, 16},
                                             {homing_offset, 4, -1'044'479, 1'044'479},
                                             {torque_enable, 1, 0, 1},
                                             {bus_watchdog, 1, 0, 127},
                                             {goal_current, 2, -max_current, max_current},
                                             {profile_acceleration, 4, 0, 32767},
                                             {profile_velocity, 4, 0, 32767},
                                             {goal_position, 4, -1'048'575, 1'048'575}}};
  const auto found =
      std::find_if(writable.begin(), writable.end(), [&](const Writable& entry) { return entry.address == address; });
  if (found == writable.end()) return StatusError::access;
  if (size > found->size) {  // a write of several adjacent entries
    const std::string_view rest = parameters.substr(static_cast<std::size_t>(2 + found->size));
    const StatusError error = write(parameters.substr(0, static_cast<std::size_t>(2 + found->size)));
    return error != StatusError::none ? error : write(little_endian(address + found->size, 2) + std::string(rest));
  }
  if (found->size != size) return StatusError::data_length;
  if (address < eeprom_end && get(torque_enable, 1) != 0) return StatusError::access;
  if (value < found->min || value > found->max) return StatusError::data_range;
  // After the watchdog has expired, the goals and the profile are read-only.
  if (get(bus_watchdog, 1) == -1 && address >= goal_current && address <= goal_position) return StatusError::data_range;
  if (address < eeprom_end) ++writes_to_eeprom_;
  set(address, size, value);
  if (address == torque_enable && value == 1) set(goal_position, 4, present(motor.plate_deg()));
  if (address == 11) {
    set(goal_current, 2, max_current);
    set(profile_velocity, 4, 0);
  }
  return StatusError::none;
}

void EmulatedDynamixel::run_until(Time now) {
  const std::int64_t watchdog = get(bus_watchdog, 1);
  if (watchdog > 0 && now - received_ > watchdog * 20ms) {
    set(bus_watchdog, 1, -1);
    set(profile_velocity, 4, 0);
    set(profile_acceleration, 4, 0);
    set(goal_position, 4, present(motor.plate_deg()));
  }
  now_ = now;
  // Drive mode (address 10): bit 0 reverses the direction; with bit 2, the profile velocity is a duration in ms.
  const auto profile = static_cast<double>(get(profile_velocity, 4));
  const double sign = (get(10, 1) & 1) != 0 ? -1.0 : 1.0;
  const auto goal_steps = sign * static_cast<double>(get(goal_position, 4) - homing() + turns_ * 4096 - 2048);
  const double travel_deg = std::abs(goal_steps * 360.0 / 4096.0 - motor.plate_deg());
  if (get(goal_position, 4) != std::exchange(last_goal_, get(goal_position, 4)) || (get(10, 1) & 4) == 0)
    motor.limit_speed(profile == 0.0          ? 1e9
                      : (get(10, 1) & 4) != 0 ? travel_deg / profile * 1000.0
                                              : profile * 0.229 * 6.0);
  motor.set_goal(get(torque_enable, 1) == 1 ? std::optional(goal_steps * 360.0 / 4096.0) : std::nullopt, now);
  motor.run_until(now);
  set(present_position, 4, present(motor.reading_deg()));
}

}  // namespace hrt::plate
