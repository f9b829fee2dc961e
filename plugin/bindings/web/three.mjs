// Support for three.js. Types and documentation: three.d.ts.
import { BoxGeometry, CylinderGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshStandardMaterial, Quaternion, Vector3 } from "three";
import { HRT_SAMPLE_LIFTED, HRT_SAMPLE_PLATE_ORIENTATION, HRT_SAMPLE_PLATE_POSE, HRT_SAMPLE_WORLD_POSITION } from "./abi.js";

const thickness_m = 0.006;

export class HapticPlate extends Group {
  #ridged = new Group();  // turns within this object, which is the mount
  #orientation_deg = 0;

  constructor({ radius_m = 0.075, ridgeSpacing_m = 0.01, ridgeWidth_m = 0.001, ridgeHeight_m = 0.001,
                discMaterial = new MeshStandardMaterial({ color: 0xf4f4f1, roughness: 0.85 }),
                ridgeMaterial = new MeshStandardMaterial({ color: 0x8a9099, roughness: 0.6 }),
                markMaterial = ridgeMaterial } = {}) {
    super();
    const disc = new Mesh(new CylinderGeometry(radius_m, radius_m, thickness_m, 72), discMaterial);
    disc.position.y = -thickness_m / 2;
    const eachSide = Math.max(0, Math.ceil(radius_m / ridgeSpacing_m) - 1);
    const ridges = new InstancedMesh(new BoxGeometry(1, ridgeHeight_m, ridgeWidth_m), ridgeMaterial, 2 * eachSide + 1);
    const place = new Matrix4();
    for (let i = 0; i < ridges.count; ++i) {
      const z = (i - eachSide) * ridgeSpacing_m;
      place.makeScale(1.96 * Math.sqrt(radius_m * radius_m - z * z), 1, 1).setPosition(0, ridgeHeight_m / 2, z);
      ridges.setMatrixAt(i, place);
    }
    const mark = new Mesh(new BoxGeometry(0.08 * radius_m, thickness_m, 0.1 * radius_m), markMaterial);
    mark.position.set(0, -thickness_m / 2, -radius_m);
    for (const part of [disc, ridges]) part.receiveShadow = true;
    this.#ridged.add(disc, ridges, mark);
    this.add(this.#ridged);
  }

  get orientation_deg() { return this.#orientation_deg; }
  set orientation_deg(orientation_deg) {
    this.#orientation_deg = orientation_deg;
    this.#ridged.rotation.y = (orientation_deg * Math.PI) / 180;
  }
}

export function trackedHand(frame) {
  const sources = frame.session.inputSources;
  for (let i = 0; i < sources.length; ++i) if (sources[i].hand) return sources[i].hand;
  return undefined;
}

export class HandReach {
  lost = true;
  measuredPlate_deg = NaN;
  lifted = false;
  #session;
  #plate;
  #at = new Vector3();
  #turned = new Quaternion();

  constructor(session, plate) {
    this.#session = session;
    this.#plate = plate;
  }

  updateFromHand(time_ms, frame, hand, referenceSpace) {
    const { sample, command } = this.#session;
    const joint = hand?.get("index-finger-tip");
    const pose = joint && referenceSpace !== null ? frame.getJointPose?.(joint, referenceSpace) : undefined;
    this.#session.setFinger(pose, time_ms);
    this.lost = (sample.flags & HRT_SAMPLE_WORLD_POSITION) === 0;
    if (!this.lost && !this.#session.registered) this.#addPlatePose();
    if (this.lifted) sample.flags |= HRT_SAMPLE_LIFTED;
    if (Number.isFinite(this.measuredPlate_deg)) {
      sample.flags |= HRT_SAMPLE_PLATE_ORIENTATION;
      sample.plate_orientation_deg = this.measuredPlate_deg;
    }
    this.#session.update();
    this.#plate.orientation_deg = command.plate_orientation_deg;
    return command;
  }

  // Without a registration, the plate has the pose of its object in the scene.
  #addPlatePose() {
    const { sample } = this.#session;
    this.#plate.getWorldPosition(this.#at).toArray(sample.plate_position_m);
    this.#plate.getWorldQuaternion(this.#turned).toArray(sample.plate_rotation);
    sample.flags |= HRT_SAMPLE_PLATE_POSE;
  }
}
