// A simulated tracker of the fingertip in use; TrackerModel of people.h says how good it is.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/finger_sample.h"
#include "core/simulation/people.h"

namespace hrt {

/// A tracker in use.
class Tracker {
 public:
  /// Its frame is turned and scaled about `about`.
  Tracker(const TrackerModel& model, const PlatePoint& about, Draws draws);

  /// Sees the finger if a sample is due at `time_s`.
  void look(double time_s, const PlatePoint& finger);

  /// The next sample that has come by `time_ns`; none if there is none.
  std::optional<FingerSample> arrived(std::int64_t time_ns);

 private:
  TrackerModel model_;
  PlatePoint about_;
  Draws draws_;
  double next_s_ = 0.0;
  double right_m_, away_m_;  // correlated noise
  bool lost_ = false;
  std::deque<FingerSample> under_way_;
};

}  // namespace hrt
