// Base class of the reaches that the plugin controls: of a simulated person, of a pointer, or of a tracked hand.
import * as hrt from "haptic-retargeting";
import { type Course, cylinderRadius_m, type Place } from "./geometry";
import type { ControllerName, Settings } from "./settings";

/** Largest angle between the normal of the ridges and the motion for which the controller "ours" plans. */
export const motionBound_deg = 75;

const sessions: Readonly<Record<ControllerName, Parameters<hrt.Library["createSession"]>[0]>> = {
  off: { control: hrt.HRT_CONTROL_FIXED_PLATE },
  paper: { guidance: hrt.HRT_GUIDANCE_FIXED_DIRECTION, adaptation: hrt.HRT_ADAPTATION_OFF, tactile_weight: 0.15 },
  ours: {
    guidance: hrt.HRT_GUIDANCE_ARRIVAL,
    adaptation: hrt.HRT_ADAPTATION_CARRIED,
    motion_bound_deg: motionBound_deg,
  },
};

/** Time from a command to the motion of the simulated servo. */
export const plateLatency_ms = 30;
/** Maximum number of steps in a trace: 41 s of a slide by the pointer, whose steps last 10 ms. */
export const maxTrace = 4096;

/** State of a hand. These are NaN: `finger_deg` and `felt_deg` at rest; `weight` if the controller is off; `felt` in a
 *  recording. */
export interface Step {
  readonly time_ms: number;
  readonly plate_deg: number;
  readonly finger_deg: number;
  readonly felt_deg: number;
  /** The controller's estimate of the tactile weight, and its SD. */
  readonly weight: number;
  readonly weight_sd: number;
  readonly finger: Readonly<Place>;
  readonly felt: Readonly<Place>;
}
export type Trace = Step[];

export abstract class GuidedReach {
  /** A new array for each reach. */
  trace: Trace = [];
  /** Orientation of a connected plate, which replaces the simulated one. NaN: no plate is connected. */
  plateConnected_deg = NaN;
  /** Recording of the last reach that has ended, as CSV. */
  recording = "";
  protected settings: Settings;
  /** Session of the plugin, which knows the targets and the plate, but not the parameters of the person. */
  protected session!: hrt.Session;
  protected real = 0;
  protected virtual = 0;

  constructor(
    protected readonly library: hrt.Library,
    settings: Readonly<Settings>,
    course: Course,
  ) {
    this.settings = { ...settings };
    this.#create(course);
  }

  get command() {
    return this.session.command;
  }

  /** Cancels a running reach, and creates a new session, which has no estimates of the person. */
  protected restartSession(course: Course): void {
    this.cancel();
    this.session.destroy();
    this.#create(course);
  }

  #create(course: Course): void {
    this.session = this.library.createSession({
      ...sessions[this.settings.controller],
      plate_latency_ns: 1e6 * plateLatency_ms,
    });
    this.real = this.session.addTarget({ role: hrt.HRT_TARGET_REAL, name: "cylinder", radius_m: cylinderRadius_m });
    this.virtual = this.session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, name: "glass" });
    this.setTargets(course);
  }

  /** Sets start, targets and the plate's speed, between reaches. The controller keeps its estimates of the person. */
  protected setTargets({ start, real_deg, real_m, virtual_deg, virtual_m }: Course): void {
    this.session.configure({
      plate_max_speed_deg_s: this.settings.plate_deg_s,
      start_position_m: [start.right_m, 0, -start.away_m],
    });
    this.session.setTarget(this.real, { direction_deg: real_deg, distance_m: real_m });
    this.session.setTarget(this.virtual, { direction_deg: virtual_deg, distance_m: virtual_m });
  }

  /** Cancels a running reach. Stops the recording and returns it; "" without a recording. */
  protected cancel(): string {
    if (this.session.state & hrt.HRT_STATE_REACHING) this.session.cancelReach();
    return this.session.state & hrt.HRT_STATE_RECORDING ? this.session.stopRecording() : "";
  }

  protected beginReach(plate_deg: number): void {
    this.cancel();
    this.trace = [];
    this.session.startRecording();
    this.session.beginReach(this.real, this.virtual, plate_deg);
  }

  protected record(step: Omit<Step, "weight" | "weight_sd">): void {
    if (this.trace.length === maxTrace) return;
    const { tactile_weight, tactile_weight_sd } = this.command,
      weight = this.settings.controller === "off" ? NaN : tactile_weight;
    this.trace.push({ ...step, weight, weight_sd: tactile_weight_sd });
  }
}
