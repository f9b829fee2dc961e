// A simulated tracker of the fingertip.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/plate/plate_frame.h"
#include "core/reach/finger_sample.h"
#include "core/simulation/random.h"

namespace hrt {

/// How good it is.
struct TrackerModel {
  double rate_hz = 90.0;
  double white_mm = 1.2;       ///< SD of the noise of a coordinate, independent for each sample
  double correlated_mm = 0.0;  ///< and decaying within correlation_s
  double correlation_s = 0.1;
  double latency_s = 0.0;           ///< from a motion to its sample
  double declared_latency_s = 0.0;  ///< of it, what the controller is given
  double late_s = 0.0;              ///< samples come up to this later still, each anew; less than between samples
  double outlier_share = 0.0;       ///< of samples that are off by 30 mm, standard deviation
  double wild_mm = 0.0;             ///< wild_samples from wild_at_s on are off by this
  double wild_at_s = 0.0;
  int wild_samples = 0;
  double dropout_share = 0.0;  ///< of samples at which tracking is lost, for some ten samples
  double jitter_share = 0.0;   ///< of the time between samples
  double turned_deg = 0.0;     ///< of its frame about the start
  double scale = 1.0;          ///< of its frame about the start
  double shear = 0.0;          ///< seen to the right by this for each millimetre away from the start
};

/// A tracker in use.
class Tracker {
 public:
  /// Its frame is turned and scaled about `about`.
  Tracker(const TrackerModel& model, const PlatePoint& about, Draws draws);

  /// Sees the finger if a sample is due at `time_s`.
  void look(double time_s, const PlatePoint& finger) {
    if (time_s >= next_s_) see(time_s, finger);
  }

  /// The next sample that has come by `time_ns`; none if there is none.
  std::optional<FingerSample> arrived(std::int64_t time_ns);

 private:
  void see(double time_s, const PlatePoint& finger);

  TrackerModel model_;
  PlatePoint about_;
  Draws draws_;
  double kept_;  // of the correlated noise from sample to sample
  double next_s_ = 0.0;
  double right_mm_, away_mm_;  // correlated noise
  bool lost_ = false;
  int wild_ = 0;  // positions so far
  std::deque<FingerSample> under_way_;
};

}  // namespace hrt
