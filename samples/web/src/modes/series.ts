// The visitor's answers whether they noticed the gap, after slides that reached the glass. QUEST+ (Watson 2017) chooses
// the next gap from them, and estimates the detection threshold after six answers.
import { distance_m } from "../geometry";
import { motionBound_deg } from "../guided_reach";
import { element, say } from "../page";
import type { Settings } from "../settings";

const answersWanted = 6,
  minGap_deg = 2;
/** Largest gap that QUEST+ selects, as a fraction of the feasible gap. At 1, the plate could not correct a slide. */
const maxFraction = 0.9;

/** Probabilities that a visitor answers "yes" without noticing anything, and "no" although they noticed. */
const falseAlarms = 0.05,
  lapses = 0.02;
/** Prior of the threshold: log-normal, with the threshold of touch in Keyson (1995) as median; SD: a factor of 2. */
const median_deg = 14;
const thresholds = Array.from({ length: 61 }, (_, i) => ({
  sds: 4 * (i / 30 - 1),
  deg: median_deg * 2 ** (4 * (i / 30 - 1)),
}));
const slopes = [1, 1.5, 2, 3, 4.5];

/** Selects the gap whose answer will probably reduce the entropy of the posterior over threshold and slope the most. */
export class QuestPlus {
  /** Gaps in steps of about 1 dB. */
  readonly #gaps_deg: readonly number[];
  /** Grid of thresholds and slopes, with their posterior probability. */
  readonly #people = thresholds.flatMap(({ sds, deg }) =>
    slopes.map((slope) => ({ deg, slope, probability: Math.exp(-(sds ** 2) / 2) })),
  );

  constructor(min_deg: number, max_deg: number) {
    const steps = Math.round(20 * Math.log10(max_deg / min_deg));
    this.#gaps_deg = Array.from({ length: steps + 1 }, (_, i) => min_deg * (max_deg / min_deg) ** (i / steps));
    this.#normalise();
  }

  next_deg(): number {
    // The expected decrease is the entropy of the answer minus its expected entropy given threshold and slope.
    const learnt = this.#gaps_deg.map((gap_deg) => {
      let yes = 0,
        left = 0;
      for (const person of this.#people) {
        const share = yesShare(gap_deg, person);
        yes += person.probability * share;
        left += person.probability * entropy(share);
      }
      return entropy(yes) - left;
    });
    return this.#gaps_deg[learnt.indexOf(Math.max(...learnt))]!;
  }

  answer(gap_deg: number, noticed: boolean): void {
    for (const person of this.#people) {
      const share = yesShare(gap_deg, person);
      person.probability *= noticed ? share : 1 - share;
    }
    this.#normalise();
  }

  /** Returns the geometric mean of the threshold under the posterior, and the bounds of its 95 % interval. */
  threshold(): { deg: number; lower_deg: number; upper_deg: number } {
    const quantile = (share: number) => {
      let below = 0;
      for (const { deg, probability } of this.#people) {
        below += probability;
        if (below >= share) return deg;
      }
      return NaN;
    };
    const log = this.#people.reduce((sum, { deg, probability }) => sum + probability * Math.log(deg), 0);
    return { deg: Math.exp(log), lower_deg: quantile(0.025), upper_deg: quantile(0.975) };
  }

  #normalise(): void {
    const sum = this.#people.reduce((all, { probability }) => all + probability, 0);
    for (const person of this.#people) person.probability /= sum;
  }
}

function yesShare(gap_deg: number, { deg, slope }: { deg: number; slope: number }): number {
  return 1 - lapses - (1 - falseAlarms - lapses) * Math.exp(-((gap_deg / deg) ** slope));
}

function entropy(share: number): number {
  return -share * Math.log(share) - (1 - share) * Math.log(1 - share);
}

export class Series {
  /** Gap of the slide about which the visitor is asked; NaN: nothing is asked. */
  #asked_deg = NaN;
  #answers = 0;
  #quest!: QuestPlus;
  gap_deg = 0;
  readonly #question = element("question", HTMLDivElement);
  readonly #limit = element("limit", HTMLParagraphElement);

  constructor() {
    for (const answer of ["no", "yes"])
      element(`noticed-${answer}`, HTMLButtonElement).addEventListener("click", () => this.#answer(answer === "yes"));
  }

  get asking(): boolean {
    return !Number.isNaN(this.#asked_deg);
  }

  /** Restarts the series with the gap of the settings. */
  begin({ gap_deg, tactile_weight }: Readonly<Settings>): void {
    const feasible_deg = tactile_weight * motionBound_deg;
    this.#quest = new QuestPlus(minGap_deg, Math.max(1.5 * minGap_deg, maxFraction * feasible_deg));
    this.gap_deg = gap_deg;
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

  #answer(noticed: boolean): void {
    if (!this.asking) return;
    this.#quest.answer(this.#asked_deg, noticed);
    this.gap_deg = this.#quest.next_deg();
    this.skip();
    ++this.#answers;
    const { deg, lower_deg, upper_deg } = this.#quest.threshold(),
      mm = (gap_deg: number) => (2000 * distance_m * Math.sin((gap_deg * Math.PI) / 360)).toFixed(0);
    say(
      this.#limit,
      this.#answers < answersWanted
        ? `Answer ${this.#answers} of ${answersWanted}. Next time the cylinder may be nearer to the glass, or farther away.`
        : `Your limit after ${this.#answers} answers: if your hand is led ${mm(deg)} mm aside, you notice it about ` +
            `two times in three. So few answers prove little: the limit is ${mm(lower_deg)} to ` +
            `${mm(upper_deg)} mm with 95 % probability. It is not the limit of your touch, because your eye stood ` +
            "in for your fingertip, and you knew what happens.",
    );
  }
}
