// Structs are those of the C headers, where plate_radius_m is plate.radius_m. See abi.d.ts.
import type {
  hrt_contact, hrt_gap, hrt_command, hrt_conditions, hrt_person_config, hrt_person_state, hrt_reach_summary,
  hrt_recording_status, hrt_replay_report, hrt_sample, hrt_scene_info, hrt_scene_target, hrt_session_config,
  hrt_setup_config, hrt_setup_result, hrt_setup_step, hrt_target_config,
} from "./abi.js";
export * from "./abi.js";

/** A struct that the library returns, as an object. 64-bit integers are bigint, except ids of targets; in JSON they are
 *  numbers up to 2^53, and decimal text above. */
type Output<Struct> = Omit<Struct, "struct_size" | "reserved">;
/** A struct that is passed to the library. Omitted fields have their defaults or, in `changes`, keep their values.
 *  Integers may be numbers. */
type Input<Struct> = {
  [Field in Exclude<keyof Struct, "struct_size" | "reserved">]?: Struct[Field] extends bigint ? bigint | number : Struct[Field];
};
/** A struct that is used in each frame, without a new object. 64-bit integers are numbers, which are exact to 2^53 (104
 *  days in nanoseconds). Properties cannot be added. */
type Frame<Struct> = {
  [Field in Exclude<keyof Struct, "struct_size" | "reserved">]: Struct[Field] extends number[] ? Float64Array
    : Struct[Field] extends bigint ? number : Struct[Field];
};

/** Identifier of a target within its session. */
export type TargetId = number;

/** Error of a call of the library, or of a call on a destroyed object. Arguments of the wrong type cause a TypeError or
 *  a RangeError instead. */
export class HapticRetargetingError extends Error {
  /** Result code, one of HRT_ERROR_*. */
  readonly code: number;
  readonly codeName: string;
}

// Declares the symbol of `using` for compilers whose library lacks it.
declare global {
  interface SymbolConstructor { readonly dispose: unique symbol }
}

/** Loads the module. `source`: its address, its bytes, or the module as a bundler provides it; default:
 *  haptic_retargeting.wasm in the folder of this file. Warnings that no call can return, for example that a clock or a
 *  unit is probably wrong, are written by `console.warn`. */
export function load(source?: string | URL | WebAssembly.Module | ArrayBuffer | ArrayBufferView): Promise<Library>;

export interface Library {
  readonly version: { readonly major: number; readonly minor: number; readonly patch: number };
  createSession(config?: Input<hrt_session_config>): Session;
  /** Creates a simulated person. The same seed and configuration give the same person on every platform. */
  createPerson(seed?: number | bigint, config?: Input<hrt_person_config>): Person;
  /** Loads a scene from the bytes of a .gltf or .glb file; error texts contain `name`. */
  loadScene(bytes: ArrayBuffer | Uint8Array, name?: string): Scene;
  /** Replays a recording and compares the results bit for bit. */
  replay(recording: string): Output<hrt_replay_report>;
}

/** The tracked joint at the fingertip: an XRPose, XRJointPose or XRRigidTransform of WebXR, an object of three.js, or a
 *  position alone. Null, undefined or numbers that are not finite mean that tracking is lost. With the rotation of the
 *  joint, the session applies `fingertip_offset_m`, the offset of the skin that a set-up measures. */
export type FingerPose = { readonly transform: { readonly position: Point; readonly orientation?: Rotation } }
  | { readonly position: Point; readonly orientation?: Rotation; readonly quaternion?: Rotation } | Point | null | undefined;
export interface Point { readonly x: number; readonly y: number; readonly z: number }
/** A unit quaternion. */
export interface Rotation extends Point { readonly w: number }

/** A session for one user and one plate. Destroy it when it is no longer used, because JavaScript does not free memory
 *  of the module. After destroy(), other calls throw, and `sample` is frozen. */
export interface Session {
  readonly config: Output<hrt_session_config>;
  /** Changes fields of the configuration, between reaches. */
  configure(changes: Input<hrt_session_config>): void;
  /** Sets the pose of the plate's mount in the world, between reaches, from a pose with a rotation: +Y is up, and -Z
   *  points away from the user. The pose replaces a registration. */
  setPlate(pose: NonNullable<FingerPose>): void;
  /** Frees the session. A second call has no effect. */
  destroy(): void;
  [Symbol.dispose](): void;

  addTarget(config: Input<hrt_target_config>): TargetId;
  target(id: TargetId): Output<hrt_target_config>;
  setTarget(id: TargetId, changes: Input<hrt_target_config>): void;
  removeTarget(id: TargetId): void;
  /** Returns the target with this name. Throws RangeError if it does not exist. */
  findTarget(name: string): TargetId;
  /** Returns the targets of a role, HRT_TARGET_*, or of both roles, in the order in which they were added. */
  targets(role?: number): TargetId[];

  /** Computes the gap between two targets, and the largest feasible gap. Needs no reach. */
  gap(realTarget: TargetId, virtualTarget: TargetId): Output<hrt_gap>;

  /** Assigns real targets to as many virtual ones as possible, so that the largest ratio of a gap to the largest
   *  feasible gap is minimal. If `exclusive`, a real target is used at most once. A virtual target without a real one
   *  has `reachable` 0. */
  assign(virtualTargets: TargetId[], realTargets: TargetId[], exclusive?: boolean): Output<hrt_gap>[];

  /** Input of the next update() or updateSetup(). Besides `time_ns`, only fields that `flags` names are read. */
  readonly sample: Frame<hrt_sample>;
  /** Output of the last update(). */
  readonly command: Readonly<Frame<hrt_command>>;
  /** State of the session, HRT_STATE_*; 0: idle, but the real or the virtual target is missing. */
  readonly state: number;
  /** Begins a reach. The plate is assumed to be at the last command, unless its orientation is given. Directions are
   *  measured from the configured start or, with `startAtFinger`, from the first position of the finger. */
  beginReach(realTarget: TargetId, virtualTarget: TargetId, plateOrientationDeg?: number, startAtFinger?: boolean): void;
  /** Redirects the reach to other targets, or to the same targets after setTarget() has moved them. */
  retargetReach(realTarget: TargetId, virtualTarget: TargetId): void;
  /** True if the plate's pose at the last beginReach() came from a registration. */
  readonly registered: boolean;
  /** Reports contact of the finger with the real object, by default at the real target's near side. The contact
   *  corrects the tracked positions of later reaches. Requires a registration. Allowed once per reach, also after its
   *  end. */
  reachTouched(contact?: Input<hrt_contact>): void;
  /** Ends the reach without a summary and discards its estimates. */
  cancelReach(): void;
  /** Writes the joint's pose in the world, or a dropout, to `sample`, and replaces its flags. `time_ms`: finite time of
   *  the frame, as passed to the callback of requestAnimationFrame(). */
  setFinger(pose: FingerPose, time_ms: number): void;
  /** Reads `sample` and writes `command`. Call it once a frame. */
  update(): void;
  endReach(): Output<hrt_reach_summary>;

  /** Parameters of the user as JSON, to be saved and loaded later. */
  readonly profile: string;
  loadProfile(profile: string): void;
  /** Conditions under which the user was measured; `differing` flags those that differ from the present ones. */
  readonly conditions: Output<hrt_conditions>;
  /** Sets the current conditions: names of plate and tracker, and the time in seconds since 1970. */
  setConditions(conditions: Input<hrt_conditions>): void;

  /** Begins a set-up of the parts HRT_SETUP_*; by default, of all missing parts. */
  beginSetup(what?: number, config?: Input<hrt_setup_config>): void;
  /** Reads `sample`. Call it once a frame, show `text` and `place_m` of the result, and send `plate_orientation_deg` to
   *  the plate. */
  updateSetup(): Output<hrt_setup_step>;
  /** Continues the fit of a part, as hrt_setup_finish() does, and applies a complete fit. Call it in each frame whose
   *  step is HRT_STEP_FINISH. The set-up is over when `left` is 0. */
  finishSetup(): Output<hrt_setup_result>;
  /** Cancels the set-up. Results of finished parts remain. */
  cancelSetup(): void;

  /** Resets the parameters of the user, for another user, whom a set-up of all missing parts then measures. */
  newPerson(): void;

  /** Records reaches and set-ups in memory, until stopRecording() returns the recording as CSV. */
  startRecording(): void;
  readonly recordingStatus: Output<hrt_recording_status>;
  stopRecording(): string;
}

/** A simulated finger for first programs and tests: a model, not a measurement of people. */
export interface Person {
  /** Begins a reach: the finger rests at the session's start for 0.6 s, and then slides towards the virtual target.
   *  Without a target, the person follows the session's set-up. */
  begin(session: Session, virtualTarget?: TargetId): void;
  /** Commands the simulated servo, advances the simulation to `time_ns`, and writes the sample of tracker and servo. */
  move(sample: Session["sample"], time_ns: number, plateOrientationDeg: number): void;
  /** True state, such as the actual and the perceived position of the finger. Not available in a set-up. */
  readonly state: Output<hrt_person_state>;
  destroy(): void;
  [Symbol.dispose](): void;
}

/** Plate, start and targets of a glTF file. */
export interface Scene {
  readonly info: Output<hrt_scene_info>;
  readonly targets: Output<hrt_scene_target>[];
  /** Sets the session's plate and start, and adds the targets. Returns their ids in the order of `targets`. */
  register(session: Session): TargetId[];
  destroy(): void;
  [Symbol.dispose](): void;
}
