// Tracked positions as they come, at any rate, with gaps, jumps and rests, to what is known of the finger and
// the person. The onset is found late, dated back by a fit to the first samples, and those are then run
// through PersonFilter, a few at each new sample.
#pragma once

#include <optional>

#include "core/person/person_filter.h"
#include "core/plate/plate_model.h"
#include "core/tracker/recent_places.h"
#include "core/tracker/resting_finger.h"

namespace hrt {

/// From a target's move to the person's answer.
inline constexpr double reaction_time_s = 0.2;

enum class FingerMotion {
  resting,  ///< before the reach
  moving,
  paused,  ///< within it: the finger rests or is lifted
};

/// How well the filter predicts the positions it then sees, over the last twenty or so.
struct ModelFit {
  double nis = 2.0;          ///< normalised innovation squared, mean; 2 if the model holds
  double correlation = 0.0;  ///< of an innovation with the one before it; 0 if the model holds

  /// Innovations well below what the noise explains may be alike: a tracker without noise shows every trace
  /// of the person.
  bool holds() const { return nis < 4.5 && (correlation < 0.75 || nis < 1.0); }
};

/// One reach. No heap, no lock, no exception. One thread at a time.
class PersonEstimator {
 public:
  /// The finger is about to move over `path_mm` from near `start`, asked to go in `virtual_direction_deg`.
  /// `noise`: of the tracker, if it is known; else it is learnt while the finger rests.
  PersonEstimator(const PersonBelief& belief, double virtual_direction_deg, double path_mm, const PlatePoint& start,
                  const std::optional<TrackerNoise>& noise);

  /// Takes a position in, seen at `time_s`, after the last one's. `plate` has stood where its trace says.
  /// False if it was left out: it is five standard deviations off, or a resting finger cannot be there so soon.
  bool observe(double time_s, const PlatePoint& position, const PlateTrace& plate);

  /// Nothing was seen, and time passes until `time_s`.
  void predict(double time_s, const PlateTrace& plate);

  /// The finger is off the plate: nothing is felt, and it may come back elsewhere.
  void lift(double time_s, const PlateTrace& plate);

  /// The target has moved at `time_s`: asked to go in `virtual_direction_deg`, over a path that is
  /// `longer_mm` longer. The person answers after reaction_time_s.
  void retarget(double time_s, double virtual_direction_deg, double longer_mm);

  FingerMotion motion() const { return motion_; }
  /// The last position was averaged into the one before it, which leaves the filter as it is.
  bool merged() const { return places_.merged(); }
  /// The filter has taken in all that was seen.
  bool caught_up() const { return backlog_ == 0; }
  const PersonFilter& filter() const { return filter_; }
  /// The filter with the person's answer to a moved target, while that is still to come.
  std::optional<PersonFilter> after_retarget() const;
  /// Of the filter; before the finger moves, of the last position.
  double time_s() const { return filter_s_; }
  /// Where the finger rested: the filter's places are measured from here.
  const PlatePoint& origin() const { return rest_.place(); }
  /// The last place that was seen or is predicted.
  PlatePoint place() const;
  const TrackerNoise& noise() const { return rest_.noise(); }
  const ModelFit& fit() const { return fit_; }
  /// When the motion began.
  double onset_s() const { return onset_s_; }

 private:
  bool is_wild(double time_s, const PlatePoint& position);
  void begin_motion();
  bool catch_up(const PlateTrace& plate);
  bool take(const TimedPoint& sample, const PlateTrace& plate);
  void take_paused(const TimedPoint& sample);
  void carry_to(double time_s, const PlateTrace& plate);
  bool stands_still(PlatePoint& where) const;

  struct Retarget {
    double time_s;  // of the answer
    double virtual_direction_deg;
    double longer_mm;
  };

  PersonBelief belief_;
  double virtual_direction_deg_;
  double path_mm_;
  RecentPlaces places_;
  RestingFinger rest_;
  PersonFilter filter_;
  std::optional<Retarget> retarget_;  // still to be answered
  FingerMotion motion_ = FingerMotion::resting;
  ModelFit fit_;

  int backlog_ = 0;  // of the last places, those that the filter has not seen
  PlatePoint pause_{};

  double filter_s_ = 0.0;
  double onset_s_ = 0.0;
  int outliers_ = 0;  // in a row
  int wild_ = 0;      // in a row, of a finger at rest
  bool lifted_ = false;
  PlatePoint last_innovation_{0.0, 0.0};
};

}  // namespace hrt
