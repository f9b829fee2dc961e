// An XL330 or XL430 servo under the plate, by the control tables of their e-manuals. Position 2048, the
// middle of the servo's turn, is orientation 0; the horn points up, so that counter-clockwise is positive.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "samples/plate/driver/device.h"
#include "samples/plate/driver/dynamixel_packet.h"
#include "samples/plate/driver/plate_failure.h"
#include "samples/plate/driver/plate_watch.h"
#include "samples/plate/driver/serial_line.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;
using namespace dynamixel;

// An entry of the control table.
struct Entry {
  int address;
  int size;
};
constexpr Entry operating_mode{11, 1}, pwm_limit{36, 2}, current_limit{38, 2}, velocity_limit{44, 4},
    max_position_limit{48, 4}, min_position_limit{52, 4}, torque_enable{64, 1}, hardware_error{70, 1},
    bus_watchdog{98, 1}, goal_pwm{100, 2}, goal_current{102, 2}, profile_velocity{112, 4},
    goal_position{116, 4}, present_position{132, 4};

struct Model {
  int number;
  const char* name;
  bool limits_current;  // in its current-based position mode; else by PWM in position mode
};
constexpr std::array models = {Model{1190, "XL330-M077", true}, Model{1200, "XL330-M288", true},
                               Model{1060, "XL430-W250", false}};
constexpr int position_mode = 3, current_based_position_mode = 5;

constexpr double deg_per_step = 360.0 / 4096.0;
constexpr int middle_step = 2048;
constexpr double deg_s_per_unit = 0.229 * 6.0;  // 0.229 revolutions a minute
constexpr double turn_stop_deg = 179.9;         // of one turn's 4096 steps
constexpr int watchdog_ticks = 15;              // of 20 ms
constexpr int watchdog_expired = -1;
constexpr auto poll_period = 20ms;
constexpr auto answer_limit = 60ms;  // 48 bytes at 57600 baud are 9 ms
constexpr auto silence_limit = 500ms;
constexpr int probes = 11;
constexpr int most_tries = 10;  // of an exchange on a disturbed line, while the servo is set up
// The servo's own: its control loop runs every millisecond.
constexpr auto servo_latency = 2ms;

struct Settings {
  std::uint8_t id;
  double speed_deg_s;
  int effort_percent;
};

class Servo : public Device {
 public:
  Servo(std::unique_ptr<Line> line, const Settings& settings) : line_(std::move(line)), settings_(settings) {
    identify();
    set_up();
    watch_.emplace(PlateGreeting{Version::two, least_deg_, most_deg_, speed_deg_s(), 0.0, true},
                   line_->now());
    for (int i = 0; i < probes; ++i) take_position(read_entry(present_position));
    write_entry(goal_position, step_of(*orientation_deg_));
    write_entry(torque_enable, 1);
    write_entry(bus_watchdog, watchdog_ticks);
  }

  ~Servo() override { stop_if_heard(); }
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  std::string description() const override {
    return std::string("Dynamixel ") + model_->name + ", id " + std::to_string(settings_.id) + ", firmware " +
           std::to_string(firmware_);
  }
  DeviceLimits limits() const override {
    return {least_deg_, most_deg_, std::min(speed_deg_s(), watch_->speed_deg_s().value_or(speed_deg_s())),
            servo_latency + round_trip().value_or(0ns) / 2};
  }
  bool is_measured() const override { return true; }
  std::optional<std::chrono::nanoseconds> round_trip() const override { return round_trips_.median(); }
  std::optional<double> orientation_deg() const override { return orientation_deg_; }
  Line::Time reported() const override { return reported_; }
  std::uint64_t refusals() const override { return refusals_ + reader_.damaged(); }

  void wait(std::chrono::milliseconds limit) override {
    try {
      line_->wait(limit);
      exchange();
    } catch (const PlateFailure&) {
      stop_if_heard();
      throw;
    }
  }

  void turn_to(double orientation_deg) override {
    const int step = step_of(orientation_deg);
    if (goal_step_ == step) return;
    goal_step_ = step;
    is_goal_sent_ = false;
    watch_->commanded(deg_of(step));
  }

  void stop() override {
    goal_step_.reset();
    is_goal_sent_ = true;
    watch_->stopped();
    must_stop_ = true;
  }

 private:
  static double deg_of(std::int64_t step) { return static_cast<double>(step - middle_step) * deg_per_step; }
  int step_of(double orientation_deg) const {
    return middle_step +
           static_cast<int>(std::lround(std::clamp(orientation_deg, least_deg_, most_deg_) / deg_per_step));
  }
  std::int64_t speed_units() const {
    return std::clamp<std::int64_t>(std::llround(settings_.speed_deg_s / deg_s_per_unit), 1, fastest_units_);
  }
  double speed_deg_s() const { return static_cast<double>(speed_units()) * deg_s_per_unit; }

  // ---- One exchange after the other, before the servo may turn.

  // Adapters and servos need a moment after the line is opened.
  void identify() {
    for (const auto give_up = line_->now() + 3s; line_->now() <= give_up;) {
      const std::optional<Packet> answer = try_once({.id = settings_.id, .instruction = ping});
      if (answer && (answer->error & ~Packet::alert) == 0) {
        take_model(*answer);
        return;
      }
    }
    throw PlateFailure(Fault::no_answer, "does not answer as a Dynamixel of id " +
                                             std::to_string(settings_.id) + " within 3 s");
  }

  void take_model(const Packet& answer) {
    const std::int64_t number = number_at(answer.parameters, 0, 2);
    firmware_ = static_cast<int>(static_cast<unsigned char>(answer.parameters[2]));
    const auto found = std::find_if(models.begin(), models.end(),
                                    [&](const Model& model) { return model.number == number; });
    if (found == models.end())
      throw PlateFailure(Fault::no_answer, "is a Dynamixel of model number " + std::to_string(number) +
                                               "; known are 1060 (XL430-W250), 1190 and 1200 (XL330)");
    model_ = &*found;
  }

  // The mode is kept in memory that wears: it is written only if it is another one.
  void set_up() {
    check_hardware(read_entry(hardware_error));
    write_entry(bus_watchdog, 0);
    write_entry(torque_enable, 0);
    const int mode = model_->limits_current ? current_based_position_mode : position_mode;
    if (read_entry(operating_mode) != mode) write_entry(operating_mode, mode);
    fastest_units_ = std::max<std::int64_t>(1, read_entry(velocity_limit));
    effort_ = read_entry(model_->limits_current ? current_limit : pwm_limit) * settings_.effort_percent / 100;
    for (const auto& [entry, value] : motion_entries()) write_entry(entry, value);
    if (mode == position_mode) take_stops();
  }

  // Which hold in position mode alone.
  void take_stops() {
    least_deg_ = std::max(least_deg_, deg_of(read_entry(min_position_limit)));
    most_deg_ = std::min(most_deg_, deg_of(read_entry(max_position_limit)));
    if (least_deg_ >= most_deg_)
      throw PlateFailure(Fault::device, "has position limits with nothing between");
  }

  // The servo forgets them when its watchdog stops it.
  std::array<std::pair<Entry, std::int64_t>, 2> motion_entries() const {
    return {{{profile_velocity, speed_units()}, {model_->limits_current ? goal_current : goal_pwm, effort_}}};
  }

  std::int64_t read_entry(Entry entry) {
    return number_at(transact(read_packet(entry)).parameters, 0, entry.size);
  }
  void write_entry(Entry entry, std::int64_t value) { transact(write_packet(entry, value)); }

  Packet transact(const Packet& packet) {
    for (int i = 0; i < most_tries; ++i) {
      const std::optional<Packet> answer = try_once(packet);
      if (!answer) continue;
      const auto error = static_cast<StatusError>(answer->error & ~Packet::alert);
      if (error == StatusError::none) return *answer;
      if (error != StatusError::crc)
        throw PlateFailure(Fault::protocol, describe(packet) + ": " + name_of(error));
      ++refusals_;
    }
    throw PlateFailure(Fault::silent, "does not answer");
  }

  std::optional<Packet> try_once(const Packet& packet) {
    send(packet);
    while (waits_for_answer()) {
      line_->wait(5ms);
      if (std::optional<Packet> answer = answer_to_last()) return answer;
    }
    pass_over_late_answer();
    return std::nullopt;
  }

  // It would be taken for that of the next request.
  void pass_over_late_answer() {
    is_answered_ = true;
    for (const auto end = line_->now() + answer_limit; line_->now() < end;) {
      line_->wait(5ms);
      answer_to_last();
    }
  }

  // ---- In motion: one request is on its way at a time.

  void exchange() {
    if (const std::optional<Packet> answer = answer_to_last()) take(*answer);
    if (!is_answered_ && !waits_for_answer()) give_up_waiting();
    if (silent_since_ && line_->now() - *silent_since_ > silence_limit)
      throw PlateFailure(Fault::silent, "has not been heard for half a second");
    if (waits_for_answer()) return;
    if (must_stop_ || !is_goal_sent_) {
      send_goal();
    } else if (line_->now() - asked_ >= poll_period) {
      send(poll_packet());
    }
    line_->flush();
  }

  void take(const Packet& answer) {
    const Packet request = last_;
    const auto error = static_cast<StatusError>(answer.error & ~Packet::alert);
    if ((answer.error & Packet::alert) != 0) check_hardware(read_entry(hardware_error));
    if (error == StatusError::crc) {
      ++refusals_;
      if (request.instruction == write) repeat_goal();
      return;
    }
    if (error == StatusError::data_range && request.instruction == write) {
      recover_from_watchdog();
      return;
    }
    if (error != StatusError::none)
      throw PlateFailure(Fault::protocol, describe(request) + ": " + name_of(error));
    if (request.instruction != read) return;
    const std::size_t watchdog_at = 0, position_at = present_position.address - bus_watchdog.address;
    const std::int64_t watchdog = number_at(answer.parameters, watchdog_at, 1);
    if (watchdog == 0) throw PlateFailure(Fault::restarted, "has restarted: its supply or its line failed");
    if (watchdog == watchdog_expired) recover_from_watchdog();
    take_position(number_at(answer.parameters, position_at, 4));
  }

  void take_position(std::int64_t step) {
    orientation_deg_ = deg_of(step);
    reported_ = line_->now();
    watch_->reported(reported_, *orientation_deg_);
  }

  // The host paused for longer than the watchdog allows: the servo has stopped, and takes no goal.
  void recover_from_watchdog() {
    write_entry(bus_watchdog, 0);
    for (const auto& [entry, value] : motion_entries()) write_entry(entry, value);
    write_entry(bus_watchdog, watchdog_ticks);
    repeat_goal();
  }

  // The request or its answer was lost: a goal is sent again.
  void give_up_waiting() {
    is_answered_ = true;
    if (last_.instruction == write) repeat_goal();
  }

  void repeat_goal() {
    if (goal_step_) is_goal_sent_ = false;
    must_stop_ = !goal_step_;
  }

  void send_goal() {
    if (must_stop_) {
      send_stop();
      return;
    }
    is_goal_sent_ = true;
    send(write_packet(goal_position, *goal_step_));
  }

  void send_stop() {
    must_stop_ = false;
    if (orientation_deg_) send(write_packet(goal_position, step_of(*orientation_deg_)));
  }

  // After the answer that is on its way: two do not speak at once on this line. If the servo does not hear,
  // its own watchdog stops it.
  void stop_if_heard() {
    try {
      while (waits_for_answer() && !answer_to_last()) line_->wait(5ms);
      send_stop();
      while (waits_for_answer() && !answer_to_last()) {
        line_->wait(5ms);
        line_->flush();
      }
    } catch (const PlateFailure&) {
      return;
    }
  }

  static void check_hardware(std::int64_t bits) {
    if (bits == 0) return;
    static constexpr std::array<std::pair<int, const char*>, 5> names = {{{0x01, "input voltage"},
                                                                          {0x04, "overheating"},
                                                                          {0x08, "motor encoder"},
                                                                          {0x10, "electrical shock"},
                                                                          {0x20, "overload"}}};
    std::string text;
    for (const auto& [bit, name] : names)
      if ((bits & bit) != 0) text += (text.empty() ? "" : ", ") + std::string(name);
    throw PlateFailure(Fault::device, "reports a hardware error: " + (text.empty() ? "unknown" : text) +
                                          "; it needs a restart");
  }

  // ---- Packets.

  Packet read_packet(Entry entry) const {
    return {.id = settings_.id,
            .instruction = read,
            .parameters = little_endian(entry.address, 2) + little_endian(entry.size, 2)};
  }
  Packet write_packet(Entry entry, std::int64_t value) const {
    return {.id = settings_.id,
            .instruction = write,
            .parameters = little_endian(entry.address, 2) + little_endian(value, entry.size)};
  }
  // Watchdog and position, and what lies between, in one answer.
  Packet poll_packet() const {
    const int size = present_position.address + present_position.size - bus_watchdog.address;
    return read_packet({bus_watchdog.address, size});
  }

  // Without an error.
  static std::size_t size_of_answer(const Packet& request) {
    constexpr std::size_t model_and_firmware = 3;
    if (request.instruction == ping) return model_and_firmware;
    return request.instruction == read ? static_cast<std::size_t>(number_at(request.parameters, 2, 2)) : 0;
  }

  static std::string describe(const Packet& packet) {
    if (packet.instruction == ping) return "answers a ping with";
    return std::string(packet.instruction == read ? "refuses to have address " : "refuses to set address ") +
           std::to_string(number_at(packet.parameters, 0, 2)) + (packet.instruction == read ? " read" : "");
  }

  void send(const Packet& packet) {
    last_ = packet;
    asked_ = line_->now();
    is_answered_ = false;
    if (!silent_since_) silent_since_ = asked_;
    round_trips_.sent(asked_, ++sequence_);
    line_->send(encode(packet));
  }

  bool waits_for_answer() const { return !is_answered_ && line_->now() - asked_ <= answer_limit; }

  // Adapters may echo what the host sends: instructions, and other servos, are passed over.
  std::optional<Packet> answer_to_last() {
    std::string bytes;
    line_->receive(bytes);
    reader_.take(bytes);
    while (std::optional<Packet> packet = reader_.next()) {
      if (packet->instruction != status || packet->id != settings_.id) continue;
      if (is_answered_) continue;
      if ((packet->error & ~Packet::alert) == 0 && packet->parameters.size() != size_of_answer(last_))
        continue;
      is_answered_ = true;
      silent_since_.reset();
      round_trips_.echoed(line_->now(), sequence_);
      return packet;
    }
    return std::nullopt;
  }

  std::unique_ptr<Line> line_;
  Settings settings_;
  const Model* model_ = nullptr;
  int firmware_ = 0;
  double least_deg_ = -turn_stop_deg, most_deg_ = turn_stop_deg;
  std::int64_t fastest_units_ = 1;
  std::int64_t effort_ = 0;
  PacketReader reader_;
  std::optional<PlateWatch> watch_;
  RoundTrips round_trips_;
  std::uint16_t sequence_ = 0;
  Packet last_;
  bool is_answered_ = true;
  std::optional<double> orientation_deg_;
  std::optional<int> goal_step_;
  bool is_goal_sent_ = true;
  bool must_stop_ = false;
  std::uint64_t refusals_ = 0;
  std::optional<Line::Time> silent_since_;  // the first request without an answer
  Line::Time asked_, reported_;
};

}  // namespace

DeviceMaker dynamixel_device(const DeviceName& name) {
  name.allow({"id", "baud", "speed", "effort"});
  const int baud = name.number("baud", 57600, 57600, 1000000);
  if (std::find(std::begin(baud_rates), std::end(baud_rates), baud) == std::end(baud_rates))
    throw std::invalid_argument("option baud is " + std::to_string(baud) +
                                "; allowed: 57600, 115200, 1000000");
  const Settings settings{static_cast<std::uint8_t>(name.number("id", 1, 0, 252)),
                          static_cast<double>(name.number("speed", 300, 10, 1000)),
                          name.number("effort", 50, 5, 100)};
  return [path = name.path, baud, settings](const LineOpener& open) {
    return std::make_unique<Servo>(open(path, baud), settings);
  };
}

}  // namespace hrt::plate
