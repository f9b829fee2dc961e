// Reach after reach of the simulated person, led by the real plugin: the plugin sees the tracked finger, the plate
// follows its commands, and the person feels the plate.
import type { Library } from "haptic-retargeting";
import { pageCourse } from "./controller";
import { bearingError_deg, type Course, type Place, type SlideEnd, slideEnd } from "./geometry";
import { Led } from "./led";
import type { World } from "./person";
import type { ControllerName, Settings } from "./settings";

const trackerRate_hz = 90;

/** How a reach ended: the simulation's truth, except what the controller believes. */
export interface ReachResult extends SlideEnd {
  /** Of this person under this controller, from 1. */
  readonly number: number;
  readonly controller: ControllerName;
  readonly tactileWeight: number;
  readonly gap_deg: number;
  /** Bearing of the finger's end, less the cylinder's. */
  readonly bearingError_deg: number;
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

export class Watch extends Led {
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

  /** `courseOf`: where reaches lead under some settings. */
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

  /** What has been learnt of the person, as JSON. */
  get profile(): string {
    return this.session.profile;
  }

  /** A new reach under these settings. What was learnt of the person stays, unless they are another one, or the
   *  controller is: then the result is true. */
  apply(settings: Readonly<Settings>): boolean {
    const before = this.settings;
    this.settings = { ...settings };
    this.course = this.courseOf(settings);
    this.drop();
    const unknown =
      before.person !== settings.person ||
      before.tactile_weight !== settings.tactile_weight ||
      before.pace_s !== settings.pace_s ||
      before.controller !== settings.controller;
    if (unknown) {
      this.renew(this.course);
      this.number = 1;
      this.phase = "waiting";
    } else {
      this.follow(this.course);
    }
    this.begin();
    return unknown;
  }

  /** The next reach. One under way is cancelled; one whose finger has not moved begins anew. */
  begin(): void {
    const world = this.world;
    if (this.phase !== "waiting") ++this.number;
    this.prepare();
    const { start, virtual_deg, virtual_m } = this.course;
    world.begin_reach(this.number, start.right_m, start.away_m, virtual_deg, virtual_m, 0);
    this.lead(0);
    this.phase = "waiting";
    this.result = null;
    this.#samples = 0;
    this.#startedAt_ms = this.#stoppedAt_ms = -1;
    this.#lastPlate_deg = world.plate_deg();
    this.#plateFastest_deg_s = this.#trackerWorst_m = 0;
  }

  /** One millisecond of the reach; nothing once it is over. */
  advance(): void {
    if (this.phase === "arrived") return;
    const world = this.world;
    this.tick();
    const now_ms = world.time_ms();
    if (now_ms >= (this.#samples * 1000) / trackerRate_hz) this.#look(now_ms);
    this.#measure(now_ms);
    const moving = world.moving() !== 0,
      felt_deg = this.course.virtual_deg + world.felt_error_deg();
    this.record(moving ? world.finger_deg() : NaN, moving ? felt_deg : NaN, ...this.#places());
    if (world.over()) this.#end();
  }

  /** Of the finger, and where it is felt. */
  #places(): [Place, Place] {
    const world = this.world;
    return [
      { right_m: world.finger_right_m(), away_m: world.finger_away_m() },
      { right_m: world.felt_right_m(), away_m: world.felt_away_m() },
    ];
  }

  #look(now_ms: number): void {
    const world = this.world;
    ++this.#samples;
    world.look();
    const right_m = world.seen_right_m(),
      away_m = world.seen_away_m();
    const off_m = Math.hypot(right_m - world.finger_right_m(), away_m - world.finger_away_m());
    this.#trackerWorst_m = Math.max(this.#trackerWorst_m, off_m);
    this.see(now_ms, right_m, away_m);
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
    this.recording = this.drop();
    const [finger, felt] = this.#places();
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
