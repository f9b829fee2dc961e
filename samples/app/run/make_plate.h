#pragma once

#include <memory>
#include <string>

#include "samples/app/plate/plate.h"
#include "samples/app/run/options.h"
#include "samples/app/xr/simulation.h"

namespace hrt::app {

/// Creates the plate that the command line selects. `simulation`: simulated user who feels the plate; null if the
/// runtime has none. Throws Failure: ExitCode::usage if the name of a device is invalid; ExitCode::plate if the plate
/// cannot be created, or if it is a device and the runtime's clock is not real time.
std::unique_ptr<Plate> make_plate(const PlateChoice& choice, Simulation* simulation, XrHeadlessSession& session,
                                  const std::string& runtime_name);

}  // namespace hrt::app
