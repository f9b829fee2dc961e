// The visitor's own finger, by mouse, touch or keyboard, on a plate that the real plugin turns. What it would feel
// is computed for the simulated person: a mouse feels nothing.
import type { Library } from "haptic-retargeting";
import { Controller, pageCourse } from "./controller";
import { Felt } from "./felt";
import { length_m, realPlace, start, virtualPlace, type Place } from "./geometry";
import type { World } from "./person";
import type { Settings } from "./settings";
import { Trace, tracePeriod_ms } from "./trace";

/** A slide that is shorter does not count. */
export const shortest_m = 0.03;
/** The finger stays on the plate. */
const reach_m = 0.13;

export interface HandResult {
  readonly toCylinder_mm: number;
  readonly toGhost_mm: number;
  readonly feltToGhost_mm: number;
}

export class Hand {
  readonly trace = new Trace();
  readonly finger: Place = { ...start };
  /** Where a connected plate is, which is felt instead of the simulated one; NaN: there is none. */
  plateConnected_deg = NaN;
  /** Sliding from the first motion to end(). */
  phase: "waiting" | "sliding" | "arrived" = "waiting";
  result: HandResult | null = null;
  /** Of the last slide that has ended, as CSV. */
  recording = "";

  readonly #world: World;
  #settings: Settings;
  #controller: Controller;
  readonly #library: Library;
  #wanted: Place = { ...start };
  readonly #felt = new Felt();
  readonly #shift_deg = (finger_deg: number): number => this.#world.felt_shift_deg(this.#world.plate_deg(), finger_deg);

  constructor(library: Library, world: World, settings: Readonly<Settings>) {
    this.#library = library;
    this.#world = world;
    this.#settings = { ...settings };
    this.#controller = new Controller(library, settings, pageCourse(settings), world.plate_latency_ms());
    this.begin();
  }

  get felt(): Readonly<Place> { return this.#felt.place; }
  /** Of the motion; NaN at rest. */
  get finger_deg(): number { return this.#felt.finger_deg; }
  get felt_deg(): number { return this.#felt.felt_deg; }

  get command() { return this.#controller.session.command; }

  /** A new slide under these settings, by a hand that is unknown to the controller. */
  apply(settings: Readonly<Settings>): void {
    this.#settings = { ...settings };
    this.#controller.destroy();
    this.#controller = new Controller(this.#library, settings, pageCourse(settings), this.#world.plate_latency_ms());
    this.begin();
  }

  /** Back to the start. Nothing is learnt: a hand that does not feel would teach the controller something false. */
  begin(): void {
    const settings = this.#settings;
    this.#controller.cancel();
    this.#controller.takeRecording();
    this.#world.set_person(settings.person, settings.tactile_weight, settings.pace_s);
    this.#world.set_apparatus(settings.noise_mm / 1000, settings.plate_deg_s);
    this.#world.begin_hand(0);
    this.#controller.begin(0);
    this.trace.clear();
    Object.assign(this.finger, start);
    this.#felt.begin(start);
    Object.assign(this.#wanted, start);
    this.phase = "waiting";
    this.result = null;
  }

  /** Where the finger is to be from now on. */
  moveTo(right_m: number, away_m: number): void {
    if (!Number.isFinite(right_m) || !Number.isFinite(away_m)) return;
    const right = right_m - start.right_m, away = away_m - start.away_m;
    const scale = Math.min(1, reach_m / Math.max(Math.hypot(right, away), 1e-9));
    this.#wanted.right_m = start.right_m + scale * right;
    this.#wanted.away_m = start.away_m + scale * away;
  }

  get wanted(): Readonly<Place> { return this.#wanted; }

  /** The next whole milliseconds, with one sample of the finger at their end, as an engine's frame has it. */
  advance(milliseconds: number): void {
    if (this.phase === "arrived" || milliseconds < 1) return;
    const world = this.#world;
    const right_m = this.#wanted.right_m - this.finger.right_m, away_m = this.#wanted.away_m - this.finger.away_m;
    for (let i = 1; i <= milliseconds; ++i) {
      if (!Number.isNaN(this.plateConnected_deg)) world.set_plate(this.plateConnected_deg);
      world.advance();
      if (world.time_ms() % tracePeriod_ms === 0 && this.phase === "sliding") this.#record();
    }
    this.#move(right_m, away_m, milliseconds);
    world.command(this.#controller.see(world.time_ms(), this.finger.right_m, this.finger.away_m));
  }

  #move(right_m: number, away_m: number, milliseconds: number): void {
    this.finger.right_m += right_m;
    this.finger.away_m += away_m;
    if (length_m(start, this.finger) > 0.002) this.phase = "sliding";
    this.#felt.move(right_m, away_m, milliseconds, this.#shift_deg);
  }

  #record(): void {
    const { tactile_weight, tactile_weight_sd } = this.command;
    const learns = this.#settings.controller !== "off";
    this.trace.add(this.#world.plate_deg(), this.finger_deg, this.felt_deg, learns ? tactile_weight : NaN,
                   learns ? tactile_weight_sd : NaN);
  }

  /** The finger is lifted. A slide that is too short begins anew. */
  end(): void {
    if (this.phase !== "sliding") return;
    if (length_m(start, this.finger) < shortest_m) return this.begin();
    this.#controller.cancel();
    this.recording = this.#controller.takeRecording();
    const course = pageCourse(this.#settings), ghost = virtualPlace(course);
    this.phase = "arrived";
    this.result = {
      toCylinder_mm: 1000 * length_m(this.finger, realPlace(course)),
      toGhost_mm: 1000 * length_m(this.finger, ghost),
      feltToGhost_mm: 1000 * length_m(this.felt, ghost),
    };
  }
}
