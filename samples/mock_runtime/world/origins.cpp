#include "samples/mock_runtime/world/origins.h"

#include <algorithm>

namespace hrt::mock {
namespace {

// A seated user's eyes are this far above the floor.
constexpr double eye_height_m = 1.2;

}  // namespace

Pose local_space_in_world() { return {Eigen::Quaterniond::Identity(), {0.0, eye_height_m, 0.0}}; }

void Origins::recenter(XrReferenceSpaceType type, XrTime change, const Pose& pose) {
  auto& changes = type == XR_REFERENCE_SPACE_TYPE_STAGE ? stage_ : local_;
  const Pose before = in_world(type, change);
  std::erase_if(changes, [&](const Change& later) { return later.time >= change; });
  changes.push_back({change, before * pose});
}

Pose Origins::latest(const std::vector<Change>& changes, const Pose& first, XrTime time) const {
  const auto after = std::upper_bound(changes.begin(), changes.end(), time,
                                      [](XrTime t, const Change& change) { return t < change.time; });
  return after == changes.begin() ? first : std::prev(after)->in_world;
}

Pose Origins::in_world(XrReferenceSpaceType type, XrTime time) const {
  Pose stage = latest(stage_, {}, time);
  if (type == XR_REFERENCE_SPACE_TYPE_STAGE) return stage;
  Pose local = latest(local_, local_space_in_world(), time);
  if (type != XR_REFERENCE_SPACE_TYPE_LOCAL) local.position_m.y() = stage.position_m.y();
  return local;
}

}  // namespace hrt::mock
