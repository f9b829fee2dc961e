// Fits of the touches and slides of a set-up.
#pragma once

#include <optional>
#include <string>

#include "core/calibrate/calibration.h"
#include "core/setup/setup.h"

namespace hrt {

/// The fit of one part; results of other parts are empty.
struct SetupFit {
  SetupPart part = setup_calibration;
  SetupProblem problem = SetupProblem::none;  ///< reason for repeating the part
  std::string reason;                         ///< reason of the problem, or of an unknown result
  std::optional<FingertipOffset> fingertip;   ///< known
  std::optional<Registration> registration;   ///< accepted registration
  std::optional<RegistrationCheck> check;
  std::optional<TouchedFrame> guided;
  std::optional<Calibration> calibration;
  int slides = 0;               ///< number of slides that were made
  std::int64_t touched_ns = 0;  ///< time of the last touch
};

/// The fit of the current part in steps, each of less than 1 ms, which a frame loop spreads over frames. It allocates.
class PartFit {
 public:
  /// Requires finish_is_due(), and a part that is left. `setup` must outlive the fit and must not change. `registered`:
  /// the registration that a check is compared with.
  PartFit(const Setup& setup, Registration registered);
  /// Returns true at the end; no calls after that.
  bool step();
  SetupFit& result() { return fit_; }

 private:
  const Setup& setup_;
  Registration registered_;
  std::optional<CalibrationFit> calibration_;
  SetupFit fit_;
};

/// Moves the set-up on after the fit of a part: to the next part, or to a repetition. `found`: its result is known.
void move_on(const SetupFit& fit, bool found, Setup* setup);

}  // namespace hrt
