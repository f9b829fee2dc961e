// The plate that the command line chooses.
#pragma once

#include <memory>
#include <string>

#include "samples/reach/plate/plate.h"
#include "samples/reach/run/options.h"
#include "samples/reach/xr/simulation.h"

namespace hrt::reach {

/// A simulated user feels it (`simulation`; null: a person). Throws Failure (ExitCode::plate) if there is
/// none, or if the runtime's clock does not suit a device.
std::unique_ptr<Plate> make_plate(const PlateChoice& choice, Simulation* simulation, XrHeadlessSession& session,
                                  const std::string& runtime_name);

}  // namespace hrt::reach
