// After each slide the visitor answers whether they noticed the gap; QUEST+, as in the experiment, chooses the next gap. After
// six answers it estimates the visitor's detection threshold.
import { motionBound_deg } from "../controller";
import { distance_m } from "../geometry";
import { element, say } from "../page";
import type { World } from "../person";

const answersWanted = 6,
  minGap_deg = 2;
/** Largest gap as a fraction of the feasible gap for this person; the remainder is reserved for corrections of a slide. */
const spared = 0.9;

export class Series {
  /** Gap of the slide that the visitor has not answered yet; NaN: there is no such slide. */
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

  /** Discards the slide without an answer. */
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
        ? `Answer ${this.#answers} of ${answersWanted}. The next gap differs.`
        : `Your limit, after ${this.#answers} answers: led ${mm(world.limit_deg())} mm aside, you would say yes about two ` +
            `times of three; the range of 95 % is ${mm(world.limit_lower_deg())} to ${mm(world.limit_upper_deg())} mm. This is ` +
            "no limit of touch: your eye stood in for your fingertip, you had seen the answer, and so few answers prove little.",
    );
  }
}
