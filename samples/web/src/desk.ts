// The picture with its labels, in the size of its place on the page. Without WebGL the rest of the page still works.

import type { VisitorScene } from "./files/scene";
import { ahead, type Course, type Place, type SlideEnd, start } from "./geometry";
import { element, say } from "./page";
import { dot, path, plate, targets } from "./plan";
import { type LabelName, Stage } from "./stage/stage";
import type { Colours } from "./theme";
import { maxTrace } from "./trace";

const labelNames: readonly LabelName[] = ["finger", "felt", "real", "glass"];
const maxLabels = 30; // more would cover each other
const margin_px = 4,
  minGap_px = 14;
const turn_rad = 0.15;

interface Label {
  readonly element: HTMLElement;
  /** Where it points to, on the canvas. */
  readonly at: (stage: Stage, out: { x: number; y: number }) => void;
  /** To the right (1) or left (-1) of it, or above it (0). */
  readonly side: number;
}

export class Desk {
  readonly frame = element("stage", HTMLDivElement);
  readonly canvas = element("view", HTMLCanvasElement);
  /** Over the plate's disc: where a thumb moves the fingertip, and does not scroll. */
  readonly grip = element("grip", HTMLDivElement);
  /** Null: this browser gives no WebGL, and a flat picture takes its place. */
  readonly stage: Stage | null;
  readonly #flat = element("no-view", SVGSVGElement);
  readonly #paths: { real: Place[]; felt: Place[] } = { real: [], felt: [] };
  /** The browser has given WebGL back: the picture is to be drawn again. */
  onRestored: () => void = () => {};
  readonly #named = Object.fromEntries(
    labelNames.map((name) => [name, element(`label-${name}`, HTMLSpanElement)]),
  ) as Record<LabelName, HTMLElement>;
  readonly #own: readonly Label[] = labelNames.map((name) => ({
    element: this.#named[name],
    at: (stage, out) => stage.toCanvas(name, out),
    side: name === "felt" || name === "glass" ? -1 : 1,
  }));
  #labels = [...this.#own];
  readonly #caption = element("caption", HTMLParagraphElement);
  #glass: Place = { ...start };
  #course: Course = { start, real_deg: 0, real_m: 0, virtual_deg: 0, virtual_m: 0 };
  readonly #at = { x: 0, y: 0 };
  /** What was drawn last; empty: something else has changed since. A picture at rest costs nothing. */
  #drawn = "";
  #revealed = 1;
  #slowFrames = 0; // in a row

  constructor() {
    try {
      this.stage = new Stage(this.canvas);
    } catch {
      this.stage = null;
    }
    this.stage?.orbit.addEventListener("change", () => this.#change(() => {}));
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.#drawn = "";
      this.onRestored();
    });
    if (this.stage) return;
    this.canvas.hidden = true;
    this.#flat.toggleAttribute("hidden", false);
    element("labels", HTMLDivElement).hidden = true;
  }

  setColours(colours: Colours): void {
    this.#change((stage) => stage.setColours(colours));
  }
  setTargets(real_deg: number, virtual_deg: number, distance_m: number): void {
    this.#glass = ahead(start, virtual_deg, distance_m);
    this.#course = { start, real_deg, real_m: distance_m, virtual_deg, virtual_m: distance_m };
    this.#change((stage) => stage.setTargets(real_deg, virtual_deg, distance_m));
  }
  /** The view from the visitor's seat, which a drag may turn. */
  setView(turns: boolean): void {
    this.stage?.setView(turns);
    this.#placeGrip();
  }
  #placeGrip(): void {
    const { clientWidth: width, clientHeight: height } = this.frame,
      disc = this.stage?.discOnCanvas() ?? { left: 0, top: 0, width, height };
    for (const side of ["left", "top", "width", "height"] as const)
      this.grip.style[side] = `${disc[side].toFixed(1)}px`;
  }

  /** By keys, as a drag does; false: not one of the arrows. */
  turn(key: string): boolean {
    const left = Number(key === "ArrowLeft") - Number(key === "ArrowRight"),
      up = Number(key === "ArrowUp") - Number(key === "ArrowDown");
    this.stage?.orbit.rotateLeft(left * turn_rad);
    this.stage?.orbit.rotateUp(up * turn_rad);
    return left !== 0 || up !== 0;
  }

  /** The hand's own shape, once it has come. */
  async bringHand(): Promise<void> {
    await this.stage?.finger.become((await import("./stage/hand_model")).pointingHand);
    this.#drawn = "";
    this.frame.dataset.hand = "yes";
  }
  clearPaths(): void {
    this.#paths.real = [];
    this.#paths.felt = [];
    this.#change((stage) => stage.clearPaths());
  }
  resize(): void {
    this.#change((stage) => stage.resize(this.canvas.clientWidth, this.canvas.clientHeight, devicePixelRatio));
    this.#placeGrip();
  }

  /** Where frames take long, a processor draws: the picture becomes lighter. */
  ease(elapsed_ms: number): void {
    this.#slowFrames = elapsed_ms > 60 && elapsed_ms < 1000 ? this.#slowFrames + 1 : 0;
    if (this.#slowFrames === 8) this.#change((stage) => stage.lighten());
  }

  /** How much of the true hand, its path and the cylinder is shown, from 0 to 1. */
  reveal(share: number): void {
    if (share === this.#revealed) return;
    this.#revealed = share;
    this.#change((stage) => stage.reveal(share));
    this.#named.finger.hidden = share === 0;
    this.#named.real.hidden = share === 0 || this.#labels.length > this.#own.length;
  }

  /** Labels for the visitor who is the finger, or for one who watches. */
  nameLabels(own: boolean): void {
    say(this.#named.finger, own ? "your hand" : "hand");
    this.#drawn = "";
  }

  /** Plate and targets of a visitor's scene instead of the page's own; null: the page's own. */
  setScene(scene: VisitorScene | null): void {
    this.#change((stage) => stage.setScene(scene));
    for (const name of ["real", "glass"] as const) this.#named[name].hidden = scene !== null;
    for (const { element: label } of this.#labels.slice(this.#own.length)) label.remove();
    this.#labels = [...this.#own];
    for (const target of scene?.targets.slice(0, maxLabels) ?? []) {
      const label = document.createElement("span");
      label.className = `label ${target.real ? "real" : "felt"}`;
      label.textContent = target.name;
      element("labels", HTMLDivElement).append(label);
      this.#labels.push({
        element: label,
        at: (stage, out) => stage.targetToCanvas(target.drawn, out),
        side: 0,
      });
    }
  }

  /** The phase, for those who check, and the words on the picture. */
  caption(phase: string, words: string): void {
    this.frame.dataset.phase = phase;
    say(this.#caption, words);
  }

  /** The paths grow to where the finger is, and is felt. */
  extendPaths(finger: Readonly<Place>, felt: Readonly<Place>): void {
    if (!this.stage && this.#paths.real.length < maxTrace) {
      this.#paths.real.push({ ...finger });
      this.#paths.felt.push({ ...felt });
    }
    this.stage?.truePath.extend(finger.right_m, finger.away_m);
    this.stage?.feltPath.extend(felt.right_m, felt.away_m);
  }

  draw(plate_deg: number, finger: Readonly<Place>, felt: Readonly<Place>): void {
    const stage = this.stage,
      state = [plate_deg, finger.right_m, finger.away_m, felt.right_m, felt.away_m].join();
    if (state === this.#drawn) return;
    this.#drawn = state;
    this.frame.dataset.plateDeg = plate_deg.toFixed(1);
    if (!stage) return this.#drawFlat(plate_deg, finger, felt);
    stage.place(plate_deg, finger, felt);
    stage.draw();
    this.#drawLabels(stage);
  }

  #drawFlat(plate_deg: number, finger: Readonly<Place>, felt: Readonly<Place>): void {
    const truth = this.#revealed > 0 ? path("real", this.#paths.real) + dot("real", finger) : "";
    this.#flat.innerHTML =
      plate(plate_deg) +
      targets(this.#course, true, this.#revealed > 0) +
      path("felt", this.#paths.felt) +
      dot("felt", felt) +
      truth;
  }

  /** Each beside its thing or above it, within the picture. */
  #drawLabels(stage: Stage): void {
    const { clientWidth, clientHeight } = this.canvas,
      gap_px = Math.max(minGap_px, 0.06 * this.grip.offsetWidth);
    for (const { element: label, at, side } of this.#labels) {
      if (label.hidden) continue;
      at(stage, this.#at);
      const { offsetWidth: width, offsetHeight: height } = label;
      const x = this.#at.x - width / 2 + side * (width / 2 + gap_px),
        y = this.#at.y - height / 2 - (side === 0 ? height : 0);
      const within = (value: number, most: number) => Math.min(Math.max(value, margin_px), most - margin_px).toFixed(1);
      label.style.transform = `translate(${within(x, clientWidth - width)}px, ${within(y, clientHeight - height)}px)`;
    }
  }

  /** For those who check: the truth in numbers, and where ring, glass and dot are in the picture. */
  write(result: SlideEnd | null, dot: Readonly<Place>): void {
    const { dataset } = this.frame;
    for (const [name, place] of Object.entries({ start, glass: this.#glass, dot })) {
      this.stage?.targetToCanvas(place, this.#at, 0);
      const text = `${this.#at.x.toFixed(1)} ${this.#at.y.toFixed(1)}`;
      if (dataset[name] !== text) dataset[name] = text;
    }
    for (const name of ["toCylinder_mm", "toGlass_mm", "feltToGlass_mm"] as const) {
      if (result) dataset[name.replace("_mm", "Mm")] = String(result[name]);
      else delete dataset[name.replace("_mm", "Mm")];
    }
  }

  /** Anything but what draw() is given. */
  #change(how: (stage: Stage) => void): void {
    if (this.stage) how(this.stage);
    this.#drawn = "";
  }

  /** The place on the plate under a pointer; false beyond the horizon, or without a picture. */
  placeOf(event: PointerEvent, out: Place): boolean {
    const box = (this.stage ? this.canvas : this.#flat).getBoundingClientRect();
    if (this.stage) return this.stage.toPlate(event.clientX - box.left, event.clientY - box.top, out);
    const scale = 0.16 / Math.min(box.width, box.height); // of its viewBox
    out.right_m = (event.clientX - box.left - box.width / 2) * scale;
    out.away_m = (box.top + box.height / 2 - event.clientY) * scale;
    return true;
  }
}
