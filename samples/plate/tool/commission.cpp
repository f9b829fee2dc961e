#include <algorithm>
#include <cmath>
#include <random>

#include "plugin/include/plate_driver/plate_failure.h"
#include "samples/app/text/format.h"
#include "samples/plate/tool/bend.h"
#include "samples/plate/tool/measure.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

using Opener = std::function<std::unique_ptr<Device>()>;

constexpr double scale_deg = 30.0;  // the operator reads the scale at this orientation and at its negative
constexpr double first_span_us = 2000.0, first_limit_deg = 45.0;  // settings before the servo is measured
constexpr double max_limit_deg = 95.0;
constexpr double scale_error = 0.007;  // relative standard error of 60 degrees on the scale, read to whole degrees
constexpr double min_readings = 20.0;  // smallest difference of the sensor's readings at the two angles
constexpr double stop_step_deg = 3.0;  // step of the search for a stop
// A plate that lags more in the last step is at a stop. The resolution of the sensor is 0.3 degrees.
constexpr double max_lag_deg = 0.5;
constexpr int bends = 9;                 // number of the settings bend_0 to bend_8: the nonlinearity of the sensor
constexpr double max_bend_deg = 5.0;     // a larger nonlinearity shows that the sensor is mounted wrongly
constexpr double stop_margin_deg = 2.0;  // distance of the limits from the stops
// Errors that the standard errors of the fits do not include, found with 200 simulated plates. They are relative,
// unless they are in degrees. The ramp is half of the duration of the acceleration.
constexpr double hobby_acceleration_error = 0.45, hobby_backlash_error_deg = 0.06;
constexpr double xl330_acceleration_error = 0.16, xl330_ramp_error = 0.04, xl330_speed_error = 0.00018;
constexpr double speed_fraction = 0.9;  // speed setting, as a fraction of the speed of the servo
constexpr double max_speed_deg_s = 300.0;

// Linear relation between orientation and reading of the sensor.
struct SensorLine {
  double at_zero;
  double per_deg;
  double at(double orientation_deg) const { return std::clamp(at_zero + per_deg * orientation_deg, 0.0, 1023.0); }
};

// Sets the limits and the readings at the limits, in an order in which the present reading is always between them.
void set_limits(BoardSettings& board, const SensorLine& sensor, double min_deg, double max_deg) {
  board.change_setting("least", std::ceil(min_deg));
  board.change_setting("most", std::floor(max_deg));
  const std::pair<const char*, double> least = {"adc_least", sensor.at(std::ceil(min_deg))},
                                       most = {"adc_most", sensor.at(std::floor(max_deg))};
  const bool rises = sensor.per_deg > 0.0;
  for (const auto& [name, value] : {rises ? most : least, rises ? least : most})
    board.change_setting(name, std::round(value));
}

void set_bend(BoardSettings& board, const std::vector<double>& bend_deg) {
  for (std::size_t i = 0; i < bend_deg.size(); ++i) board.change_setting("bend_" + std::to_string(i), bend_deg[i]);
}

// Returns a random serial number, which identifies this plate in its plate file.
double random_serial() {
  std::random_device device;
  return std::uniform_int_distribution(1, 999999)(device);
}

double read_scale(Device& device, const Dialogue& dialogue, double orientation_deg) {
  turn_and_wait(device, orientation_deg);
  const auto read_deg = ask_number(
      device, dialogue, "Which angle does the scale show at the notch? Left, towards +, is positive.", -90, 90);
  if (!read_deg)
    throw PlateFailure(Fault::device, "cannot be commissioned without this angle. Start again and enter the angle");
  return *read_deg;
}

// Finds and sets direction, span and zero of the servo. Returns the relation between orientation and sensor reading.
SensorLine find_sensor_line(Device& device, BoardSettings& board, const Dialogue& dialogue) {
  ask(device, dialogue,
      "Keep your hands off the plate: it is homed slowly, then turns to two orientations. Press Enter to start.");
  // Equal settings declare that there is no sensor. Until then the present reading stays between them, because the
  // smaller one is set first.
  const bool rises = board.setting("adc_most") > board.setting("adc_least");
  for (const char* name : {rises ? "adc_least" : "adc_most", rises ? "adc_most" : "adc_least"})
    board.change_setting(name, 0);
  set_bend(board, std::vector<double>(bends, 0.0));
  board.change_setting("span", first_span_us);
  board.change_setting("least", -first_limit_deg);
  board.change_setting("most", first_limit_deg);
  turn_and_wait(device, 0.0);
  const double above_deg = read_scale(device, dialogue, scale_deg), reading_above = board.sensor_reading();
  // Both orientations are approached from the same side, so that the play of the gears has no effect.
  turn_and_wait(device, -scale_deg - 10.0);
  const double below_deg = read_scale(device, dialogue, -scale_deg), reading_below = board.sensor_reading();
  if (std::abs(reading_above - reading_below) < min_readings)
    throw PlateFailure(Fault::device,
                       "cannot be measured: the reading of the sensor at pin A0 does not change. Check the sensor, the "
                       "magnet and the wire, or use the plate only for demonstrations");
  const double turn = (above_deg - below_deg) / (2.0 * scale_deg);
  const double span_us = turn == 0.0 ? 1e9 : std::round(first_span_us / turn);
  if (std::abs(span_us) < 500.0 || std::abs(span_us) > 2500.0)
    throw PlateFailure(Fault::device, format("turned by %g degrees between the two readings; allowed: 48 to 180, in "
                                             "either direction. Start again and read the scale carefully",
                                             turn * 60.0));
  turn_and_wait(device, 0.0);
  board.change_setting("span", span_us);  // at orientation 0 this does not move the servo
  const double middle_deg = 0.5 * (above_deg + below_deg);
  device.set_zero(device.zero_deg() - middle_deg);
  const double per_deg = (reading_above - reading_below) / (above_deg - below_deg);
  return {reading_above - per_deg * above_deg, per_deg};
}

// Commands an orientation, and returns the mean orientation from 0.3 to 0.6 s later, also if the plate is blocked.
double orientation_after_step(Device& device, double orientation_deg) {
  device.turn_to(orientation_deg);
  for (const auto end = device.now() + 300ms; device.now() < end;) device.wait(10ms);
  double sum_deg = 0.0;
  constexpr int count = 15;
  for (int i = 0; i < count; ++i) {
    device.wait(20ms);
    sum_deg += device.orientation_deg().value_or(orientation_deg);
  }
  return sum_deg / count;
}

// Steps from first_limit_deg towards limit_deg, and returns the orientation stop_margin_deg before the first stop. A
// stop is detected by a lag of half a step or, in the last step, of max_lag_deg. Without one, returns about limit_deg.
double find_stop(Device& device, double limit_deg) {
  const double sign = limit_deg < 0.0 ? -1.0 : 1.0;
  const int count = static_cast<int>(std::ceil((std::abs(limit_deg) - first_limit_deg) / stop_step_deg));
  const double step_deg = (limit_deg - sign * first_limit_deg) / count;
  settle_at(device, sign * first_limit_deg);
  double before_deg = orientation_after_step(device, sign * first_limit_deg);
  for (int i = 1; i <= count; ++i) {
    const double reported_deg = orientation_after_step(device, sign * first_limit_deg + i * step_deg);
    const double lag_deg = std::abs(step_deg) - std::abs(reported_deg - before_deg);
    before_deg = reported_deg;
    if (lag_deg <= (i < count ? 0.5 * std::abs(step_deg) : max_lag_deg)) continue;
    settle_at(device, sign * first_limit_deg);
    return reported_deg - sign * stop_margin_deg;
  }
  // At the widest range, a stop may be just beyond the limit.
  return std::abs(limit_deg) < max_limit_deg ? limit_deg : limit_deg - sign * stop_margin_deg;
}

template <class Action>
void with_board(const Opener& open, Action action) {
  const auto device = open();
  BoardSettings& board = *device->board_settings();
  action(*device, board);
  board.save_settings();
}

// Sets up a hobby servo. Opens the plate again after each change of its limits, which the driver reads on opening.
void set_up_servo(const Opener& open, const Dialogue& dialogue) {
  SensorLine sensor{};
  with_board(open, [&](Device& device, BoardSettings& board) {
    if (board.setting("serial") == 0.0) board.change_setting("serial", random_serial());
    sensor = find_sensor_line(device, board, dialogue);
    set_limits(board, sensor, -max_limit_deg, max_limit_deg);
  });
  double min_deg = 0.0, max_deg = 0.0;
  with_board(open, [&](Device& device, BoardSettings& board) {
    dialogue.print("Searching for the stops");
    max_deg = find_stop(device, device.limits().max_deg);
    min_deg = find_stop(device, device.limits().min_deg);
    settle_at(device, 0.0);
    set_limits(board, sensor, min_deg, max_deg);
  });
  with_board(open, [&](Device& device, BoardSettings& board) {
    dialogue.print("Measuring the nonlinearity of the sensor");
    const DeviceLimits limits = device.limits();
    const auto bend_deg = fit_bend(sweep(device), limits.min_deg, limits.max_deg, bends);
    for (const double off_deg : bend_deg)
      if (std::abs(off_deg) > max_bend_deg)
        throw PlateFailure(
            Fault::device,
            format("has a sensor with an error of %.1f deg; allowed: %g. Centre magnet and sensor on the axis", off_deg,
                   max_bend_deg));
    settle_at(device, 0.0);
    set_bend(board, bend_deg);
  });
}

void widen(Measured& measured, double deviation) { measured.deviation = std::hypot(measured.deviation, deviation); }

// Asks for the direction, because a servo may be mounted upside down or turn the plate through gears.
void confirm_direction(Device& device, const Dialogue& dialogue) {
  ask(device, dialogue, "Keep your hands off the plate: it turns by 20 degrees. Press Enter to start.");
  const double from_deg = settle_at(device, device.orientation_deg().value_or(0.0));
  settle_at(device, from_deg + 20.0);
  const std::string answer = ask(
      device, dialogue, "Did the plate turn counter-clockwise, seen from above, by about 20 degrees? Enter y or n.");
  settle_at(device, from_deg);
  if (answer != "y")
    throw PlateFailure(Fault::device,
                       "cannot be used: the answer was not y. Mount the servo with its horn up and without gears");
}

}  // namespace

Measurements commission(const Opener& open, const Dialogue& dialogue) {
  const bool has_settings = open()->board_settings() != nullptr;
  if (has_settings) set_up_servo(open, dialogue);
  const auto device = open();
  if (!has_settings) confirm_direction(*device, dialogue);
  if (!has_settings)
    ask(*device, dialogue, "Keep your hands off the plate: it turns through its whole range. Press Enter to start.");
  Measurements found = measure(*device, dialogue.print);
  if (found.speed_deg_s.value > 1.1 * found.limits.speed_deg_s && !has_settings)
    throw PlateFailure(
        Fault::device,
        format("turns at %.0f deg/s, but its profile velocity is set to %.0f deg/s. Do not use this servo",
               found.speed_deg_s.value, found.limits.speed_deg_s));
  const double ramp_ms = 500.0 * found.speed_deg_s.value / found.acceleration_deg_s2.value;
  if (!has_settings) {
    widen(found.acceleration_deg_s2, xl330_acceleration_error * found.acceleration_deg_s2.value);
    widen(found.latency_ms, xl330_ramp_error * ramp_ms);
    widen(found.speed_deg_s, xl330_speed_error * found.speed_deg_s.value);
  }
  if (BoardSettings* board = device->board_settings()) {
    for (Measured* angle : {&found.speed_deg_s, &found.acceleration_deg_s2, &found.backlash_deg})
      widen(*angle, scale_error * angle->value);
    widen(found.acceleration_deg_s2, hobby_acceleration_error * found.acceleration_deg_s2.value);
    widen(found.backlash_deg, hobby_backlash_error_deg);
    board->change_setting("latency", std::clamp(std::round(found.latency_ms.value), 0.0, 200.0));
    found.limits.speed_deg_s = std::clamp(std::floor(speed_fraction * found.speed_deg_s.value), 1.0, max_speed_deg_s);
    board->change_setting("speed", found.limits.speed_deg_s);
    board->save_settings();
  }
  found.details = device->details();
  return found;
}

}  // namespace hrt::plate
