#include "plugin/src/recording/replayed_calibrations.h"

namespace hrt::plugin {

hrt_result ReplayedCalibrations::change(const hrt_session_config& session_config,
                                        const CalibrationChanged& changed) {
  if (changed.added == calibrations_.contains(changed.number))
    return fail(HRT_ERROR_BAD_FORMAT, "calibration ", changed.number,
                changed.added ? " is there already" : " is not there");
  if (!changed.added) {
    calibrations_.erase(changed.number);
    return HRT_OK;
  }
  if (calibrations_.size() == HRT_CALIBRATIONS_MAX)
    return fail(HRT_ERROR_BAD_FORMAT, "there are ", HRT_CALIBRATIONS_MAX, " calibrations already");
  calibrations_.emplace(changed.number,
                        std::make_unique<StreamedCalibration>(session_config, changed.config, under_way_));
  return HRT_OK;
}

hrt_result ReplayedCalibrations::find(std::uint64_t number, StreamedCalibration** out) const {
  const auto found = calibrations_.find(number);
  if (found == calibrations_.end())
    return fail(HRT_ERROR_BAD_FORMAT, "calibration ", number, " is not there");
  *out = found->second.get();
  return HRT_OK;
}

hrt_result call_again(StreamedCalibration& calibration, TrialBegun& call) {
  return calibration.begin_trial(call.plate_orientation_deg);
}

hrt_result call_again(StreamedCalibration& calibration, TrialSampled& call) {
  return calibration.add_sample(call.sample);
}

hrt_result call_again(StreamedCalibration& calibration, TrialEnded&) {
  return calibration.end_trial();
}

hrt_result call_again(StreamedCalibration& calibration, TrialCancelled&) {
  return calibration.cancel_trial();
}

hrt_result call_again(StreamedCalibration& calibration, AngleChosen& call) {
  return calibration.next_angle(&call.plate_orientation_deg, &call.enough);
}

hrt_result call_again(StreamedCalibration& calibration, CalibrationSolved& call) {
  return calibration.solve(&call.result);
}

}  // namespace hrt::plugin
