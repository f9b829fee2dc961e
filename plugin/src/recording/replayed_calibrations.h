// The calibrations of a recording that is run again.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>

#include "plugin/src/abi/error.h"
#include "plugin/src/recording/format.h"
#include "plugin/src/session/streamed_calibration.h"

namespace hrt::plugin {

// Each makes one call.
hrt_result call_again(StreamedCalibration& calibration, TrialBegun& call);
hrt_result call_again(StreamedCalibration& calibration, TrialSampled& call);
hrt_result call_again(StreamedCalibration& calibration, TrialEnded& call);
hrt_result call_again(StreamedCalibration& calibration, TrialCancelled& call);
hrt_result call_again(StreamedCalibration& calibration, AngleChosen& call);
hrt_result call_again(StreamedCalibration& calibration, CalibrationSolved& call);

class ReplayedCalibrations {
 public:
  /// A calibration is added with the session's configuration, or destroyed.
  hrt_result change(const hrt_session_config& session_config, const CalibrationChanged& changed);

  /// Makes the call again, and puts what came out of it in place of what was recorded. Fails if the
  /// calibration is not there.
  template <class Call>
    requires requires(StreamedCalibration& calibration, Call& call) { call_again(calibration, call); }
  hrt_result rerun(Call& call, hrt_result* result) {
    StreamedCalibration* calibration = nullptr;
    HRT_RETURN_IF_FAILED(find(call.number, &calibration));
    *result = call_again(*calibration, call);
    return HRT_OK;
  }

 private:
  hrt_result find(std::uint64_t number, StreamedCalibration** out) const;

  std::map<std::uint64_t, std::unique_ptr<StreamedCalibration>> calibrations_;
  std::shared_ptr<std::atomic<int>> under_way_ = std::make_shared<std::atomic<int>>(0);
};

}  // namespace hrt::plugin
