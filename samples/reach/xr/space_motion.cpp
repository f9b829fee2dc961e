#include "samples/reach/xr/space_motion.h"

#include <Eigen/Geometry>
#include <cmath>

namespace hrt::reach {
namespace {

constexpr XrPosef identity{{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};

Eigen::Quaternionf orientation(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  return {q.w, q.x, q.y, q.z};
}

Eigen::Vector3f position(const XrPosef& pose) { return {pose.position.x, pose.position.y, pose.position.z}; }

// Normalised, since many products would lose the length of 1.
XrPosef pose_of(const Eigen::Quaternionf& turned, const Eigen::Vector3f& moved) {
  const Eigen::Quaternionf q = turned.normalized();
  return {{q.x(), q.y(), q.z(), q.w()}, {moved.x(), moved.y(), moved.z()}};
}

XrPosef product(const XrPosef& a, const XrPosef& b) {
  return pose_of(orientation(a) * orientation(b), orientation(a) * position(b) + position(a));
}

XrPosef inverse(const XrPosef& pose) {
  const Eigen::Quaternionf back = orientation(pose).conjugate();
  return pose_of(back, -(back * position(pose)));
}

// A runtime's values are not trusted: numbers, and an orientation that can be normalised.
bool is_pose(const XrPosef& pose) {
  return position(pose).allFinite() && std::abs(orientation(pose).squaredNorm() - 1.0f) < 0.02f;
}

}  // namespace

void SpaceMotion::announce(const XrEventDataReferenceSpaceChangePending& change) { pending_.push_back(change); }

SpaceMotion::Change SpaceMotion::advance(XrReferenceSpaceType space, XrTime time) {
  Change made = Change::none;
  std::erase_if(pending_, [&](const XrEventDataReferenceSpaceChangePending& change) {
    if (change.referenceSpaceType != space || change.changeTime > time) return false;
    if (change.poseValid != XR_TRUE || !is_pose(change.poseInPreviousSpace)) {
      first_.erase(space);
      made = Change::unknown;
      return true;
    }
    first_[space] = product(inverse(product(identity, change.poseInPreviousSpace)), now(space, identity));
    if (made == Change::none) made = Change::moved;
    return true;
  });
  return made;
}

XrPosef SpaceMotion::now(XrReferenceSpaceType space, const XrPosef& pose_at_first) const {
  const auto moved = first_.find(space);
  return moved == first_.end() ? pose_at_first : product(moved->second, pose_at_first);
}

}  // namespace hrt::reach
