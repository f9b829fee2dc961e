// After each slide the visitor says whether they noticed; QUEST+, as in the experiment, chooses the next gap. After six answers
// it gives the visitor's own limit.
import { motionBound_deg } from "../controller";
import { distance_m } from "../geometry";
import { element, say } from "../page";
import type { World } from "../person";

const answersWanted = 6,
  minGap_deg = 2;
/** Of the gap that a plate can hold for this person: the rest corrects what a slide does wrong. */
const spared = 0.9;

export class Series {
  /** Of the slide that waits for an answer; NaN: none does. */
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

  /** Of the next slide. */
  get gap_deg(): number {
    return this.#gap_deg;
  }
  get asking(): boolean {
    return !Number.isNaN(this.#asked_deg);
  }

  /** Begins again, with this gap. */
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

  /** The slide counts for nothing. */
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
