#include "plugin/src/recording/recorded_calibration.h"

#include <utility>

namespace hrt::plugin {

RecordedCalibration::RecordedCalibration(const hrt_session_config& session_config,
                                         const hrt_calibration_config& checked_config,
                                         std::shared_ptr<std::atomic<int>> under_way,
                                         std::shared_ptr<RecorderGate> line, std::uint64_t number)
    : calibration_(session_config, checked_config, std::move(under_way)),
      line_(std::move(line)),
      recording_(line_->current()),
      number_(number) {
  if (recording_ != 0) record(HRT_OK, CalibrationChanged{true, number_, checked_config});
}

RecordedCalibration::~RecordedCalibration() {
  if (recording_ != 0) record(HRT_OK, CalibrationChanged{false, number_, {}});
}

hrt_result RecordedCalibration::begin_trial(double plate_orientation_deg) {
  const hrt_result result = calibration_.begin_trial(plate_orientation_deg);
  record(result, TrialBegun{number_, plate_orientation_deg});
  return result;
}

hrt_result RecordedCalibration::add_sample(const hrt_sample& sample) {
  const hrt_result result = calibration_.add_sample(sample);
  record(result, TrialSampled{number_, sample});
  return result;
}

hrt_result RecordedCalibration::end_trial() {
  const hrt_result result = calibration_.end_trial();
  record(result, TrialEnded{number_});
  return result;
}

hrt_result RecordedCalibration::cancel_trial() {
  const hrt_result result = calibration_.cancel_trial();
  record(result, TrialCancelled{number_});
  return result;
}

hrt_result RecordedCalibration::next_angle(double* out_plate_orientation_deg, std::uint32_t* out_enough) {
  AngleChosen chosen{number_, 0.0, 0};
  const hrt_result result = calibration_.next_angle(&chosen.plate_orientation_deg, &chosen.enough);
  record(result, chosen);
  if (result != HRT_OK) return result;
  *out_plate_orientation_deg = chosen.plate_orientation_deg;
  *out_enough = chosen.enough;
  return HRT_OK;
}

hrt_result RecordedCalibration::solve(hrt_calibration_result* out) {
  CalibrationSolved solved{number_, {}};
  const hrt_result result = calibration_.solve(&solved.result);
  record(result, solved);
  if (result == HRT_OK) *out = solved.result;
  return result;
}

}  // namespace hrt::plugin
