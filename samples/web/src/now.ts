// "What is felt now": the sum that makes the illusion, in words and numbers.
import { folded_deg } from "./geometry";
import { element, say, sideways, turned } from "./page";

export class Now {
  readonly #finger = element("now-finger", HTMLElement);
  readonly #plate = element("now-plate", HTMLElement);
  readonly #shift = element("now-shift", HTMLElement);
  readonly #felt = element("now-felt", HTMLElement);
  readonly #ghost = element("now-ghost", HTMLElement);
  readonly #turn = element("now-turn", HTMLElement);

  /** Directions are NaN while the finger rests. `goal_deg`: where the ghost lies, as a direction. */
  show(plate_deg: number, finger_deg: number, felt_deg: number, goal_deg: number): void {
    say(this.#finger, sideways(finger_deg, 1));
    say(this.#plate, sideways(folded_deg(plate_deg), 0));
    say(this.#shift, turned(felt_deg - finger_deg));
    say(this.#felt, sideways(felt_deg, 1));
    say(this.#ghost, sideways(goal_deg, 1));
    const error_deg = felt_deg - goal_deg;
    say(this.#turn, Number.isNaN(error_deg) ? "–" : Math.abs(error_deg) < 1 ? "hardly" : error_deg > 0 ? "right" : "left");
  }
}
