// The physics of a plate on its servo, in simulated time: what every emulated device of the tests moves.
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <random>

namespace hrt::plate {

struct ServoTraits {
  double speed_deg_s = 250.0;  ///< without a load
  double acceleration_deg_s2 = 10'000.0;
  std::chrono::microseconds dead_time{10'000};  ///< from a new goal to the motor
  double dead_band_deg = 0.1;                   ///< error that the motor leaves
  double backlash_deg = 0.0;                    ///< between motor and plate; the sensor is at the plate
  double load = 0.0;                            ///< share of the stall torque that friction takes: the speed sags by it
  double lower_stop_deg = -100.0, upper_stop_deg = 100.0;
  double noise_deg = 0.0;  ///< standard deviation of a reading
  unsigned seed = 1;
};

/// A motor that turns to its goal with a trapezoid of speed, and drags the plate along through its gears.
class EmulatedServo {
 public:
  using Time = std::chrono::nanoseconds;

  explicit EmulatedServo(const ServoTraits& traits = {}, double place_deg = 0.0)
      : traits_(traits), motor_deg_(place_deg), plate_deg_(place_deg), random_(traits.seed) {}

  /// Nothing: no force; it stays, and a hand can turn it.
  void set_goal(std::optional<double> goal_deg, Time now);
  void run_until(Time now);
  /// While it is without force.
  void turn_by_hand(double place_deg) { motor_deg_ = plate_deg_ = place_deg; }
  /// Of its own speed, as a profile does.
  void limit_speed(double speed_deg_s) { limit_deg_s_ = speed_deg_s; }

  const ServoTraits& traits() const { return traits_; }
  double plate_deg() const { return plate_deg_; }
  /// With the sensor's noise.
  double reading_deg();
  /// Fastest so far, and farthest from 0.
  double max_speed_deg_s() const { return max_speed_deg_s_; }
  double max_turn_deg() const { return max_turn_deg_; }
  /// Speed that it reaches with load, supply and profile.
  double full_speed_deg_s() const;
  Time now() const { return now_; }

  bool is_jammed = false;
  double supply = 1.0;    ///< share of its voltage
  double slip_deg = 0.0;  ///< by which its sensor has slipped on the axis
  /// Error of its sensor: a wave over the place, as a magnet beside the axis has it.
  double bend_deg = 0.0, bend_phase_deg = 0.0;
  int bend_waves = 1;  ///< in a turn

 private:
  struct Goal {
    Time acts;
    std::optional<double> place_deg;
  };
  void step(double seconds);

  ServoTraits traits_;
  double motor_deg_, plate_deg_, speed_deg_s_ = 0.0;
  double limit_deg_s_ = 1e9;
  double max_speed_deg_s_ = 0.0, max_turn_deg_ = 0.0;
  std::optional<double> goal_deg_;
  std::deque<Goal> coming_;
  Time now_{0};
  std::mt19937 random_;
};

/// A hobby servo, with a sensor of 10 bits at the plate: 1 V at -90, 4 V at 90 degrees, of 5 V.
class HobbyServo : public EmulatedServo {
 public:
  explicit HobbyServo(const ServoTraits& traits = {}, double place_deg = 0.0) : EmulatedServo(traits, place_deg) {}

  /// Drives the motor for a frame.
  void take_pulse(double width_us, Time now);
  void run_until(Time now);
  double sensor_mv() { return 2500.0 + reading_deg() * 3000.0 / 180.0; }

  /// What 180 degrees take of the pulse; negative: clockwise.
  double span_us = 2000.0;

 private:
  std::optional<Time> pulsed_;
};

}  // namespace hrt::plate
