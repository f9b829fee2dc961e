// What happened within one reach, every 10 ms, for the chart. Memory is taken once.

import { element, sideways } from "./page";

export const tracePeriod_ms = 10;
const capacity = 4096; // 41 s

export type TraceName = "plate_deg" | "finger_deg" | "felt_deg" | "weight" | "weight_sd";

export class Trace {
  length = 0;
  readonly capacity = capacity;
  /** Values at multiples of the period; NaN where there is none. */
  readonly plate_deg = new Float32Array(capacity);
  readonly finger_deg = new Float32Array(capacity);
  readonly felt_deg = new Float32Array(capacity);
  readonly weight = new Float32Array(capacity);
  readonly weight_sd = new Float32Array(capacity);

  clear(): void {
    this.length = 0;
  }

  add(plate_deg: number, finger_deg: number, felt_deg: number, weight: number, weight_sd: number): void {
    if (this.length === capacity) return;
    this.plate_deg[this.length] = plate_deg;
    this.finger_deg[this.length] = finger_deg;
    this.felt_deg[this.length] = felt_deg;
    this.weight[this.length] = weight;
    this.weight_sd[this.length] = weight_sd;
    ++this.length;
  }
}

const rowPeriod_ms = 200;

/** The trace as a table, for who does not see the chart. Costs nothing while it is folded. */
export class TraceTable {
  readonly #fold = element("trace-fold", HTMLDetailsElement);
  readonly #table = element("trace", HTMLTableElement);
  #shown: unknown[] = [];

  show(trace: Trace): void {
    const every = rowPeriod_ms / tracePeriod_ms,
      count = Math.ceil(trace.length / every),
      body = this.#table.tBodies[0];
    if (!this.#fold.open || !body || (this.#shown[0] === trace && this.#shown[1] === count)) return;
    this.#shown = [trace, count];
    body.replaceChildren();
    for (let i = 0; i < trace.length; i += every) {
      const row = body.insertRow(),
        at = (name: TraceName) => trace[name][i] ?? NaN,
        weight = at("weight");
      for (const text of [
        `${((i * tracePeriod_ms) / 1000).toFixed(1)} s`,
        sideways(at("plate_deg")),
        sideways(at("finger_deg"), 1),
        sideways(at("felt_deg"), 1),
        Number.isNaN(weight) ? "–" : `${weight.toFixed(2)} ± ${(1.96 * at("weight_sd")).toFixed(2)}`,
      ]) {
        row.insertCell().textContent = text;
      }
    }
  }
}
