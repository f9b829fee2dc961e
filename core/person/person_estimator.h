// Estimates the state of finger and person from tracked positions, which may come at any rate, with interruptions,
// jumps and rests.
//   phase   FingerPhase: waiting until the onset, moving, paused or lifted (tracker/finger_phase.h)
//   gate    OutlierGate rejects outliers of the motion, and accepts a run of them as a jump
//   filter  PersonFilter runs from the onset on; ModelFit measures how well the filter predicts the positions
//   log     MotionLog stores positions of the motion, and estimates the person from them after its end
// A motion is detected some time after its onset. motion_fit then estimates the time of the onset from the first
// positions, and the filter processes the stored positions since the onset, a few with each new sample.
#pragma once

#include <array>
#include <optional>

#include "core/person/person_filter.h"
#include "core/plate/plate_model.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

/// Counts successive implausible positions: the first `max_outliers` are outliers; the next one is accepted as a jump.
class OutlierGate {
 public:
  enum Result { accepted, outlier, relocated };

  explicit OutlierGate(double max_outliers) : max_outliers_(max_outliers) {}

  Result test(bool plausible) {
    outliers_ = plausible ? 0 : outliers_ + 1;
    if (outliers_ <= max_outliers_) return plausible ? accepted : outlier;
    outliers_ = 0;
    return relocated;
  }
  void reset() { outliers_ = 0; }

 private:
  double max_outliers_;
  int outliers_ = 0;
};

/// Measures how well the filter predicts positions before it processes them, as running means over about 20 positions:
///   nis          normalised innovation squared; the expectation is 2 if the model is right
///   correlation  correlation of successive innovations; the expectation is 0 if the model is right
class ModelFit {
 public:
  /// Adds the innovation of a position and its NIS, also for outliers, with a weight in the means.
  void add(double weight, const PlatePoint& innovation_mm, double nis);

  double nis() const { return nis_; }

  /// Returns true if the model describes the motion. Correlated innovations are accepted if the mean NIS is small: with
  /// a tracker that has hardly any noise, innovations show every deviation of the person from the model, and correlate.
  bool holds(const Tuning& tuning) const;

 private:
  double nis_ = 2.0;
  double correlation_ = 0.0;
  PlatePoint previous_mm_{0.0, 0.0};
};

/// Positions of one motion, from which the person is estimated after the motion.
///
/// The SD of the wander is a parameter of the filter, which innovations do not correct. After the reach, three filters,
/// whose log_wander differs by -eps, 0 and eps (Tuning::wander_step) from the mean of its prior, process the stored
/// positions. With the normalised innovation squared (nis) and the covariance S of innovations, log likelihoods are
///   l = beta sum over the positions of -(nis + log det S) / 2
/// From l, the posterior of log_wander is approximated by a normal distribution with precision 1 / var - min(l'', 0)
/// and a mean that is l' / precision above that of the prior (at most Tuning::max_wander_change). var is the variance
/// of the prior, l' and l'' are finite differences over eps, and beta (Tuning::wander_evidence) is below 1 because
/// successive positions are correlated. If the log was not closed, a fourth filter with the mean of the posterior then
/// processes the positions, and estimates the other traits.
///
/// When `capacity` is reached, every other position is deleted, and only every second, fourth, ... position is stored
/// from then on. Uses no heap, lock or exception.
class MotionLog {
 public:
  static constexpr int capacity = 64;

  /// Deletes all positions, and stores `filter` as the state at `onset_s`.
  void begin(const PersonFilter& filter, double onset_s);
  /// Adds a position relative to the rest position, and the plate orientation whose effect the person perceives at
  /// `time_s`. Times must increase. Has no effect after close().
  void add(double time_s, const PlatePoint& position, double felt_plate_deg);
  /// Ends the log early, at a pause, a lift, a jump or a move of the target: later positions are ignored.
  void close() { closed_ = true; }

  int count() const { return count_; }
  /// Returns the posterior of the person after the motion. `learnt`: posterior of the filter that ran during the reach.
  /// If the log was closed, returns `learnt` with a new log_wander; if the log is empty, returns `learnt` unchanged.
  PersonBelief belief(const PersonBelief& learnt) const;

 private:
  struct Position {
    double time_s;
    PlatePoint position;
    double felt_plate_deg;
  };
  double log_likelihood(PersonFilter& filter) const;

  std::array<Position, capacity> positions_;
  std::optional<PersonFilter> filter_;  // filter at the onset
  double onset_s_ = 0.0;
  int count_ = 0;
  int stride_ = 1;   // one of `stride_` positions is stored
  int skipped_ = 0;  // number of positions since the last stored one
  bool closed_ = true;
};

/// Estimator for one reach. Uses no heap, lock or exception. One thread at a time.
class PersonEstimator {
 public:
  /// Begins before the motion: the finger is near `start`, and will move over `path_mm` towards
  /// `virtual_direction_deg`. `noise`: noise of the tracker; nullopt: it is estimated while the finger rests.
  PersonEstimator(const PersonBelief& belief, double virtual_direction_deg, double path_mm, const PlatePoint& start,
                  const std::optional<TrackerNoise>& noise, const Tuning& tuning = {});

  /// Adds a plate orientation at `time_s`, not earlier than the last one. Requires one before the first observation.
  void add_plate(double time_s, double orientation_deg) { plate_.add(time_s, orientation_deg); }
  /// Plate orientations of the last second.
  const PlateTrace& plate() const { return plate_; }

  /// Processes a position observed at `time_s`, later than the previous one. Returns false for an outlier,
  /// and for a jump during the motion.
  bool observe(double time_s, const PlatePoint& position);

  /// After the onset, advances the filter to `time_s` without a sample, if caught_up().
  void predict(double time_s);

  /// Reports that the finger is lifted. The finger may be set down at another position.
  void lift(double time_s);

  /// Reports that the target moved at `time_s`, to `virtual_direction_deg`, and made the path `longer_mm` longer. After
  /// the onset, the person responds Tuning::reaction_time_s later.
  void retarget(double time_s, double virtual_direction_deg, double longer_mm);

  /// True once the onset has been detected.
  bool begun() const { return finger_.has_moved(); }
  /// True if the finger has begun to move, and is neither lifted nor paused. A rest while the filter expects a low
  /// speed, as at the end of the motion, is no pause.
  bool moving() const { return begun() && !clock_stopped_; }
  /// True if the filter has processed all stored positions since the onset.
  bool caught_up() const { return unprocessed_ == 0; }
  const PersonFilter& filter() const { return filter_; }
  const FingerPhase& finger() const { return finger_; }
  /// Returns a copy of the filter after the target's move, before the response; nullopt if no response is pending.
  std::optional<PersonFilter> after_retarget() const;
  /// Time of the filter's state, on the time axis of observe(); before the onset, time of the last position.
  double time_s() const { return filter_s_; }
  /// Rest position of the finger, which is the origin of the filter's positions.
  const PlatePoint& origin() const { return begun() ? origin_ : finger_.rest_place(); }
  /// Position of the finger: the last tracked one before the onset, the estimate of the filter after it.
  PlatePoint place() const;
  const TrackerNoise& noise() const { return finger_.noise(); }
  const ModelFit& fit() const { return fit_; }
  bool model_fits() const { return fit_.holds(tuning()); }
  double onset_s() const { return onset_s_; }
  /// Returns the posterior of the person after the reach; see MotionLog::belief().
  PersonBelief learnt() const;

 private:
  const Tuning& tuning() const { return filter_.tuning(); }
  void begin_motion();
  bool take_next();
  void relocate(const PlatePoint& position);
  void carry_to(double time_s);
  bool find_pause(double nis);

  struct Retarget {
    double time_s;  // time of the person's response
    double virtual_direction_deg;
    double longer_mm;
  };

  PersonBelief belief_;
  double virtual_direction_deg_;
  double path_mm_;
  PlateTrace plate_;
  FingerPhase finger_;
  PersonFilter filter_;
  std::optional<Retarget> retarget_;  // move of the target to which the person has not responded yet
  PlatePoint origin_;                 // position of the rest before the motion

  OutlierGate gate_;
  ModelFit fit_;
  MotionLog log_;

  bool clock_stopped_ = false;  // the filter's phase does not advance: the finger has paused or is lifted
  int unprocessed_ = 0;
  double filter_s_ = 0.0;
  double onset_s_ = 0.0;
  double felt_plate_deg_ = 0.0;  // ridge normal whose effect the person perceived in the last step of the filter
};

}  // namespace hrt
