// Perceived position of a sliding fingertip: the sum of the steps of its motion, each rotated by the illusion of the ridges.
import { ahead, direction_deg, type Place } from "./geometry";
import type { World } from "./person";

/** Time constant of the filter of the velocity, because tracked positions and the pixels of a mouse are coarse. */
const smoothing_ms = 60;
const minSpeed_m_s = 0.004;

export class Felt {
  readonly place: Place = { right_m: 0, away_m: 0 };
  /** Direction of the motion; NaN at rest. */
  finger_deg = NaN;
  felt_deg = NaN;
  #speedRight_m_s = 0;
  #speedAway_m_s = 0;

  constructor(private readonly world: World) {}

  get speed_m_s(): number {
    return Math.hypot(this.#speedRight_m_s, this.#speedAway_m_s);
  }

  /** Starts at rest at `at`, which is the true and the perceived position. */
  begin(at: Readonly<Place>): void {
    Object.assign(this.place, at);
    this.#speedRight_m_s = this.#speedAway_m_s = 0;
    this.finger_deg = this.felt_deg = NaN;
  }

  /** Adds a motion over the plate of the world. `milliseconds`: its duration, above 0. */
  move(right_m: number, away_m: number, milliseconds: number): void {
    const weight = 1 - Math.exp(-milliseconds / smoothing_ms);
    this.#speedRight_m_s += weight * ((1000 * right_m) / milliseconds - this.#speedRight_m_s);
    this.#speedAway_m_s += weight * ((1000 * away_m) / milliseconds - this.#speedAway_m_s);
    let added_deg = 0;
    if (this.speed_m_s < minSpeed_m_s) {
      this.finger_deg = this.felt_deg = NaN;
    } else {
      this.finger_deg = direction_deg(this.#speedRight_m_s, this.#speedAway_m_s);
      added_deg = this.world.felt_shift_deg(this.world.plate_deg(), this.finger_deg);
      this.felt_deg = this.finger_deg + added_deg;
    }
    const felt_deg = direction_deg(right_m, away_m) + added_deg;
    Object.assign(this.place, ahead(this.place, felt_deg, Math.hypot(right_m, away_m)));
  }
}
