// Trials of a calibration as they are streamed in, and what is fitted to them.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/calibrate/calibration.h"
#include "haptic_retargeting/calibration.h"

namespace hrt::plugin {

/// Fails naming the first field that is out of its range.
hrt_result check_calibration_config(const hrt_calibration_config& config);

/// Its memory is taken at construction; only next_angle() and solve() take more. Every call that fails
/// changes nothing.
class StreamedCalibration {
 public:
  /// `under_way` counts the trials under way of all calibrations of the session.
  StreamedCalibration(const hrt_session_config& session_config, const hrt_calibration_config& checked_config,
                      std::shared_ptr<std::atomic<int>> under_way);
  ~StreamedCalibration();
  StreamedCalibration(const StreamedCalibration&) = delete;
  StreamedCalibration& operator=(const StreamedCalibration&) = delete;

  /// What a caller gave has been read, not checked.
  hrt_result begin_trial(double plate_orientation_deg);
  hrt_result add_sample(const hrt_sample& sample);
  hrt_result end_trial();
  hrt_result cancel_trial();
  hrt_result next_angle(double* out_plate_orientation_deg, std::uint32_t* out_enough) const;
  hrt_result solve(hrt_calibration_result* out);
  hrt_result get_residual(std::uint32_t slide, hrt_calibration_slide* out) const;

 private:
  struct Trial {
    double plate_orientation_deg;
    std::size_t first_sample;
  };
  hrt_result check_trial() const;
  hrt_result check_no_trial() const;
  void leave_trial();
  std::vector<CalibrationTrial> whole_trials() const;

  hrt_session_config session_config_;
  hrt_calibration_config config_;
  std::shared_ptr<std::atomic<int>> under_way_;
  std::vector<Trial> trials_;
  std::vector<TimedPoint> samples_;      // of all trials, one after another
  std::vector<double> plate_deg_;        // one a sample
  std::vector<CalibratedSlide> solved_;  // of the last solution
  bool in_trial_ = false;
  bool sampled_ = false;  // the trial has had a sample
  std::int64_t last_time_ns_ = 0;
  double now_plate_deg_ = 0.0;
};

}  // namespace hrt::plugin
