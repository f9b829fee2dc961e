// A picture of what the simulation knows and the person does not see.
#pragma once

#include "samples/mock_runtime/graphics/picture.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

/// The world now, from above and behind the plate, or the user if there is no plate.
Picture picture_of_world(const World& world, XrTime now);

}  // namespace hrt::mock
