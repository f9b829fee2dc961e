#include "plugin/src/plate/file_watch.h"

#include <algorithm>
#include <cmath>

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double slow_share = 0.8;   // fraction of the speed in the file
constexpr auto deviates_after = 1s;  // duration of the rest, and of an error at rest
constexpr double late_s = 0.04;
constexpr double min_way_deg = 90.0;  // turn after which lateness is judged
constexpr auto max_pause = 50ms;      // longest pause of the host; motion in a longer one is not observed

}  // namespace

void FileWatch::look(Time now, const Device& device, std::optional<double> command_deg) {
  const double latency_ms = file_.latency_ms;
  if (command_deg != command_deg_) {
    const auto latency =
        std::chrono::nanoseconds(std::llround(latency_ms * 1e6)) + device.round_trip().value_or(0ns) / 2;
    commanded_ = now;
    if (command_deg) coming_.push_back({now + latency, *command_deg});
    command_deg_ = command_deg;
  }
  const std::optional<double> place_deg = device.orientation_deg();
  const bool rests = command_deg && place_deg && now - commanded_ > deviates_after;
  if (!rests || std::abs(*place_deg - *command_deg) <= file_.error_deg) near_ = now;
  follow(now, device);
  const bool is_late = way_deg_ > min_way_deg && late_sum_ > late_s * square_sum_;
  deviates_ = now - near_ > deviates_after || device.limits().speed_deg_s < slow_share * file_.speed_deg_s || is_late;
}

// Lateness: slope of the plate's lag over its speed v, less the lag of v / 2 a due to a constant acceleration a.
void FileWatch::follow(Time now, const Device& device) {
  const std::optional<double> place_deg = device.orientation_deg();
  const bool paused = now - looked_ > max_pause;
  const double seconds = std::chrono::duration<double>(now - looked_).count();
  looked_ = now;
  if (!command_deg_ || !place_deg || paused || !goal_deg_) {
    model_deg_ = place_deg.value_or(0.0);
    goal_deg_ = place_deg;
    if (!command_deg_) coming_.clear();
    return;
  }
  for (; !coming_.empty() && coming_.front().acts <= now; coming_.pop_front())
    goal_deg_ = coming_.front().orientation_deg;
  const double most_deg = file_.speed_deg_s * seconds;
  const double step_deg = std::clamp(*goal_deg_ - model_deg_, -most_deg, most_deg);
  model_deg_ += step_deg;
  if (device.reported() == reported_ || seconds <= 0.0) return;
  reported_ = device.reported();
  const double speed_deg_s = step_deg / seconds;
  const double ramp_deg = 0.5 * speed_deg_s * std::abs(speed_deg_s) / file_.acceleration_deg_s2;
  late_sum_ += (model_deg_ - ramp_deg - *place_deg) * speed_deg_s;
  square_sum_ += speed_deg_s * speed_deg_s;
  way_deg_ += std::abs(step_deg);
  if (way_deg_ < 4.0 * min_way_deg) return;
  for (double* sum : {&late_sum_, &square_sum_, &way_deg_}) *sum *= 0.5;
}

}  // namespace hrt::plate
