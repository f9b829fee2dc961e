// Reach after reach of the simulated person, led by the real plugin: the plugin sees the tracked finger, the plate
// follows its commands, and the person feels the plate.
import type { Library } from "haptic-retargeting";
import { Controller, pageCourse } from "./controller";
import { bearingError_deg, length_m, realPlace, virtualPlace, type Course } from "./geometry";
import type { World } from "./person";
import type { ControllerName, Settings } from "./settings";
import { Trace, tracePeriod_ms } from "./trace";

const trackerRate_hz = 90;

export type Phase = "waiting" | "sliding" | "arrived";

/** How a reach ended: the simulation's truth, except what the controller believes. */
export interface ReachResult {
  /** Of this person under this controller, from 1. */
  readonly number: number;
  readonly controller: ControllerName;
  readonly tactileWeight: number;
  readonly gap_deg: number;
  /** Bearing of the finger's end, less the cylinder's. */
  readonly bearingError_deg: number;
  readonly toCylinder_mm: number;
  /** From where the finger is felt to the ghost. */
  readonly feltToGhost_mm: number;
  readonly peakFeltError_deg: number;
  /** What the controller believes; 0 deviation: it does not learn. */
  readonly weight: number;
  readonly weightSd: number;
  readonly flags: number;
  readonly motion_s: number;
  readonly plateFastest_deg_s: number;
  /** Greatest distance of a tracked position from the finger. */
  readonly trackerWorst_mm: number;
}

export class Watch {
  readonly trace = new Trace();
  phase: Phase = "waiting";
  /** Where a connected plate is, which the person then feels instead of the simulated one; NaN: there is none. */
  plateConnected_deg = NaN;
  result: ReachResult | null = null;
  /** Of the last reach that has ended, as CSV. */
  recording = "";

  readonly #library: Library;
  readonly #world: World;
  readonly #courseOf: (settings: Readonly<Settings>) => Course;
  #course: Course;
  #settings: Settings;
  #controller: Controller;
  #number = 1;
  #samples = 0;
  #startedAt_ms = -1;
  #stoppedAt_ms = -1;
  #lastPlate_deg = 0;
  #plateFastest_deg_s = 0;
  #trackerWorst_m = 0;

  /** `courseOf`: where reaches lead under some settings. */
  constructor(library: Library, world: World, settings: Readonly<Settings>, courseOf: (settings: Readonly<Settings>) => Course = pageCourse) {
    this.#library = library;
    this.#world = world;
    this.#settings = { ...settings };
    this.#courseOf = courseOf;
    this.#course = courseOf(settings);
    this.#controller = new Controller(library, settings, this.#course, world.plate_latency_ms());
    this.begin();
  }

  get command() { return this.#controller.session.command; }
  /** What has been learnt of the person, as JSON. */
  get profile(): string { return this.#controller.session.profile; }
  get number(): number { return this.#number; }
  get course(): Course { return this.#course; }

  /** A new reach under these settings. What was learnt of the person stays, unless they are another one, or the
   *  controller is: then the result is true. */
  apply(settings: Readonly<Settings>): boolean {
    const before = this.#settings;
    this.#settings = { ...settings };
    this.#course = this.#courseOf(settings);
    this.#drop();
    const unknown = before.person !== settings.person || before.tactile_weight !== settings.tactile_weight ||
      before.pace_s !== settings.pace_s || before.controller !== settings.controller;
    if (unknown) {
      this.#controller.destroy();
      this.#controller = new Controller(this.#library, settings, this.#course, this.#world.plate_latency_ms());
      this.#number = 1;
      this.phase = "waiting";
    } else {
      this.#controller.apply(settings, this.#course);
    }
    this.begin();
    return unknown;
  }

  /** The next reach. One under way is cancelled; one whose finger has not moved begins anew. */
  begin(): void {
    const settings = this.#settings, world = this.#world;
    this.#drop();
    if (this.phase !== "waiting") ++this.#number;
    world.set_person(settings.person, settings.tactile_weight, settings.pace_s);
    world.set_apparatus(settings.noise_mm / 1000, settings.plate_deg_s);
    const { start, virtual_deg, virtual_m } = this.#course;
    world.begin_reach(this.#number, start.right_m, start.away_m, virtual_deg, virtual_m, 0);
    this.#controller.begin(0);
    this.trace.clear();
    this.phase = "waiting";
    this.result = null;
    this.#samples = 0;
    this.#startedAt_ms = this.#stoppedAt_ms = -1;
    this.#lastPlate_deg = world.plate_deg();
    this.#plateFastest_deg_s = this.#trackerWorst_m = 0;
  }

  #drop(): void {
    this.#controller.cancel();
    this.#controller.takeRecording();
  }

  /** One millisecond of the reach; nothing once it is over. */
  advance(): void {
    if (this.phase === "arrived") return;
    const world = this.#world;
    if (!Number.isNaN(this.plateConnected_deg)) world.set_plate(this.plateConnected_deg);
    world.advance();
    const now_ms = world.time_ms();
    if (now_ms >= (this.#samples * 1000) / trackerRate_hz) this.#look(now_ms);
    this.#measure(now_ms);
    if (now_ms % tracePeriod_ms === 0) this.#record();
    if (world.over()) this.#end();
  }

  #look(now_ms: number): void {
    const world = this.#world;
    ++this.#samples;
    world.look();
    const right_m = world.seen_right_m(), away_m = world.seen_away_m();
    const off_m = Math.hypot(right_m - world.finger_right_m(), away_m - world.finger_away_m());
    this.#trackerWorst_m = Math.max(this.#trackerWorst_m, off_m);
    world.command(this.#controller.see(now_ms, right_m, away_m));
  }

  #measure(now_ms: number): void {
    const world = this.#world, plate_deg = world.plate_deg();
    this.#plateFastest_deg_s = Math.max(this.#plateFastest_deg_s, 1000 * Math.abs(plate_deg - this.#lastPlate_deg));
    this.#lastPlate_deg = plate_deg;
    if (world.moving()) {
      if (this.#startedAt_ms < 0) this.#startedAt_ms = now_ms;
      this.phase = "sliding";
    } else if (this.#startedAt_ms >= 0 && this.#stoppedAt_ms < 0) {
      this.#stoppedAt_ms = now_ms;
    }
  }

  #record(): void {
    const world = this.#world, { command } = this;
    const moving = world.moving() !== 0;
    const learns = this.#settings.controller !== "off";
    this.trace.add(world.plate_deg(), moving ? world.finger_deg() : NaN,
                   moving ? this.#course.virtual_deg + world.felt_error_deg() : NaN,
                   learns ? command.tactile_weight : NaN, learns ? command.tactile_weight_sd : NaN);
  }

  #end(): void {
    const world = this.#world, settings = this.#settings;
    const { tactile_weight, tactile_weight_sd } = this.command;
    const summary = this.#controller.end();
    this.recording = this.#controller.takeRecording();
    const finger = { right_m: world.finger_right_m(), away_m: world.finger_away_m() };
    const felt = { right_m: world.felt_right_m(), away_m: world.felt_away_m() };
    this.phase = "arrived";
    this.result = {
      number: this.#number,
      controller: settings.controller,
      tactileWeight: settings.tactile_weight,
      gap_deg: this.#course.virtual_deg - this.#course.real_deg,
      bearingError_deg: bearingError_deg(finger, this.#course),
      toCylinder_mm: 1000 * length_m(finger, realPlace(this.#course)),
      feltToGhost_mm: 1000 * length_m(felt, virtualPlace(this.#course)),
      peakFeltError_deg: world.peak_felt_error_deg(),
      weight: tactile_weight,
      weightSd: tactile_weight_sd,
      flags: summary.flags,
      motion_s: (this.#stoppedAt_ms - this.#startedAt_ms) / 1000,
      plateFastest_deg_s: this.#plateFastest_deg_s,
      trackerWorst_mm: 1000 * this.#trackerWorst_m,
    };
  }
}
