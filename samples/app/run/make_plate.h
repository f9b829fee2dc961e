// The plate that the command line chooses.
#pragma once

#include <memory>
#include <string>

#include "samples/app/plate/plate.h"
#include "samples/app/run/options.h"
#include "samples/app/xr/simulation.h"

namespace hrt::app {

/// Creates the plate, which the simulated user feels (`simulation`; null: the user is a person). Throws Failure
/// (ExitCode::plate) if it cannot be created, or if the runtime's clock is not real time and the plate is a device.
std::unique_ptr<Plate> make_plate(const PlateChoice& choice, Simulation* simulation, XrHeadlessSession& session,
                                  const std::string& runtime_name);

}  // namespace hrt::app
