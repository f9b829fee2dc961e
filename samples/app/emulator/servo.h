// Simulation of a plate on a servo, which the emulators of devices use. Its time is that of the caller.
#pragma once

#include <chrono>
#include <deque>
#include <optional>
#include <random>

namespace hrt::plate {

struct ServoTraits {
  double speed_deg_s = 250.0;  ///< speed without a load
  double acceleration_deg_s2 = 10'000.0;
  std::chrono::microseconds dead_time{10'000};  ///< time from a new goal to the motion of the motor
  double dead_band_deg = 0.1;                   ///< error up to which the motor does not move
  double backlash_deg = 0.0;                    ///< play between motor and plate; the sensor is at the plate
  double load = 0.0;  ///< friction, as a fraction of the stall torque; it reduces the speed by the same fraction
  double lower_stop_deg = -100.0, upper_stop_deg = 100.0;
  double noise_deg = 0.0;  ///< SD of a reading
  unsigned seed = 1;
};

/// Motor that turns to its goal with a trapezoidal speed profile, and turns a plate through gears with play.
class EmulatedServo {
 public:
  using Time = std::chrono::nanoseconds;

  explicit EmulatedServo(const ServoTraits& traits = {}, double orientation_deg = 0.0)
      : traits_(traits), motor_deg_(orientation_deg), plate_deg_(orientation_deg), random_(traits.seed) {}

  /// Sets the goal. With nullopt the motor exerts no force, so that a hand can turn the plate.
  void set_goal(std::optional<double> goal_deg, Time now);
  void run_until(Time now);
  /// Turns the plate, as a hand does while the motor exerts no force.
  void turn_by_hand(double orientation_deg) { motor_deg_ = plate_deg_ = orientation_deg; }
  /// Limits the speed from now on, as the profile velocity of a Dynamixel does.
  void limit_speed(double speed_deg_s) { limit_deg_s_ = speed_deg_s; }

  const ServoTraits& traits() const { return traits_; }
  double plate_deg() const { return plate_deg_; }
  /// Reading of the sensor, with noise and errors.
  double reading_deg();
  /// Largest speed of the motor so far, and largest distance of the plate from orientation 0.
  double max_speed_deg_s() const { return max_speed_deg_s_; }
  double max_turn_deg() const { return max_turn_deg_; }
  /// Speed that the motor reaches with the present load, supply and limit.
  double full_speed_deg_s() const;
  Time now() const { return now_; }

  bool is_jammed = false;
  double supply = 1.0;    ///< fraction of the nominal voltage
  double slip_deg = 0.0;  ///< angle by which the sensor has slipped on the axis
  /// Amplitude and phase of an error of the sensor that is a sine of the orientation, as that of an eccentric magnet.
  double bend_deg = 0.0, bend_phase_deg = 0.0;
  int bend_waves = 1;  ///< periods of this sine in a turn

 private:
  struct Goal {
    Time takes_effect;
    std::optional<double> orientation_deg;
  };
  void step(double seconds);

  ServoTraits traits_;
  double motor_deg_, plate_deg_, speed_deg_s_ = 0.0;
  double limit_deg_s_ = 1e9;
  double max_speed_deg_s_ = 0.0, max_turn_deg_ = 0.0;
  std::optional<double> goal_deg_;
  std::deque<Goal> pending_goals_;
  Time now_{0};
  std::mt19937 random_;
};

/// Hobby servo with an analogue sensor at the plate, whose output is 1 V at -90 degrees and 4 V at 90 degrees.
class HobbyServo : public EmulatedServo {
 public:
  explicit HobbyServo(const ServoTraits& traits = {}, double orientation_deg = 0.0)
      : EmulatedServo(traits, orientation_deg) {}

  /// Receives a pulse, which drives the motor for 24 ms.
  void receive_pulse(double width_us, Time now);
  void run_until(Time now);
  double sensor_mv() { return 2500.0 + reading_deg() * 3000.0 / 180.0; }

  /// Change of the width of the pulse for 180 degrees; negative for a servo that longer pulses turn clockwise.
  double span_us = 2000.0;

 private:
  std::optional<Time> pulsed_;
};

}  // namespace hrt::plate
