// The strip chart of one reach: plate orientation; the finger's true and perceived direction; the controller's estimate of the
// tactile weight with its 95 % interval. The cursor reads values, a drag zooms. It is part of "For researchers".
import uPlot from "uplot";
import { type Colours, readColours } from "./theme";
import { type Trace, tracePeriod_ms } from "./trace";

/** Values that are constant within a reach. */
export interface ChartGoals {
  readonly real_deg: number;
  readonly virtual_deg: number;
  /** True tactile weight of the person; NaN: not drawn. */
  readonly weight: number;
}

interface Line {
  readonly label: string;
  readonly colour: keyof Colours;
  readonly value: (at: Trace[number], goals: ChartGoals) => number;
  readonly dash?: number[];
  readonly width?: number;
}

const level = { dash: [1, 3], width: 1 };
const strips: readonly {
  title: string;
  range: [number, number];
  unit: string;
  band?: [number, number];
  lines: readonly Line[];
}[] = [
  {
    title: "plate orientation: normal of the ridges",
    range: [-95, 95],
    unit: "°",
    lines: [{ label: "plate", colour: "chart", value: ({ plate_deg }) => plate_deg }],
  },
  {
    title: "direction of the hand, true and perceived",
    range: [-24, 24],
    unit: "°",
    lines: [
      { label: "cylinder", colour: "real", value: (_, goals) => goals.real_deg, ...level },
      { label: "glass", colour: "felt", value: (_, goals) => goals.virtual_deg, ...level },
      { label: "true", colour: "real", value: ({ finger_deg }) => finger_deg },
      { label: "perceived", colour: "felt", value: ({ felt_deg }) => felt_deg, dash: [6, 4] },
    ],
  },
  {
    title: "tactile weight: estimate and 95 % interval",
    range: [0, 0.5],
    unit: "",
    band: [2, 3],
    lines: [
      { label: "of the person", colour: "text", value: (_, goals) => goals.weight, ...level },
      { label: "at most", colour: "weight", value: ({ weight, weight_sd }) => weight + 1.96 * weight_sd, width: 0 },
      { label: "at least", colour: "weight", value: ({ weight, weight_sd }) => weight - 1.96 * weight_sd, width: 0 },
      { label: "estimate", colour: "weight", value: ({ weight }) => weight },
    ],
  },
];

export class Chart {
  readonly #plots: uPlot[];
  #colours = readColours();
  #trace: Trace | null = null;
  #length = -1;
  #goals = "";

  constructor(place: HTMLElement) {
    const axis = {
      stroke: () => this.#colours.muted,
      grid: { stroke: () => this.#colours.line, width: 1 },
      ticks: { show: false },
      size: 38,
    };
    this.#plots = strips.map(
      ({ title, range, unit, band, lines }, i) =>
        new uPlot(
          {
            title,
            width: 300,
            height: 190,
            cursor: { sync: { key: "reach" }, y: false, points: { show: false } },
            scales: {
              x: { time: false, range: (_, min, max) => [min ?? 0, Math.max(max ?? 0, (min ?? 0) + 0.1)] },
              y: { range },
            },
            axes: [
              {
                ...axis,
                show: i === strips.length - 1,
                size: 26,
                values: (_, values) => values.map((value) => `${value} s`),
              },
              { ...axis, values: (_, values) => values.map((value) => `${value}${unit}`) },
            ],
            series: [
              { label: "time", value: (_, value) => (value === null ? "–" : `${value.toFixed(2)} s`) },
              ...lines.map(({ label, colour, dash = [], width = 2 }) => ({
                label,
                dash,
                width,
                stroke: () => this.#colours[colour],
                points: { show: false },
                value: (_: uPlot, value: number | null) =>
                  value === null ? "–" : `${value.toFixed(unit ? 1 : 2)}${unit}`,
              })),
            ],
            bands: band ? [{ series: band, fill: () => `${this.#colours.weight}38` }] : [],
          },
          [[]],
          place,
        ),
    );
    const fit = () => {
      for (const plot of this.#plots) plot.setSize({ width: place.clientWidth, height: plot.height });
    };
    new ResizeObserver(() => requestAnimationFrame(fit)).observe(place);
  }

  setColours(colours: Colours): void {
    this.#colours = colours;
    for (const plot of this.#plots) plot.redraw(false);
  }

  draw(trace: Trace, goals: ChartGoals): void {
    const said = Object.values(goals).join();
    if (trace === this.#trace && trace.length === this.#length && said === this.#goals) return;
    [this.#trace, this.#length, this.#goals] = [trace, trace.length, said];
    const times = trace.map((_, i) => (i * tracePeriod_ms) / 1000),
      drawn = (value: number) => (Number.isNaN(value) ? null : value);
    for (const [i, plot] of this.#plots.entries())
      plot.setData([times, ...strips[i]!.lines.map(({ value }) => trace.map((at) => drawn(value(at, goals))))]);
  }
}
