// The mode "Replay": a recorded reach as it was tracked and commanded. What was felt is not in a recording; the chart
// shows what the controller believed of it.
import type { Desk } from "../desk";
import type { RecordedReach, RecordedSample } from "../files/recording";
import { showNow } from "../now";
import { sideways } from "../page";
import { maxTrace, type Trace, tracePeriod_ms } from "../trace";

const pause_ms = 2200;

export class Replaying {
  trace: Trace = [];
  reach: RecordedReach | null = null;
  #next = 0;
  #time_ms = 0;

  /** `still`: the reach is shown at its end, at once. */
  constructor(
    private readonly desk: Desk,
    private readonly still: boolean,
  ) {}

  /** From its start. */
  show(reach: RecordedReach): void {
    this.reach = reach;
    this.#next = this.#time_ms = 0;
    this.trace = [];
    this.desk.clearPaths();
    if (this.still) this.#time_ms = this.#last_ms(reach);
  }

  frame(elapsed_ms: number): void {
    const { reach } = this;
    if (!reach) return;
    if (!this.still) this.#time_ms += elapsed_ms;
    if (this.#time_ms > this.#last_ms(reach) + pause_ms) this.show(reach);
    for (const next of reach.samples.slice(this.#next)) {
      if (next.time_ms > this.#time_ms) break;
      this.#take(next);
    }
    const sample = reach.samples[Math.max(0, this.#next - 1)];
    if (!sample) return;
    const over = this.#next === reach.samples.length;
    this.desk.draw(sample.plate_deg, sample.finger, sample.finger);
    showNow(sample.plate_deg, sample.finger_deg, sample.felt_deg, reach.virtual_deg);
    this.desk.caption(
      over ? "arrived" : Number.isNaN(sample.finger_deg) ? "waiting" : "sliding",
      `${(sample.time_ms / 1000).toFixed(1)} s of ${(this.#last_ms(reach) / 1000).toFixed(1)} s: the ` +
        `plate is sent to ${sideways(sample.plate_deg)}.`,
    );
  }

  #last_ms(reach: RecordedReach): number {
    return reach.samples.at(-1)?.time_ms ?? 0;
  }

  #take(sample: RecordedSample): void {
    ++this.#next;
    this.desk.extendPaths(sample.finger, sample.finger);
    while (this.trace.length * tracePeriod_ms <= sample.time_ms && this.trace.length < maxTrace)
      this.trace.push(sample);
  }
}
