// The strip chart of one reach: plate orientation; the finger's true and perceived direction; the controller's estimate
// of the tactile weight with its 95 % interval. The legend shows the values at the cursor; a drag zooms. A table below
// the chart has a row for each 0.2 s, for visitors who do not see the chart.
import uPlot from "uplot";
import type { Course } from "./geometry";
import type { Step, Trace } from "./guided_reach";
import { addRow, type Colours, element, readColours, sideways } from "./page";

const rowPeriod_ms = 200;

/** Values that are constant within a reach. `weight`: true tactile weight of the person; NaN: not drawn. */
type Goals = Pick<Course, "real_deg" | "virtual_deg"> & { readonly weight: number };

interface Line {
  readonly label: string;
  readonly colour: keyof Colours;
  readonly value: (at: Step, goals: Goals) => number;
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
  readonly #fold = element("trace-fold", HTMLDetailsElement);

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
    this.#fold.addEventListener("toggle", () => this.#list(this.#trace ?? []));
    new ResizeObserver(() => requestAnimationFrame(fit)).observe(place);
  }

  setColours(colours: Colours): void {
    this.#colours = colours;
    for (const plot of this.#plots) plot.redraw(false);
  }

  draw(trace: Trace, { real_deg, virtual_deg }: Course, weight: number): void {
    const goals = { real_deg, virtual_deg, weight },
      said = Object.values(goals).join();
    if (trace === this.#trace && trace.length === this.#length && said === this.#goals) return;
    [this.#trace, this.#length, this.#goals] = [trace, trace.length, said];
    const times = trace.map(({ time_ms }) => time_ms / 1000),
      drawn = (value: number) => (Number.isNaN(value) ? null : value);
    for (const [i, plot] of this.#plots.entries())
      plot.setData([times, ...strips[i]!.lines.map(({ value }) => trace.map((at) => drawn(value(at, goals))))]);
    if (this.#fold.open) this.#list(trace);
  }

  #list(trace: Trace): void {
    const body = element("trace-rows", HTMLTableSectionElement);
    body.replaceChildren();
    let next_ms = 0;
    for (const { time_ms, plate_deg, finger_deg, felt_deg, weight, weight_sd } of trace) {
      if (time_ms < next_ms) continue;
      next_ms = time_ms + rowPeriod_ms;
      const estimate = Number.isNaN(weight) ? "–" : `${weight.toFixed(2)} ± ${(1.96 * weight_sd).toFixed(2)}`,
        angles = [sideways(plate_deg), sideways(finger_deg, 1), sideways(felt_deg, 1)];
      addRow(body, [`${(time_ms / 1000).toFixed(1)} s`, ...angles, estimate]);
    }
  }
}
