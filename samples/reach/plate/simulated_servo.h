// A servo simulated by this program: no stops, constant speed towards the nearest orientation that feels like
// the last command.
#pragma once

#include "samples/reach/plate/plate.h"

namespace hrt::reach {

class SimulatedServo : public Plate {
 public:
  /// Starts at 0; reports its orientation modulo 180, within 90 degrees; turns at `speed_deg_per_s` > 0.
  explicit SimulatedServo(double speed_deg_per_s) : speed_deg_per_s_(speed_deg_per_s) {}

  std::optional<PlateLimits> limits() const override { return PlateLimits{speed_deg_per_s_, 0.0, 0.0, 0}; }
  void service(XrTime time) override { turn_until(time); }
  void command(XrTime time, double orientation_deg) override;
  std::optional<double> orientation_deg(XrTime time) override;
  void stop(XrTime time) override;

 private:
  void turn_until(XrTime time);

  double speed_deg_per_s_;
  XrTime time_ = 0;
  double orientation_deg_ = 0.0;
  double goal_deg_ = 0.0;
};

}  // namespace hrt::reach
