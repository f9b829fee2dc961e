// Fits the touches and slides of a set-up.
#pragma once

#include <optional>
#include <string>

#include "core/calibrate/calibration.h"
#include "core/setup/setup.h"

namespace hrt {

/// Result of one part; fields of other parts are empty.
struct SetupFit {
  SetupPart part = setup_calibration;
  SetupProblem problem = SetupProblem::none;  ///< reason for repeating the part
  std::string reason;                         ///< details of the problem or of the result
  std::optional<FingertipOffset> fingertip;   ///< known offset
  std::optional<Registration> registration;   ///< accepted registration
  std::optional<RegistrationCheck> check;
  std::optional<TouchedFrame> guided;
  std::optional<Calibration> calibration;
  int slides = 0;               ///< number of completed slides
  std::int64_t touched_ns = 0;  ///< time of the last touch
};

/// Fits the current part in steps of about 1 ms, which a frame loop can distribute over frames. Allocates.
class PartFit {
 public:
  /// Requires finish_is_due() and a pending part. `setup` must outlive the fit and must not change. `registered`:
  /// the registration that setup_check tests.
  PartFit(const Setup& setup, Registration registered);
  /// Returns true when the fit is finished; do not call step() after that.
  bool step();
  SetupFit& result() { return fit_; }

 private:
  const Setup& setup_;
  Registration registered_;
  std::optional<CalibrationFit> calibration_;
  SetupFit fit_;
};

/// Repeats the part if its fit has a problem. Otherwise ends the part: with a result if `found`, or by dropping it.
void move_on(const SetupFit& fit, bool found, Setup* setup);

}  // namespace hrt
