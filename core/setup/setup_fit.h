// What the touches and slides of a set-up say.
#pragma once

#include <optional>

#include "core/calibrate/calibration.h"
#include "core/setup/setup.h"

namespace hrt {

/// Of one part: what is not of it is none.
struct SetupFit {
  SetupPart part = setup_calibration;
  SetupProblem problem = SetupProblem::none;  ///< why the part is repeated
  std::optional<FingertipOffset> fingertip;   ///< known
  std::optional<Registration> registration;   ///< that holds
  std::optional<RegistrationCheck> check;
  std::optional<TouchedFrame> guided;
  std::optional<Calibration> calibration;
  int slides = 0;               ///< that were made
  std::int64_t touched_ns = 0;  ///< when the last touch was made
};

/// Fits the part under way, for which finish_is_due() and something is left, and moves the set-up on: to the
/// next part, or to a repetition. `registered`: what a check is of. Allocates, and takes up to a second.
SetupFit finish_part(Setup* setup, const Registration& registered);

}  // namespace hrt
