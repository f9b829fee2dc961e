// The visitor's hand on a plate that the real plugin turns. Mouse, touch or keys say where the finger is felt; where it really
// goes follows from the ridges, for the person of the settings: a person who keeps what is felt straight is bent by them.
import type { Library } from "haptic-retargeting";
import { Controller, pageCourse } from "./controller";
import { Felt } from "./felt";
import { ahead, direction_deg, length_m, realPlace, ridgeSpacing_m, start, virtualPlace, type Place } from "./geometry";
import type { World } from "./person";
import type { Settings } from "./settings";
import { Trace, tracePeriod_ms } from "./trace";

/** A slide that is shorter does not count. */
export const minReach_m = 0.03;
/** A finger that is felt this near to the ghost has reached it. */
const near_m = 0.005;
const degree = Math.PI / 180;

export interface HandResult {
  readonly toCylinder_mm: number;
  readonly toGhost_mm: number;
  readonly feltToGhost_mm: number;
}

export class Hand {
  readonly trace = new Trace();
  /** Where a connected plate is, which is felt instead of the simulated one; NaN: there is none. */
  plateConnected_deg = NaN;
  /** Sliding from the first motion to end(). */
  phase: "waiting" | "sliding" | "arrived" = "waiting";
  result: HandResult | null = null;
  /** Of the last slide that has ended, as CSV. */
  recording = "";
  /** Ridges that the true finger has crossed, by its own motion or the plate's. */
  ridges = 0;

  readonly #world: World;
  #settings: Settings;
  #controller: Controller;
  readonly #library: Library;
  #wanted: Place = { ...start };
  readonly #felt: Place = { ...start };
  // From felt to true: the sum of touch the other way round.
  readonly #true = new Felt();
  readonly #back_deg = (felt_deg: number): number => {
    let finger_deg = felt_deg;
    for (let i = 0; i < 12; ++i) finger_deg = felt_deg - this.#world.felt_shift_deg(this.#world.plate_deg(), finger_deg);
    return finger_deg - felt_deg;
  };
  #ridge = 0;

  constructor(library: Library, world: World, settings: Readonly<Settings>) {
    this.#library = library;
    this.#world = world;
    this.#settings = { ...settings };
    this.#controller = new Controller(library, settings, pageCourse(settings), world.plate_latency_ms());
    this.begin();
  }

  get finger(): Readonly<Place> { return this.#true.place; }
  get felt(): Readonly<Place> { return this.#felt; }
  /** Of the motion; NaN at rest. */
  get finger_deg(): number { return this.#true.felt_deg; }
  get felt_deg(): number { return this.#true.finger_deg; }

  get command() { return this.#controller.session.command; }

  /** A new slide under these settings, by a hand that is unknown to the controller. */
  apply(settings: Readonly<Settings>): void {
    this.#settings = { ...settings };
    this.#controller.destroy();
    this.#controller = new Controller(this.#library, settings, pageCourse(settings), this.#world.plate_latency_ms());
    this.begin();
  }

  /** Back to the start. Nothing is learnt. */
  begin(): void {
    const settings = this.#settings;
    this.#controller.cancel();
    this.#controller.takeRecording();
    this.#world.set_person(settings.person, settings.tactile_weight, settings.pace_s);
    this.#world.set_apparatus(settings.noise_mm / 1000, settings.plate_deg_s);
    this.#world.begin_hand(0);
    this.#controller.begin(0);
    this.trace.clear();
    this.#true.begin(start);
    Object.assign(this.#felt, start);
    Object.assign(this.#wanted, start);
    this.#ridge = this.#ridgeUnder();
    this.phase = "waiting";
    this.result = null;
  }

  /** Where the finger is to be felt from now on. */
  moveTo(right_m: number, away_m: number): void {
    if (!Number.isFinite(right_m) || !Number.isFinite(away_m) || this.phase === "arrived") return;
    Object.assign(this.#wanted, { right_m, away_m });
  }

  get wanted(): Readonly<Place> { return this.#wanted; }

  /** The next whole milliseconds, with one sample of the finger at their end, as an engine's frame has it. A finger that is
   *  felt at the ghost, or as far as it, ends there. */
  advance(milliseconds: number): void {
    if (this.phase === "arrived" || milliseconds < 1) return;
    const world = this.#world;
    for (let i = 1; i <= milliseconds; ++i) {
      if (!Number.isNaN(this.plateConnected_deg)) world.set_plate(this.plateConnected_deg);
      world.advance();
      if (world.time_ms() % tracePeriod_ms === 0 && this.phase === "sliding") this.#record();
    }
    const to = this.#next(), over = this.#isOver(to);
    this.#true.move(to.right_m - this.#felt.right_m, to.away_m - this.#felt.away_m, milliseconds, this.#back_deg);
    Object.assign(this.#felt, to);
    if (length_m(start, to) > 0.002) this.phase = "sliding";
    const ridge = this.#ridgeUnder();
    this.ridges += Math.abs(ridge - this.#ridge);
    this.#ridge = ridge;
    world.command(this.#controller.see(world.time_ms(), this.finger.right_m, this.finger.away_m));
    if (over) this.end();
  }

  /** No further than the ghost, and onto it from nearby. */
  #next(): Place {
    const { virtual_m } = pageCourse(this.#settings), ghost = virtualPlace(pageCourse(this.#settings));
    const from_m = length_m(start, this.#felt), to_m = length_m(start, this.#wanted);
    const share = to_m > virtual_m ? Math.max(0, (virtual_m - from_m) / (to_m - from_m)) : 1;
    const right_m = this.#felt.right_m + share * (this.#wanted.right_m - this.#felt.right_m);
    const away_m = this.#felt.away_m + share * (this.#wanted.away_m - this.#felt.away_m);
    const to = share < 1 ? ahead(start, direction_deg(right_m - start.right_m, away_m - start.away_m), virtual_m) : { right_m, away_m };
    return length_m(to, ghost) < near_m ? ghost : to;
  }

  #isOver(to: Place): boolean { return length_m(start, to) > pageCourse(this.#settings).virtual_m - 1e-6; }

  /** Number of the ridge that the true finger is nearest to. */
  #ridgeUnder(): number {
    const angle = this.#world.plate_deg() * degree, { right_m, away_m } = this.finger;
    return Math.round((away_m * Math.cos(angle) - right_m * Math.sin(angle)) / ridgeSpacing_m);
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
    if (length_m(start, this.#felt) < minReach_m) return this.begin();
    this.#controller.cancel();
    this.recording = this.#controller.takeRecording();
    const course = pageCourse(this.#settings), ghost = virtualPlace(course);
    this.phase = "arrived";
    this.result = {
      toCylinder_mm: 1000 * length_m(this.finger, realPlace(course)),
      toGhost_mm: 1000 * length_m(this.finger, ghost),
      feltToGhost_mm: 1000 * length_m(this.#felt, ghost),
    };
  }
}
