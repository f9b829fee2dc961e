// The strip chart of one reach: the plate; the finger's direction and the felt one; the weight of touch that the
// controller believes, with its 95 % interval.
import type { Colours } from "./theme";
import { tracePeriod_ms, type Trace } from "./trace";

interface Strip {
  readonly title: string;
  readonly min: number;
  readonly max: number;
  readonly ticks: readonly number[];
  readonly unit: string;
}

const strips = {
  plate: { title: "plate: normal of the ridges", min: -95, max: 95, ticks: [-90, 0, 90], unit: "°" },
  direction: { title: "direction: finger, and as felt", min: -24, max: 24, ticks: [-20, -10, 0, 10, 20], unit: "°" },
  weight: { title: "weight of touch: believed, 95 %", min: 0, max: 0.5, ticks: [0, 0.2, 0.4], unit: "" },
} as const satisfies Record<string, Strip>;

const left = 38, right = 8, titleHeight = 18, foot = 20;

/** What stands still within a reach. */
export interface ChartGoals {
  readonly real_deg: number;
  readonly virtual_deg: number;
  /** The person's own; NaN: not drawn. */
  readonly weight: number;
}

export class Chart {
  readonly #canvas: HTMLCanvasElement;
  readonly #to: CanvasRenderingContext2D;
  #colours: Colours;
  #span_ms = 3000;
  // What was drawn last, and whether size or colours have changed since.
  #stale = true;
  #trace: Trace | null = null;
  #length = -1;
  readonly #goals = { real_deg: NaN, virtual_deg: NaN, weight: NaN };

  constructor(canvas: HTMLCanvasElement, colours: Colours) {
    const context = canvas.getContext("2d");
    if (!context) throw new Error("this browser gives no 2D canvas");
    this.#canvas = canvas;
    this.#to = context;
    this.#colours = colours;
  }

  setColours(colours: Colours): void {
    this.#colours = colours;
    this.#stale = true;
  }

  resize(width: number, height: number, pixelRatio: number): void {
    const ratio = Math.min(pixelRatio, 2);
    this.#stale = true;
    this.#canvas.width = Math.max(1, Math.round(width * ratio));
    this.#canvas.height = Math.max(1, Math.round(height * ratio));
    this.#to.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  draw(trace: Trace, goals: ChartGoals): void {
    if (!this.#changes(trace, goals)) return;
    const to = this.#to, scale = to.getTransform().a;
    const width = this.#canvas.width / scale, height = this.#canvas.height / scale;
    this.#span_ms = 1000 * Math.max(2, Math.ceil((trace.length * tracePeriod_ms) / 1000));
    to.fillStyle = this.#colours.panel;
    to.fillRect(0, 0, width, height);
    const each = (height - foot) / 3;
    const band = (index: number) => ({ top: index * each + titleHeight, height: each - titleHeight - 4, width });

    this.#axes(strips.plate, band(0));
    this.#curve(strips.plate, band(0), trace, trace.plate_deg, this.#colours.chartPlate, 2, []);

    this.#axes(strips.direction, band(1));
    this.#level(strips.direction, band(1), goals.real_deg, this.#colours.real, "cylinder");
    this.#level(strips.direction, band(1), goals.virtual_deg, this.#colours.felt, "ghost");
    this.#curve(strips.direction, band(1), trace, trace.finger_deg, this.#colours.real, 2, []);
    this.#curve(strips.direction, band(1), trace, trace.felt_deg, this.#colours.felt, 2, [6, 4]);

    this.#axes(strips.weight, band(2));
    this.#interval(strips.weight, band(2), trace);
    if (!Number.isNaN(goals.weight)) this.#level(strips.weight, band(2), goals.weight, this.#colours.text, "true");
    this.#curve(strips.weight, band(2), trace, trace.weight, this.#colours.weight, 2, []);
    this.#time(height, width);
  }

  #changes(trace: Trace, goals: ChartGoals): boolean {
    const before = this.#goals;
    const same = !this.#stale && trace === this.#trace && trace.length === this.#length &&
      goals.real_deg === before.real_deg && goals.virtual_deg === before.virtual_deg && goals.weight === before.weight;
    this.#stale = false;
    this.#trace = trace;
    this.#length = trace.length;
    Object.assign(before, goals);
    return !same;
  }

  #x(index: number, width: number): number {
    return left + ((width - left - right) * index * tracePeriod_ms) / this.#span_ms;
  }
  #y(strip: Strip, band: Band, value: number): number {
    const share = (Math.min(strip.max, Math.max(strip.min, value)) - strip.min) / (strip.max - strip.min);
    return band.top + band.height * (1 - share);
  }

  #axes(strip: Strip, band: Band): void {
    const to = this.#to;
    to.font = "12px system-ui, sans-serif";
    to.textBaseline = "alphabetic";
    to.textAlign = "left";
    to.fillStyle = this.#colours.text;
    to.fillText(strip.title, left, band.top - 5);
    to.textBaseline = "middle";
    to.textAlign = "right";
    to.fillStyle = this.#colours.muted;
    to.strokeStyle = this.#colours.line;
    to.lineWidth = 1;
    to.setLineDash([]);
    for (const tick of strip.ticks) {
      const y = Math.round(this.#y(strip, band, tick)) + 0.5;
      to.beginPath();
      to.moveTo(left, y);
      to.lineTo(band.width - right, y);
      to.stroke();
      to.fillText(`${tick}${strip.unit}`, left - 5, y);
    }
  }

  #level(strip: Strip, band: Band, value: number, colour: string, name: string): void {
    const to = this.#to, y = this.#y(strip, band, value);
    to.strokeStyle = colour;
    to.lineWidth = 1;
    to.setLineDash([1, 3]);
    to.beginPath();
    to.moveTo(left, y);
    to.lineTo(band.width - right, y);
    to.stroke();
    to.fillStyle = colour;
    to.textAlign = "right";
    to.textBaseline = "bottom";
    to.fillText(name, band.width - right, y - 1);
  }

  #curve(strip: Strip, band: Band, trace: Trace, values: Float32Array, colour: string, lineWidth: number,
         dashes: number[]): void {
    const to = this.#to;
    to.strokeStyle = colour;
    to.lineWidth = lineWidth;
    to.setLineDash(dashes);
    to.beginPath();
    let drawing = false;
    for (let i = 0; i < trace.length; ++i) {
      const value = values[i] ?? NaN;
      if (Number.isNaN(value)) {
        drawing = false;
        continue;
      }
      const x = this.#x(i, band.width), y = this.#y(strip, band, value);
      if (drawing) to.lineTo(x, y);
      else to.moveTo(x, y);
      drawing = true;
    }
    to.stroke();
    to.setLineDash([]);
  }

  #interval(strip: Strip, band: Band, trace: Trace): void {
    const to = this.#to;
    to.fillStyle = this.#colours.weight;
    to.globalAlpha = 0.22;
    to.beginPath();
    let any = false;
    for (const sign of [1, -1]) {
      for (let k = 0; k < trace.length; ++k) {
        const i = sign > 0 ? k : trace.length - 1 - k;
        const weight = trace.weight[i] ?? NaN, sd = trace.weight_sd[i] ?? NaN;
        if (Number.isNaN(weight)) continue;
        const x = this.#x(i, band.width), y = this.#y(strip, band, weight + sign * 1.96 * sd);
        if (any) to.lineTo(x, y);
        else to.moveTo(x, y);
        any = true;
      }
    }
    if (any) to.fill();
    to.globalAlpha = 1;
  }

  #time(height: number, width: number): void {
    const to = this.#to, seconds = this.#span_ms / 1000;
    to.fillStyle = this.#colours.muted;
    to.textBaseline = "alphabetic";
    to.textAlign = "center";
    const every = seconds > 8 ? 5 : 1;
    for (let s = 0; s <= seconds; s += every) {
      to.fillText(s === 0 ? "0 s" : `${s}`, this.#x((1000 * s) / tracePeriod_ms, width), height - 5);
    }
  }
}

interface Band {
  readonly top: number;
  readonly height: number;
  readonly width: number;
}
