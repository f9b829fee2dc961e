// The visitor's hand on a plate that the real plugin turns. Mouse, touch or keys say where the finger is felt; where it really
// goes follows from the ridges, for the person of the settings: a person who keeps what is felt straight is bent by them.
import type { Library } from "haptic-retargeting";
import { pageCourse } from "./controller";
import { Felt } from "./felt";
import {
  ahead,
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
import { Led } from "./led";
import type { World } from "./person";
import type { Settings } from "./settings";

/** A slide that is shorter does not count. */
export const minReach_m = 0.03;
/** A finger that is felt this near to the ghost has reached it. */
const near_m = 0.005;

export class Hand extends Led {
  /** Sliding from the first motion to end(). */
  phase: "waiting" | "sliding" | "arrived" = "waiting";
  result: SlideEnd | null = null;
  /** Ridges that the true finger has crossed, by its own motion or the plate's. */
  ridges = 0;

  /** Where the finger is to be felt. */
  readonly wanted: Place = { ...start };
  readonly felt: Place = { ...start };
  // From felt to true: the sum of touch the other way round.
  readonly #true = new Felt();
  readonly #back_deg = (felt_deg: number): number => {
    let finger_deg = felt_deg;
    for (let i = 0; i < 12; ++i) finger_deg = felt_deg - this.world.felt_shift_deg(this.world.plate_deg(), finger_deg);
    return finger_deg - felt_deg;
  };
  #ridge = 0;

  constructor(library: Library, world: World, settings: Readonly<Settings>) {
    super(library, world, settings, pageCourse(settings));
    this.begin();
  }

  get finger(): Readonly<Place> {
    return this.#true.place;
  }
  /** Of the motion; NaN at rest. */
  get finger_deg(): number {
    return this.#true.felt_deg;
  }
  get felt_deg(): number {
    return this.#true.finger_deg;
  }

  /** A new slide under these settings, by a hand that is unknown to the controller. */
  apply(settings: Readonly<Settings>): void {
    this.settings = { ...settings };
    this.renew(pageCourse(settings));
    this.begin();
  }

  /** Back to the start. Nothing is learnt. */
  begin(): void {
    this.prepare();
    this.world.begin_hand(0);
    this.lead(0);
    this.#true.begin(start);
    Object.assign(this.felt, start);
    Object.assign(this.wanted, start);
    this.#ridge = this.#ridgeUnder();
    this.phase = "waiting";
    this.result = null;
  }

  /** Where the finger is to be felt from now on. */
  moveTo(right_m: number, away_m: number): void {
    if (!Number.isFinite(right_m) || !Number.isFinite(away_m) || this.phase === "arrived") return;
    Object.assign(this.wanted, { right_m, away_m });
  }

  /** The next whole milliseconds, with one sample of the finger at their end, as an engine's frame has it. A finger that is
   *  felt at the ghost, or as far as it, ends there. */
  advance(milliseconds: number): void {
    if (this.phase === "arrived" || milliseconds < 1) return;
    const world = this.world;
    for (let i = 1; i <= milliseconds; ++i) {
      this.tick();
      if (this.phase === "sliding") this.record(this.finger_deg, this.felt_deg);
    }
    const to = this.#next();
    this.#true.move(to.right_m - this.felt.right_m, to.away_m - this.felt.away_m, milliseconds, this.#back_deg);
    Object.assign(this.felt, to);
    if (length_m(start, to) > 0.002) this.phase = "sliding";
    const ridge = this.#ridgeUnder();
    this.ridges += Math.abs(ridge - this.#ridge);
    this.#ridge = ridge;
    this.see(world.time_ms(), this.finger.right_m, this.finger.away_m);
    if (length_m(start, to) > distance_m - 1e-6) this.end();
  }

  /** No further than the ghost, and onto it from nearby. */
  #next(): Place {
    const ghost = virtualPlace(pageCourse(this.settings)),
      from_m = length_m(start, this.felt),
      to_m = length_m(start, this.wanted);
    const share = to_m > distance_m ? Math.max(0, (distance_m - from_m) / (to_m - from_m)) : 1;
    const gone = {
      right_m: this.felt.right_m + share * (this.wanted.right_m - this.felt.right_m),
      away_m: this.felt.away_m + share * (this.wanted.away_m - this.felt.away_m),
    };
    const to = share < 1 ? ahead(start, bearing_deg(start, gone), distance_m) : gone;
    return length_m(to, ghost) < near_m ? ghost : to;
  }

  /** Number of the ridge that the true finger is nearest to. */
  #ridgeUnder(): number {
    const angle = this.world.plate_deg() * degree,
      { right_m, away_m } = this.finger;
    return Math.round((away_m * Math.cos(angle) - right_m * Math.sin(angle)) / ridgeSpacing_m);
  }

  /** The finger is lifted. A slide that is too short begins anew. */
  end(): void {
    if (this.phase !== "sliding") return;
    if (length_m(start, this.felt) < minReach_m) return this.begin();
    this.recording = this.drop();
    this.phase = "arrived";
    this.result = slideEnd(this.finger, this.felt, pageCourse(this.settings));
  }
}
