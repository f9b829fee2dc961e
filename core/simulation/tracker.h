// A simulated tracker of the fingertip.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/plate/plate_frame.h"
#include "core/reach/finger_sample.h"
#include "core/simulation/random.h"

namespace hrt {

struct TrackerModel {
  double rate_hz = 90.0;
  double white_mm = 1.2;       ///< SD of white noise in a coordinate
  double correlated_mm = 0.0;  ///< SD of correlated noise in a coordinate, with time constant correlation_s
  double correlation_s = 0.1;
  double smoothing_s = 0.0;         ///< time constant of a low-pass filter of the correlated noise; 0: none
  double correlated_log_sd = 0.0;   ///< SD of the log of the correlated noise's size from reach to reach
  double latency_s = 0.0;           ///< time from a motion to its sample
  double declared_latency_s = 0.0;  ///< the latency that an uninformed controller is given
  double late_s = 0.0;  ///< additional latency of a sample, uniform from 0 to this value; must be below the period
  double outlier_share = 0.0;  ///< fraction of samples with an error of 30 mm (SD)
  double burst_mm = 0.0;       ///< displacement of a burst of outliers: burst_samples samples from burst_at_s on
  double burst_at_s = 0.0;
  int burst_samples = 0;
  double dropout_share = 0.0;            ///< probability per sample that tracking is lost, for ten samples on average
  double jitter_share = 0.0;             ///< jitter as a fraction of the time between samples
  double turned_deg = 0.0;               ///< rotation of the frame about the start
  double scale = 1.0;                    ///< scale of the tracker's frame about the start
  double shear = 0.0;                    ///< displacement to the right per millimetre away from the start
  double bearing_sd_deg = 0.0;           ///< SD of an additional rotation of the frame in each reach
  double declared_bearing_sd_deg = 0.0;  ///< SD of the bearing error that the controller is given
  double creep_mm = 0.0;        ///< error while the finger moves; decays after the stop with a time constant of 0.2 s
  double end_loss_share = 0.0;  ///< fraction of reaches with an error of 150 to 900 mm as the finger brakes
  double excursions_hz = 0.0;   ///< rate of excursions at rest before the motion: 10 to 16 mm for 50 to 100 ms
};

/// Errors that depend on the motion: creep, and excursions before the motion and while the finger brakes.
class MotionErrors {
 public:
  MotionErrors(const TrackerModel& model, Draws& draws);
  /// Returns the error of the tracked position. Times increase.
  PlatePoint error(double time_s, const PlatePoint& finger, Draws& draws);

 private:
  // A displacement by `by_mm` in one direction, which rises and falls linearly within `rise_s`.
  struct Excursion {
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
  Excursion excursion_{};
};

class Tracker {
 public:
  /// `about`: point that rotation, scale and shear of the frame keep.
  Tracker(const TrackerModel& model, const PlatePoint& about, Draws draws);

  void sample_if_due(double time_s, const PlatePoint& finger) {
    if (time_s >= next_s_) take_sample(time_s, finger);
  }

  /// Returns the next sample that is available at `time_ns`; nullopt if none is.
  std::optional<FingerSample> arrived(std::int64_t time_ns);

 private:
  void take_sample(double time_s, const PlatePoint& finger);

  PlatePoint about_;
  Draws draws_;
  TrackerModel model_;
  double kept_, smoothed_;  // factors from sample to sample of the correlated noise and of its low-pass
  double input_mm_;         // SD of the input of the low-pass
  PlatePoint input_, noise_;
  MotionErrors motion_errors_;
  double next_s_ = 0.0;
  bool lost_ = false;
  int burst_count_ = 0;  // samples of the burst so far
  std::deque<FingerSample> in_transit_;
};

}  // namespace hrt
