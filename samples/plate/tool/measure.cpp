#include "samples/plate/tool/measure.h"

#include <algorithm>
#include <cmath>

#include "plugin/src/plate/plate_failure.h"
#include "samples/format.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double near_deg = 5.0;   // of the command: there
constexpr double still_deg = 0.5;  // within which a plate at rest stays
constexpr auto rest_time = 200ms;
constexpr auto settle_limit = 3000ms;
constexpr double sweep_step_deg = 15.0;
constexpr int returns = 6;
constexpr int steps = 6;
constexpr double onset_deg = 1.0;

double place_of(const Device& device) {
  return device.orientation_deg().value_or(0.0);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Of a turn, and what follows it.
std::chrono::milliseconds limit_of_turn(const Device& device, double orientation_deg) {
  const double turn_s = std::abs(orientation_deg - place_of(device)) / device.limits().speed_deg_s;
  return settle_limit + std::chrono::milliseconds(std::llround(turn_s * 1000.0));
}

// Turns there, and waits until the plate has been near and still for rest_time; its mean place in that time.
double settle_at(Device& device, double orientation_deg) {
  const auto give_up = device.now() + limit_of_turn(device, orientation_deg);
  auto still_since = device.now();
  double rest_deg = place_of(device), sum_deg = 0.0;
  int count = 0;
  while (count == 0 || device.now() - still_since < rest_time) {
    device.turn_to(orientation_deg);  // again, if this program was paused and the plate stopped
    device.wait(20ms);
    const double place_deg = place_of(device);
    const bool still =
        std::abs(place_deg - rest_deg) <= still_deg && std::abs(place_deg - orientation_deg) <= near_deg;
    if (!still) {
      rest_deg = place_deg;
      still_since = device.now();
      sum_deg = 0.0;
      count = 0;
    } else {
      sum_deg += place_deg;
      ++count;
    }
    if (device.now() > give_up) {
      throw PlateFailure(Fault::device, format("does not come to rest at %.1f deg; it is at %.1f deg",
                                               orientation_deg, place_deg));
    }
  }
  return sum_deg / count;
}

void sweep(Device& device, Measurements& found) {
  const double min_deg = found.limits.min_deg, max_deg = found.limits.max_deg;
  const int count = std::max(2, static_cast<int>(std::ceil((max_deg - min_deg) / sweep_step_deg)));
  const auto visit = [&](int i, bool upwards) {
    const double commanded_deg = min_deg + (max_deg - min_deg) * i / count;
    found.sweep.push_back({commanded_deg, settle_at(device, commanded_deg), upwards});
  };
  for (int i = 0; i <= count; ++i) visit(i, true);
  for (int i = count - 1; i >= 0; --i) visit(i, false);
  for (const SweepPoint& point : found.sweep)
    found.max_error_deg = std::max(found.max_error_deg, std::abs(point.reported_deg - point.commanded_deg));
}

// Of the sweep's inner points, which were visited from both sides; the last one up was visited once.
double backlash_of(const std::vector<SweepPoint>& sweep) {
  const std::size_t count = sweep.size() / 2;
  double sum_deg = 0.0;
  for (std::size_t i = 1; i < count; ++i)
    sum_deg += sweep[2 * count - i].reported_deg - sweep[i].reported_deg;
  return sum_deg / static_cast<double>(count - 1);
}

double repeatability_of(Device& device, double away_deg) {
  double sum_deg = 0.0, squares_deg2 = 0.0;
  for (int i = 0; i < returns; ++i) {
    settle_at(device, away_deg);
    const double place_deg = settle_at(device, 0.0);
    sum_deg += place_deg;
    squares_deg2 += place_deg * place_deg;
  }
  const double mean_deg = sum_deg / returns;
  return std::sqrt(std::max(0.0, squares_deg2 - returns * mean_deg * mean_deg) / (returns - 1));
}

struct Step {
  std::optional<double> onset_ms;
  std::optional<double> speed_deg_s;
};

// One turn from where the plate rests, as its reports show it.
Step step_to(Device& device, double orientation_deg) {
  const double from_deg = place_of(device), way_deg = orientation_deg - from_deg;
  const auto limit = limit_of_turn(device, orientation_deg);
  const auto began = device.now();
  std::optional<Line::Time> at_20_percent;
  double place_at_20_percent_deg = 0.0;
  Step step;
  device.turn_to(orientation_deg);
  while (device.now() - began < limit && !step.speed_deg_s) {
    device.wait(5ms);
    const auto now = device.now();
    const double place_deg = place_of(device), done = (place_deg - from_deg) / way_deg;
    if (!step.onset_ms && std::abs(place_deg - from_deg) >= onset_deg)
      step.onset_ms = std::chrono::duration<double, std::milli>(now - began).count();
    if (!at_20_percent && done >= 0.2) {
      at_20_percent = now;
      place_at_20_percent_deg = place_deg;
    }
    if (at_20_percent && done >= 0.8)
      step.speed_deg_s = std::abs(place_deg - place_at_20_percent_deg) /
                         std::chrono::duration<double>(now - *at_20_percent).count();
  }
  settle_at(device, orientation_deg);
  return step;
}

void time_steps(Device& device, Measurements& found) {
  std::vector<double> onsets_ms, speeds_deg_s;
  settle_at(device, found.limits.min_deg);
  for (int i = 0; i < steps; ++i) {
    const Step step = step_to(device, i % 2 == 0 ? found.limits.max_deg : found.limits.min_deg);
    if (step.onset_ms) onsets_ms.push_back(*step.onset_ms);
    if (step.speed_deg_s && std::isfinite(*step.speed_deg_s)) speeds_deg_s.push_back(*step.speed_deg_s);
  }
  if (!speeds_deg_s.empty()) found.speed_deg_s = median(speeds_deg_s);
  const double line_ms = std::chrono::duration<double, std::milli>(found.round_trip).count();
  if (!onsets_ms.empty()) found.latency_ms = std::max(0.0, median(onsets_ms) - line_ms);
}

}  // namespace

Measurements measure(Device& device, const std::function<void(const std::string&)>& note) {
  if (!device.round_trip())
    throw PlateFailure(Fault::protocol, "speaks protocol 1, which has nothing to measure with");
  Measurements found;
  found.device = device.description();
  found.limits = device.limits();
  found.is_measured = device.is_measured();
  found.round_trip = *device.round_trip();
  note("Homing");
  settle_at(device, 0.0);
  note("Sweeping from " + std::to_string(std::lround(found.limits.min_deg)) + " to " +
       std::to_string(std::lround(found.limits.max_deg)) + " deg and back");
  sweep(device, found);
  if (found.is_measured) {
    found.backlash_deg = backlash_of(found.sweep);
    note("Returning to 0");
    found.repeatability_deg = repeatability_of(device, found.limits.min_deg / 2.0);
    note("Timing steps");
    time_steps(device, found);
  }
  settle_at(device, 0.0);
  return found;
}

}  // namespace hrt::plate
