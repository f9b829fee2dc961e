// A simulated person who slides a fingertip over the plate. Illusion, goal, steering and pace are chosen independently.
// Most combinations differ from the controller's model, so results show how the controller performs with such people.
//
// Angles are degrees counter-clockwise from the mid-line; t is the angle from the direction of motion to the ridge
// normal, wrapped to +-90 degrees.
#pragma once

#include <array>
#include <optional>

#include "core/plate/plate_frame.h"
#include "core/simulation/own_path.h"
#include "core/simulation/random.h"

namespace hrt {

/// Shift of the perceived direction as a function of t.
enum class IllusionFamily {
  linear,      ///< w t
  saturating,  ///< w t within `scale_deg`, constant beyond
  sine,        ///< w scale_deg sin 2t
  tanh,        ///< w scale_deg tanh(t / scale_deg)
  dead_band,   ///< 0 within scale_deg of 0; beyond, w (|t| - scale_deg) with the sign of t
  unequal,     ///< w t to the left, half of w t to the right
  peaked,      ///< w t within scale_deg; beyond, falls linearly to 0 at 90 degrees
};

struct SimulatedIllusion {
  IllusionFamily family = IllusionFamily::linear;
  double tactile_weight = 0.2;  ///< w, in (0, 0.5)
  double scale_deg = 45.0;      ///< > 0; see the family
};

/// Returns the shift for a ridge normal at `offset_deg` from the motion; period 180. Requires a finite offset.
double felt_shift_deg(const SimulatedIllusion& illusion, double offset_deg);

/// Returns the size of the largest shift to the left (`sign` > 0) or right with the ridge normal within `bound_deg` of
/// the motion.
double max_shift_deg(const SimulatedIllusion& illusion, double bound_deg, double sign);

enum class Steering {
  steps,        ///< in steps of 100 ms: paper section II-A
  continuous,   ///< d(direction)/dt = -k (perceived direction(time - delay) - goal) + noise
  predictive,   ///< as continuous, but the own direction is known without delay
  place,        ///< as continuous, towards the virtual target from the perceived position, up to 85 % of the path
  heavy_arm,    ///< a mass driven by muscles with a time constant; delayed feedback
  crossings,    ///< as continuous; the shift decays, and is renewed when the finger crosses a ridge, every 10 mm
  placing_arm,  ///< as heavy_arm, towards the position of the virtual target
  corrections,  ///< as continuous, with one correction every 250 ms
};

/// Fraction of the path over the fraction u of the duration.
enum class Pace {
  minimum_jerk,  ///< 10 u^3 - 15 u^4 + 6 u^5
  even,
  skewed,        ///< minimum jerk with the maximum of the speed at 0.37 of the time
  stop_and_go,   ///< minimum jerk with pauses of 0.3 s at 35 and at 70 % of the duration
  pause,         ///< minimum jerk with a pause of 0.6 s at half of the duration
  two_parts,     ///< minimum jerk to 60 % of the path, then again to the end
  reversal,      ///< overshoots by a tenth of the path and comes back
  submovements,  ///< three minimum-jerk motions in sequence, with random parts of path and time in each reach
  recorded,      ///< draw_pace(), or that of a reach in OwnPath::recorded
};

struct Person {
  SimulatedIllusion illusion;
  Steering steering = Steering::continuous;
  double gain_per_s = 9.0;        ///< k
  double delay_s = 0.06;          ///< sensory delay; clamped to 255 ms
  double noise_deg2_per_s = 8.0;  ///< density of the random walk of the direction of motion
  double start_direction_deg = 0.0;
  double bias_deg = 0.0;      ///< goal minus virtual direction
  double own_bias_deg = 0.0;  ///< bias of the perceived direction of the own motion
  double habit_deg = 0.0;     ///< the goal direction includes habit (1 - 2 s), where s is the fraction of the path
  double scatter_deg = 0.0;   ///< SD of the bias from reach to reach
  double touch_s = 0.0;       ///< time constant with which a shift is perceived; 0: immediately
  double mass_kg = 1.0;       ///< mass of a heavy arm
  double muscle_s = 0.04;     ///< time constant of a heavy arm's force
  double weight_drift = 0.0;  ///< change of w from the start of a reach to its end
  Pace pace = Pace::minimum_jerk;
  double duration_s = 1.5;  ///< duration of the motion without pauses and return, > 0; scaled by a recorded pace
  double path_scale = 1.0;  ///< length of the path divided by the distance to the target
  OwnPath own_path;
};

/// Distance between ridges, and time constant with which the shift decays after a crossing (Steering::crossings).
inline constexpr double ridge_spacing_mm = 10.0;
inline constexpr double touch_memory_s = 0.3;

/// Returns the mean shift during a motion at constant speed. The speed has an effect only with Steering::crossings.
/// Ignores touch_s and weight_drift.
double mean_felt_shift_deg(const Person& person, double speed_mm_s, double offset_deg);
double max_shift_deg(const Person& person, double speed_mm_s, double bound_deg, double sign);

/// Time from a target's move to the person's response.
inline constexpr double reaction_s = 0.2;

/// One reach of a simulated person, in steps of a millisecond.
class SlidingPerson {
 public:
  /// Begins at rest at `start`, before a motion over `distance_mm` towards `virtual_direction_deg`.
  SlidingPerson(const Person& person, const PlatePoint& start, double virtual_direction_deg, double distance_mm,
                Draws draws);

  /// Moves the virtual target to `place`. After `reaction_s` the person aims from the perceived position at the new
  /// target. If more than 10 % of the path remains, the rest of the path is rescaled; otherwise another motion begins.
  void retarget(const PlatePoint& place);

  /// Advances by one millisecond. `plate_orientation_deg`: plate orientation at the end of the millisecond.
  void advance(double plate_orientation_deg);

  bool done() const { return done_ && answers_in_ms_ == 0; }
  const PlatePoint& position() const { return position_; }
  /// Perceived position of the finger: the integral of the motion in the perceived direction.
  const PlatePoint& felt_position() const { return felt_position_; }
  double speed_mm_s() const { return speed_mm_s_; }
  double direction_deg() const { return direction_deg_; }
  /// Perceived direction minus the sum of virtual direction and own path's direction.
  double felt_error_deg() const { return felt_deg_ - virtual_direction_deg_ - own_deg_; }
  double elapsed_s() const { return time_s_; }

 private:
  void draw_reach();
  double own_direction_deg(double path_fraction) const;
  double progress(double time_s) const;
  void answer();
  double move(double travel_mm);
  double felt_shift_deg(double offset_deg, double travel_mm);
  void steer(double motion_deg);
  bool is_arm() const { return person_.steering == Steering::heavy_arm || person_.steering == Steering::placing_arm; }
  bool seeks_place() const { return person_.steering == Steering::place || person_.steering == Steering::placing_arm; }

  Person person_;
  double virtual_direction_deg_;
  double distance_mm_;
  double duration_with_pauses_s_;
  PlatePoint virtual_place_;
  int answers_in_ms_ = 0;  // time until the response to a moved target; 0: none is pending
  Draws draws_;
  PlatePoint position_;
  PlatePoint felt_position_;
  int delay_ms_;
  double noise_sd_deg_;  // SD of the noise that each step of 1 ms adds to the direction
  double direction_deg_;
  // State of an arm.
  double velocity_right_mm_s_ = 0.0, velocity_away_mm_s_ = 0.0;
  double force_right_mn_ = 0.0, force_away_mn_ = 0.0;

  double speed_mm_s_ = 0.0;
  double time_s_ = 0.0;
  double path_fraction_ = 0.0;  // progress(time_s_)
  double felt_deg_;
  double goal_deg_;
  double crossed_shift_deg_ = 0.0, touched_shift_deg_ = 0.0;
  double ridge_travel_mm_ = 0.0;
  double perceived_variance_deg2_ = 0.0;  // for Steering::steps
  // End of a submovement.
  struct Part {
    double time, share;  // fractions of the whole motion
  };
  std::array<Part, 3> parts_{};
  RecordedPace pace_;
  PathShape shape_{};
  std::optional<RecordedReach> recorded_;  // recording that this reach replays
  double own_deg_ = 0.0;                   // direction of the own path
  int millisecond_ = 0;
  bool done_ = false;
  int rested_ms_ = 0;              // millisecond of the last rest
  double felt_at_rest_deg_ = 0.0;  // the value for felt_history_ at that time
  // Perceived directions of the last milliseconds, for the delay; for Steering::predictive, minus that of the motion.
  static constexpr int history_size = 256;
  std::array<double, history_size> felt_history_{};
};

}  // namespace hrt
