// Structs have the fields of the C headers, under their names, which end in the unit: see abi.d.ts.
import type {
  hrt_authority, hrt_calibration_config, hrt_calibration_result, hrt_command, hrt_reach_summary,
  hrt_replay_report, hrt_sample, hrt_scene_info, hrt_scene_target, hrt_session_config, hrt_target_config,
} from "./abi.js";
export * from "./abi.js";

/** A struct that the library returns, as an object. 64-bit integers are bigint. */
type Output<Struct> = Omit<Struct, "struct_size" | "reserved">;
/** A struct for the library: fields left out take their defaults; integers may be numbers. */
type Input<Struct> = {
  [Field in keyof Output<Struct>]?: Struct[Field] extends bigint ? bigint | number : Struct[Field];
};
/** A struct in the module's memory, read and written every frame without making objects. 64-bit integers are
 *  numbers, exact to 2^53 (as nanoseconds: 104 days). Arrays are views: do not keep them from frame to frame. */
type View<Struct> = {
  [Field in keyof Output<Struct>]: Struct[Field] extends number[] ? Float64Array
    : Struct[Field] extends bigint ? number : Struct[Field];
};

/** A target's id within its session. */
export type TargetId = bigint;

/** A call that failed. The message is the library's: call, field, value and what is allowed. Arguments that are not
 *  what their type says are a TypeError or a RangeError instead. */
export class HapticRetargetingError extends Error {
  /** HRT_ERROR_*. */
  readonly code: number;
  /** Its name. */
  readonly codeName: string;
}

/** Loads the module: haptic_retargeting.wasm beside this file, unless `source` is another address, or the module
 *  itself as a bundler gives it. */
export function load(source?: string | URL | WebAssembly.Module | ArrayBuffer | ArrayBufferView): Promise<Library>;

export interface Library {
  readonly version: { readonly major: number; readonly minor: number; readonly patch: number };
  createSession(config?: Input<hrt_session_config>): Session;
  /** A .gltf or .glb file's bytes; `name` stands for it in error texts. */
  loadScene(bytes: ArrayBuffer | Uint8Array, name?: string): Scene;
  /** Runs a recording again and compares, bit for bit. */
  replay(recording: string): Output<hrt_replay_report>;
}

/** One user, one plate. To be destroyed when done: JavaScript does not collect what the module holds. */
export interface Session {
  readonly config: Output<hrt_session_config>;
  /** Changes fields of the configuration, between reaches. */
  configure(changes: Input<hrt_session_config>): void;
  destroy(): void;

  addTarget(config: Input<hrt_target_config>): TargetId;
  target(id: TargetId): Output<hrt_target_config>;
  setTarget(id: TargetId, changes: Input<hrt_target_config>): void;
  removeTarget(id: TargetId): void;
  findTarget(name: string): TargetId;
  /** In the order in which they were added; of one role, HRT_TARGET_*, or of both. */
  targets(role?: number): TargetId[];

  /** The largest gap that the plate can sustain for a pair, computed before a reach. */
  authority(realTarget: TargetId, virtualTarget: TargetId): Output<hrt_authority>;
  /** The same for the real target that serves a virtual one best. */
  bestAuthority(virtualTarget: TargetId): Output<hrt_authority>;

  /** The real target that serves each virtual one, so that the largest needed share of the authority is smallest; each
   *  real one serves one at most if `exclusive`. What cannot be served has `reachable` 0 and no real target. */
  assign(virtualTargets: TargetId[], realTargets: TargetId[], exclusive?: boolean): Output<hrt_authority>[];

  /** Input of the next update(). Fields that `flags` does not name are not read. */
  readonly sample: View<hrt_sample>;
  /** Output of the last update(). */
  readonly command: Readonly<View<hrt_command>>;
  /** What the session is about now: HRT_STATE_*; 0: idle. */
  readonly state: number;
  /** The plate is at the last command, unless its orientation is given. Directions are measured from the configured
   *  start, or from where the finger is first seen. */
  beginReach(realTarget: TargetId, virtualTarget: TargetId, plateOrientationDeg?: number, startAtFinger?: boolean): void;
  /** Leads the reach to other targets from now on, or to the same ones after setTarget() has moved them. */
  retargetReach(realTarget: TargetId, virtualTarget: TargetId): void;
  /** Ends the reach without a summary; nothing is learnt from it. */
  cancelReach(): void;
  /** Reads `sample` and writes `command`. Once a frame. */
  update(): void;
  endReach(): Output<hrt_reach_summary>;

  /** All that was learnt of the user, as JSON to save and load later. */
  readonly profile: string;
  loadProfile(profile: string): void;
  createCalibration(config?: Input<hrt_calibration_config>): Calibration;
  applyCalibration(result: Output<hrt_calibration_result>): void;

  /** Records all calls in memory, until stopRecording() returns them as CSV. */
  startRecording(): void;
  stopRecording(): string;
}

/** Identifies the user by slides over a plate at rest: for each beginTrial(), addSample() as samples come, endTrial(). */
export interface Calibration {
  destroy(): void;
  beginTrial(plateOrientationDeg: number): void;
  /** Input of the next addSample(). */
  readonly sample: View<hrt_sample>;
  addSample(): void;
  endTrial(): void;
  cancelTrial(): void;
  /** Half a second of work for 20000 samples: not between two frames. */
  solve(): Output<hrt_calibration_result>;
}

/** Plate, start and targets of a glTF file. */
export interface Scene {
  readonly info: Output<hrt_scene_info>;
  readonly targets: Output<hrt_scene_target>[];
  /** Sets the session's plate and start, and adds the targets; their ids, in the order of `targets`. */
  register(session: Session): TargetId[];
  destroy(): void;
}
