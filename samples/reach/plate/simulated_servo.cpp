#include "samples/reach/plate/simulated_servo.h"

#include <algorithm>
#include <cmath>

namespace hrt::reach {

void SimulatedServo::turn_until(XrTime time) {
  if (time <= time_) return;
  const double max_deg = time_ == 0 ? 0.0 : speed_deg_per_s_ * static_cast<double>(time - time_) * 1e-9;
  orientation_deg_ += std::clamp(goal_deg_ - orientation_deg_, -max_deg, max_deg);
  time_ = time;
}

void SimulatedServo::command(XrTime time, double orientation_deg) {
  turn_until(time);
  goal_deg_ = orientation_deg_ + std::remainder(orientation_deg - orientation_deg_, 180.0);
}

std::optional<double> SimulatedServo::orientation_deg(XrTime time) {
  turn_until(time);
  return std::remainder(orientation_deg_, 180.0);
}

void SimulatedServo::stop(XrTime time) {
  turn_until(time);
  goal_deg_ = orientation_deg_;
}

}  // namespace hrt::reach
