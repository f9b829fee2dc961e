// Writes the results of a set-up into a session's model.
#pragma once

#include "core/setup/setup_fit.h"
#include "plugin/src/session/session_model.h"

namespace hrt::plugin {

/// Returns the registration in the model, for touches with an SD of `touch_sd_mm`. The model does not contain the
/// uncertainty of tilt and height, which is assumed to be as large as that in the plane.
Registration registration_of(const SessionModel& model, double touch_sd_mm);

/// Parameters of the user in which a retest (a repeated calibration) differs from the model.
struct RetestDifference {
  bool tactile_weight = false;
  bool bias = false;
  bool habit = false;
};
RetestDifference difference(const SessionModel& model, const Calibration& calibration);

/// Writes what the fit of a part has determined into the model. Returns false if the part has failed; a failed
/// check or calibration may change the model, too.
bool apply(const SetupFit& fit, const SetupConfig& config, SessionModel* model);

}  // namespace hrt::plugin
