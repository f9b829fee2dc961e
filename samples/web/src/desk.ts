// The picture of the desk with its labels: in three dimensions, or from above in a browser without WebGL.
import type { VisitorScene } from "./files/scene";
import { ahead, type Course, type Place, type SlideEnd, start } from "./geometry";
import { element, say } from "./page";
import { dot, paths, plate, targets } from "./plan";
import { type LabelName, Stage } from "./stage/stage";
import type { Colours } from "./theme";
import { maxTrace } from "./trace";

const labelNames: readonly LabelName[] = ["finger", "felt", "real", "glass"];
const maxLabels = 30; // more labels would overlap
const margin_px = 4,
  minGap_px = 14;
const turn_rad = 0.15;

interface Label {
  readonly element: HTMLElement;
  /** Writes the point on the canvas that the label names. */
  readonly at: (stage: Stage, out: { x: number; y: number }) => void;
  /** Side of the point on which the label is: right (1), left (-1) or above (0). */
  readonly side: number;
}

export class Desk {
  readonly frame = element("stage", HTMLDivElement);
  readonly canvas = element("view", HTMLCanvasElement);
  /** Area over the plate's disc in which a thumb moves the fingertip and does not scroll. */
  readonly grip = element("grip", HTMLDivElement);
  /** Null if the browser has no WebGL: the picture from above is drawn instead. */
  readonly stage: Stage | null;
  readonly #flat = element("no-view", SVGSVGElement);
  /** Path that the picture from above shows. */
  #path: { finger: Place; felt: Place }[] = [];
  /** Called when the browser has restored WebGL and the picture must be drawn again. */
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
  /** State that was drawn last, so that an unchanged picture is not drawn again. Empty: the next draw() must draw. */
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
  /** Shows the view from the visitor's seat; `turns`: a drag rotates it. */
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

  /** Rotates the view by an arrow key, as a drag does. Returns false for other keys. */
  turn(key: string): boolean {
    const left = Number(key === "ArrowLeft") - Number(key === "ArrowRight"),
      up = Number(key === "ArrowUp") - Number(key === "ArrowDown");
    this.stage?.orbit.rotateLeft(left * turn_rad);
    this.stage?.orbit.rotateUp(up * turn_rad);
    return left !== 0 || up !== 0;
  }

  /** Loads the model of the hand, and draws it from then on. */
  async bringHand(): Promise<void> {
    await this.stage?.finger.become((await import("./stage/hand_model")).pointingHand);
    this.#drawn = "";
    this.frame.dataset.hand = "yes";
  }
  clearPaths(): void {
    this.#path = [];
    this.#change((stage) => stage.clearPaths());
  }
  resize(): void {
    this.#change((stage) => stage.resize(this.canvas.clientWidth, this.canvas.clientHeight, devicePixelRatio));
    this.#placeGrip();
  }

  /** Counts slow frames. After eight in a row, which suggest software rendering, the picture is simplified. */
  ease(elapsed_ms: number): void {
    this.#slowFrames = elapsed_ms > 60 && elapsed_ms < 1000 ? this.#slowFrames + 1 : 0;
    if (this.#slowFrames === 8) this.#change((stage) => stage.lighten());
  }

  /** Sets the opacity of the true hand, its path and the cylinder, from 0 to 1. */
  reveal(fraction: number): void {
    if (fraction === this.#revealed) return;
    this.#revealed = fraction;
    this.#change((stage) => stage.reveal(fraction));
    this.#named.finger.hidden = fraction === 0;
    this.#named.real.hidden = fraction === 0 || this.#labels.length > this.#own.length;
  }

  /** Names the hand in its label. `own`: the hand is the visitor's. */
  nameLabels(own: boolean): void {
    say(this.#named.finger, own ? "your hand" : "hand");
    this.#drawn = "";
  }

  /** Shows plate and targets of a visitor's scene; null: the page's own. */
  setScene(scene: VisitorScene | null): void {
    this.#change((stage) => stage.setScene(scene));
    for (const name of ["real", "glass"] as const) this.#named[name].hidden = scene !== null;
    for (const { element: label } of this.#labels.slice(this.#own.length)) label.remove();
    this.#labels = [...this.#own];
    const fromLeft = [...(scene?.targets ?? [])].sort((a, b) => a.drawn.right_m - b.drawn.right_m);
    for (const target of fromLeft.slice(0, maxLabels)) {
      const label = document.createElement("span");
      label.className = `label ${target.real ? "real" : "felt"}`;
      label.textContent = target.name;
      element("labels", HTMLDivElement).append(label);
      this.#labels.push({ element: label, at: (stage, out) => stage.targetToCanvas(target.drawn, out), side: 0 });
    }
  }

  /** Sets the text above the picture, and the phase of the reach, which tests read. */
  caption(phase: string, words: string): void {
    this.frame.dataset.phase = phase;
    say(this.#caption, words);
  }

  /** Extends the drawn paths to a true and a perceived position of the hand. */
  extendPaths(finger: Readonly<Place>, felt: Readonly<Place>): void {
    if (!this.stage && this.#path.length < maxTrace) this.#path.push({ finger: { ...finger }, felt: { ...felt } });
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
    const all = this.#revealed > 0,
      shown = paths(this.#path, all) + dot("felt", felt) + (all ? dot("real", finger) : "");
    this.#flat.innerHTML = plate(plate_deg) + targets(this.#course, true, all) + shown;
  }

  /** Places each label beside or above the object that it names, within the picture. Labels above objects form a row. */
  #drawLabels(stage: Stage): void {
    const { clientWidth, clientHeight } = this.canvas,
      gap_px = Math.max(minGap_px, 0.06 * this.grip.offsetWidth),
      away = this.#course.virtual_deg < this.#course.real_deg ? -1 : 1; // the labels of a mirrored course are mirrored
    let free_px = 0; // right end of the last label in the row
    for (const { element: label, at, side } of this.#labels) {
      if (label.hidden) continue;
      at(stage, this.#at);
      const { offsetWidth: width, offsetHeight: height } = label;
      let x = this.#at.x - width / 2 + away * side * (width / 2 + gap_px);
      if (side === 0) x = Math.max(x, free_px);
      if (side === 0) free_px = x + width + margin_px;
      const y = this.#at.y - height / 2 - (side === 0 ? height : 0);
      const within = (value: number, most: number) => Math.min(Math.max(value, margin_px), most - margin_px).toFixed(1);
      label.style.transform = `translate(${within(x, clientWidth - width)}px, ${within(y, clientHeight - height)}px)`;
    }
  }

  /** Writes the distances at the end of a slide, and the positions of ring, glass and dot in the picture, for tests. */
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

  /** Applies a change that is not an argument of draw(), and requests a redraw. */
  #change(how: (stage: Stage) => void): void {
    if (this.stage) how(this.stage);
    this.#drawn = "";
  }

  /** Writes the position on the plate under a pointer. Returns false if the pointer is above the horizon. */
  placeOf(event: PointerEvent, out: Place): boolean {
    const box = (this.stage ? this.canvas : this.#flat).getBoundingClientRect();
    if (this.stage) return this.stage.toPlate(event.clientX - box.left, event.clientY - box.top, out);
    const scale = 0.16 / Math.min(box.width, box.height); // size of the viewBox, in metres
    out.right_m = (event.clientX - box.left - box.width / 2) * scale;
    out.away_m = (box.top + box.height / 2 - event.clientY) * scale;
    return true;
  }
}
