// Detects a fingertip at rest: a pinch that is held, or a hand in the ring.
import { Vector3 } from "three";

export class RestDetector {
  /** Mean position during the rest. */
  readonly place = new Vector3();
  readonly #sum = new Vector3();
  #count = 0;
  #since_ms = NaN;
  #taken = false;

  /** A fingertip rests when it stays within `radius_m` of its mean position for `time_ms`. */
  constructor(
    private readonly radius_m: number,
    private readonly time_ms: number,
  ) {}

  /** Returns true once for each rest; the fingertip must move away before the next one. `tip`: null if it is not tracked. */
  update(time_ms: number, tip: Vector3 | null): boolean {
    if (!tip || (this.#count > 0 && tip.distanceTo(this.place) > this.radius_m)) {
      this.reset(tip === null && this.#taken);
      if (!tip) return false;
    }
    if (this.#count === 0) this.#since_ms = time_ms;
    this.#sum.add(tip);
    this.place.copy(this.#sum).divideScalar(++this.#count);
    if (this.#taken || time_ms - this.#since_ms < this.time_ms) return false;
    this.#taken = true;
    return true;
  }

  /** Returns for how long the fingertip has rested. */
  held_ms(time_ms: number): number {
    return this.#count === 0 ? 0 : time_ms - this.#since_ms;
  }

  /** Forgets the rest. With `taken` false, the next one may be at the same position. */
  reset(taken = false): void {
    this.#count = 0;
    this.#sum.set(0, 0, 0);
    this.#taken = taken;
  }
}
