// A calibration whose calls are recorded while the recording runs that it began in.
#pragma once

#include <cstdint>
#include <memory>

#include "plugin/src/recording/recording_line.h"
#include "plugin/src/session/streamed_calibration.h"

namespace hrt::plugin {

/// Forwards calls to a calibration and hands each one to its session's recording. Calls that run out of
/// memory are not recorded: they change nothing.
class RecordedCalibration {
 public:
  /// `number` is what the recording that runs calls this calibration.
  RecordedCalibration(const hrt_session_config& session_config, const hrt_calibration_config& checked_config,
                      std::shared_ptr<std::atomic<int>> under_way, std::shared_ptr<RecorderGate> line,
                      std::uint64_t number);
  ~RecordedCalibration();
  RecordedCalibration(const RecordedCalibration&) = delete;
  RecordedCalibration& operator=(const RecordedCalibration&) = delete;

  hrt_result begin_trial(double plate_orientation_deg);
  hrt_result add_sample(const hrt_sample& sample);
  hrt_result end_trial();
  hrt_result cancel_trial();
  hrt_result next_angle(double* out_plate_orientation_deg, std::uint32_t* out_enough);
  hrt_result solve(hrt_calibration_result* out);
  hrt_result get_residual(std::uint32_t slide, hrt_calibration_slide* out) const {
    return calibration_.get_residual(slide, out);
  }

 private:
  template <class Call>
  void record(hrt_result result, const Call& call) const {
    line_->record(recording_, [&] { return Record{result, call}; });
  }

  StreamedCalibration calibration_;
  std::shared_ptr<RecorderGate> line_;
  std::uint64_t recording_;  // that it began in; 0: none
  std::uint64_t number_;
};

}  // namespace hrt::plugin
