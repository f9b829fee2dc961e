// A simulated person who slides a fingertip over the plate: how they feel the ridges, where they mean to go,
// how they steer, and at what pace. Each part is chosen apart from the others. Nothing here is the model of
// the controller: results over such people say how the controller does with people who are not its model.
//
// Angles are degrees counter-clockwise from the mid-line; t is the ridge normal less the direction of motion,
// folded to within 90 degrees.
#pragma once

#include <array>
#include <optional>

#include "core/plate/plate_frame.h"
#include "core/simulation/own_path.h"
#include "core/simulation/random.h"

namespace hrt {

/// Shape of the shift of the perceived direction, as a function of t.
enum class IllusionFamily {
  linear,      ///< w t
  saturating,  ///< w t within `scale_deg`, constant beyond
  sine,        ///< w scale_deg sin 2t
  tanh,        ///< w scale_deg tanh(t / scale_deg)
  dead_band,   ///< nothing within scale_deg of 0, w (|t| - scale_deg) beyond
  unequal,     ///< w t to the left, half of w t to the right
  peaked,      ///< w t within scale_deg, and evenly back to 0 at 90
};

struct SimulatedIllusion {
  IllusionFamily family = IllusionFamily::linear;
  double tactile_weight = 0.2;  ///< w, in (0, 0.5)
  double scale_deg = 45.0;      ///< > 0; see the family
};

/// Perceived minus true direction of motion for the plate `offset_deg` from the motion; any finite angle, period
/// 180.
double felt_shift_deg(const SimulatedIllusion& illusion, double offset_deg);

/// The largest shift with the plate within `bound_deg` of the motion that raises the felt direction (`sign` >
/// 0) or lowers it.
double max_shift_deg(const SimulatedIllusion& illusion, double bound_deg, double sign);

enum class Steering {
  steps,        ///< paper section II-A, every 100 ms
  continuous,   ///< dP/dt = -k (felt(time - delay) - goal) + noise
  predictive,   ///< as continuous, with knowledge of the own direction without delay
  place,        ///< as continuous, towards the position of the virtual target as seen from the perceived position
  heavy_arm,    ///< a mass that slow muscles pull, feedback after the delay
  crossings,    ///< as continuous; ridges are felt only when the finger crosses one, every 10 mm
  placing_arm,  ///< as heavy_arm, towards the position of the virtual target
  corrections,  ///< as continuous, in corrections every 250 ms
};

enum class Pace {
  minimum_jerk,  ///< 10 u^3 - 15 u^4 + 6 u^5
  even,
  skewed,        ///< minimum jerk that peaks at two fifths of the time
  stop_and_go,   ///< minimum jerk whose clock stops for 0.3 s at 35 and at 70 % of it
  pause,         ///< minimum jerk whose clock stops for 0.6 s at half of it
  two_parts,     ///< minimum jerk to 60 % of the path, then again to the end
  reversal,      ///< overshoots by a tenth of the path and comes back
  submovements,  ///< three minimum jerks, one after the other, of shares and times drawn at each reach
  recorded,      ///< statistics of recorded reaches, drawn at each reach: draw_pace(), or a reach of OwnPath::recorded
};

struct Person {
  SimulatedIllusion illusion;
  Steering steering = Steering::continuous;
  double gain_per_s = 9.0;           ///< k
  double delay_s = 0.06;             ///< delay of perception
  double noise_deg2_per_s = 8.0;     ///< noise of the direction of motion
  double start_direction_deg = 0.0;  ///< direction of the first motion
  double bias_deg = 0.0;             ///< goal minus virtual direction
  double own_bias_deg = 0.0;         ///< added to what they feel of their own direction
  double habit_deg = 0.0;            ///< goal bends by habit (1 - 2 s) over the path s
  double scatter_deg = 0.0;          ///< SD of the bias from reach to reach
  double touch_s = 0.0;              ///< time constant with which a shift is perceived; 0: immediately
  double mass_kg = 1.0;              ///< mass of a heavy arm
  double muscle_s = 0.04;            ///< time constant of a heavy arm's force
  double weight_drift = 0.0;         ///< w changes by this from the start of a reach to its end
  Pace pace = Pace::minimum_jerk;
  double duration_s = 1.5;  ///< > 0, without pauses
  double path_scale = 1.0;  ///< length of the path over the distance asked for
  OwnPath own_path;         ///< added to the direction of motion
};

/// Distance between ridges, and the time constant with which a crossed ridge fades from what is felt.
inline constexpr double ridge_spacing_mm = 10.0;
inline constexpr double touch_memory_s = 0.3;

/// Mean perceived shift during a motion at that speed. Only people who feel ridges as they cross them depend on the
/// speed.
double mean_felt_shift_deg(const Person& person, double speed_mm_s, double offset_deg);
double max_shift_deg(const Person& person, double speed_mm_s, double bound_deg, double sign);

/// Time from a target's move to the person's answer.
inline constexpr double reaction_s = 0.2;

/// A reach of a simulated person. Advances in milliseconds.
class SlidingPerson {
 public:
  /// At rest at `start`, asked to go `distance_mm` to the virtual target in `virtual_direction_deg`. Without
  /// `feels_place` felt_position() is void unless the person seeks a place, and the target cannot move.
  SlidingPerson(const Person& person, const PlatePoint& start, double virtual_direction_deg, double distance_mm,
                Draws draws, bool feels_place = true);

  /// Moves the virtual target to `place`. The person answers after `reaction_s`, by the target as seen from the
  /// perceived position: the same motion stretched or shortened, or another one near its end.
  void retarget(const PlatePoint& place);

  /// One millisecond of the motion with the plate at `plate_orientation_deg` at its end.
  void advance(double plate_orientation_deg);

  bool done() const { return done_ && answers_in_ms_ == 0; }
  const PlatePoint& position() const { return position_; }
  /// Perceived position of the finger: the start, plus all motion in the perceived direction.
  const PlatePoint& felt_position() const { return felt_position_; }
  double speed_mm_s() const { return speed_mm_s_; }
  double direction_deg() const { return direction_deg_; }
  /// Perceived direction minus that of the virtual target, without the own path.
  double felt_error_deg() const { return felt_deg_ - virtual_direction_deg_ - own_deg_; }
  /// Perceived minus intended direction.
  double intended_error_deg() const { return felt_deg_ - goal_deg_; }
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
  double total_s_;  // duration including pauses
  PlatePoint virtual_place_;
  int answers_in_ms_ = 0;  // time until the answer to a target that has moved; 0: answered
  Draws draws_;
  PlatePoint position_;
  PlatePoint felt_position_;
  bool feels_place_;
  int delay_;            // milliseconds
  double noise_sd_deg_;  // a millisecond's
  double direction_deg_;
  double velocity_right_mm_s_ = 0.0, velocity_away_mm_s_ = 0.0;  // heavy arm
  double force_right_mn_ = 0.0, force_away_mn_ = 0.0;
  double speed_mm_s_ = 0.0;
  double time_s_ = 0.0, share_ = 0.0;  // progress(time_s_)
  double felt_deg_;
  double goal_deg_;
  double crossed_shift_deg_ = 0.0, touched_shift_deg_ = 0.0;
  double ridge_travel_mm_ = 0.0;
  double perceived_variance_deg2_ = 0.0;  // steps
  // End of a submovement.
  struct Part {
    double time, share;  // fraction of the whole
  };
  std::array<Part, 3> parts_{};
  RecordedPace pace_;
  PathShape shape_{};
  std::optional<RecordedReach> recorded_;  // recorded reach that this reach follows
  double own_deg_ = 0.0;                   // direction of the own path
  int millisecond_ = 0;
  bool done_ = false;
  // Perceived error of each millisecond, which the person answers after the delay.
  static constexpr int history_size = 256;
  std::array<double, history_size> felt_history_{};
  int rested_ms_ = 0;
  double felt_at_rest_deg_ = 0.0;
};

}  // namespace hrt
