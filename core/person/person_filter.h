// Extended Kalman filter of a finger that slides over the plate, and of the person who moves it.
//
// The person moves along a path of length L with the pace s(u). The ridges shift the perceived direction by g. The
// person steers the perceived direction towards the goal G, which is the virtual direction V plus the bias B
// (person_model.h). In addition, the direction of the hand deviates without delay by the own path o, so that the hand
// leaves the line to the goal and returns to this line. With s_u = ds/du:
//
//   progress    v = L r s_u(u),   du/dt = r = exp(rho)
//   own path    o = omega + c (1 - 2 s(u)) - y / (L (1 - s)),   dy/dt = v (omega - y / (L (1 - s)))
//   motion      phi = psi + o,   dpsi/dt = -k (psi + g(T(time - sensory delay) - phi) - G),   G = V + B
//               dx/dt = -v sin phi,   dz/dt = v cos phi
//   measured    x + nx and z + nz, each with white noise. nx and nz are correlated noise with a time constant of 0.1 s
//               unless another one is known. The time constant of omega is 0.35 of the duration.
//
// person_state.h lists the states. core/person/README.md has symbols and derivatives.
#pragma once

#include <Eigen/Core>

#include "core/person/person_belief.h"
#include "core/person/person_model.h"
#include "core/person/person_state.h"
#include "core/person/tuning.h"
#include "core/plate/plate_frame.h"
#include "core/tracker/noise_learner.h"

namespace hrt {

/// Filter for one motion. Positions are relative to the rest position before the motion. Uses no heap, lock or
/// exception.
class PersonFilter {
 public:
  using X = PersonState;
  using State = Eigen::Matrix<double, X::count, 1>;
  using Covariance = Eigen::Matrix<double, X::count, X::count>;

  /// Begins at rest, before a motion over `path_mm` > 0 towards `virtual_direction_deg`.
  PersonFilter(const PersonBelief& belief, double virtual_direction_deg, double path_mm, const TrackerNoise& noise,
               const Tuning& tuning = {});

  /// Begins the motion. `log_rate`: see motion_fit.h. `onset_sd_s`, `place_sd_mm`: SDs of onset time and rest position.
  void begin(double log_rate, double onset_sd_s, double place_sd_mm);

  /// Returns a copy with a log_wander that is larger by `change`. Call it before the first move().
  PersonFilter with_wander(double change) const;

  static constexpr double max_step_s = 0.012;
  /// Advances the motion by `seconds`, at most max_step_s. `felt_plate_deg`: plate orientation one sensory delay
  /// (Tuning::sensory_delay_s) before the middle of the step.
  void move(double seconds, double felt_plate_deg);

  /// Advances by `seconds` in which the finger rests: the phase u does not change.
  void rest(double seconds);

  /// A measured position minus its prediction: position of the state plus correlated noise. H: derivative of the
  /// prediction by the state; P: covariance of the state; R: covariance of the white noise.
  struct Innovation {
    PlatePoint off_mm;                         ///< nu: measured minus predicted position
    Eigen::Matrix<double, X::count, 2> cross;  ///< P H^T
    Eigen::Matrix2d information;               ///< S^-1, S = H P H^T + R
    double nis;  ///< nu^T S^-1 nu: chi-squared with 2 degrees of freedom if the model is right
  };
  Innovation innovation(const PlatePoint& position) const;

  /// Corrects the state by `innovation`. The filter must not have changed since innovation() returned it.
  void correct(const Innovation& innovation);

  /// Sets the position after a jump, a pause or a lift.
  void place_at(const PlatePoint& position);

  /// Changes the target during the motion, to `virtual_direction_deg` and a path that is `longer_mm` longer.
  /// `answered`: true: the person responds immediately; false: the response is still to come, and goal_deg() approaches
  /// the new goal with the time constant Tuning::answer_s.
  void retarget(double virtual_direction_deg, double longer_mm, bool answered);

  /// Increases the variance of the phase u by that of a time with the SD `seconds`.
  void add_phase_sd(double seconds);

  double mean(X::Index index) const { return mean_(index); }
  double sd(X::Index index) const;
  const State& mean() const { return mean_; }
  const Covariance& covariance() const { return covariance_; }
  PlatePoint position() const { return {mean_(X::right), mean_(X::away)}; }
  /// Variance of `right` x + `away` z, where (x, z) is the position.
  double position_variance_mm2(double right, double away) const;

  Illusion illusion(double speed_mm_s, double travelled_mm) const;
  /// Illusion at the mean speed of the reach, after the whole path.
  Illusion mean_illusion() const { return illusion(mean_speed_mm_s(), path_mm_); }
  double rate() const { return rate_; }  ///< r: one over the duration, 1/s
  double mean_speed_mm_s() const { return path_mm_ * rate_; }
  double speed_mm_s() const { return mean_speed_mm_s() * pace(mean_(X::phase)).rate; }  ///< v: present speed
  double path_mm() const { return path_mm_; }
  double direction_deg() const;  ///< phi: direction of the motion
  /// G, when the fraction `turn_kept` of the pending response to a moved target is still to come.
  double goal_deg(double turn_kept = 1.0) const {
    return virtual_direction_deg_ + mean_(X::bias) + turn_kept * unanswered_deg_;
  }
  /// Fraction of the response to a moved target that is still to come after `seconds`; 1 if no response is pending.
  double turn_kept(double seconds) const;
  /// Own path o at a fraction of the path, when the fraction `wander_kept` of the present wander remains.
  double own_deg(double path_fraction, double wander_kept) const;
  /// Lateral distance, left positive, that the own path will add until arrival.
  double own_to_come_mm() const;
  Progress pace(double phase) const { return progress(mean_(X::evenness), phase, tuning_.pace_skew); }

  /// Posterior of the traits, from the samples processed so far.
  PersonBelief belief() const;
  const Tuning& tuning() const { return tuning_; }

 private:
  struct Step;
  Step linearised(double seconds, double felt_plate_deg) const;
  double displacement_deg_mm(double path_fraction) const;
  void keep_in_range();

  Tuning tuning_;
  double virtual_direction_deg_;
  // Former minus present virtual direction, of the part of a target's move to which the person has not responded yet.
  double unanswered_deg_ = 0.0;
  double path_mm_;
  TrackerNoise noise_;
  double wander_deg2_;
  State mean_;
  double rate_;  // exp(rho)
  Covariance covariance_;
};

}  // namespace hrt
