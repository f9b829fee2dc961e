// Writes the results of a set-up into a session's model.
#pragma once

#include "core/setup/setup_fit.h"
#include "plugin/src/session/session_model.h"

namespace hrt::plugin {

/// The registration that the model has, with touches of `touch_sd_mm`. The model does not hold the uncertainty of tilt
/// and height: it is taken to be as large as that in the plane.
Registration registration_of(const SessionModel& model, double touch_sd_mm);

/// The person's values that differ from the model by a retest.
struct RetestDifference {
  bool tactile_weight = false;
  bool bias = false;
  bool habit = false;
};
RetestDifference difference(const SessionModel& model, const Calibration& calibration);

/// Writes the fit of one part into the model. False if the fit leaves the part without a result.
bool apply(const SetupFit& fit, const SetupConfig& config, SessionModel* model);

}  // namespace hrt::plugin
