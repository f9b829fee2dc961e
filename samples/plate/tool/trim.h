// Trims the plate against the mark on its base.
#pragma once

#include "samples/plate/tool/person.h"

namespace hrt::plate {

/// Turns the plate to 0; the person then enters, as often as wanted, by how many degrees its mark is off,
/// counter-clockwise positive, and an empty line to keep the trim in the plate. Throws Abandoned, and leaves
/// the old trim.
void trim(Device& device, const Person& person);

}  // namespace hrt::plate
