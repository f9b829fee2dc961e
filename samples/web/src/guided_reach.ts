// Base class of the reaches that the plugin controls: a session of the plugin, and the simulated world with the plate. The hand
// is a simulated person's, the visitor's pointer, or one that a headset tracks.
import * as hrt from "haptic-retargeting";
import { sessions } from "./controller";
import { type Course, cylinderRadius_m, type Place } from "./geometry";
import type { World } from "./person";
import type { Settings } from "./settings";
import { maxTrace, type Trace, tracePeriod_ms } from "./trace";

type Directions = Readonly<Record<"finger_deg" | "felt_deg", number>>;

export abstract class GuidedReach {
  /** Trace of the current reach. Each reach has its own array. */
  trace: Trace = [];
  /** Orientation of a connected plate, which replaces the simulated one. NaN: no plate is connected. */
  plateConnected_deg = NaN;
  /** Recording of the last reach that has ended, as CSV. */
  recording = "";
  protected settings: Settings;
  /** Session of the plugin. It is given the targets and the plate's limits, but no parameter of the person. */
  protected session!: hrt.Session;
  #real = 0;
  #virtual = 0;

  constructor(
    private readonly library: hrt.Library,
    protected readonly world: World,
    settings: Readonly<Settings>,
    course: Course,
  ) {
    this.settings = { ...settings };
    this.#create(course);
  }

  get command() {
    return this.session.command;
  }

  /** Replaces the session by one with the default parameters of a person. */
  protected restartSession(course: Course): void {
    this.cancel();
    this.session.destroy();
    this.#create(course);
  }

  #create(course: Course): void {
    this.session = this.library.createSession({
      ...sessions[this.settings.controller],
      plate_latency_ns: Math.round(1e6 * this.world.plate_latency_ms()),
    });
    this.#real = this.session.addTarget({ role: hrt.HRT_TARGET_REAL, name: "cylinder", radius_m: cylinderRadius_m });
    this.#virtual = this.session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, name: "glass" });
    this.setTargets(course);
  }

  /** Changes targets and plate between reaches. The controller keeps its estimates of the person. */
  protected setTargets({ start, real_deg, real_m, virtual_deg, virtual_m }: Course): void {
    this.session.configure({
      plate_max_speed_deg_s: this.settings.plate_deg_s,
      start_position_m: [start.right_m, 0, -start.away_m],
    });
    this.session.setTarget(this.#real, { direction_deg: real_deg, distance_m: real_m });
    this.session.setTarget(this.#virtual, { direction_deg: virtual_deg, distance_m: virtual_m });
  }

  /** Cancels a running reach; the controller discards its samples. Returns the recording, or "" if nothing was recorded. */
  protected cancel(): string {
    if (this.session.state & hrt.HRT_STATE_REACHING) this.session.cancelReach();
    return this.session.state & hrt.HRT_STATE_RECORDING ? this.session.stopRecording() : "";
  }

  /** Cancels a running reach, applies the settings to person and plate, and begins an empty trace. */
  protected prepare(): void {
    this.cancel();
    this.world.set_person(this.settings.person, this.settings.tactile_weight, this.settings.pace_s);
    this.world.set_apparatus(this.settings.noise_mm / 1000, this.settings.plate_deg_s);
    this.trace = [];
  }

  protected beginReach(plate_deg: number): void {
    this.session.startRecording();
    this.session.beginReach(this.#real, this.#virtual, plate_deg);
  }

  /** Passes a position of the fingertip to the plugin, and the plugin's command to the plate. */
  protected updateFinger(time_ms: number, right_m: number, away_m: number): void {
    const { sample } = this.session;
    sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
    sample.time_ns = Math.round(1e6 * time_ms);
    sample.finger_position_m[0] = right_m;
    sample.finger_position_m[1] = 0;
    sample.finger_position_m[2] = -away_m;
    this.session.update();
    this.world.command(this.command.plate_orientation_deg);
  }

  /** Advances the world by one millisecond, with the orientation of a connected plate if there is one. */
  protected advanceWorld(): void {
    if (!Number.isNaN(this.plateConnected_deg)) this.world.set_plate(this.plateConnected_deg);
    this.world.advance();
  }

  /** Appends to the trace, once in each period of the trace. Directions are NaN at rest. */
  protected record(directions: Directions, finger: Readonly<Place>, felt: Readonly<Place>): void {
    if (this.world.time_ms() % tracePeriod_ms !== 0 || this.trace.length === maxTrace) return;
    const { finger_deg, felt_deg } = directions,
      { tactile_weight, tactile_weight_sd: weight_sd } = this.command,
      weight = this.settings.controller === "off" ? NaN : tactile_weight;
    const plate_deg = this.world.plate_deg();
    this.trace.push({ plate_deg, finger_deg, felt_deg, weight, weight_sd, finger: { ...finger }, felt: { ...felt } });
  }
}
