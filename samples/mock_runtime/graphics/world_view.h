// What the runtime knows and the person does not see, as a picture: the plate with its ridges, the true
// hands, and where the person feels a sliding hand to be.
#pragma once

#include "samples/mock_runtime/graphics/picture.h"
#include "samples/mock_runtime/world/world.h"

namespace hrt::mock {

/// From above and behind the plate, or the user where there is none. Now.
Picture picture_of_world(const World& world, XrTime now);

}  // namespace hrt::mock
