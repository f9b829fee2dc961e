// A simulated tracker of the fingertip.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/plate/plate_frame.h"
#include "core/reach/finger_sample.h"
#include "core/simulation/random.h"

namespace hrt {

/// Quality of a tracker.
struct TrackerModel {
  double rate_hz = 90.0;
  double white_mm = 1.2;       ///< SD of the noise of a coordinate, independent for each sample
  double correlated_mm = 0.0;  ///< SD of correlated noise, which decays within correlation_s
  double correlation_s = 0.1;
  double smoothing_s = 0.0;         ///< a low-pass with this time constant smooths the correlated noise; 0: none
  double correlated_log_sd = 0.0;   ///< the noise of a reach is e^x times as large, with this SD of x
  double latency_s = 0.0;           ///< time from a motion to its sample
  double declared_latency_s = 0.0;  ///< part of the latency that the controller knows
  double late_s =
      0.0;  ///< further delay of samples, uniform up to this and drawn for each; less than the time between samples
  double outlier_share = 0.0;  ///< fraction of samples with an error of 30 mm (SD)
  double wild_mm = 0.0;        ///< wild_samples from wild_at_s on are off by this
  double wild_at_s = 0.0;
  int wild_samples = 0;
  double dropout_share = 0.0;  ///< fraction of samples at which tracking is lost, for about ten samples
  double jitter_share = 0.0;   ///< jitter as a fraction of the time between samples
  double turned_deg = 0.0;     ///< rotation of its frame about the start
  double scale = 1.0;          ///< scale of its frame about the start
  double shear = 0.0;  ///< displacement of the tracked position to the right for each millimetre away from the start
  double bearing_sd_deg = 0.0;           ///< SD of the rotation of its frame about the start, drawn for each reach
  double declared_bearing_sd_deg = 0.0;  ///< SD of the bearing that the controller is given
  double creep_mm = 0.0;                 ///< displacement of a moving finger; it decays within 0.2 s of the stop
  double end_loss_share = 0.0;           ///< fraction of reaches in which the hand is lost as the finger brakes
  double excursions_hz = 0.0;            ///< rate at rest of excursions of 10 to 16 mm for 50 to 100 ms
};

/// Errors that depend on what the finger does: creep after a stop, losses at the end, excursions at rest.
class MotionErrors {
 public:
  MotionErrors(const TrackerModel& model, Draws& draws);
  /// Error of the tracked position. Times increase.
  PlatePoint off(double time_s, const PlatePoint& finger, Draws& draws);

 private:
  // Seen off by `by_mm` in a direction: rises within `rise_s`, and falls as fast before it ends.
  struct Glide {
    double from_s, to_s, rise_s, by_mm, towards_deg;
    PlatePoint at(double time_s) const;
  };

  TrackerModel model_;
  double creeps_towards_deg_ = 0.0;
  double creep_mm_ = 0.0;
  bool loses_end_ = false;
  std::optional<PlatePoint> last_;
  double last_s_ = 0.0;
  double peak_mm_s_ = 0.0;
  Glide glide_{};
};

/// A tracker in use.
class Tracker {
 public:
  /// `about`: centre of the frame's rotation and scale.
  Tracker(const TrackerModel& model, const PlatePoint& about, Draws draws);

  /// Sees the finger if a sample is due at `time_s`.
  void look(double time_s, const PlatePoint& finger) {
    if (time_s >= next_s_) see(time_s, finger);
  }

  /// Returns the next sample that has arrived by `time_ns`, or none.
  std::optional<FingerSample> arrived(std::int64_t time_ns);

 private:
  void see(double time_s, const PlatePoint& finger);

  PlatePoint about_;
  Draws draws_;
  TrackerModel model_;
  double kept_, smoothed_;  // shares of the correlated noise, and of its low-pass, from sample to sample
  double input_mm_;         // SD of what the low-pass smooths
  PlatePoint input_, noise_;
  MotionErrors motion_errors_;
  double next_s_ = 0.0;
  bool lost_ = false;
  int wild_ = 0;  // positions so far
  std::deque<FingerSample> under_way_;
};

}  // namespace hrt
