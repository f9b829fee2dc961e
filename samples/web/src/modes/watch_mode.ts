// The mode "Watch": plays reaches of the simulated person one after the other at the chosen speed, describes them, and
// lists their results in a table.
import * as hrt from "haptic-retargeting";
import type { Desk } from "../desk";
import { addRow, element, say, sideways } from "../page";
import type { Settings } from "../settings";
import type { ReachResult, SimulatedReach } from "../simulated_reach";

/** Time for which the end of a reach is shown. */
const pause_ms = 2200;
const step_ms = 100;
const rowsKept = 10;
const arrived_deg = 1.5;
const controllerTexts = { off: "off", paper: "the paper's", ours: "ours" };
const warnings: readonly (readonly [number, string])[] = [
  [hrt.HRT_COMMAND_UNREACHABLE, "no plate orientation sustains the gap"],
  [hrt.HRT_COMMAND_OFF_TARGET, "the hand will miss the target"],
  [hrt.HRT_COMMAND_MISFIT, "the motion does not fit the model"],
  [hrt.HRT_COMMAND_NOT_AT_START, "the hand is not at the start"],
];

export class WatchMode {
  playing = false;
  #scale = 1;
  readonly #play = element("play", HTMLButtonElement);
  readonly #speed = element("speed", HTMLSelectElement);
  readonly #rows = element("result-rows", HTMLTableSectionElement);
  #shownFor_ms = 0;

  /** `still`: reaches are shown at their end, unless the visitor plays or steps them. */
  constructor(
    private reach: SimulatedReach,
    private readonly desk: Desk,
    private readonly still: boolean,
  ) {
    this.#play.addEventListener("click", () => this.#setPlaying(!this.playing));
    element("step", HTMLButtonElement).addEventListener("click", () => this.#step());
    element("again", HTMLButtonElement).addEventListener("click", () => this.resume());
    this.#setPlaying(!still);
  }

  apply(settings: Readonly<Settings>): void {
    if (this.reach.apply(settings)) this.#rows.replaceChildren();
    this.#shownFor_ms = 0;
    this.#finishIfStill();
  }

  /** Plays `reach`, drawn `scale` times as large. */
  play(reach: SimulatedReach, scale: number): void {
    this.#scale = scale;
    if (reach === this.reach) return;
    this.reach = reach;
    this.#rows.replaceChildren();
  }

  resume(): void {
    this.#begin();
    this.#finishIfStill();
  }

  frame(elapsed_ms: number): void {
    if (this.playing && this.reach.phase !== "arrived") {
      this.#advance(elapsed_ms * Number(this.#speed.value));
    } else if (this.playing) {
      this.#shownFor_ms += elapsed_ms;
      if (this.#shownFor_ms >= pause_ms) this.#begin();
    }
    this.desk.draw(this.reach.shown, this.#scale);
    this.desk.caption(this.reach.phase, this.#text());
  }

  #finishIfStill(): void {
    if (this.still && !this.playing) while (this.reach.phase !== "arrived") this.#advance(step_ms);
  }

  #setPlaying(playing: boolean): void {
    this.playing = playing;
    say(this.#play, playing ? "Pause" : "Play");
  }

  #step(): void {
    this.#setPlaying(false);
    if (this.reach.phase === "arrived") this.#begin();
    else this.#advance(step_ms);
  }

  #begin(): void {
    this.reach.begin();
    this.#shownFor_ms = 0;
  }

  #advance(milliseconds: number): void {
    this.reach.advance(milliseconds);
    const { result } = this.reach;
    if (!result) return;
    this.#list(result);
    say(element("spoken", HTMLParagraphElement), resultText(result));
  }

  #list(result: Readonly<ReachResult>): void {
    const { number, controller, bearingError_deg, toCylinder_mm, peakFeltError_deg, weight, weightSd, flags } = result,
      weights = {
        off: "–",
        paper: `${weight.toFixed(2)}, fixed`,
        ours: weightSd > 0 ? `${weight.toFixed(2)} ± ${(1.96 * weightSd).toFixed(2)}` : "–",
      };
    const row = addRow(
      this.#rows,
      [
        String(number),
        controllerTexts[controller],
        `${arrived(result) ? "✓" : "✗"} ${Math.abs(bearingError_deg).toFixed(1)}°, ${toCylinder_mm.toFixed(1)} mm`,
        `${peakFeltError_deg.toFixed(1)}°`,
        weights[controller],
        controller === "off" ? "" : warnings.flatMap(([flag, text]) => (flags & flag ? [text] : [])).join("; "),
      ],
      0,
    );
    row.dataset.result = JSON.stringify(result); // for tests
    while (this.#rows.rows.length > rowsKept) this.#rows.deleteRow(-1);
  }

  #text(): string {
    const { phase, result, course, controller } = this.reach,
      { finger_deg, felt_deg } = this.reach.shown;
    if (result) return resultText(result);
    if (Number.isNaN(finger_deg)) {
      if (phase === "sliding") return "The hand has stopped.";
      return controller === "off"
        ? "The hand rests in the ring. The plate does not turn."
        : "The hand rests in the ring. The plate turns for the beginning of the slide.";
    }
    return (
      `The hand moves ${sideways(finger_deg)}; over these ridges that feels like ${sideways(felt_deg)}. ` +
      `The glass lies ${sideways(course.virtual_deg)}.`
    );
  }
}

function arrived(result: Readonly<ReachResult>): boolean {
  return Math.abs(result.bearingError_deg) <= arrived_deg;
}

function resultText(result: Readonly<ReachResult>): string {
  const end =
    `The hand is ${result.toCylinder_mm.toFixed(1)} mm from the cylinder; the simulated person feels it ` +
    `${result.feltToGlass_mm.toFixed(1)} mm from the glass.`;
  if (result.controller === "off") return `${end} The plate did not turn.`;
  return `${arrived(result) ? "Arrived" : "Missed"}. ${end}`;
}
