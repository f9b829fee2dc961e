// From a plate that was just built to the file that hrt_plate_open() takes.
#pragma once

#include <functional>
#include <memory>

#include "plugin/src/plate/plate_link.h"
#include "samples/plate/tool/measure.h"
#include "samples/plate/tool/person.h"

namespace hrt::plate {

/// Opens the device anew.
using Opener = std::function<std::unique_ptr<Device>()>;

/// Finds direction, span, sensor and stops of a hobby servo with the help of the person, who reads the scale
/// twice, and keeps them in the plate; any other device knows its own. Then measures the plate. Throws
/// PlateFailure, also if something cannot be measured, and Abandoned.
Measurements commission(const Opener& open, const Person& person);

}  // namespace hrt::plate
