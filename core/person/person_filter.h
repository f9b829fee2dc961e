// What is known of a finger that slides over the plate and of the person who moves it: an extended Kalman
// filter on tracked positions.
//
// The person moves over a path of length L at the pace of pace.h, feels their motion shifted by the ridges
// (illusion.h), and steers what they feel towards a goal:
//
//   progress    v = L r s'(u),   u' = r = exp(rho)
//   goal        G = V + d + dr + c (1 - 2 s(u))
//   motion      phi' = -k (phi + g(T(now - 60 ms) - phi) - G),   x' = -v sin phi,   z' = v cos phi
//   measured    x + nx and z + nz, each with white noise; nx and nz decay within 0.1 s if nothing else is
//   known, dr
//               within 0.3 s
//
// Unknown besides place x, z, direction phi and phase u: w, b and f of the illusion, the gain k, the bias d,
// the habit c of curving, the evenness a of the pace, rho, and the share of the goal's direction in which the
// person sets out. core/person/README.md has the derivatives and the source of every number.
#pragma once

#include <Eigen/Core>
#include <cstring>

#include "core/person/illusion.h"
#include "core/person/person_belief.h"
#include "core/reach/pace.h"
#include "core/tracker/resting_finger.h"

namespace hrt {

/// What is known of the finger and of the person during a motion, or how well.
struct PersonState {
  double right_mm, away_mm;              ///< the finger's place, from where it rested
  double direction_deg;                  ///< of its motion
  double phase;                          ///< u
  double log_rate;                       ///< rho
  double wander_deg;                     ///< dr
  double noise_right_mm, noise_away_mm;  ///< the tracker's correlated noise
  double weight, curve;                  ///< w and b of the illusion
  double gain_s;                         ///< k, 1/s
  double bias_deg, habit_deg;            ///< d and c
  double evenness;                       ///< a
  double heading;
  double fading;  ///< f of the illusion
};
/// Of each, in its order.
inline constexpr const char* person_state_names[] = {
    "right_mm", "away_mm", "direction_deg", "phase",    "log_rate",  "wander_deg", "noise_right_mm", "noise_away_mm",
    "weight",   "curve",   "gain_per_s",    "bias_deg", "habit_deg", "evenness",   "heading",        "fading"};

/// Finger and person at the filter's time, as a sample's plan and command read them.
struct PersonNow {
  PersonState mean;
  Progress pace;
  double speed_mm_s;
  double goal_deg;    ///< G
  Illusion illusion;  ///< at this speed
};

/// One motion. Places are millimetres from where the finger rested. No heap, no lock, no exception.
class PersonFilter {
 public:
  enum Index {
    right,
    away,
    direction,
    phase,
    log_rate,
    wander,
    noise_right,
    noise_away,
    weight,
    curve,
    gain,
    bias,
    habit,
    evenness,
    heading,
    fading,
    size
  };
  using State = Eigen::Matrix<double, size, 1>;
  using Covariance = Eigen::Matrix<double, size, size>;

  /// What a step of the motion does to the state: the finger's way, sine and cosine of its direction, its
  /// turn, the share of the duration that passes, what is left of what decays; and its derivatives.
  struct Step {
    double seconds, travel_mm, sine, cosine, turn_deg, phase, wander_kept, noise_kept;
    FeltShift felt;
    double travel_by_phase, travel_by_evenness, goal_by_habit, goal_by_phase;
    double turn_by_felt, turn_by_direction, turn_by_gain;
  };

  /// At rest, about to move over `path_mm` > 0 towards `virtual_direction_deg`.
  PersonFilter(const PersonBelief& belief, double virtual_direction_deg, double path_mm, const TrackerNoise& noise);

  /// Begins the motion with a log rate and evenness that fit its first samples. `onset_sd_s`, `place_sd_mm`:
  /// standard deviations of when it began and of where the finger rested.
  void begin(double motion_log_rate, double motion_evenness, double onset_sd_s, double place_sd_mm);

  /// `seconds` of motion, at most 12 ms, while the ridge normal that is felt stands at `felt_plate_deg`.
  void move(double seconds, double felt_plate_deg);

  /// `seconds` of rest: the person's clock stands still.
  void rest(double seconds);

  /// Takes a position in, unless its normalised innovation squared (chi-squared with 2 degrees of freedom if
  /// the model holds) exceeds `gate`. Returns it.
  double observe(double right_mm, double away_mm, double gate);

  /// The place is void: the tracker has jumped, or the finger was lifted and set down.
  void place_at(double right_mm, double away_mm);

  /// The target has moved within the motion: asked to go in `virtual_direction_deg`, over a path that still
  /// goes `longer_mm` further than it did. `answered`: the person turns now, or else within wander_s.
  void retarget(double virtual_direction_deg, double longer_mm, bool answered);

  /// The person's clock may be off by `seconds`, standard deviation.
  void loosen_clock(double seconds);

  PersonState state() const { return named(state_); }
  PersonNow now() const;
  /// Standard deviations.
  PersonState deviation() const { return named(covariance_.diagonal().cwiseMax(0.0).cwiseSqrt()); }
  /// Of the finger's place along a unit vector.
  double place_variance_mm2(double right, double away) const;
  /// Of the felt shift with these slopes and of the goal, which a degree of bias moves by `by_bias`, to first
  /// order.
  double shift_variance_deg2(const FeltShift& slopes, double by_bias) const;

  /// The same in this file's order.
  const State& vector() const { return state_; }
  const Covariance& covariance() const { return covariance_; }
  /// At a speed of the finger, which has come `travelled_mm`.
  Illusion illusion(double speed_mm_s, double travelled_mm) const;
  /// At the mean speed of the reach, ridges having been crossed.
  Illusion mean_illusion() const { return illusion(mean_speed_mm_s(), path_mm_); }
  /// r, one over the duration, 1/s.
  double rate() const { return rate_; }
  double mean_speed_mm_s() const { return path_mm_ * rate_; }
  double speed_mm_s() const { return mean_speed_mm_s() * progress(state_(evenness), state_(phase)).rate; }
  double path_mm() const { return path_mm_; }

  /// G at a share of the path, with the fast part at `wander_deg`.
  double goal_deg(double share, double wander_deg) const;

  LinearIllusion linear_illusion() const;

  /// What this reach says of the person.
  PersonBelief belief() const;

 private:
  static PersonState named(const State& vector) {
    PersonState state;
    static_assert(sizeof state == sizeof(double) * size);
    std::memcpy(&state, vector.data(), sizeof state);
    return state;
  }
  void move_state(const Step& step);
  void add_noise(const Step& step);
  void keep_in_range();

  double virtual_direction_deg_;
  double scatter_deg_, scatter_variance_deg2_;  // of the belief
  double path_mm_;
  TrackerNoise noise_;
  State state_;
  double rate_;  // of state_
  Covariance covariance_;
};

/// How the fast part of the goal decays.
inline constexpr double wander_s = 0.3;
/// Between plate and felt direction, in the person.
inline constexpr double sensory_delay_s = 0.06;

}  // namespace hrt
