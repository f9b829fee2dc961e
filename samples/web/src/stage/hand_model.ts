// Loads the generic hand of webxr-input-profiles: flat, as in its file, for a headset, or bent into a pointing hand.
import left from "generic-hand/left.glb";
import right from "generic-hand/right.glb";
import * as THREE from "three";
import { type GLTF, GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

export async function readHand(side: "left" | "right"): Promise<GLTF> {
  const file = { left, right }[side];
  const bytes = typeof file === "string" ? await (await fetch(file)).arrayBuffer() : file.buffer;
  return new GLTFLoader().parseAsync(bytes, "");
}

export function cover(hand: THREE.Object3D, skin: THREE.Material): void {
  const mesh = hand.getObjectByProperty("isSkinnedMesh", true) as THREE.SkinnedMesh;
  Object.assign(mesh, { material: skin, castShadow: true, frustumCulled: false });
}

/** Bend of each finger at its joints in a pointing hand, from the wrist to the tip, in degrees. */
const bends = {
  "index-finger": [0, 4, 14, 10],
  "middle-finger": [0, 52, 70, 40],
  "ring-finger": [0, 58, 76, 40],
  "pinky-finger": [0, 60, 72, 40],
  thumb: [6, 16, 30],
};
/** Orientation of the hand: the forearm comes from below, somewhat to the right, so that it does not hide the ring. */
const attitude = new THREE.Quaternion().setFromEuler(new THREE.Euler(-0.38, 0.12, 0.05, "YXZ"));
/** Radii and length of the forearm beyond the wrist, before scaling. */
const arm_m = { wrist: 0.026, elbow: 0.045, length: 0.34 };
/** Scale of the hand. A hand of the real size would hide the plate. */
const scale = 0.7;
/** Distance from the joint within the fingertip to its skin. */
const pad_m = 0.0065 * scale;

/** Creates a right hand that points ahead, with its index fingertip at the origin. */
export async function pointingHand(skin: THREE.Material): Promise<THREE.Object3D> {
  const hand = (await readHand("right")).scene.children[0],
    turn = new THREE.Quaternion();
  const wrist = hand?.getObjectByName("wrist"),
    tip = hand?.getObjectByName("index-finger-tip");
  if (!hand || !wrist || !tip)
    throw new Error("the model of the hand lacks its wrist or its index fingertip; build the page again");
  for (const [finger, angles] of Object.entries(bends)) {
    // The joints are siblings: a bend must also move the joints beyond it.
    const joints = hand.children.filter(({ name }) => name.startsWith(finger));
    angles.forEach((angle, i) => {
      const at = joints[i]?.position.clone() ?? new THREE.Vector3(),
        axis = new THREE.Vector3(1, 0, 0).applyQuaternion(joints[i]?.quaternion ?? turn);
      turn.setFromAxisAngle(axis, (-angle * Math.PI) / 180);
      for (const joint of joints.slice(i)) {
        joint.position.sub(at).applyQuaternion(turn).add(at);
        joint.quaternion.premultiply(turn);
      }
    });
  }
  cover(hand, skin);
  hand.quaternion.copy(attitude).multiply(wrist.quaternion.clone().invert());
  const arm = new THREE.Mesh(new THREE.CylinderGeometry(arm_m.wrist, arm_m.elbow, arm_m.length, 24, 1, true), skin);
  arm.castShadow = true;
  // The hand extends along -Z of the wrist; the cylinder along Y, with its top at the wrist.
  arm.position.set(0, 0, arm_m.length / 2 - 0.01);
  arm.rotation.x = -Math.PI / 2;
  wrist.add(arm);
  hand.scale.setScalar(scale);
  hand.position.copy(tip.position).applyQuaternion(hand.quaternion).multiplyScalar(-scale);
  hand.position.y += pad_m;
  return hand;
}
