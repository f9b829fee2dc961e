// The visitor's hand on a plate that the plugin turns. The pointer is the true fingertip; the visitor sees the
// perceived one.
import { HRT_SAMPLE_PLATE_POSITION, type Library } from "haptic-retargeting";
import {
  bearing_deg,
  degree,
  distance_m,
  length_m,
  type Place,
  pageCourse,
  ridgeSpacing_m,
  type SlideEnd,
  slideEnd,
  start,
  virtualPlace,
} from "./geometry";
import { maxTrace } from "./guided_reach";
import type { Settings } from "./settings";
import { VisitorHand } from "./visitor_hand";

/** A slide whose fingertip is lifted nearer to the start does not count: it begins again. */
export const minReach_m = 0.03;
/** Distance below which the perceived fingertip has reached the glass. */
const near_m = 0.002;
const step_ms = 10;
/** Rest, before and within the slide, after which the reach is not computed until the fingertip moves. */
const settle_ms = 700,
  maxRest_ms = 1000;

export class VisitorReach extends VisitorHand {
  phase: "waiting" | "sliding" | "arrived" = "waiting";
  /** `gap_deg`: angle between the perceived and the true end, seen from the start. */
  result: (SlideEnd & { readonly gap_deg: number }) | null = null;
  /** Number of ridges that have passed under the fingertip, by its own motion or the plate's. */
  ridges = 0;
  /** Position to which the next advance() moves the fingertip. */
  readonly wanted: Place = { ...start };
  #rested_ms = 0;
  #ridge = 0;

  constructor(library: Library, settings: Readonly<Settings>) {
    super(library, settings);
    this.begin();
  }

  get course() {
    return pageCourse(this.settings.gap_deg);
  }
  /** True if the state stays the same until `wanted` changes or a connected plate turns. */
  get resting(): boolean {
    return this.phase === "arrived" || this.#rested_ms > (this.phase === "waiting" ? settle_ms : maxRest_ms);
  }

  /** Begins a slide with these settings and a new session of the plugin. */
  apply(settings: Readonly<Settings>): void {
    this.settings = { ...settings };
    this.restartSession(this.course);
    this.begin();
  }

  /** Begins the next slide, with this gap. The controller keeps its estimates of this hand. */
  begin(gap_deg = this.settings.gap_deg): void {
    this.settings.gap_deg = gap_deg;
    this.rest();
    this.setTargets(this.course);
    this.beginReach(0);
    Object.assign(this.wanted, start);
    this.#ridge = this.#nearestRidge();
    this.#rested_ms = 0;
    this.phase = "waiting";
    this.result = null;
  }

  /** Sets `wanted`. The call is ignored after the arrival, and for a value that is not finite. */
  moveTo(right_m: number, away_m: number): void {
    if (!Number.isFinite(right_m) || !Number.isFinite(away_m) || this.phase === "arrived") return;
    Object.assign(this.wanted, { right_m, away_m });
  }

  /** Advances by whole milliseconds. The slide ends when the dot is at the glass or farther from the start than the
   *  glass, and when the trace is full. */
  advance(milliseconds: number): void {
    for (let left_ms = milliseconds; left_ms > 0 && this.phase !== "arrived"; left_ms -= step_ms) {
      const moved = length_m(this.finger, this.wanted) > 0;
      if (moved) this.#rested_ms = 0;
      if (!moved && this.resting) return this.showConnectedPlate();
      this.#step(Math.min(step_ms, left_ms), Math.min(1, step_ms / left_ms));
    }
  }

  /** Moves the fingertip by this fraction of its distance to `wanted`. */
  #step(milliseconds: number, fraction: number): void {
    const { finger, wanted, session } = this,
      { sample } = session;
    this.#rested_ms += milliseconds;
    this.advancePlate(milliseconds);
    this.moveFinger(
      {
        right_m: finger.right_m + fraction * (wanted.right_m - finger.right_m),
        away_m: finger.away_m + fraction * (wanted.away_m - finger.away_m),
      },
      milliseconds,
    );
    if (length_m(start, finger) > 0.002) this.phase = "sliding";
    if (this.phase === "sliding") this.recordHand();
    const ridge = this.#nearestRidge();
    this.ridges += Math.abs(ridge - this.#ridge);
    this.#ridge = ridge;
    sample.flags = HRT_SAMPLE_PLATE_POSITION;
    sample.time_ns = 1e6 * this.time_ms;
    sample.finger_position_m.set([finger.right_m, 0, -finger.away_m]);
    session.update();
    this.turnPlate();
    const reached = length_m(this.felt, virtualPlace(this.course)) < near_m || length_m(start, this.felt) > distance_m;
    if (reached) this.#arrive(true);
    else if (this.time_ms > maxTrace * step_ms) this.end();
  }

  #nearestRidge(): number {
    const angle = this.plate_deg * degree,
      { right_m, away_m } = this.finger;
    return Math.round((away_m * Math.cos(angle) - right_m * Math.sin(angle)) / ridgeSpacing_m);
  }

  /** Lifts the fingertip. A slide shorter than minReach_m begins again; the controller discards a longer one. */
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
      ...slideEnd(this.finger, this.felt, this.course),
      gap_deg: Math.abs(bearing_deg(start, this.felt) - bearing_deg(start, this.finger)),
    };
  }
}
