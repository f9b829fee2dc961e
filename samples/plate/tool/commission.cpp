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

constexpr double asked_deg = 30.0;  // where the scale is read, by the first guess of the span
constexpr double first_span_us = 2000.0, first_limit_deg = 45.0;
constexpr double max_limit_deg = 95.0;
constexpr double scale_share = 0.007;    // standard error of two angles, read to a degree, 60 apart
constexpr double min_readings = 20.0;    // of the converter, between the two places
constexpr double stop_step_deg = 3.0;    // in which stops are approached
constexpr double max_lag_deg = 0.5;      // of the last step, if it was followed; a converter's step is 0.3
constexpr int bends = 9;                 // of the firmware's settings
constexpr double max_bend_deg = 5.0;     // a sensor that is off by more was not mounted right
constexpr double stop_margin_deg = 2.0;  // to stay away from them
// What fits of steps do not know of their own errors, from 200 simulated plates. What is left of a bend falsifies the
// first degrees of a step, which show the acceleration; the converter's steps, and where in its dead band a servo
// rests, the play; an encoder's steps the speed.
constexpr double bent_share = 0.45, min_play_deg = 0.06;
constexpr double acceleration_share = 0.16, ramp_share = 0.04, encoder_share = 0.00018;
constexpr double speed_share = 0.9;  // of the servo's speed, which its motion takes
constexpr double max_speed_deg_s = 300.0;

// The sensor's reading is a line over the orientation.
struct Scale {
  double at_zero;
  double per_deg;
  double at(double orientation_deg) const { return std::clamp(at_zero + per_deg * orientation_deg, 0.0, 1023.0); }
};

// Limits, and the readings there. A reading between the two that are set is within the limits at each step.
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

// So that the file is of this plate alone.
double any_serial() {
  std::random_device device;
  return std::uniform_int_distribution(1, 999999)(device);
}

double place_read(Device& device, const Person& person, double orientation_deg) {
  turn_and_wait(device, orientation_deg);
  const auto read_deg = ask_number(
      device, person, "Which angle does the scale show at the notch? Left, towards +, is positive.", -90, 90);
  if (!read_deg) throw PlateFailure(Fault::device, "was not read: an angle is needed");
  return *read_deg;
}

// Which way the plate turns, how far, and what its sensor says.
Scale find_scale(Device& device, BoardSettings& board, const Person& person) {
  ask(device, person, "Hands off the plate: it is homed slowly, then turns to two places. Enter starts it.");
  // The smaller one first: a reading between the two stays within the limits.
  const bool rises = board.setting("adc_most") > board.setting("adc_least");
  for (const char* name : {rises ? "adc_least" : "adc_most", rises ? "adc_most" : "adc_least"})
    board.change_setting(name, 0);
  set_bend(board, std::vector<double>(bends, 0.0));
  board.change_setting("span", first_span_us);
  board.change_setting("least", -first_limit_deg);
  board.change_setting("most", first_limit_deg);
  turn_and_wait(device, 0.0);
  const double above_deg = place_read(device, person, asked_deg), reading_above = board.sensor_reading();
  turn_and_wait(device, -asked_deg - 10.0);  // both from the same side, so that loose gears do not count
  const double below_deg = place_read(device, person, -asked_deg), reading_below = board.sensor_reading();
  if (std::abs(reading_above - reading_below) < min_readings)
    throw PlateFailure(Fault::device,
                       "has no sensor at A0: nothing of it can be measured, and it serves for demonstrations only");
  const double turn = (above_deg - below_deg) / (2.0 * asked_deg);
  const double span_us = turn == 0.0 ? 1e9 : std::round(first_span_us / turn);
  if (std::abs(span_us) < 500.0 || std::abs(span_us) > 2500.0)
    throw PlateFailure(Fault::device, format("turned by %g degrees where 60 were asked of a usual servo", turn * 60.0));
  turn_and_wait(device, 0.0);
  board.change_setting("span", span_us);  // does not matter at 0
  const double middle_deg = 0.5 * (above_deg + below_deg);
  device.set_zero(device.zero_deg() - middle_deg);
  const double per_deg = (reading_above - reading_below) / (above_deg - below_deg);
  return {reading_above - per_deg * above_deg, per_deg};
}

// Where the plate is after a step, by the mean of its reports; it need not have come there.
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

// Goes outwards until the plate does not follow, or to the limit. A stop within a step shows in the next one;
// within the last one a small lag shows it.
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
  // Beyond the widest range nothing was seen.
  return std::abs(limit_deg) < max_limit_deg ? limit_deg : limit_deg - sign * stop_margin_deg;
}

template <class Action>
void with_board(const Opener& open, Action action) {
  const auto device = open();
  BoardSettings& board = *device->board_settings();
  action(*device, board);
  board.save_settings();
}

// The limits of a plate are those of its greeting: it is greeted anew after each change.
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

// A servo under the plate may be upside down, or geared.
void confirm_direction(Device& device, const Person& person) {
  ask(device, person, "Hands off the plate: it turns by 20 degrees. Enter starts it.");
  const double from_deg = settle_at(device, device.orientation_deg().value_or(0.0));
  settle_at(device, from_deg + 20.0);
  const std::string answer =
      ask(device, person, "Did it turn counter-clockwise, seen from above, by about 20 degrees? y or n");
  settle_at(device, from_deg);
  if (answer != "y")
    throw PlateFailure(Fault::device,
                       "turns the wrong way, or by another angle: its horn must point up, without gears");
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
    throw PlateFailure(Fault::device,
                       format("turns at %.0f deg/s, faster than its limit of %.0f: its profile does not hold",
                              found.speed_deg_s.value, found.limits.speed_deg_s));
  const double ramp_ms = 500.0 * found.speed_deg_s.value / found.acceleration_deg_s2.value;  // which latency includes
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
