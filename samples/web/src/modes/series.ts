// After each slide the visitor answers whether they noticed the gap. From the answers QUEST+, as in samples/experiment, chooses
// the next gap and, after six answers, estimates the visitor's detection threshold.
import { motionBound_deg } from "../controller";
import { distance_m } from "../geometry";
import { element, say } from "../page";
import type { World } from "../person";

const answersWanted = 6,
  minGap_deg = 2;
/** Largest gap of the series, as a fraction of the feasible gap. The remainder lets the controller correct a slide. */
const spared = 0.9;

export class Series {
  /** Gap of the slide about which the visitor is asked; NaN: nothing is asked. */
  #asked_deg = NaN;
  #answers = 0;
  #gap_deg = 0;
  readonly #question = element("question", HTMLDivElement);
  readonly #limit = element("limit", HTMLParagraphElement);

  constructor(private readonly world: World) {
    for (const [id, noticed] of [
      ["noticed-no", 0],
      ["noticed-yes", 1],
    ] as const)
      element(id, HTMLButtonElement).addEventListener("click", () => this.#answer(noticed));
  }

  /** Gap of the next slide. */
  get gap_deg(): number {
    return this.#gap_deg;
  }
  get asking(): boolean {
    return !Number.isNaN(this.#asked_deg);
  }

  /** Restarts the series with this gap. */
  begin(gap_deg: number): void {
    const held_deg = this.world.max_gap_deg(motionBound_deg);
    this.world.begin_series(minGap_deg, Math.max(1.5 * minGap_deg, spared * held_deg));
    this.#gap_deg = gap_deg;
    this.#answers = 0;
    this.skip();
    say(this.#limit, "");
  }

  ask(gap_deg: number): void {
    this.#asked_deg = gap_deg;
    this.#question.hidden = false;
  }

  skip(): void {
    this.#asked_deg = NaN;
    this.#question.hidden = true;
  }

  #answer(noticed: number): void {
    if (!this.asking) return;
    const world = this.world;
    world.answer(this.#asked_deg, noticed);
    this.#gap_deg = world.next_gap_deg();
    this.skip();
    ++this.#answers;
    const mm = (gap_deg: number) => (2000 * distance_m * Math.sin((gap_deg * Math.PI) / 360)).toFixed(0);
    say(
      this.#limit,
      this.#answers < answersWanted
        ? `Answer ${this.#answers} of ${answersWanted}. Next time the cylinder may be nearer to the glass, or farther away.`
        : `Your limit after ${this.#answers} answers: if your hand is led ${mm(world.limit_deg())} mm aside, you notice it about ` +
            `two times in three. So few answers prove little: the limit is ${mm(world.limit_lower_deg())} to ` +
            `${mm(world.limit_upper_deg())} mm with 95 % probability. It is not the limit of your touch, because your eye stood ` +
            "in for your fingertip, and you knew what happens.",
    );
  }
}
