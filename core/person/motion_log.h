// Stores the positions of one motion, and estimates the person from them after the motion.
//
// The SD of the wander is a parameter of the filter, which innovations do not correct. After the reach, three filters,
// whose log_wander differs by -eps, 0 and eps (Tuning::wander_step) from the mean of its prior, process the stored
// positions. With the normalised innovation squared (nis) and the covariance S of innovations, log likelihoods are
//   l = beta sum over the positions of -(nis + log det S) / 2
// From l, the posterior of log_wander is approximated by a normal distribution with precision 1 / var - min(l'', 0) and
// a mean that is l' / precision above that of the prior (at most Tuning::max_wander_change). var is the variance of the
// prior, l' and l'' are finite differences over eps, and beta (Tuning::wander_evidence) is below 1 because successive
// positions are correlated. If the log was not closed, a fourth filter with the mean of the posterior then processes
// the positions, and estimates the other traits.
#pragma once

#include <array>
#include <optional>

#include "core/person/person_filter.h"

namespace hrt {

/// Positions of one motion. When `capacity` is reached, every other position is deleted, and only every second, fourth,
/// ... position is stored from then on. Uses no heap, lock or exception.
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

}  // namespace hrt
