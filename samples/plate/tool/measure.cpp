#include "samples/plate/tool/measure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plugin/include/plate_driver/plate_failure.h"
#include "samples/app/text/format.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double max_slip_deg = 0.4;  // largest error of the return from the sweep; the sensor's resolution is 0.3 deg
constexpr double near_deg = 5.0;      // a plate that is nearer to its command than this has arrived
constexpr double still_deg = 0.6;     // largest change of the reports of a plate at rest, due to noise
constexpr auto rest_time = 200ms;
constexpr auto settle_limit = 3000ms;
constexpr double sweep_step_deg = 15.0;
constexpr int returns = 6;
constexpr int steps = 10;
constexpr double max_step_deg = 120.0;
constexpr double run_up_deg = 10.0;  // turn before a step, larger than the play of the gears
constexpr auto frame = 20ms;         // period of a hobby servo's pulses

double orientation_of(const Device& device) { return device.orientation_deg().value_or(0.0); }

// Time limit of a turn, including the time in which the plate settles.
std::chrono::milliseconds limit_of_turn(const Device& device, double orientation_deg) {
  const double turn_s = std::abs(orientation_deg - orientation_of(device)) / device.limits().speed_deg_s;
  return settle_limit + std::chrono::milliseconds(std::llround(turn_s * 1000.0));
}

// Range of the sweep: that of the plate, within -180 to 180.
std::pair<double, double> sweep_range_deg(const DeviceLimits& limits) {
  return {std::max(-180.0, limits.min_deg), std::min(180.0, limits.max_deg)};
}

// Returns the mean backlash at the inner points of the sweep, which were approached from both sides.
Measured backlash_of(const std::vector<SweepPoint>& sweep) {
  const std::size_t count = sweep.size() / 2;
  std::vector<double> differences_deg;
  for (std::size_t i = 1; i < count; ++i)
    differences_deg.push_back(sweep[2 * count - i].reported_deg - sweep[i].reported_deg);
  return mean_of(differences_deg);
}

// Returns the SD of several returns to 0 from the same side, and the standard error of this SD.
Measured repeatability_of(Device& device, double away_deg) {
  std::vector<double> returned_deg;
  for (int i = 0; i < returns; ++i) {
    settle_at(device, away_deg);
    returned_deg.push_back(settle_at(device, 0.0));
  }
  const double spread_deg = mean_of(returned_deg).deviation * std::sqrt(static_cast<double>(returns));
  return {spread_deg, spread_deg / std::sqrt(2.0 * (returns - 1))};
}

// Records the reports of one turn from rest.
Step step_to(Device& device, double from_deg, double orientation_deg) {
  const double sign = orientation_deg < from_deg ? -1.0 : 1.0;
  const auto give_up = device.now() + limit_of_turn(device, orientation_deg);
  const auto began = device.now();
  Step step{std::abs(orientation_deg - from_deg), {}};
  device.turn_to(orientation_deg);
  for (auto last = device.reported(); device.now() < give_up;) {
    device.wait(5ms);
    if (device.reported() == last) continue;
    last = device.reported();
    step.samples.push_back(
        {std::chrono::duration<double>(last - began).count(), sign * (orientation_of(device) - from_deg)});
    if (std::abs(orientation_of(device) - orientation_deg) < near_deg) break;
  }
  return step;
}

// Measures the response to ten steps, which begin at different phases of the pulse period of a hobby servo. A short
// turn before each step, in its direction, takes up the play of the gears.
void measure_steps(Device& device, Measurements& found) {
  const double half_deg = std::min(max_step_deg / 2.0, 0.9 * std::min(found.limits.max_deg, -found.limits.min_deg));
  const double filter_s = std::chrono::duration<double>(device.sensor_filter()).count();
  const double line_ms = std::chrono::duration<double, std::milli>(found.round_trip).count();
  std::vector<Step> timed;
  const auto first = device.now();
  for (int i = 0; i < steps; ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    settle_at(device, -sign * half_deg);
    const double aside_deg = 2.0 * std::fmod(0.618 * i, 1.0);  // averages the rounding of the sensor's readings
    const double from_deg = settle_at(device, -sign * (half_deg - run_up_deg - aside_deg));
    while ((device.now() - first) % frame > 1ms) device.wait(1ms);
    for (const auto begin = device.now() + frame * i / steps; device.now() < begin;) device.wait(1ms);
    timed.push_back(step_to(device, from_deg, sign * half_deg));
  }
  const auto fit = fit_steps(timed, filter_s);
  if (!fit)
    throw PlateFailure(Fault::device, "reports too rarely to measure its steps. Check the cable and the baud rate");
  found.latency_ms = {std::max(0.0, fit->onset_s.value * 1000.0 - line_ms), fit->onset_s.deviation * 1000.0};
  found.speed_deg_s = fit->speed_deg_s;
  found.acceleration_deg_s2 = fit->acceleration_deg_s2;
}

}  // namespace

std::vector<SweepPoint> sweep(Device& device) {
  std::vector<SweepPoint> found;
  const auto [low_deg, high_deg] = sweep_range_deg(device.limits());
  const double min_deg = low_deg, max_deg = high_deg;
  const int count = std::max(4, static_cast<int>(std::ceil((max_deg - min_deg) / sweep_step_deg)));
  const auto visit = [&](int i, bool upwards) {
    // The distances are unequal, so that rounding of the sensor's readings averages out.
    const double aside = i == 0 || i == count ? 0.0 : 0.5 * (std::fmod(0.618 * i, 1.0) - 0.5);
    const double commanded_deg = min_deg + (max_deg - min_deg) * (i + aside) / count;
    found.push_back({commanded_deg, settle_at(device, commanded_deg), upwards});
  };
  for (int i = 0; i <= count; ++i) visit(i, true);
  for (int i = count - 1; i >= 0; --i) visit(i, false);
  // The first and the last point have the same orientation, and were approached from the same side, above.
  if (const double slip_deg = found.back().reported_deg - found.front().reported_deg; std::abs(slip_deg) > max_slip_deg)
    throw PlateFailure(
        Fault::device,
        format("returned from its sweep with an error of %.2f deg; allowed: %g. Fasten sensor, magnet and horn",
               slip_deg, max_slip_deg));
  return found;
}

void turn_and_wait(Device& device, double orientation_deg) {
  // A plate of unknown orientation is homed by its first turn, which takes 8 s.
  const auto time = device.orientation_deg() ? limit_of_turn(device, orientation_deg) : 9000ms;
  device.turn_to(orientation_deg);
  for (const auto end = device.now() + time; device.now() < end;) device.wait(10ms);
}

double settle_at(Device& device, double orientation_deg) {
  const auto give_up = device.now() + limit_of_turn(device, orientation_deg);
  auto still_since = device.now();
  double rest_deg = orientation_of(device), sum_deg = 0.0;
  int count = 0;
  while (count == 0 || device.now() - still_since < rest_time) {
    device.turn_to(orientation_deg);  // repeated, because the plate stops if this program is paused
    device.wait(20ms);
    const double reported_deg = orientation_of(device);
    const bool still =
        std::abs(reported_deg - rest_deg) <= still_deg && std::abs(reported_deg - orientation_deg) <= near_deg;
    if (!still) {
      rest_deg = reported_deg;
      still_since = device.now();
      sum_deg = 0.0;
      count = 0;
    } else {
      sum_deg += reported_deg;
      ++count;
    }
    if (device.now() > give_up) {
      throw PlateFailure(Fault::device,
                         format("does not come to rest at %.1f deg; it is at %.1f deg. Check that no part rubs",
                                orientation_deg, reported_deg));
    }
  }
  return sum_deg / count;
}

Measurements measure(Device& device, const std::function<void(const std::string&)>& print) {
  if (!device.is_measured())
    throw PlateFailure(Fault::device,
                       "has no sensor, so it cannot be measured. Connect one, or use the plate for demonstrations");
  Measurements found;
  found.device = device.description();
  found.limits = device.limits();
  found.round_trip = device.round_trip().value_or(0ns);
  const auto [min_deg, max_deg] = sweep_range_deg(found.limits);
  print(format("Sweeping from %.0f to %.0f deg and back", min_deg, max_deg));
  found.sweep = sweep(device);
  std::vector<double> errors_deg;
  for (const SweepPoint& point : found.sweep) errors_deg.push_back(point.reported_deg - point.commanded_deg);
  found.error_deg = mean_of(errors_deg);
  found.error_deg.deviation *= std::sqrt(static_cast<double>(errors_deg.size()));
  found.backlash_deg = backlash_of(found.sweep);
  print("Returning to 0");
  found.repeatability_deg = repeatability_of(device, std::max(-90.0, found.limits.min_deg) / 2.0);
  print("Measuring the response to steps, at the full speed of the servo");
  device.begin_measurement();
  measure_steps(device, found);
  settle_at(device, 0.0);
  for (Measured* angle : {&found.error_deg, &found.backlash_deg, &found.repeatability_deg})
    angle->deviation = std::max(angle->deviation, device.report_step_deg() / std::sqrt(12.0));
  return found;
}

}  // namespace hrt::plate
