// The picture with its labels, in the size of its place on the page. Without WebGL the rest of the page still works.

import type { VisitorScene } from "./files/scene";
import { ahead, degree, type Place, type SlideEnd, start } from "./geometry";
import { element, say } from "./page";
import { type LabelName, Stage } from "./stage/stage";
import type { Colours } from "./theme";

const labelNames: readonly LabelName[] = ["finger", "felt", "real", "glass"];
const maxLabels = 30; // more would cover each other
const margin_px = 4,
  gap_px = 14,
  rings = 6;
const turn_rad = 0.15;

interface Label {
  readonly element: HTMLElement;
  /** Where it points to, on the canvas. */
  readonly at: (stage: Stage, out: { x: number; y: number }) => void;
  /** Sides on which it may stand, the best one first: clockwise from the right. */
  readonly sides_deg: readonly number[];
}

export class Desk {
  readonly frame = element("stage", HTMLDivElement);
  readonly canvas = element("view", HTMLCanvasElement);
  /** Over the plate's disc: where a thumb moves the fingertip, and does not scroll. */
  readonly grip = element("grip", HTMLDivElement);
  /** Null: this browser gives no WebGL. */
  readonly stage: Stage | null;
  readonly #named = Object.fromEntries(
    labelNames.map((name) => [name, element(`label-${name}`, HTMLSpanElement)]),
  ) as Record<LabelName, HTMLElement>;
  readonly #own: readonly Label[] = labelNames.map((name) => {
    const sides_deg = name === "finger" || name === "felt" ? [0, 45, -45, 90] : [-90, -45, 0, 180],
      mirrored = name === "felt" || name === "glass";
    return {
      element: this.#named[name],
      at: (stage, out) => stage.toCanvas(name, out),
      sides_deg: mirrored ? sides_deg.map((angle) => 180 - angle) : sides_deg,
    };
  });
  #labels = [...this.#own];
  readonly #caption = element("caption", HTMLParagraphElement);
  readonly #over = [element("legend", HTMLParagraphElement)];
  #glass: Place = { ...start };
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
    if (!this.stage) {
      this.canvas.hidden = true;
      element("no-view", HTMLParagraphElement).hidden = false;
      element("labels", HTMLDivElement).hidden = true;
    }
  }

  setColours(colours: Colours): void {
    this.#change((stage) => stage.setColours(colours));
  }
  setTargets(real_deg: number, virtual_deg: number, distance_m: number): void {
    this.#glass = ahead(start, virtual_deg, distance_m);
    this.#change((stage) => stage.setTargets(real_deg, virtual_deg, distance_m));
  }
  /** The view from the visitor's seat, which a drag may turn. */
  setView(turns: boolean): void {
    this.stage?.setView(turns);
    this.#placeGrip();
  }
  #placeGrip(): void {
    const disc = this.stage?.discOnCanvas();
    if (!disc) return;
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
        sides_deg: [-90, -45, -135, 0, 180],
      });
    }
  }

  /** The phase, for those who check, and the words on the picture. */
  caption(phase: string, words: string): void {
    this.frame.dataset.phase = phase;
    say(this.#caption, words);
  }

  showFelt(shown: boolean): void {
    this.#change((stage) => stage.showFelt(shown));
    this.#named.felt.hidden = !shown;
  }

  /** The paths grow to where the finger is, and is felt. */
  extendPaths(finger: Readonly<Place>, felt: Readonly<Place>): void {
    this.stage?.truePath.extend(finger.right_m, finger.away_m);
    this.stage?.feltPath.extend(felt.right_m, felt.away_m);
  }

  draw(plate_deg: number, finger: Readonly<Place>, felt: Readonly<Place>): void {
    const stage = this.stage,
      state = [plate_deg, finger.right_m, finger.away_m, felt.right_m, felt.away_m].join();
    if (!stage || state === this.#drawn) return;
    this.#drawn = state;
    stage.place(plate_deg, finger, felt);
    stage.draw();
    this.#drawLabels(stage);
  }

  /** Each beside its thing, within the picture, off the others and off the words that lie on the picture. */
  #drawLabels(stage: Stage): void {
    const { clientWidth, clientHeight } = this.canvas,
      within = new DOMRect(margin_px, margin_px, clientWidth - 2 * margin_px, clientHeight - 2 * margin_px);
    const taken = this.#over.map((on) => new DOMRect(on.offsetLeft, on.offsetTop, on.offsetWidth, on.offsetHeight));
    for (const { element: label, at, sides_deg } of this.#labels) {
      if (label.hidden) continue;
      at(stage, this.#at);
      const box = new DOMRect(0, 0, label.offsetWidth, label.offsetHeight);
      place(box, this.#at, sides_deg, within, taken);
      taken.push(box);
      label.style.transform = `translate(${box.x.toFixed(1)}px, ${box.y.toFixed(1)}px)`;
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
    const box = this.canvas.getBoundingClientRect();
    return this.stage?.toPlate(event.clientX - box.left, event.clientY - box.top, out) ?? false;
  }
}

/** Puts the box beside `at`: on the first side and in the nearest ring where it is free, else where it is within. */
function place(
  box: DOMRect,
  at: Readonly<{ x: number; y: number }>,
  sides_deg: readonly number[],
  within: DOMRect,
  taken: readonly DOMRect[],
): void {
  for (let ring = 1; ring <= rings; ++ring) {
    for (const side_deg of sides_deg) {
      const right = Math.round(Math.cos(side_deg * degree)),
        down = Math.round(Math.sin(side_deg * degree));
      box.x = at.x + right * (box.width / 2 + ring * gap_px) - box.width / 2;
      box.y = at.y + down * (box.height / 2 + (ring * gap_px) / 2) - box.height / 2;
      const inside =
        box.left >= within.left && box.top >= within.top && box.right <= within.right && box.bottom <= within.bottom;
      if (inside && !taken.some((other) => meet(box, other))) return;
    }
  }
  box.x = Math.min(Math.max(at.x - box.width / 2, within.x), within.right - box.width);
  box.y = Math.min(Math.max(at.y - 2 * box.height, within.y), within.bottom - box.height);
}

function meet(one: DOMRect, other: DOMRect): boolean {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}
