// Time series of one reach, sampled every 10 ms, for the chart.
import type { Place } from "./geometry";
import { addRow, element, sideways } from "./page";

export const tracePeriod_ms = 10;
export const maxTrace = 4096; // 41 s
const rowPeriod_ms = 200;

/** Values at multiples of the period; NaN for values that do not exist. */
export type Trace = {
  readonly plate_deg: number;
  readonly finger_deg: number;
  readonly felt_deg: number;
  readonly weight: number;
  readonly weight_sd: number;
  readonly finger: Readonly<Place>;
  readonly felt: Readonly<Place>;
}[];

/** The trace as a table, for visitors who do not see the chart. It is filled only while it is unfolded. */
export class TraceTable {
  readonly #fold = element("trace-fold", HTMLDetailsElement);
  readonly #body = element("trace-rows", HTMLTableSectionElement);
  #shown: unknown[] = [];

  show(trace: Trace): void {
    const every = rowPeriod_ms / tracePeriod_ms,
      count = Math.ceil(trace.length / every);
    if (!this.#fold.open || (this.#shown[0] === trace && this.#shown[1] === count)) return;
    this.#shown = [trace, count];
    this.#body.replaceChildren();
    for (const [i, { plate_deg, finger_deg, felt_deg, weight, weight_sd }] of trace.entries()) {
      if (i % every !== 0) continue;
      addRow(this.#body, [
        `${((i * tracePeriod_ms) / 1000).toFixed(1)} s`,
        sideways(plate_deg),
        sideways(finger_deg, 1),
        sideways(felt_deg, 1),
        Number.isNaN(weight) ? "–" : `${weight.toFixed(2)} ± ${(1.96 * weight_sd).toFixed(2)}`,
      ]);
    }
  }
}
