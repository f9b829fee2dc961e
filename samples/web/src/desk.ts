// The picture with its labels, in the size of its place on the page. Without WebGL the rest of the page still works.
import type { Place } from "./geometry";
import { element } from "./page";
import type { SceneTarget, VisitorScene } from "./scene";
import { Stage, type LabelName } from "./stage/stage";
import type { Colours } from "./theme";

const labelNames: readonly LabelName[] = ["real", "ghost", "finger", "felt"];
const maxLabels = 30;  // more would cover each other
const middle_px = { x: -0.5, y: -1.15 };  // of a label's own size: it stands above its thing

export class Desk {
  readonly frame = element("stage", HTMLDivElement);
  readonly canvas = element("view", HTMLCanvasElement);
  /** Null: this browser gives no WebGL. */
  readonly stage: Stage | null;
  readonly #labels = labelNames.map((name) => ({ name, element: element(`label-${name}`, HTMLSpanElement), width: 0, height: 0 }));
  readonly #sceneLabels: { element: HTMLElement; target: SceneTarget }[] = [];
  readonly #at = { x: 0, y: 0 };
  // What was drawn last, and whether anything else has changed since: a picture at rest costs nothing.
  #stale = true;
  #fingerShown = true;
  #plate_deg = NaN;
  readonly #finger: Place = { right_m: NaN, away_m: NaN };
  readonly #felt: Place = { right_m: NaN, away_m: NaN };

  constructor() {
    this.stage = createStage(this.canvas);
    if (!this.stage) {
      this.canvas.hidden = true;
      element("no-view", HTMLParagraphElement).hidden = false;
      element("labels", HTMLDivElement).hidden = true;
    }
  }

  setColours(colours: Colours): void {
    this.stage?.setColours(colours);
    this.#stale = true;
  }
  setTargets(real_deg: number, virtual_deg: number, distance_m: number): void {
    this.stage?.setTargets(real_deg, virtual_deg, distance_m);
    this.#stale = true;
  }
  setView(view: "oblique" | "above"): void {
    this.stage?.setView(view);
    this.#stale = true;
  }
  clearPaths(): void {
    this.stage?.clearPaths();
    this.#stale = true;
  }

  resize(): void {
    this.#stale = true;
    this.stage?.resize(this.canvas.clientWidth, this.canvas.clientHeight, devicePixelRatio);
    for (const label of this.#labels) {
      label.width = label.element.offsetWidth;
      label.height = label.element.offsetHeight;
    }
  }

  showFinger(shown: boolean): void {
    if (shown === this.#fingerShown) return;
    this.#fingerShown = shown;
    this.#stale = true;
    this.stage?.showFinger(shown);
    for (const label of this.#labels) if (label.name === "finger") label.element.hidden = !shown;
  }

  /** Plate and targets of a visitor's scene instead of the page's own; null: the page's own. */
  setScene(scene: VisitorScene | null): void {
    this.stage?.setScene(scene);
    this.#stale = true;
    for (const label of this.#labels) label.element.hidden = scene !== null && (label.name === "real" || label.name === "ghost");
    this.#sceneLabels.splice(0).forEach(({ element: label }) => label.remove());
    for (const target of scene?.targets.slice(0, maxLabels) ?? []) {
      const label = document.createElement("span");
      label.className = `label ${target.real ? "real" : "felt"}`;
      label.textContent = target.name;
      element("labels", HTMLDivElement).append(label);
      this.#sceneLabels.push({ element: label, target });
    }
  }

  showFelt(shown: boolean): void {
    this.stage?.showFelt(shown);
    this.#stale = true;
    for (const label of this.#labels) if (label.name === "felt") label.element.hidden = !shown;
  }

  /** The paths grow to where the finger is, and is felt. */
  extendPaths(finger: Readonly<Place>, felt: Readonly<Place>): void {
    this.stage?.truePath.extend(finger.right_m, finger.away_m);
    this.stage?.feltPath.extend(felt.right_m, felt.away_m);
  }

  draw(plate_deg: number, finger: Readonly<Place>, felt: Readonly<Place>): void {
    const stage = this.stage;
    if (!stage || !this.#changes(plate_deg, finger, felt)) return;
    stage.place(plate_deg, finger, felt);
    stage.draw();
    this.#drawSceneLabels(stage);
    for (const { name, element: label, width, height } of this.#labels) {
      stage.toCanvas(name, this.#at);
      // Labels of a pair that lie close stand on their own sides.
      const side = name === "real" || name === "finger" ? 1 : -1;
      const beside = name === "finger" || name === "felt";
      const x = this.#at.x + middle_px.x * width + side * (width / 2 + (beside ? 16 : 4));
      const y = beside ? this.#at.y - height / 2 : this.#at.y + middle_px.y * height;
      label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }

  /** Each above its target, and above those labels that it would cover. */
  #drawSceneLabels(stage: Stage): void {
    const taken: { x: number; y: number; width: number }[] = [];
    for (const { element: label, target } of this.#sceneLabels) {
      stage.targetToCanvas(target.drawn, this.#at);
      const width = label.offsetWidth, height = label.offsetHeight, x = this.#at.x - width / 2;
      let y = this.#at.y - height;
      const covers = (other: (typeof taken)[number]) =>
        x < other.x + other.width && other.x < x + width && Math.abs(y - other.y) < height;
      for (let other = taken.find(covers); other; other = taken.find(covers)) y = other.y - height - 1;
      taken.push({ x, y, width });
      label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }

  #changes(plate_deg: number, finger: Readonly<Place>, felt: Readonly<Place>): boolean {
    const same = !this.#stale && plate_deg === this.#plate_deg && isSame(finger, this.#finger) && isSame(felt, this.#felt);
    this.#stale = false;
    this.#plate_deg = plate_deg;
    Object.assign(this.#finger, finger);
    Object.assign(this.#felt, felt);
    return !same;
  }

  /** The place on the plate under a pointer; false beyond the horizon, or without a picture. */
  placeOf(event: PointerEvent, out: Place): boolean {
    const box = this.canvas.getBoundingClientRect();
    return this.stage?.toPlate(event.clientX - box.left, event.clientY - box.top, out) ?? false;
  }
}

function isSame(one: Readonly<Place>, other: Readonly<Place>): boolean {
  return one.right_m === other.right_m && one.away_m === other.away_m;
}

function createStage(canvas: HTMLCanvasElement): Stage | null {
  try {
    return new Stage(canvas);
  } catch {
    return null;
  }
}
