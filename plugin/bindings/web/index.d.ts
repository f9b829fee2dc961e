// Structs have the fields of the C headers, under their names, which end in the unit: see abi.d.ts.
import type {
  hrt_contact, hrt_gap, hrt_command, hrt_conditions, hrt_person_config, hrt_person_state, hrt_reach_summary,
  hrt_recording_status, hrt_replay_report, hrt_sample, hrt_scene_info, hrt_scene_target, hrt_session_config,
  hrt_setup_config, hrt_setup_result, hrt_setup_step, hrt_target_config,
} from "./abi.js";
export * from "./abi.js";

/** A struct that the library returns, as an object. 64-bit integers are bigint, except ids of targets; in JSON they are
 *  numbers up to 2^53, and decimal text beyond. */
type Output<Struct> = Omit<Struct, "struct_size" | "reserved">;
/** A struct for the library: fields left out take their defaults; integers may be numbers. */
type Input<Struct> = {
  [Field in Exclude<keyof Struct, "struct_size" | "reserved">]?: Struct[Field] extends bigint ? bigint | number : Struct[Field];
};
/** A struct of every frame: one object, read and written without making others. 64-bit integers are numbers, exact to
 *  2^53 (as nanoseconds: 104 days). It has no other properties, and takes none. */
type Frame<Struct> = {
  [Field in Exclude<keyof Struct, "struct_size" | "reserved">]: Struct[Field] extends number[] ? Float64Array
    : Struct[Field] extends bigint ? number : Struct[Field];
};

/** A target's id within its session. */
export type TargetId = number;

/** A call that failed. The message is the library's: call, field, value and what is allowed. Arguments that are not
 *  what their type says are a TypeError or a RangeError instead. */
export class HapticRetargetingError extends Error {
  /** HRT_ERROR_*. */
  readonly code: number;
  /** Its name. */
  readonly codeName: string;
}

// For `using`, where the compiler's library has it not yet.
declare global {
  interface SymbolConstructor { readonly dispose: unique symbol }
}

/** Loads the module: haptic_retargeting.wasm beside this file, unless `source` is another address, or the module
 *  itself as a bundler gives it. */
export function load(source?: string | URL | WebAssembly.Module | ArrayBuffer | ArrayBufferView): Promise<Library>;

export interface Library {
  readonly version: { readonly major: number; readonly minor: number; readonly patch: number };
  createSession(config?: Input<hrt_session_config>): Session;
  /** A simulated person, who feels the plate and is bent by it: a model, the same on every host for the same seed. */
  createPerson(seed?: number | bigint, config?: Input<hrt_person_config>): Person;
  /** A .gltf or .glb file's bytes; `name` stands for it in error texts. */
  loadScene(bytes: ArrayBuffer | Uint8Array, name?: string): Scene;
  /** Runs a recording again and compares, bit for bit. */
  replay(recording: string): Output<hrt_replay_report>;
}

/** The tracked joint at the fingertip: an XRPose, XRJointPose or XRRigidTransform of WebXR, an object of three.js, or a
 *  position alone. Null, undefined or numbers that are not finite: lost. With the rotation of the joint, the session applies
 *  `fingertip_offset_m`, the offset of the skin that a set-up finds. */
export type FingerPose = { readonly transform: { readonly position: Point; readonly orientation?: Rotation } }
  | { readonly position: Point; readonly orientation?: Rotation; readonly quaternion?: Rotation } | Point | null | undefined;
export interface Point { readonly x: number; readonly y: number; readonly z: number }
/** A unit quaternion. */
export interface Rotation extends Point { readonly w: number }

/** 16 numbers, column by column, from plate coordinates to the world; or WebXR's XRRigidTransform, or a Matrix4 of
 *  three.js. */
export type PlateMatrix = ArrayLike<number> | { readonly matrix: ArrayLike<number> } | { readonly elements: ArrayLike<number> };

/** One user, one plate. Destroy it when it is no longer used: JavaScript does not free memory of the module. Other calls
 *  throw after that, and `sample` is frozen. */
export interface Session {
  readonly config: Output<hrt_session_config>;
  /** Changes fields of the configuration, between reaches. */
  configure(changes: Input<hrt_session_config>): void;
  /** Where the plate's mount stands in the world, between reaches: a rotation and a translation. In the frame of the
   *  mount +Y is up and -Z away from the user. It replaces a registration. */
  setPlate(matrix: PlateMatrix): void;
  /** Frees the session. A second call has no effect. */
  destroy(): void;
  [Symbol.dispose](): void;

  addTarget(config: Input<hrt_target_config>): TargetId;
  target(id: TargetId): Output<hrt_target_config>;
  setTarget(id: TargetId, changes: Input<hrt_target_config>): void;
  removeTarget(id: TargetId): void;
  /** RangeError if there is none. */
  findTarget(name: string): TargetId;
  /** In the order in which they were added; of one role, HRT_TARGET_*, or of both. */
  targets(role?: number): TargetId[];

  /** The gap between two targets, and the largest that the plate can hold, computed before a reach. */
  gap(realTarget: TargetId, virtualTarget: TargetId): Output<hrt_gap>;

  /** The real target that serves each virtual one, so that the largest needed share of what can be held is smallest; each
   *  real one serves one at most if `exclusive`. What cannot be served has `reachable` 0 and no real target. */
  assign(virtualTargets: TargetId[], realTargets: TargetId[], exclusive?: boolean): Output<hrt_gap>[];

  /** Input of the next update(). Fields that `flags` does not name are not read. */
  readonly sample: Frame<hrt_sample>;
  /** Output of the last update(). */
  readonly command: Readonly<Frame<hrt_command>>;
  /** What the session is about now: HRT_STATE_*; 0: idle. */
  readonly state: number;
  /** The plate is at the last command, unless its orientation is given. Directions are measured from the configured
   *  start, or from where the finger is first seen. */
  beginReach(realTarget: TargetId, virtualTarget: TargetId, plateOrientationDeg?: number, startAtFinger?: boolean): void;
  /** Leads the reach to other targets from now on, or to the same ones after setTarget() has moved them. */
  retargetReach(realTarget: TargetId, virtualTarget: TargetId): void;
  /** The pose of the plate is from a registration, as of the last beginReach(). */
  readonly registered: boolean;
  /** The finger has met the real object, by default at the real target's near side: later reaches correct the tracker's frame,
   *  about a registration. Once a reach, before its end or after it. */
  reachTouched(contact?: Input<hrt_contact>): void;
  /** Ends the reach without a summary; nothing is learnt from it. */
  cancelReach(): void;
  /** Writes the fingertip's place in the world to `sample`, or a dropout, in place of other flags. `time_ms`: the frame's
   *  time, as the callback of requestAnimationFrame() has it; finite. */
  setFinger(pose: FingerPose, time_ms: number): void;
  /** Reads `sample` and writes `command`. Once a frame. */
  update(): void;
  endReach(): Output<hrt_reach_summary>;

  /** All that was learnt of the user, as JSON to save and load later. */
  readonly profile: string;
  loadProfile(profile: string): void;
  /** Under which conditions the person of the profile was measured, and which of them are others now (`differing`,
   *  HRT_CONDITION_*). */
  readonly conditions: Output<hrt_conditions>;
  /** The conditions of now: names of plate and tracker, and the time, seconds since 1970. */
  setConditions(conditions: Input<hrt_conditions>): void;

  /** Begins a set-up of HRT_SETUP_*: registration, fingertip, calibration, retest, or all that is missing. */
  beginSetup(what?: number, config?: Input<hrt_setup_config>): void;
  /** Reads `sample`; what to do now: show `text` and `place_m`, send `plate_orientation_deg` to the plate. Once a frame. */
  updateSetup(): Output<hrt_setup_step>;
  /** Continues the fit of a part for less than 1 ms, in each frame whose step says HRT_STEP_FINISH, and applies the result of a
   *  complete fit. The set-up is over when `left` is 0. */
  finishSetup(): Output<hrt_setup_result>;
  /** What was found before stays. */
  cancelSetup(): void;

  /** Forgets the user, who is another one from now on: a set-up of all that is missing asks for them. */
  newPerson(): void;

  /** Records all calls in memory, until stopRecording() returns them as CSV. */
  startRecording(): void;
  /** Rows so far. */
  readonly recordingStatus: Output<hrt_recording_status>;
  stopRecording(): string;
}

/** A finger for first programs and tests. No measurement of people. */
export interface Person {
  /** At rest at the session's start, for 0.6 s; then they slide to the virtual target. Without one they do what the session's
   *  set-up asks for. */
  begin(session: Session, virtualTarget?: TargetId): void;
  /** Commands the plate's servo, lets time pass until `time_ns`, and writes what tracker and servo report to `sample`, which
   *  is Session.sample. */
  move(sample: Session["sample"], time_ns: number, plateOrientationDeg: number): void;
  /** Where the finger is, and where it is felt. */
  readonly state: Output<hrt_person_state>;
  destroy(): void;
  [Symbol.dispose](): void;
}

/** Plate, start and targets of a glTF file. */
export interface Scene {
  readonly info: Output<hrt_scene_info>;
  readonly targets: Output<hrt_scene_target>[];
  /** Sets the session's plate and start, and adds the targets; their ids, in the order of `targets`. */
  register(session: Session): TargetId[];
  destroy(): void;
  [Symbol.dispose](): void;
}
