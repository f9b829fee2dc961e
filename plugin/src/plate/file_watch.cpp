#include "plugin/src/plate/file_watch.h"

#include <algorithm>
#include <cmath>

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double slow_fraction = 0.8;    // a plate below this fraction of the speed in the file deviates
constexpr auto deviates_after = 1s;      // allowed duration of a motion, and after it of an error at rest
constexpr double late_s = 0.04;          // a plate whose lateness exceeds this time deviates
constexpr double min_travel_deg = 90.0;  // travel after which the lateness is reliable
constexpr auto max_pause = 50ms;         // motion between two updates further apart is not compared

}  // namespace

void FileWatch::update(Time now, const Device& device, std::optional<double> command_deg) {
  const double latency_ms = file_.latency_ms;
  if (command_deg != command_deg_) {
    const auto latency =
        std::chrono::nanoseconds(std::llround(latency_ms * 1e6)) + device.round_trip().value_or(0ns) / 2;
    command_changed_ = now;
    if (command_deg) pending_.push_back({now + latency, *command_deg});
    command_deg_ = command_deg;
  }
  const std::optional<double> present_deg = device.orientation_deg();
  const bool rests = command_deg && present_deg && now - command_changed_ > deviates_after;
  if (!rests || std::abs(*present_deg - *command_deg) <= file_.error_deg) near_command_at_ = now;
  compare_with_model(now, device);
  const bool is_late = travelled_deg_ > min_travel_deg && late_sum_ > late_s * square_sum_;
  deviates_ = now - near_command_at_ > deviates_after ||
              device.limits().speed_deg_s < slow_fraction * file_.speed_deg_s || is_late;
}

// Estimates the lateness, in seconds, as the slope of the plate's lag behind the model over the model's speed v, by
// least squares. The lag v |v| / (2 a), which the acceleration a in the file explains, is subtracted first.
void FileWatch::compare_with_model(Time now, const Device& device) {
  const std::optional<double> present_deg = device.orientation_deg();
  const bool paused = now - updated_ > max_pause;
  const double seconds = std::chrono::duration<double>(now - updated_).count();
  updated_ = now;
  if (!command_deg_ || !present_deg || paused || !goal_deg_) {
    model_deg_ = present_deg.value_or(0.0);
    goal_deg_ = present_deg;
    if (!command_deg_) pending_.clear();
    return;
  }
  for (; !pending_.empty() && pending_.front().acts <= now; pending_.pop_front())
    goal_deg_ = pending_.front().orientation_deg;
  const double max_step_deg = file_.speed_deg_s * seconds;
  const double step_deg = std::clamp(*goal_deg_ - model_deg_, -max_step_deg, max_step_deg);
  model_deg_ += step_deg;
  if (device.reported() == reported_ || seconds <= 0.0) return;
  reported_ = device.reported();
  const double speed_deg_s = step_deg / seconds;
  const double ramp_deg = 0.5 * speed_deg_s * std::abs(speed_deg_s) / file_.acceleration_deg_s2;
  late_sum_ += (model_deg_ - ramp_deg - *present_deg) * speed_deg_s;
  square_sum_ += speed_deg_s * speed_deg_s;
  travelled_deg_ += std::abs(step_deg);
  if (travelled_deg_ < 4.0 * min_travel_deg) return;
  for (double* sum : {&late_sum_, &square_sum_, &travelled_deg_}) *sum *= 0.5;
}

}  // namespace hrt::plate
