// Reads poses of WebXR and of 3D libraries.

/** Returns the { x, y, z } of a pose, or undefined if tracking is lost. */
export function positionOf(pose) {
  if (pose === null || pose === undefined) return undefined;
  const at = pose.transform?.position ?? pose.position ?? pose;
  if (typeof at.x === "number" && typeof at.y === "number" && typeof at.z === "number") {
    return Number.isFinite(at.x + at.y + at.z) ? at : undefined;
  }
  throw new TypeError("the pose has no transform.position, no position, and no x, y, z; pass null for a hand that is not tracked");
}

/** Returns the { x, y, z, w } of a pose's rotation, or undefined if the pose has no rotation. */
export function rotationOf(pose) {
  const rotation = pose.transform?.orientation ?? pose.orientation ?? pose.quaternion;
  return typeof rotation?.w === "number" ? rotation : undefined;
}
