// Device: an XL330 servo under the plate. Position 2048, the middle of a turn of the servo, is orientation 0. The horn
// points up, so that counter-clockwise seen from above is positive.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "plugin/include/plate_driver/device.h"
#include "plugin/include/plate_driver/plate_failure.h"
#include "plugin/src/plate/dynamixel/bus.h"
#include "plugin/src/plate/plate_watch.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;
using namespace dynamixel;

constexpr double stop_deg = 360.0;   // limit of the driver; the servo can turn further
constexpr double slack_deg = 3.0;    // tolerance beyond stop_deg
constexpr auto ping_limit = 3s;      // adapters and servos need time after the serial line is opened
constexpr int probes = 11;           // reads that measure the round trip
constexpr auto servo_latency = 2ms;  // assumed latency of the servo, whose control loop runs every millisecond
// Profile velocity at rest: 1.4 degrees a second, so that a goal of another program moves the plate slowly.
constexpr std::int64_t resting_units = 1;
constexpr auto rest_time = 100ms;   // a plate that has not moved for this time is at rest
constexpr double rest_deg = 1.0;    // largest distance from the goal at rest
constexpr double still_deg = 0.5;   // a smaller change of the measured position is noise of the sensor
constexpr int polls_per_check = 8;  // every eighth poll reads torque_enable instead of the other entries

struct Settings {
  std::uint8_t id;
  double speed_deg_s;
  int effort_percent;
};

double deg_of(std::int64_t step) { return static_cast<double>(step - middle_step) * deg_per_step; }

std::string volts(std::int64_t tenths) {
  return std::to_string(tenths / 10) + "." + std::to_string(std::abs(tenths % 10)) + " V";
}

void check_hardware(std::int64_t bits) {
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
                                        ". Switch its supply off and on");
}

class Servo : public Device {
 public:
  Servo(std::unique_ptr<Line> line, const Settings& settings, Start start)
      : bus_(std::move(line), settings.id), settings_(settings) {
    identify();
    check_hardware(bus_.read(hardware_error));
    check_supply(bus_.read(present_voltage));
    fastest_units_ = std::max<std::int64_t>(1, bus_.read(velocity_limit));
    if (start == Start::hold) set_up();
    watch_.emplace(PlateGreeting{-stop_deg, stop_deg, speed_deg_s(), 0.0, true}, now());
    for (int i = 0; i < probes; ++i) handle_position(bus_.read(present_position));
    if (start == Start::hold) start_holding();
  }

  ~Servo() override {
    if (has_torque_command_) try_to_stop();
  }
  Servo(const Servo&) = delete;
  Servo& operator=(const Servo&) = delete;

  std::string description() const override {
    return std::string("Dynamixel ") + model_->name + ", id " + std::to_string(settings_.id) + ", firmware " +
           std::to_string(firmware_);
  }
  DeviceLimits limits() const override {
    return {-stop_deg, stop_deg, std::min(speed_deg_s(), watch_->speed_deg_s().value_or(speed_deg_s())),
            servo_latency + round_trip().value_or(0ns) / 2};
  }
  bool is_measured() const override { return true; }
  std::optional<std::chrono::nanoseconds> round_trip() const override { return bus_.round_trip(); }
  std::optional<double> orientation_deg() const override { return orientation_deg_; }
  Line::Time reported() const override { return reported_; }
  std::uint64_t refusals() const override { return bus_.damaged(); }
  Line::Time now() const override { return bus_.line().now(); }

  void wait(std::chrono::milliseconds limit) override {
    try {
      bus_.line().wait(limit);
      exchange();
    } catch (const PlateFailure&) {
      try_to_stop();
      throw;
    }
  }

  void turn_to(double orientation_deg) override {
    const int step = step_of(orientation_deg);
    if (goal_step_ == step) return;
    goal_step_ = step;
    next_ = Next::turn;
    watch_->note_command(deg_of(step));
  }

  void stop() override {
    goal_step_.reset();
    next_ = Next::stop;
    watch_->note_stop();
  }

  std::vector<std::string> details() override {
    finish_exchange();
    const auto value = [&](const char* name, Entry entry, const char* unit) {
      return name + std::to_string(bus_.read(entry)) + unit;
    };
    return {value("setting drive mode ", drive_mode, ""),
            value("setting operating mode ", operating_mode, ""),
            value("setting homing offset ", homing_offset, " steps"),
            value("setting velocity limit ", velocity_limit, ""),
            "supply " + volts(bus_.read(present_voltage)),
            value("temperature ", present_temperature, " °C"),
            value("hardware error ", hardware_error, "")};
  }

  // The servo reports the position of its shaft plus homing_offset: at orientation 0, the shaft is at 2048 - offset.
  double zero_deg() override {
    finish_exchange();
    return static_cast<double>(-bus_.read(homing_offset)) * deg_per_step;
  }

  // Switches the torque off for some milliseconds, because the servo refuses to store an offset while it has torque.
  void set_zero(double zero_deg) override {
    const std::int64_t offset = -std::llround(zero_deg / deg_per_step);
    if (std::abs(offset) > max_homing_steps)
      throw PlateFailure(Fault::device, "would need a homing offset of " + std::to_string(offset) +
                                            " steps; allowed: -1024 to 1024. Turn the horn on its shaft");
    finish_exchange();
    bus_.write(torque_enable, 0);
    bus_.write(homing_offset, offset);
    handle_position(bus_.read(present_position));
    start_holding();
    repeat_motion();
  }

  void save_zero() override { stop(); }                      // set_zero() has stored the offset in the servo
  void begin_measurement() override { poll_period_ = 0ms; }  // the profile velocity still limits the speed
  double report_step_deg() const override { return deg_per_step; }
  std::chrono::nanoseconds sensor_filter() const override { return 0ns; }

 private:
  int step_of(double orientation_deg) const {
    return middle_step + static_cast<int>(std::lround(std::clamp(orientation_deg, -stop_deg, stop_deg) / deg_per_step));
  }
  std::int64_t speed_units() const {
    return std::clamp<std::int64_t>(std::llround(settings_.speed_deg_s / deg_s_per_unit), 1, fastest_units_);
  }
  double speed_deg_s() const { return static_cast<double>(speed_units()) * deg_s_per_unit; }

  void identify() {
    for (const auto give_up = now() + ping_limit; now() <= give_up;) {
      const std::optional<Packet> answer = bus_.try_once(bus_.ping_request());
      if (answer && answer->status_error() == StatusError::none) {
        take_model(*answer);
        return;
      }
    }
    throw PlateFailure(Fault::no_answer, "does not answer as a Dynamixel of id " + std::to_string(settings_.id) +
                                             " within 3 s; check id, baud, cable and supply");
  }

  void take_model(const Packet& answer) {
    const std::int64_t number = number_at(answer.parameters, 0, 2);
    firmware_ = static_cast<int>(static_cast<unsigned char>(answer.parameters[2]));
    const auto found =
        std::find_if(models.begin(), models.end(), [&](const Model& model) { return model.number == number; });
    if (found == models.end())
      throw PlateFailure(Fault::no_answer,
                         "is a Dynamixel of model number " + std::to_string(number) +
                             "; allowed: 1190 (XL330-M077) and 1200 (XL330-M288). Use one of these servos");
    model_ = &*found;
  }

  // Writes the modes only if they differ, because each write wears out the memory of the servo.
  void set_up() {
    bus_.write(bus_watchdog, 0);
    bus_.write(torque_enable, 0);
    if (bus_.read(operating_mode) != current_based_position_mode)
      bus_.write(operating_mode, current_based_position_mode);
    if (bus_.read(drive_mode) != normal_drive_mode) bus_.write(drive_mode, normal_drive_mode);
    const double max_ma = std::min(settings_.effort_percent / 100.0, max_torque_nm / model_->stall_nm) * stall_ma;
    effort_ = std::min(static_cast<std::int64_t>(max_ma), bus_.read(current_limit));
    bus_.write(goal_current, effort_);
  }

  // Reads the goal back, because the servo replaces it by its present position when the torque is switched on.
  void start_holding() {
    has_torque_command_ = true;
    bus_.write(motion, motion_of(resting_units, step_of(*orientation_deg_)));
    bus_.write(torque_enable, 1);
    bus_.write(bus_watchdog, watchdog_ticks);
    motion_in_servo_ = bus_.read(motion);
  }

  static std::int64_t motion_of(std::int64_t profile_units, std::int64_t goal) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(goal) << 32U |
                                     static_cast<std::uint64_t>(profile_units));
  }

  void exchange() {
    if (const std::optional<Packet> answer = bus_.answer()) handle_answer(*answer);
    repeat_lost_motion();
    bus_.check_silence();
    if (bus_.awaits_answer()) return;
    if (next_ == Next::stop) {
      send_stop();
    } else if (next_ == Next::turn) {
      rested_since_ = now();
      send_motion(speed_units(), *goal_step_);
    } else if (is_fast_ && is_at_rest()) {
      send_motion(resting_units, *goal_step_);
    } else if (now() - bus_.asked() >= poll_period_) {
      bus_.send(poll_request());
    }
    bus_.line().flush();
  }

  void handle_answer(const Packet& answer) {
    const Packet request = bus_.request();
    const StatusError error = answer.status_error();
    const bool writes = request.instruction == Instruction::write;
    if (answer.is_alert()) check_hardware(bus_.read(hardware_error));
    if (error == StatusError::crc) {
      bus_.count_refusal();
      if (writes) repeat_motion();
    } else if (error == StatusError::data_range && writes) {
      recover_from_watchdog();
    } else if (error != StatusError::none) {
      throw PlateFailure(Fault::protocol, Bus::describe(request, error));
    } else if (!writes) {
      handle_poll(answer.parameters);
    } else {
      motion_in_servo_ = number_at(request.parameters, 2, motion.size);
    }
  }

  // Requests the entries from the watchdog to the voltage, or in every eighth poll torque_enable. After
  // begin_measurement(), requests only the position.
  Packet poll_request() {
    if (poll_period_ == 0ms) return bus_.read_request(present_position);
    if (++polls_ % polls_per_check == 0) return bus_.read_request(torque_enable);
    const int size = present_voltage.address + present_voltage.size - bus_watchdog.address;
    return bus_.read_request({bus_watchdog.address, size});
  }

  void handle_poll(const std::string& table) {
    if (table.size() == std::size_t{present_position.size})
      return handle_position(number_at(table, 0, present_position.size));
    if (table.size() == std::size_t{torque_enable.size}) {
      has_torque_ = table[0] != 0;
      return;
    }
    const auto value = [&](Entry entry) {
      return number_at(table, static_cast<std::size_t>(entry.address - bus_watchdog.address), entry.size);
    };
    const std::int64_t watchdog = value(bus_watchdog);
    if (watchdog == 0) throw PlateFailure(Fault::restarted, restarted_text);
    if (!has_torque_)
      throw PlateFailure(Fault::device,
                         "has no torque: another program or the servo switched the torque off. Open the plate again");
    handle_position(value(present_position));
    check_supply(value(present_voltage));
    if (watchdog == watchdog_expired) {
      recover_from_watchdog();
    } else if ((motion_in_servo_ && value(motion) != *motion_in_servo_) || value(goal_current) != effort_) {
      has_other_program_ = true;
      throw PlateFailure(Fault::line, second_program_text);
    }
  }

  void handle_position(std::int64_t step) {
    const double seconds = std::chrono::duration<double>(now() - reported_).count();
    if (orientation_deg_ && seconds > 0.0) observed_speed_deg_s_ = (deg_of(step) - *orientation_deg_) / seconds;
    orientation_deg_ = deg_of(step);
    if (std::abs(*orientation_deg_) > stop_deg + slack_deg)
      throw PlateFailure(Fault::limits, "was turned by " + std::to_string(std::lround(*orientation_deg_)) +
                                            " degrees; allowed: -360 to 360. Switch the servo's supply off and on");
    reported_ = now();
    if (std::abs(*orientation_deg_ - rested_deg_) > still_deg) {
      rested_deg_ = *orientation_deg_;
      rested_since_ = reported_;
    }
    watch_->note_report(reported_, orientation_deg_);
  }

  // Starts the servo's watchdog again after it has expired. Until then, the servo does not move and refuses goals.
  void recover_from_watchdog() {
    bus_.write(bus_watchdog, 0);
    bus_.write(profile_velocity, resting_units);
    bus_.write(goal_current, effort_);
    bus_.write(bus_watchdog, watchdog_ticks);
    repeat_motion();
  }

  void repeat_lost_motion() {
    if (bus_.has_missed_answer() && bus_.request().instruction == Instruction::write) repeat_motion();
  }

  void repeat_motion() {
    motion_in_servo_.reset();
    next_ = goal_step_ ? Next::turn : Next::stop;
  }

  bool is_at_rest() const {
    return goal_step_ && reported_ - rested_since_ >= rest_time &&
           std::abs(*orientation_deg_ - deg_of(*goal_step_)) <= rest_deg;
  }

  void send_motion(std::int64_t profile_units, std::int64_t goal) {
    next_ = Next::poll;
    is_fast_ = profile_units != resting_units;
    bus_.send(bus_.write_request(motion, motion_of(profile_units, goal)));
  }

  // Sets the present position, extrapolated from the last report, as the goal, so that the plate does not turn back.
  void send_stop() {
    next_ = Next::poll;
    if (!orientation_deg_) return;
    const double age_s = std::min(0.05, std::chrono::duration<double>(now() - reported_).count());
    send_motion(resting_units, step_of(*orientation_deg_ + age_s * observed_speed_deg_s_));
  }

  static void check_supply(std::int64_t tenths) {
    if (tenths >= min_supply && tenths <= max_supply) return;
    throw PlateFailure(Fault::device, "has a supply of " + volts(tenths) + "; allowed: " + volts(min_supply) + " to " +
                                          volts(max_supply) + ". Check adapter, fuse and wires");
  }

  // Waits for the answer to the last request, because only one end of the bus may send at a time.
  void await_answer() {
    while (bus_.awaits_answer() && !bus_.answer()) {
      bus_.line().wait(5ms);
      bus_.line().flush();
    }
  }

  void finish_exchange() {
    await_answer();
    repeat_lost_motion();
  }

  // Sends a stop if the serial line still works. Otherwise the servo's watchdog stops the plate. If another program
  // sends goals, also switches the torque off, so that no further goal turns the plate.
  void try_to_stop() {
    try {
      await_answer();
      send_stop();
      await_answer();
      if (!has_other_program_) return;
      bus_.send(bus_.write_request(torque_enable, 0));
      await_answer();
    } catch (const PlateFailure&) {
      return;
    }
  }

  Bus bus_;
  Settings settings_;
  const Model* model_ = nullptr;
  int firmware_ = 0;
  std::int64_t fastest_units_ = 1;
  std::int64_t effort_ = 0;  // goal current, mA
  bool has_torque_ = true;
  bool has_other_program_ = false;
  double observed_speed_deg_s_ = 0.0;  // between the last two reports
  int polls_ = 0;
  std::optional<PlateWatch> watch_;
  std::optional<double> orientation_deg_;
  std::optional<int> goal_step_;
  std::optional<std::int64_t> motion_in_servo_;  // value of the entry `motion`; nullopt: not known
  enum class Next { poll, turn, stop } next_ = Next::poll;
  bool is_fast_ = false;     // the last profile velocity that was sent is not resting_units
  double rested_deg_ = 0.0;  // the plate has stayed within still_deg of this position since rested_since_
  Line::Time rested_since_;
  bool has_torque_command_ = false;
  std::chrono::milliseconds poll_period_{20};
  Line::Time reported_;
};

}  // namespace

DeviceMaker dynamixel_device(const DeviceName& name) {
  name.check_options({"id", "baud", "speed", "effort"});
  constexpr const char* rates = "57600, 115200, 1000000";
  const int baud = name.integer("baud", 57600, 57600, 1'000'000, rates);
  if (std::find(std::begin(baud_rates), std::end(baud_rates), baud) == std::end(baud_rates))
    throw std::invalid_argument("option baud is " + std::to_string(baud) + "; allowed: " + rates);
  const Settings settings{static_cast<std::uint8_t>(name.integer("id", 1, 0, 252)),
                          static_cast<double>(name.integer("speed", 300, 10, 1000)),
                          name.integer("effort", 50, 5, 100)};
  return [path = name.path, baud, settings](const LineOpener& open, Start start) {
    return std::make_unique<Servo>(open(path, baud), settings, start);
  };
}

}  // namespace hrt::plate
