// Positions of one motion, and the estimate of the person from them after the motion.
//
// The SD of the wander is a parameter of the filter, not a state. It is estimated by likelihood: after the reach the
// motion passes through filters that differ in log_wander alone, by -eps, 0 and eps. With their log likelihoods
//
//   l = beta sum over the positions of -(nis + log det S) / 2
//
// the posterior of log_wander is to second order normal, with precision 1 / var - l'' and a mean that lies
// l' / precision above the prior's. var is the variance of the prior, l' and l'' are differences over eps, and beta < 1
// accounts for positions that are less independent than in the model. The motion then passes through a filter with that
// mean, which determines the other traits.
#pragma once

#include <array>
#include <optional>

#include "core/person/person_filter.h"

namespace hrt {

/// Positions of one motion, at most `capacity`: when the log is full, every other one is dropped. Uses no heap, lock or
/// exception.
class MotionLog {
 public:
  static constexpr int capacity = 64;

  /// Begins with the state of `filter` at `onset_s`.
  void begin(const PersonFilter& filter, double onset_s);
  /// Adds a position, relative to where the finger rested, and the ridge normal felt at that time. `time_s`: after the
  /// last one's. Ignored after close().
  void add(double time_s, const PlatePoint& position, double felt_plate_deg);
  /// Ends the log at a pause, a lift, a jump or another target: later positions are not added.
  void close() { closed_ = true; }

  int count() const { return count_; }
  /// Returns the belief about the person after the motion. `learnt` is the belief of the filter that ran during the
  /// reach; if the motion was interrupted, it determines all traits but log_wander.
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
  int stride_ = 1;   // one of this many positions is kept
  int skipped_ = 0;  // since the last one
  bool closed_ = true;
};

}  // namespace hrt
