// The plate that the command line chooses.
#pragma once

#include <memory>
#include <string>

#include "samples/app/plate/plate.h"
#include "samples/app/run/options.h"
#include "samples/app/xr/simulation.h"

namespace hrt::app {

/// A simulated user feels it (`simulation`; null: a person). Throws Failure (ExitCode::plate) if there is
/// none, or if the runtime's clock does not suit a device.
std::unique_ptr<Plate> make_plate(const PlateChoice& choice, Simulation* simulation, XrHeadlessSession& session,
                                  const std::string& runtime_name);

}  // namespace hrt::app
