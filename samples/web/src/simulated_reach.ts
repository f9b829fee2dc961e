// Reaches of the simulated person, controlled by the real plugin: the plugin receives the tracked fingertip, the simulated plate
// follows its commands, and the person feels the plate.
import type { Library } from "haptic-retargeting";
import { pageCourse } from "./controller";
import { bearingError_deg, type Course, type SlideEnd, slideEnd } from "./geometry";
import { GuidedReach } from "./guided_reach";
import { places, type World } from "./person";
import type { ControllerName, Settings } from "./settings";

const trackerRate_hz = 90;

/** Result of a reach: the ground truth of the simulation and the controller's estimates. */
export interface ReachResult extends SlideEnd {
  /** Number of the reach by this person with this controller, from 1. */
  readonly number: number;
  readonly controller: ControllerName;
  readonly tactileWeight: number;
  readonly gap_deg: number;
  /** Direction of the end of the reach minus that of the cylinder, both seen from the start. */
  readonly bearingError_deg: number;
  readonly peakFeltError_deg: number;
  /** Estimate of the tactile weight and its SD, which is 0 if the controller does not learn. */
  readonly weight: number;
  readonly weightSd: number;
  readonly flags: number;
  readonly motion_s: number;
  readonly plateFastest_deg_s: number;
  /** Largest distance of a tracked position from the true one. */
  readonly trackerWorst_mm: number;
}

export class SimulatedReach extends GuidedReach {
  phase: "waiting" | "sliding" | "arrived" = "waiting";
  result: ReachResult | null = null;

  course: Course;
  number = 1;
  #samples = 0;
  #startedAt_ms = -1;
  #stoppedAt_ms = -1;
  #lastPlate_deg = 0;
  #plateFastest_deg_s = 0;
  #trackerWorst_m = 0;

  /** `courseOf` returns the targets for given settings. */
  constructor(
    library: Library,
    world: World,
    settings: Readonly<Settings>,
    private readonly courseOf: (settings: Readonly<Settings>) => Course = pageCourse,
  ) {
    super(library, world, settings, courseOf(settings));
    this.course = courseOf(settings);
    this.begin();
  }

  /** Profile of the person as JSON. */
  get profile(): string {
    return this.session.profile;
  }

  /** Begins a reach under these settings. Returns true if the person or the controller has changed, in which case the
   *  estimates of the person are discarded. */
  apply(settings: Readonly<Settings>): boolean {
    const before = this.settings;
    this.settings = { ...settings };
    this.course = this.courseOf(settings);
    this.cancel();
    const unknown =
      before.person !== settings.person ||
      before.tactile_weight !== settings.tactile_weight ||
      before.pace_s !== settings.pace_s ||
      before.controller !== settings.controller;
    if (unknown) {
      this.restartSession(this.course);
      this.number = 1;
      this.phase = "waiting";
    } else {
      this.setTargets(this.course);
    }
    this.begin();
    return unknown;
  }

  /** Begins the next reach, and cancels a running one. If the hand has not moved in the latter, both have the same number. */
  begin(): void {
    const world = this.world;
    if (this.phase !== "waiting") ++this.number;
    this.prepare();
    const { start, virtual_deg, virtual_m } = this.course;
    world.begin_reach(this.number, start.right_m, start.away_m, virtual_deg, virtual_m, 0);
    this.beginReach(0);
    this.phase = "waiting";
    this.result = null;
    this.#samples = 0;
    this.#startedAt_ms = this.#stoppedAt_ms = -1;
    this.#lastPlate_deg = world.plate_deg();
    this.#plateFastest_deg_s = this.#trackerWorst_m = 0;
  }

  /** Advances the reach by one millisecond, until it has ended. */
  advance(): void {
    if (this.phase === "arrived") return;
    const world = this.world;
    this.advanceWorld();
    const now_ms = world.time_ms();
    if (now_ms >= (this.#samples * 1000) / trackerRate_hz) this.#sample(now_ms);
    this.#measure(now_ms);
    const { finger, felt } = places(world);
    this.record(this.directions(), finger, felt);
    if (world.over()) this.#end();
  }

  /** True and perceived direction of the motion; NaN at rest. */
  directions(): { finger_deg: number; felt_deg: number } {
    const world = this.world;
    if (world.moving() === 0) return { finger_deg: NaN, felt_deg: NaN };
    return { finger_deg: world.finger_deg(), felt_deg: this.course.virtual_deg + world.felt_error_deg() };
  }

  #sample(now_ms: number): void {
    const world = this.world;
    ++this.#samples;
    world.look();
    const right_m = world.seen_right_m(),
      away_m = world.seen_away_m();
    const off_m = Math.hypot(right_m - world.finger_right_m(), away_m - world.finger_away_m());
    this.#trackerWorst_m = Math.max(this.#trackerWorst_m, off_m);
    this.updateFinger(now_ms, right_m, away_m);
  }

  #measure(now_ms: number): void {
    const world = this.world,
      plate_deg = world.plate_deg();
    this.#plateFastest_deg_s = Math.max(this.#plateFastest_deg_s, 1000 * Math.abs(plate_deg - this.#lastPlate_deg));
    this.#lastPlate_deg = plate_deg;
    if (world.moving()) {
      if (this.#startedAt_ms < 0) this.#startedAt_ms = now_ms;
      this.phase = "sliding";
    } else if (this.#startedAt_ms >= 0 && this.#stoppedAt_ms < 0) {
      this.#stoppedAt_ms = now_ms;
    }
  }

  #end(): void {
    const world = this.world,
      settings = this.settings;
    const { tactile_weight, tactile_weight_sd } = this.command;
    const summary = this.session.endReach();
    this.recording = this.cancel();
    const { finger, felt } = places(world);
    this.phase = "arrived";
    this.result = {
      number: this.number,
      controller: settings.controller,
      tactileWeight: settings.tactile_weight,
      gap_deg: this.course.virtual_deg - this.course.real_deg,
      bearingError_deg: bearingError_deg(finger, this.course),
      ...slideEnd(finger, felt, this.course),
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
