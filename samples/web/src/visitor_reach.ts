// The visitor's hand on a plate that the real plugin turns. The pointer is the true fingertip; its perceived position follows
// from its motion, the ridges and the tactile weight of the settings. The visitor sees and steers the perceived position only.
import type { Library } from "haptic-retargeting";
import { pageCourse } from "./controller";
import { Felt } from "./felt";
import {
  bearing_deg,
  degree,
  distance_m,
  length_m,
  type Place,
  ridgeSpacing_m,
  type SlideEnd,
  slideEnd,
  start,
  virtualPlace,
} from "./geometry";
import { GuidedReach } from "./guided_reach";
import type { World } from "./person";
import type { Settings } from "./settings";
import { maxTrace, tracePeriod_ms } from "./trace";

/** A shorter slide does not count: it begins again. */
export const minReach_m = 0.03;
/** Distance below which the perceived fingertip has reached the glass. */
const near_m = 0.002;
const step_ms = 10;
/** Before the motion, the plugin receives a fingertip at rest for a while, during which the plate turns to its first orientation.
 *  Then the time stops until the fingertip moves, so that a resting hand is neither recorded nor computed. */
const settle_ms = 700,
  maxRest_ms = 1000;

export class VisitorReach extends GuidedReach {
  /** Phase of the slide, which is "sliding" from the first motion to the end. */
  phase: "waiting" | "sliding" | "arrived" = "waiting";
  /** `gap_deg`: angle between the perceived and the true end, seen from the start. */
  result: (SlideEnd & { readonly gap_deg: number }) | null = null;
  /** Number of ridges that have passed under the fingertip, by its own motion or the plate's. */
  ridges = 0;

  /** Position of the fingertip, and the position to which it moves next. */
  readonly finger: Place = { ...start };
  readonly wanted: Place = { ...start };
  readonly felt = new Felt(this.world);
  #rested_ms = 0;
  #ridge = 0;

  constructor(library: Library, world: World, settings: Readonly<Settings>) {
    super(library, world, settings, pageCourse(settings));
    this.begin(settings.gap_deg);
  }

  get gap_deg(): number {
    return this.settings.gap_deg;
  }
  /** True if nothing changes until the wanted position does, or a connected plate turns. */
  get resting(): boolean {
    return this.phase === "arrived" || this.#rested_ms > (this.phase === "waiting" ? settle_ms : maxRest_ms);
  }

  /** Begins a slide with these settings and a new session of the plugin. */
  apply(settings: Readonly<Settings>): void {
    this.settings = { ...settings };
    this.restartSession(pageCourse(settings));
    this.begin(settings.gap_deg);
  }

  /** Begins the next slide, with this gap. The controller keeps its estimates of this hand. */
  begin(gap_deg = this.gap_deg): void {
    this.settings.gap_deg = gap_deg;
    this.prepare();
    this.setTargets(pageCourse(this.settings));
    this.world.begin_hand(0);
    this.beginReach(0);
    this.felt.begin(start);
    Object.assign(this.finger, start);
    Object.assign(this.wanted, start);
    this.#ridge = this.#ridgeUnder();
    this.#rested_ms = 0;
    this.phase = "waiting";
    this.result = null;
  }

  /** Sets the position to which the next advance() moves the fingertip. */
  moveTo(right_m: number, away_m: number): void {
    if (!Number.isFinite(right_m) || !Number.isFinite(away_m) || this.phase === "arrived") return;
    Object.assign(this.wanted, { right_m, away_m });
  }

  /** Advances by whole milliseconds, with a sample of the fingertip for each step. The slide ends when the perceived fingertip is
   *  at the glass, or as far from the start as the glass. */
  advance(milliseconds: number): void {
    for (let left_ms = milliseconds; left_ms > 0 && this.phase !== "arrived"; left_ms -= step_ms) {
      const moved = length_m(this.finger, this.wanted) > 0;
      if (moved) this.#rested_ms = 0;
      if (!moved && this.resting) return this.#rest();
      this.#step(Math.min(step_ms, left_ms), Math.min(1, step_ms / left_ms));
    }
  }

  #rest(): void {
    if (!Number.isNaN(this.plateConnected_deg)) this.world.set_plate(this.plateConnected_deg);
  }

  /** `fraction`: part of the way to the wanted position. */
  #step(milliseconds: number, fraction: number): void {
    const { finger, wanted, world } = this;
    for (let i = 1; i <= milliseconds; ++i) {
      this.advanceWorld();
      if (this.phase === "sliding") this.record(this.felt, finger, this.felt.place);
    }
    this.#rested_ms += milliseconds;
    const right_m = fraction * (wanted.right_m - finger.right_m),
      away_m = fraction * (wanted.away_m - finger.away_m);
    this.felt.move(right_m, away_m, milliseconds);
    finger.right_m += right_m;
    finger.away_m += away_m;
    if (length_m(start, finger) > 0.002) this.phase = "sliding";
    const ridge = this.#ridgeUnder();
    this.ridges += Math.abs(ridge - this.#ridge);
    this.#ridge = ridge;
    this.updateFinger(world.time_ms(), finger.right_m, finger.away_m);
    const glass = virtualPlace(pageCourse(this.settings)),
      { place } = this.felt;
    const reached = length_m(place, glass) < near_m || length_m(start, place) > distance_m;
    if (reached) this.#arrive(true);
    else if (world.time_ms() > maxTrace * tracePeriod_ms) this.end();
  }

  /** Number of the ridge nearest to the fingertip. */
  #ridgeUnder(): number {
    const angle = this.world.plate_deg() * degree,
      { right_m, away_m } = this.finger;
    return Math.round((away_m * Math.cos(angle) - right_m * Math.sin(angle)) / ridgeSpacing_m);
  }

  /** Lifts the fingertip. A slide that is too short begins again. The controller discards a slide that stops early. */
  end(): void {
    if (this.phase !== "sliding") return;
    if (length_m(start, this.finger) < minReach_m) return this.begin();
    this.#arrive(false);
  }

  #arrive(whole: boolean): void {
    if (whole) this.session.endReach();
    this.recording = this.cancel();
    this.phase = "arrived";
    this.result = {
      ...slideEnd(this.finger, this.felt.place, pageCourse(this.settings)),
      gap_deg: Math.abs(bearing_deg(start, this.felt.place) - bearing_deg(start, this.finger)),
    };
  }
}
