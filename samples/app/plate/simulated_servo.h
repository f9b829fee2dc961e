#pragma once

#include <algorithm>
#include <cmath>

#include "samples/app/plate/plate.h"

namespace hrt::app {

/// Simulated servo without end stops. Turns at constant speed to the nearest orientation that is equivalent (modulo 180
/// degrees) to a command.
class SimulatedServo : public Plate {
 public:
  /// Starts at 0 degrees. Requires speed_deg_per_s > 0. Reports its orientation within +-90 degrees.
  explicit SimulatedServo(double speed_deg_per_s)
      : report_{.struct_size = sizeof report_, .max_speed_deg_s = speed_deg_per_s} {}

  const hrt_plate_report* report() const override { return &report_; }
  void service(XrTime time) override { turn_until(time); }
  void command(XrTime time, double orientation_deg) override {
    turn_until(time);
    goal_deg_ = orientation_deg_ + std::remainder(orientation_deg - orientation_deg_, 180.0);
  }
  std::optional<double> orientation_deg(XrTime time) override {
    turn_until(time);
    return std::remainder(orientation_deg_, 180.0);
  }
  void stop(XrTime time) override {
    turn_until(time);
    goal_deg_ = orientation_deg_;
  }

 private:
  void turn_until(XrTime time) {
    if (time <= time_) return;
    const double max_deg = time_ == 0 ? 0.0 : report_.max_speed_deg_s * static_cast<double>(time - time_) * 1e-9;
    orientation_deg_ += std::clamp(goal_deg_ - orientation_deg_, -max_deg, max_deg);
    time_ = time;
  }

  hrt_plate_report report_;
  XrTime time_ = 0;
  double orientation_deg_ = 0.0;
  double goal_deg_ = 0.0;
};

}  // namespace hrt::app
