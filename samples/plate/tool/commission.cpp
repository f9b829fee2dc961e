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

constexpr double asked_deg = 30.0;  // orientation at which the scale is read, with the first guess of the span
constexpr double first_span_us = 2000.0, first_limit_deg = 45.0;
constexpr double max_limit_deg = 95.0;
constexpr double scale_share = 0.007;    // relative standard error of 60 degrees, read to a degree
constexpr double min_readings = 20.0;    // smallest difference of the converter's readings at these angles
constexpr double stop_step_deg = 3.0;    // step of the approach to a stop
constexpr double max_lag_deg = 0.5;      // largest lag of a last step that was followed; the converter resolves 0.3
constexpr int bends = 9;                 // number of the firmware's bend settings
constexpr double max_bend_deg = 5.0;     // a larger bend shows a wrongly mounted sensor
constexpr double stop_margin_deg = 2.0;  // distance of the limits from the stops
// Errors, relative to the value, that the standard errors of the fits do not include, from 200 simulated plates. The
// residual bend disturbs the first degrees of a step, which determine the acceleration. The resolution of the converter
// and the position of a servo within its dead band disturb the play; the resolution of an encoder disturbs the speed.
constexpr double bent_share = 0.45, min_play_deg = 0.06;
constexpr double acceleration_share = 0.16, ramp_share = 0.04, encoder_share = 0.00018;
constexpr double speed_share = 0.9;  // speed of the motion, as a fraction of the servo's speed
constexpr double max_speed_deg_s = 300.0;

// Line that gives the sensor's reading at an orientation.
struct Scale {
  double at_zero;
  double per_deg;
  double at(double orientation_deg) const { return std::clamp(at_zero + per_deg * orientation_deg, 0.0, 1023.0); }
};

// Sets the limits, and the readings at them, in an order in which each reading stays within the limits.
void set_limits(BoardSettings& board, const Scale& sensor, double min_deg, double max_deg) {
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

// Random serial number, which ties the file to this plate.
double any_serial() {
  std::random_device device;
  return std::uniform_int_distribution(1, 999999)(device);
}

double place_read(Device& device, const Person& person, double orientation_deg) {
  turn_and_wait(device, orientation_deg);
  const auto read_deg = ask_number(
      device, person, "Which angle does the scale show at the notch? Left, towards +, is positive.", -90, 90);
  if (!read_deg) throw PlateFailure(Fault::device, "cannot be commissioned without the angle. Commission it again");
  return *read_deg;
}

// Finds the direction and span of the servo and the scale of the sensor.
Scale find_scale(Device& device, BoardSettings& board, const Person& person) {
  ask(device, person, "Hands off the plate: it is homed slowly, then turns to two places. Enter starts it.");
  // Sets the smaller reading first, so that a reading between the two stays within the limits.
  const bool rises = board.setting("adc_most") > board.setting("adc_least");
  for (const char* name : {rises ? "adc_least" : "adc_most", rises ? "adc_most" : "adc_least"})
    board.change_setting(name, 0);
  set_bend(board, std::vector<double>(bends, 0.0));
  board.change_setting("span", first_span_us);
  board.change_setting("least", -first_limit_deg);
  board.change_setting("most", first_limit_deg);
  turn_and_wait(device, 0.0);
  const double above_deg = place_read(device, person, asked_deg), reading_above = board.sensor_reading();
  turn_and_wait(device, -asked_deg - 10.0);  // approaches both from the same side, so that loose gears do not matter
  const double below_deg = place_read(device, person, -asked_deg), reading_below = board.sensor_reading();
  if (std::abs(reading_above - reading_below) < min_readings)
    throw PlateFailure(Fault::device,
                       "has no sensor at A0, so nothing can be measured. Connect it, or use it for demonstrations");
  const double turn = (above_deg - below_deg) / (2.0 * asked_deg);
  const double span_us = turn == 0.0 ? 1e9 : std::round(first_span_us / turn);
  if (std::abs(span_us) < 500.0 || std::abs(span_us) > 2500.0)
    throw PlateFailure(
        Fault::device,
        format("turned by %g degrees where a usual servo turns by 60. Read the scale again", turn * 60.0));
  turn_and_wait(device, 0.0);
  board.change_setting("span", span_us);  // moves nothing at 0
  const double middle_deg = 0.5 * (above_deg + below_deg);
  device.set_zero(device.zero_deg() - middle_deg);
  const double per_deg = (reading_above - reading_below) / (above_deg - below_deg);
  return {reading_above - per_deg * above_deg, per_deg};
}

// Returns the mean reported orientation after a step, which the plate need not have completed.
double place_after_step(Device& device, double orientation_deg) {
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

// Steps outwards until the plate does not follow, or to the limit. A stop within a step shows in the next step; within
// the last step, a small lag shows it.
double find_stop(Device& device, double limit_deg) {
  const double sign = limit_deg < 0.0 ? -1.0 : 1.0;
  const int count = static_cast<int>(std::ceil((std::abs(limit_deg) - first_limit_deg) / stop_step_deg));
  const double step_deg = (limit_deg - sign * first_limit_deg) / count;
  settle_at(device, sign * first_limit_deg);
  double before_deg = place_after_step(device, sign * first_limit_deg);
  for (int i = 1; i <= count; ++i) {
    const double place_deg = place_after_step(device, sign * first_limit_deg + i * step_deg);
    const double lag_deg = std::abs(step_deg) - std::abs(place_deg - before_deg);
    before_deg = place_deg;
    if (lag_deg <= (i < count ? 0.5 * std::abs(step_deg) : max_lag_deg)) continue;
    settle_at(device, sign * first_limit_deg);
    return place_deg - sign * stop_margin_deg;
  }
  // Beyond the widest range, a stop was not looked for.
  return std::abs(limit_deg) < max_limit_deg ? limit_deg : limit_deg - sign * stop_margin_deg;
}

template <class Action>
void with_board(const Opener& open, Action action) {
  const auto device = open();
  BoardSettings& board = *device->board_settings();
  action(*device, board);
  board.save_settings();
}

// Sets up a hobby servo. Greets the plate again after each change of its limits, which are read from the greeting.
void set_up_servo(const Opener& open, const Person& person) {
  Scale sensor{};
  with_board(open, [&](Device& device, BoardSettings& board) {
    if (board.setting("serial") == 0.0) board.change_setting("serial", any_serial());
    sensor = find_scale(device, board, person);
    set_limits(board, sensor, -max_limit_deg, max_limit_deg);
  });
  double min_deg = 0.0, max_deg = 0.0;
  with_board(open, [&](Device& device, BoardSettings& board) {
    person.say("Looking for the stops");
    max_deg = find_stop(device, device.limits().max_deg);
    min_deg = find_stop(device, device.limits().min_deg);
    settle_at(device, 0.0);
    set_limits(board, sensor, min_deg, max_deg);
  });
  with_board(open, [&](Device& device, BoardSettings& board) {
    person.say("Looking for the bend of the sensor");
    const DeviceLimits limits = device.limits();
    const auto bend_deg = fit_bend(sweep(device), limits.min_deg, limits.max_deg, bends);
    for (const double off_deg : bend_deg)
      if (std::abs(off_deg) > max_bend_deg)
        throw PlateFailure(
            Fault::device,
            format("has a sensor that is off by %.1f deg; allowed: %g. Centre magnet and sensor on the axis", off_deg,
                   max_bend_deg));
    settle_at(device, 0.0);
    set_bend(board, bend_deg);
  });
}

void widen(Measured& measured, double deviation) { measured.deviation = std::hypot(measured.deviation, deviation); }

// Asks for the direction, because a servo under the plate may be upside down, or geared.
void confirm_direction(Device& device, const Person& person) {
  ask(device, person, "Hands off the plate: it turns by 20 degrees. Enter starts it.");
  const double from_deg = settle_at(device, device.orientation_deg().value_or(0.0));
  settle_at(device, from_deg + 20.0);
  const std::string answer =
      ask(device, person, "Did it turn counter-clockwise, seen from above, by about 20 degrees? y or n");
  settle_at(device, from_deg);
  if (answer != "y")
    throw PlateFailure(Fault::device,
                       "turns the wrong way, or by another angle. Mount the servo with its horn up, without gears");
}

}  // namespace

Measurements commission(const Opener& open, const Person& person) {
  const bool has_settings = open()->board_settings() != nullptr;
  if (has_settings) set_up_servo(open, person);
  const auto device = open();
  if (!has_settings) confirm_direction(*device, person);
  if (!has_settings) ask(*device, person, "Hands off the plate: it turns through its whole range. Enter starts it.");
  Measurements found = measure(*device, person.say);
  if (found.speed_deg_s.value > 1.1 * found.limits.speed_deg_s && !has_settings)
    throw PlateFailure(Fault::device, format("turns at %.0f deg/s; allowed by its profile: %.0f. Do not use this servo",
                                             found.speed_deg_s.value, found.limits.speed_deg_s));
  const double ramp_ms = 500.0 * found.speed_deg_s.value / found.acceleration_deg_s2.value;  // part of the latency
  if (!has_settings) {
    widen(found.acceleration_deg_s2, acceleration_share * found.acceleration_deg_s2.value);
    widen(found.latency_ms, ramp_share * ramp_ms);
    widen(found.speed_deg_s, encoder_share * found.speed_deg_s.value);
  }
  if (BoardSettings* board = device->board_settings()) {
    for (Measured* angle : {&found.speed_deg_s, &found.acceleration_deg_s2, &found.backlash_deg})
      widen(*angle, scale_share * angle->value);
    widen(found.acceleration_deg_s2, bent_share * found.acceleration_deg_s2.value);
    widen(found.backlash_deg, min_play_deg);
    board->change_setting("latency", std::clamp(std::round(found.latency_ms.value), 0.0, 200.0));
    found.limits.speed_deg_s = std::clamp(std::floor(speed_share * found.speed_deg_s.value), 1.0, max_speed_deg_s);
    board->change_setting("speed", found.limits.speed_deg_s);
    board->save_settings();
  }
  found.details = device->details();
  return found;
}

}  // namespace hrt::plate
