// A finger at rest, before it moves: where it rests, the noise that it is seen with, and when it leaves.
#pragma once

#include <optional>

#include "core/tracker/recent_places.h"

namespace hrt {

/// White and correlated noise of a tracked coordinate, standard deviations, > 0.
struct TrackerNoise {
  double white_mm = 0.8;
  double correlated_mm = 0.9;
  double correlation_s = 0.1;  ///< the correlated part decays to 1/e in this, > 0

  double variance_mm2() const { return white_mm * white_mm + correlated_mm * correlated_mm; }
};

/// No heap, no lock, no exception. One thread at a time.
class RestingFinger {
 public:
  /// It is expected at `start`. `noise`: of the tracker, if it is known; else it is learnt.
  RestingFinger(const PlatePoint& start, const std::optional<TrackerNoise>& noise);

  /// Takes the last of `places` in. True once the finger has left; that place is not one of the rest.
  bool observe(const RecentPlaces& places);

  /// The finger was lifted: the next place is the first of another rest.
  void lift() { rested_ = 0; }

  const PlatePoint& place() const { return place_; }
  double place_sd_mm() const;
  const TrackerNoise& noise() const { return noise_; }

 private:
  bool has_left(const RecentPlaces& places) const;
  void learn_noise();

  TrackerNoise noise_;
  bool noise_known_;
  PlatePoint place_;
  int rested_ = 0;  // places that place_ is made of
  // Squares of its distance from the mean, and of its steps.
  double square_sum_mm2_ = 0.0;
  double step_sum_mm2_ = 0.0;
  double spacing_sum_s_ = 0.0;
  int steps_ = 0;
  int departures_ = 0;
};

}  // namespace hrt
