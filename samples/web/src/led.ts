// What simulated person, visitor's finger and worn hand have in common: a world, and a session of the plugin that leads them in it.
import * as hrt from "haptic-retargeting";
import { sessions } from "./controller";
import { type Course, cylinderRadius_m, type Place } from "./geometry";
import type { World } from "./person";
import type { Settings } from "./settings";
import { maxTrace, type Trace, tracePeriod_ms } from "./trace";

export abstract class Led {
  /** Of the reach; another one for each. */
  trace: Trace = [];
  /** Where a connected plate is, which is felt instead of the simulated one; NaN: there is none. */
  plateConnected_deg = NaN;
  /** Of the last reach that has ended, as CSV. */
  recording = "";
  protected settings: Settings;
  /** Knows the course and what the plate can do; nothing of the person. */
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

  /** From now on a person of whom the controller knows nothing. */
  protected renew(course: Course): void {
    this.drop();
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
    this.follow(course);
  }

  /** Between reaches: other targets and another plate, with what has been learnt of the person. */
  protected follow({ start, real_deg, real_m, virtual_deg, virtual_m }: Course): void {
    this.session.configure({
      plate_max_speed_deg_s: this.settings.plate_deg_s,
      start_position_m: [start.right_m, 0, -start.away_m],
    });
    this.session.setTarget(this.#real, { direction_deg: real_deg, distance_m: real_m });
    this.session.setTarget(this.#virtual, { direction_deg: virtual_deg, distance_m: virtual_m });
  }

  /** Nothing is learnt from a reach that is still under way. Returns the recording; empty: there was none. */
  protected drop(): string {
    if (this.session.state & hrt.HRT_STATE_REACHING) this.session.cancelReach();
    return this.session.state & hrt.HRT_STATE_RECORDING ? this.session.stopRecording() : "";
  }

  /** Person, plate and trace are as the settings have them, before another reach. */
  protected prepare(): void {
    this.drop();
    this.world.set_person(this.settings.person, this.settings.tactile_weight, this.settings.pace_s);
    this.world.set_apparatus(this.settings.noise_mm / 1000, this.settings.plate_deg_s);
    this.trace = [];
  }

  /** A reach begins, and is recorded. */
  protected lead(plate_deg: number): void {
    this.session.startRecording();
    this.session.beginReach(this.#real, this.#virtual, plate_deg);
  }

  /** The plugin sees the finger there, and commands the plate. */
  protected see(time_ms: number, right_m: number, away_m: number): void {
    const { sample } = this.session;
    sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
    sample.time_ns = Math.round(1e6 * time_ms);
    sample.finger_position_m[0] = right_m;
    sample.finger_position_m[1] = 0;
    sample.finger_position_m[2] = -away_m;
    this.session.update();
    this.world.command(this.command.plate_orientation_deg);
  }

  /** One millisecond of the world, which a connected plate takes part in. */
  protected tick(): void {
    if (!Number.isNaN(this.plateConnected_deg)) this.world.set_plate(this.plateConnected_deg);
    this.world.advance();
  }

  /** Directions are NaN at rest. */
  protected record(finger_deg: number, felt_deg: number, finger: Readonly<Place>, felt: Readonly<Place>): void {
    if (this.world.time_ms() % tracePeriod_ms !== 0 || this.trace.length === maxTrace) return;
    const { tactile_weight, tactile_weight_sd: weight_sd } = this.command,
      weight = this.settings.controller === "off" ? NaN : tactile_weight;
    const plate_deg = this.world.plate_deg();
    this.trace.push({ plate_deg, finger_deg, felt_deg, weight, weight_sd, finger: { ...finger }, felt: { ...felt } });
  }
}
