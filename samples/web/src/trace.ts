// What happened within one reach, every 10 ms, for the chart. Memory is taken once.

export const tracePeriod_ms = 10;
const capacity = 4096;  // 41 s

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

  clear(): void { this.length = 0; }

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
