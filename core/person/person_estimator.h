// From tracked positions, at any rate and with gaps, jumps and rests, to the state of finger and person.
//
//   gate    rejects outliers; a run of outliers is a jump to another position (OutlierGate)
//   phase   waiting until the onset, moving, paused or lifted (tracker/finger_phase)
//   filter  PersonFilter, over the motion; ModelFit says how well it predicts
//
// The onset is detected late, dated back by a fit to the first positions (motion_fit), and the positions since
// then pass through the filter, a few at each new sample.
#pragma once

#include <optional>

#include "core/person/motion_log.h"
#include "core/person/person_filter.h"
#include "core/plate/plate_model.h"
#include "core/tracker/finger_phase.h"

namespace hrt {

/// Counts implausible positions in a row. Up to a maximum they are outliers; the next one is accepted as a jump.
class OutlierGate {
 public:
  enum Verdict { accepted, outlier, relocated };

  /// `max_outliers`: a whole number.
  explicit OutlierGate(double max_outliers) : max_outliers_(max_outliers) {}

  Verdict judge(bool plausible) {
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

/// How well the filter predicts the positions that it then receives, as running means over about 20 positions in
/// motion:
///
///   nis          normalised innovation squared; 2 if the model holds
///   correlation  of an innovation with the previous one; 0 if the model holds
class ModelFit {
 public:
  /// Adds a position, outliers included: its innovation and the innovation's NIS.
  void add(const Tuning& tuning, const PlatePoint& innovation_mm, double nis);

  double nis() const { return nis_; }

  /// True if the model describes the motion. Innovations far below the noise may correlate: a tracker without
  /// noise shows every trace of the person.
  bool holds(const Tuning& tuning) const;

 private:
  double nis_ = 2.0;
  double correlation_ = 0.0;
  PlatePoint previous_mm_{0.0, 0.0};
};

/// Estimator of one reach. Uses no heap, lock or exception. One thread at a time.
class PersonEstimator {
 public:
  /// The finger is about to move over `path_mm` from near `start`, towards `virtual_direction_deg`.
  /// `noise`: of the tracker, if it is known; otherwise it is learnt while the finger rests.
  PersonEstimator(const PersonBelief& belief, double virtual_direction_deg, double path_mm, const PlatePoint& start,
                  const std::optional<TrackerNoise>& noise, const Tuning& tuning = {});

  /// Processes a position observed at `time_s`, later than the previous one. `plate`: orientations of the plate in the
  /// last second. False if the position is an outlier.
  bool observe(double time_s, const PlatePoint& position, const PlateTrace& plate);

  /// Advances to `time_s` without a sample.
  void predict(double time_s, const PlateTrace& plate);

  /// The finger is lifted: it feels nothing, and may come down at another position.
  void lift(double time_s, const PlateTrace& plate);

  /// The target moved at `time_s`, to `virtual_direction_deg` over a path that is `longer_mm` longer. The person
  /// answers after Tuning::reaction_time_s.
  void retarget(double time_s, double virtual_direction_deg, double longer_mm);

  /// The motion has begun.
  bool begun() const { return finger_.has_moved(); }
  /// True if the finger moves, and has neither paused on the way nor been lifted. A finger that rests where the filter
  /// expects the end of the motion has not paused.
  bool moving() const { return begun() && !clock_stopped_; }
  /// True if the filter has processed all positions.
  bool caught_up() const { return backlog_ == 0; }
  const PersonFilter& filter() const { return filter_; }
  const FingerPhase& finger() const { return finger_; }
  /// The filter with the person's answer to a moved target, while that is still to come.
  std::optional<PersonFilter> after_retarget() const;
  /// Time of the filter; before the onset, of the last position.
  double time_s() const { return filter_s_; }
  /// Rest position of the finger, the origin of the filter's positions.
  const PlatePoint& origin() const { return begun() ? origin_ : finger_.rest_place(); }
  /// Last position, observed or predicted.
  PlatePoint place() const;
  const TrackerNoise& noise() const { return finger_.noise(); }
  const ModelFit& fit() const { return fit_; }
  /// True if the model describes the motion so far.
  bool model_fits() const { return fit_.holds(tuning()); }
  double onset_s() const { return onset_s_; }
  /// Returns the belief about the person after the reach.
  PersonBelief learnt() const;

 private:
  const Tuning& tuning() const { return filter_.tuning(); }
  void begin_motion();
  bool catch_up(const PlateTrace& plate);
  bool take(const TimedPoint& sample, const PlateTrace& plate);
  void relocate(const PlatePoint& position);
  void carry_to(double time_s, const PlateTrace& plate);
  bool find_pause(double nis);

  struct Retarget {
    double time_s;  // time of the answer
    double virtual_direction_deg;
    double longer_mm;
  };

  PersonBelief belief_;
  double virtual_direction_deg_;
  double path_mm_;
  FingerPhase finger_;
  PersonFilter filter_;
  std::optional<Retarget> retarget_;  // still to be answered
  PlatePoint origin_;                 // position of the rest before the motion

  OutlierGate gate_;
  ModelFit fit_;
  MotionLog log_;

  bool clock_stopped_ = false;  // the person's clock: the motion has paused
  int backlog_ = 0;             // number of the last positions that the filter has not processed
  double filter_s_ = 0.0;
  double onset_s_ = 0.0;
};

}  // namespace hrt
