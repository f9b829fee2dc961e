#include "samples/reach/xr/space_motion.h"

#include <cmath>

namespace hrt::reach {
namespace {

constexpr XrPosef identity{{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};

XrVector3f cross(const XrVector3f& a, const XrVector3f& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// v' = v + 2 q x (q x v + w v), of a unit quaternion (q, w).
XrVector3f rotated(const XrQuaternionf& r, const XrVector3f& v) {
  const XrVector3f q{r.x, r.y, r.z};
  XrVector3f inner = cross(q, v);
  inner = {inner.x + r.w * v.x, inner.y + r.w * v.y, inner.z + r.w * v.z};
  const XrVector3f outer = cross(q, inner);
  return {v.x + 2.0f * outer.x, v.y + 2.0f * outer.y, v.z + 2.0f * outer.z};
}

XrQuaternionf product(const XrQuaternionf& a, const XrQuaternionf& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

// Of length 1, which many products would lose.
XrQuaternionf normalised(const XrQuaternionf& q) {
  const float length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {q.x / length, q.y / length, q.z / length, q.w / length};
}

XrPosef product(const XrPosef& a, const XrPosef& b) {
  const XrVector3f moved = rotated(a.orientation, b.position);
  return {normalised(product(a.orientation, b.orientation)),
          {moved.x + a.position.x, moved.y + a.position.y, moved.z + a.position.z}};
}

XrPosef inverse(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  const XrQuaternionf back{-q.x, -q.y, -q.z, q.w};
  const XrVector3f moved = rotated(back, pose.position);
  return {back, {-moved.x, -moved.y, -moved.z}};
}

// A runtime's values are not trusted: numbers, and an orientation that can be normalised.
bool is_pose(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  const float square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  return std::isfinite(pose.position.x) && std::isfinite(pose.position.y) && std::isfinite(pose.position.z) &&
         std::abs(square - 1.0f) < 0.02f;
}

}  // namespace

void SpaceMotion::announce(const XrEventDataReferenceSpaceChangePending& change) {
  pending_.push_back(change);
}

SpaceMotion::Change SpaceMotion::advance(XrReferenceSpaceType space, XrTime time) {
  Change made = Change::none;
  std::erase_if(pending_, [&](const XrEventDataReferenceSpaceChangePending& change) {
    if (change.referenceSpaceType != space || change.changeTime > time) return false;
    if (change.poseValid != XR_TRUE || !is_pose(change.poseInPreviousSpace)) {
      first_.erase(space);
      made = Change::unknown;
      return true;
    }
    XrPosef previous = change.poseInPreviousSpace;
    previous.orientation = normalised(previous.orientation);
    first_[space] = product(inverse(previous), now(space, identity));
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
