// The mode "Replay": a recorded reach as it was tracked and commanded. What was felt is not in a recording; the chart
// shows what the controller believed of it.
import type { Desk } from "../desk";
import type { RecordedReach } from "../files/recording";
import type { Place } from "../geometry";
import { showNow } from "../now";
import { element, say, sideways } from "../page";
import { Trace, tracePeriod_ms } from "../trace";

const pause_ms = 2200;
const maxFrame_ms = 100;

export class Replaying {
  readonly trace = new Trace();
  readonly #caption = element("caption", HTMLParagraphElement);
  readonly #finger: Place = { right_m: 0, away_m: 0 };
  #reach: RecordedReach | null = null;
  #next = 0;
  #time_ms = 0;

  /** `still`: the reach is shown at its end, at once. */
  constructor(
    private readonly desk: Desk,
    private readonly still: boolean,
  ) {}

  get reach(): RecordedReach | null {
    return this.#reach;
  }

  /** From its start. */
  show(reach: RecordedReach): void {
    this.#reach = reach;
    this.#next = this.#time_ms = 0;
    this.trace.clear();
    this.desk.clearPaths();
    if (this.still) this.#time_ms = this.#last_ms(reach);
  }

  frame(elapsed_ms: number): void {
    const reach = this.#reach;
    if (!reach) return;
    if (!this.still) this.#time_ms += Math.min(elapsed_ms, maxFrame_ms);
    if (this.#time_ms > this.#last_ms(reach) + pause_ms) this.show(reach);
    while ((reach.samples[this.#next]?.time_ms ?? Infinity) <= this.#time_ms) this.#take(reach, this.#next++);
    const sample = reach.samples[Math.max(0, this.#next - 1)];
    if (!sample) return;
    const over = this.#next === reach.samples.length;
    this.desk.frame.dataset.phase = over ? "arrived" : Number.isNaN(sample.finger_deg) ? "waiting" : "sliding";
    this.desk.draw(sample.plate_deg, this.#finger, this.#finger);
    showNow(sample.plate_deg, sample.finger_deg, sample.felt_deg, reach.virtual_deg);
    say(
      this.#caption,
      `${(sample.time_ms / 1000).toFixed(1)} s of ${(this.#last_ms(reach) / 1000).toFixed(1)} s: the ` +
        `plate is sent to ${sideways(sample.plate_deg)}.`,
    );
  }

  #last_ms(reach: RecordedReach): number {
    return reach.samples.at(-1)?.time_ms ?? 0;
  }

  #take(reach: RecordedReach, index: number): void {
    const sample = reach.samples[index];
    if (!sample) return;
    this.#finger.right_m = sample.right_m;
    this.#finger.away_m = sample.away_m;
    this.desk.extendPaths(this.#finger, this.#finger);
    while (this.trace.length * tracePeriod_ms <= sample.time_ms && this.trace.length < this.trace.capacity) {
      this.trace.add(sample.plate_deg, sample.finger_deg, sample.felt_deg, sample.weight, sample.weight_sd);
    }
  }
}
