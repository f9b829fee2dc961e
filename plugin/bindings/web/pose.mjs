// Reads poses of WebXR and of 3D libraries.

/** Returns the { x, y, z } of a fingertip, or undefined if tracking is lost. */
export function fingertipOf(pose) {
  if (pose === null || pose === undefined) return undefined;
  const at = pose.transform?.position ?? pose.position ?? pose;
  if (typeof at.x === "number" && typeof at.y === "number" && typeof at.z === "number") {
    return Number.isFinite(at.x + at.y + at.z) ? at : undefined;
  }
  throw new TypeError("the pose has neither transform.position nor position nor x, y, z; pass null if the hand is not tracked");
}

/** Returns the { x, y, z, w } of a joint's rotation, or undefined if the pose has no rotation. */
export function rotationOf(pose) {
  const rotation = pose.transform?.orientation ?? pose.orientation ?? pose.quaternion;
  return typeof rotation?.w === "number" ? rotation : undefined;
}

/** Returns position and rotation of a plate from a 4 x 4 column-major matrix from plate coordinates to the world. */
export function plateOf(matrix) {
  const m = matrix?.elements ?? matrix?.matrix ?? matrix;  // three.js has `elements`, an XRRigidTransform `matrix`
  if (m?.length !== 16 || !Array.prototype.every.call(m, Number.isFinite)) {
    throw new TypeError("the matrix is not 16 finite numbers, nor an object that has them as `elements` (three.js) or `matrix` (WebXR)");
  }
  const x = [m[0], m[1], m[2]], y = [m[4], m[5], m[6]], z = [m[8], m[9], m[10]];
  const rigid = [x, y, z].every((axis) => near(dot(axis, axis), 1)) && near(dot(x, y), 0) && near(dot(y, z), 0) &&
                near(dot(z, x), 0) && near(dot(cross(x, y), z), 1);
  if (!rigid || m[3] !== 0 || m[7] !== 0 || m[11] !== 0 || m[15] !== 1) {
    throw new RangeError("the matrix is not a rotation and a translation alone: scale, shear and mirrors are not allowed");
  }
  return { plate_position_m: [m[12], m[13], m[14]], plate_rotation: quaternion(x, y, z) };
}

function near(value, wanted) { return Math.abs(value - wanted) < 1e-3; }
function dot(a, b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
function cross(a, b) { return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]; }

// Shepperd 1978: the row of 4 q q' with the largest diagonal element is a multiple of q by a factor that is not small.
function quaternion(x, y, z) {
  const squares = [1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2], 1 + x[0] + y[1] + z[2]];
  const largest = squares.indexOf(Math.max(...squares));
  const q = [
    [squares[0], x[1] + y[0], z[0] + x[2], y[2] - z[1]],
    [x[1] + y[0], squares[1], y[2] + z[1], z[0] - x[2]],
    [z[0] + x[2], y[2] + z[1], squares[2], x[1] - y[0]],
    [y[2] - z[1], z[0] - x[2], x[1] - y[0], squares[3]],
  ][largest];
  const length = Math.hypot(...q);
  return q.map((part) => part / length);
}
