// Where the origins of the reference spaces are in the world, which is STAGE as it was when the session was
// created. A user who recentres moves an origin; nothing in the room moves.
#pragma once

#include <openxr/openxr.h>

#include <vector>

#include "samples/mock_runtime/world/pose.h"

namespace hrt::mock {

/// The head of the seated user, and LOCAL space, when the session is created.
Pose local_space_in_world();

class Origins {
 public:
  /// From `change` on, LOCAL or STAGE is where `pose` is in it before.
  void recenter(XrReferenceSpaceType type, XrTime change, const Pose& pose);

  /// LOCAL, LOCAL_FLOOR (below LOCAL, on the floor of STAGE) or STAGE, at a time.
  Pose in_world(XrReferenceSpaceType type, XrTime time) const;

 private:
  struct Change {
    XrTime time;
    Pose in_world;
  };
  Pose latest(const std::vector<Change>& changes, const Pose& first, XrTime time) const;

  std::vector<Change> local_;  // in order of time
  std::vector<Change> stage_;
};

}  // namespace hrt::mock
