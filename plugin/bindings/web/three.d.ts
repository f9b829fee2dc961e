// The part of the package for three.js 0.150 or later: "haptic-retargeting/three".
import type { Group, Material } from "three";
import type { Point, Rotation, Session } from "./index.js";

export interface HapticPlateOptions {
  /** Default 0.075. */
  radius_m?: number;
  /** From ridge to ridge. Default 0.01. */
  ridgeSpacing_m?: number;
  /** Default 0.001. */
  ridgeWidth_m?: number;
  /** Default 0.001. */
  ridgeHeight_m?: number;
  discMaterial?: Material;
  ridgeMaterial?: Material;
  /** Of the notch on the rim where the normal of the ridges points: half turns of the ridges look alike. */
  markMaterial?: Material;
}

/** The ridged plate. This object is its mount, whose axes are the plugin's plate coordinates: origin at the centre of
 *  rotation on the surface, +Y up, -Z the mid-line away from the user, in metres. Give it the pose of the apparatus in the
 *  scene, after a registration `plate_position_m` and `plate_rotation` of the session's configuration; do not scale it.
 *  Only the ridged disc within turns with `orientation_deg`. */
export class HapticPlate extends Group {
  constructor(options?: HapticPlateOptions);
  /** Direction of the normal of the ridges, counter-clockwise from the mid-line, seen from above. Default 0. */
  orientation_deg: number;
}

/** The part of an XRFrame that updateFromHand() uses, so that types of WebXR are not needed. */
export interface HandFrame<Joint, Space> {
  /** Missing in a browser without hands: none is tracked. */
  readonly getJointPose?: ((joint: Joint, space: Space) => HandPose | null | undefined) | undefined;
}
export interface HandPose {
  readonly transform: { readonly position: Point; readonly orientation?: Rotation };
}

/** The first hand that an XRFrame's session tracks. Makes no objects. */
export function trackedHand<Hand>(frame: { readonly session: { readonly inputSources: Sources<Hand> } }): Hand | undefined;
export interface Sources<Hand> { readonly length: number; readonly [index: number]: { readonly hand?: Hand | undefined } }

/** A reach of a hand that WebXR tracks: passes the pose of the joint at the tip of the index finger to the session, whose
 *  `fingertip_offset_m` gives the point of contact on the skin. The pose of the plate is that of the session's registration,
 *  or without one that of the plate's object. Session.beginReach() and endReach() begin and end the reach. */
export class HandReach {
  constructor(session: Session, plate: HapticPlate);
  /** The last frame had no index fingertip: the plate was held. True before the first frame. */
  readonly lost: boolean;
  /** Set before each update, if the plate reports its orientation. Default NaN: not reported. */
  measuredPlate_deg: number;
  /** Set before each update, if the host knows that the finger does not touch the plate: the model waits. A fingertip above
   *  the session's lift_height_m counts as lifted anyway. Default false. */
  lifted: boolean;
  /** Once in each frame of an XRSession, while a reach is under way: `time_ms` is the time that the frame's callback is given,
   *  which every browser has; `hand` is inputSource.hand, `referenceSpace` the space
   *  in which the scene is drawn, null before there is one. Updates the session with the index fingertip, or with a dropout, and shows the plate's
   *  command. Makes no objects of its own. Errors are those of Session.update(). */
  updateFromHand<Joint, Space>(time_ms: number, frame: HandFrame<Joint, Space>, hand: { get(name: "index-finger-tip"): Joint | undefined } | null | undefined,
                               referenceSpace: Space | null): Session["command"];
}
