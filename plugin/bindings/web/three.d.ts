// The part of the package for three.js 0.150 or later, "haptic-retargeting/three".
import type { Group, Material } from "three";
import type { Point, Rotation, Session } from "./index.js";

export interface HapticPlateOptions {
  /** Radius of the plate. Default 0.075. */
  radius_m?: number;
  /** Distance between neighbouring ridges. Default 0.01. */
  ridgeSpacing_m?: number;
  /** Width of a ridge. Default 0.001. */
  ridgeWidth_m?: number;
  /** Height of a ridge. Default 0.001. */
  ridgeHeight_m?: number;
  discMaterial?: Material;
  ridgeMaterial?: Material;
  /** Material of the mark on the rim, at the normal of the ridges: the ridges alone look the same after a half turn. */
  markMaterial?: Material;
}

/** The ridged plate. This object is its mount, whose axes are the plugin's plate coordinates: origin at the centre of
 *  rotation on the surface, +Y up, -Z along the mid-line away from the user, in metres. Set its pose to that of the
 *  apparatus in the scene, after a registration to `plate_position_m` and `plate_rotation` of the session's
 *  configuration. Do not scale it. Only the ridged disc within it turns with `orientation_deg`. */
export class HapticPlate extends Group {
  constructor(options?: HapticPlateOptions);
  /** Direction of the normal of the ridges, counter-clockwise from the mid-line, seen from above. Default 0. */
  orientation_deg: number;
}

/** The part of an XRFrame that updateFromHand() uses, so that types of WebXR are not needed. */
export interface HandFrame<Joint, Space> {
  /** Undefined in a browser without hand tracking. */
  readonly getJointPose?: ((joint: Joint, space: Space) => HandPose | null | undefined) | undefined;
}
export interface HandPose {
  readonly transform: { readonly position: Point; readonly orientation?: Rotation };
}

/** Returns the first hand that an XRFrame's session tracks. Creates no objects. */
export function trackedHand<Hand>(frame: { readonly session: { readonly inputSources: Sources<Hand> } }): Hand | undefined;
export interface Sources<Hand> { readonly length: number; readonly [index: number]: { readonly hand?: Hand | undefined } }

/** A reach of a hand that WebXR tracks: passes the pose of the joint at the tip of the index finger to the session,
 *  whose `fingertip_offset_m` gives the point of contact on the skin. The pose of the plate is from the session's
 *  registration or, without a registration, from `plate`. Session.beginReach() and endReach() begin and end the
 *  reach. */
export class HandReach {
  constructor(session: Session, plate: HapticPlate);
  /** True if the last frame had no index fingertip, so that the plate kept its command, and before the first frame. */
  readonly lost: boolean;
  /** Measured plate orientation, to be set before each update. Default NaN: not measured. */
  measuredPlate_deg: number;
  /** True if the host knows that the finger does not touch the plate; to be set before each update. A fingertip above
   *  the session's lift_height_m counts as lifted too. Default false. */
  lifted: boolean;
  /** Updates the session with the index fingertip, or with a dropout, and shows the plate's command. Call it once in
   *  each frame of an XRSession during a reach. `time_ms` is the time that the frame's callback receives; `hand` is
   *  inputSource.hand; `referenceSpace` is the space in which the scene is drawn, null before it exists. */
  updateFromHand<Joint, Space>(time_ms: number, frame: HandFrame<Joint, Space>, hand: { get(name: "index-finger-tip"): Joint | undefined } | null | undefined,
                               referenceSpace: Space | null): Session["command"];
}
