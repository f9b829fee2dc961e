// Extended Kalman filter of a finger that slides over the plate and of the person who moves it.
//
// The person moves over a path of length L at the pace of pace.h, perceives the motion shifted by the ridges
// (illusion.h), and steers the perceived direction towards a goal G, which is the virtual direction V plus the bias B.
// The own path strays from the line to the goal and returns to it, without lag:
//
//   progress    v = L r s'(u),   u' = r = exp(rho)
//   own path    o = dr + c (1 - 2 s(u)) - y / (L (1 - s)),   y' = v (dr - y / (L (1 - s)))
//   motion      phi = psi + o,   psi' = -k (psi + g(T(now - 60 ms) - phi) - G),   G = V + B
//               x' = -v sin phi,   z' = v cos phi
//   measured    x + nx and z + nz, each with white noise; nx and nz decay within 0.1 s unless known otherwise, dr
//               within 0.3 s
//
// person_state.h lists the states; core/person/README.md has the derivatives.
#pragma once

#include <Eigen/Core>

#include "core/person/illusion.h"
#include "core/person/person_belief.h"
#include "core/person/person_state.h"
#include "core/person/tuning.h"
#include "core/plate/plate_frame.h"
#include "core/reach/pace.h"
#include "core/tracker/noise_learner.h"

namespace hrt {

/// Quantities derived from the state, at the time of the filter.
struct PersonNow {
  Progress pace;
  double speed_mm_s;
  double direction_deg;  ///< phi
  double goal_deg;       ///< G + o: the direction that the person means to move in
  Illusion illusion;     ///< illusion at this speed
};

/// Filter of one motion. Positions are relative to the rest before it. Uses no heap, lock or exception.
class PersonFilter {
 public:
  using X = PersonState;
  using State = Eigen::Matrix<double, X::count, 1>;
  using Covariance = Eigen::Matrix<double, X::count, X::count>;

  /// At rest, about to move over `path_mm` > 0 towards `virtual_direction_deg`.
  PersonFilter(const PersonBelief& belief, double virtual_direction_deg, double path_mm, const TrackerNoise& noise,
               const Tuning& tuning = {});

  /// Begins the motion with a log rate that fits its first samples. `onset_sd_s`, `place_sd_mm`: SDs of the onset and
  /// of where the finger rested.
  void begin(double log_rate, double onset_sd_s, double place_sd_mm);

  /// This filter, before its motion, with log_wander larger by `change`.
  PersonFilter with_wander(double change) const;

  static constexpr double max_step_s = 0.012;  ///< longest step of move()
  /// `seconds` of motion, at most max_step_s, with the ridge normal that is felt at `felt_plate_deg`.
  void move(double seconds, double felt_plate_deg);

  /// `seconds` of rest: the person's clock stops.
  void rest(double seconds);

  /// A measured position minus its prediction: nu = z - H x, with H x = position + correlated noise.
  struct Innovation {
    PlatePoint off_mm;                         ///< nu
    Eigen::Matrix<double, X::count, 2> cross;  ///< P H'
    Eigen::Matrix2d information;               ///< S^-1, S = H P H' + R
    double nis;  ///< nu' S^-1 nu: chi-squared with 2 degrees of freedom if the model holds
  };
  Innovation innovation(const PlatePoint& position) const;

  /// Takes the position of `innovation` in. The filter must not have changed since then.
  void correct(const Innovation& innovation);

  /// The finger is elsewhere: the tracker has jumped, or the finger was lifted and set down.
  void place_at(const PlatePoint& position);

  /// The target moved within the motion: to `virtual_direction_deg`, over a path that goes `longer_mm` further than
  /// before. `answered`: the person turns now, otherwise within answer_s.
  void retarget(double virtual_direction_deg, double longer_mm, bool answered);

  /// Adds an SD of `seconds` to the person's clock.
  void loosen_clock(double seconds);

  double mean(X::Index index) const { return mean_(index); }
  double sd(X::Index index) const;
  const State& mean() const { return mean_; }
  const Covariance& covariance() const { return covariance_; }
  PlatePoint position() const { return {mean_(X::right), mean_(X::away)}; }
  /// Variance of the position along a unit vector.
  double position_variance_mm2(double right, double away) const;
  /// Variance, to first order, of the felt shift with these slopes and of the goal, which a degree of bias moves by
  /// `by_bias`.
  double shift_variance_deg2(const FeltShift& slopes, double by_bias) const;

  PersonNow now() const;
  /// Illusion at a speed of the finger after `travelled_mm`.
  Illusion illusion(double speed_mm_s, double travelled_mm) const;
  /// At the mean speed of the reach, ridges having been crossed.
  Illusion mean_illusion() const { return illusion(mean_speed_mm_s(), path_mm_); }
  /// r, one over the duration, 1/s.
  double rate() const { return rate_; }
  double mean_speed_mm_s() const { return path_mm_ * rate_; }
  double path_mm() const { return path_mm_; }
  /// phi: direction of motion.
  double direction_deg() const;
  /// G, after `turn_kept` of the answer to a moved target that is still to come.
  double goal_deg(double turn_kept = 1.0) const {
    return virtual_direction_deg_ + mean_(X::bias) + turn_kept * unanswered_deg_;
  }
  /// Fraction of the answer to a moved target that is still to come after `seconds`; 1 without such an answer.
  double turn_kept(double seconds) const;
  /// o at a fraction of the path, after `wander_kept` of the wander.
  double own_deg(double path_fraction, double wander_kept) const;
  /// Lateral distance, to the left, that the own path adds until arrival: it returns to the line.
  double own_to_come_mm() const;
  /// The pace, at a phase.
  Progress pace(double phase) const { return progress(mean_(X::evenness), phase, tuning_.pace_skew); }

  /// Estimate of the person from this reach.
  PersonBelief belief() const;
  const Tuning& tuning() const { return tuning_; }

 private:
  struct Step;
  void carry(Step step);
  void move_state(const Step& step);
  void add_noise(const Step& step);
  double strayed_deg_mm(double path_fraction) const;
  void keep_in_range();

  Tuning tuning_;
  double virtual_direction_deg_;
  double unanswered_deg_ =
      0.0;  // angle from V to the goal that the person does not answer yet, after the target has moved
  double path_mm_;
  TrackerNoise noise_;
  double wander_deg2_;  // variance of the wander
  State mean_;
  double rate_;  // exp(rho)
  Covariance covariance_;
};

}  // namespace hrt
