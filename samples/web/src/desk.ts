// The picture of the desk with its labels: in three dimensions, or from above in a browser without WebGL.
import type { VisitorScene } from "./files/scene";
import { ahead, type Course, type Place, pageCourse, type SlideEnd, start } from "./geometry";
import { type Colours, element, say } from "./page";
import { dot, paths, plate, targets } from "./plan";
import { type Shown, Stage } from "./stage/stage";

const maxLabels = 30; // of the targets of a visitor's scene
const targetTop_m = 0.034;
const margin_px = 4,
  minGap_px = 14;
const turn_rad = 0.15;

interface Label {
  readonly element: HTMLElement;
  /** 1: right of `place`, -1: left, 0: above; reversed if the glass (virtual target) is right of the cylinder. */
  readonly side: number;
  place: Readonly<Place>;
  readonly height_m: number;
}

export class Desk {
  readonly frame = element("stage", HTMLDivElement);
  readonly canvas = element("view", HTMLCanvasElement);
  /** Area over the plate's disc in which a touch moves the fingertip instead of scrolling the page. */
  readonly grip = element("grip", HTMLDivElement);
  /** Null if the browser has no WebGL: the picture from above is drawn instead. */
  readonly stage: Stage | null;
  readonly #flat = element("no-view", SVGSVGElement);
  /** Called when the browser has restored WebGL and the picture must be drawn again. */
  onRestored: () => void = () => {};
  readonly #named = {
    finger: label("finger", 1, 0.006),
    felt: label("felt", -1, 0.006),
    real: label("real", 1),
    glass: label("glass", -1),
  };
  readonly #own: readonly Label[] = Object.values(this.#named);
  #labels = [...this.#own];
  readonly #caption = element("caption", HTMLParagraphElement);
  #course: Course = pageCourse(0);
  /** State in the last picture, which draw() does not draw again. Empty: the next draw() must draw. */
  #drawn = "";
  #trace: unknown = null;
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
  setTargets(course: Course): void {
    this.#course = course;
    this.#named.real.place = ahead(start, course.real_deg, course.real_m);
    this.#named.glass.place = ahead(start, course.virtual_deg, course.virtual_m);
    this.#change((stage) => stage.setTargets(course));
  }
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

  /** Loads the model of the hand, and adds it to the three-dimensional picture. */
  async bringHand(): Promise<void> {
    await this.stage?.finger.become((await import("./stage/hand_model")).pointingHand);
    this.#drawn = "";
    this.frame.dataset.hand = "yes";
  }
  resize(): void {
    this.#change((stage) => stage.resize(this.canvas.clientWidth, this.canvas.clientHeight, devicePixelRatio));
    this.#placeGrip();
  }

  /** Simplifies the picture after eight successive frames of 60 to 1000 ms, which suggest software rendering. */
  ease(elapsed_ms: number): void {
    this.#slowFrames = elapsed_ms > 60 && elapsed_ms < 1000 ? this.#slowFrames + 1 : 0;
    if (this.#slowFrames === 8) this.#change((stage) => stage.lighten());
  }

  /** Fades in the true hand and draws its path by this fraction, from 0 to 1. At 0, the cylinder and the labels of hand
   *  and cylinder are hidden. */
  reveal(fraction: number): void {
    if (fraction === this.#revealed) return;
    this.#revealed = fraction;
    this.#change((stage) => stage.reveal(fraction));
    this.#named.finger.element.hidden = fraction === 0;
    this.#named.real.element.hidden = fraction === 0 || this.#labels.length > this.#own.length;
  }

  /** `own`: the hand is the visitor's, not a simulated person's. */
  nameLabels(own: boolean): void {
    say(this.#named.finger.element, own ? "your hand" : "hand");
    this.#drawn = "";
  }

  setScene(scene: VisitorScene | null): void {
    this.#change((stage) => stage.setScene(scene));
    for (const name of ["real", "glass"] as const) this.#named[name].element.hidden = scene !== null;
    for (const { element: label } of this.#labels.slice(this.#own.length)) label.remove();
    this.#labels = [...this.#own];
    const fromLeft = [...(scene?.targets ?? [])].sort((a, b) => a.drawn.right_m - b.drawn.right_m);
    for (const target of fromLeft.slice(0, maxLabels)) {
      const span = document.createElement("span");
      span.className = `label ${target.real ? "real" : "felt"}`;
      span.textContent = target.name;
      element("labels", HTMLDivElement).append(span);
      this.#labels.push({ element: span, side: 0, place: target.drawn, height_m: targetTop_m });
    }
  }

  /** Sets the text above the picture, and the phase of the reach, which page.css and tests read. */
  caption(phase: string, words: string): void {
    this.frame.dataset.phase = phase;
    say(this.#caption, words);
  }

  draw(shown: Shown, scale = 1): void {
    const stage = this.stage,
      { plate_deg, finger, felt, trace } = shown,
      state = [plate_deg, finger.right_m, finger.away_m, felt.right_m, felt.away_m, trace.length].join();
    if (state === this.#drawn && trace === this.#trace) return;
    [this.#drawn, this.#trace] = [state, trace];
    this.frame.dataset.plateDeg = plate_deg.toFixed(1);
    if (!stage) return this.#drawFlat(shown);
    stage.place(shown, scale);
    stage.draw();
    const scaled = ({ right_m, away_m }: Place) => ({ right_m: scale * right_m, away_m: scale * away_m });
    this.#named.finger.place = scaled(finger);
    this.#named.felt.place = scaled(felt);
    this.#drawLabels(stage);
  }

  #drawFlat({ plate_deg, finger, felt, trace }: Shown): void {
    const all = this.#revealed > 0,
      hand = paths(trace, all) + dot("felt", felt) + (all ? dot("real", finger) : "");
    this.#flat.innerHTML = plate(plate_deg) + targets(this.#course, true, all) + hand;
  }

  /** Places the labels within the picture. Those above objects do not overlap unless they reach the edge. */
  #drawLabels(stage: Stage): void {
    const { clientWidth, clientHeight } = this.canvas,
      gap_px = Math.max(minGap_px, 0.06 * this.grip.offsetWidth),
      mirror = this.#course.virtual_deg < this.#course.real_deg ? -1 : 1;
    let free_px = 0; // least left end of the next label above an object
    for (const { element: label, place, height_m, side } of this.#labels) {
      if (label.hidden) continue;
      const at = stage.toCanvas(place, height_m),
        { offsetWidth: width, offsetHeight: height } = label;
      let x = at.x - width / 2 + mirror * side * (width / 2 + gap_px);
      if (side === 0) x = Math.max(x, free_px);
      if (side === 0) free_px = x + width + margin_px;
      const y = at.y - height / 2 - (side === 0 ? height : 0);
      const within = (value: number, most: number) => Math.min(Math.max(value, margin_px), most - margin_px).toFixed(1);
      label.style.transform = `translate(${within(x, clientWidth - width)}px, ${within(y, clientHeight - height)}px)`;
    }
  }

  /** Writes distances of a finished slide and positions in the picture to data attributes, for tests. */
  write(result: SlideEnd | null, dot: Readonly<Place>): void {
    const { dataset } = this.frame;
    for (const [name, place] of Object.entries({ start, glass: this.#named.glass.place, dot })) {
      const at = this.stage?.toCanvas(place, 0);
      if (at) dataset[name] = `${at.x.toFixed(1)} ${at.y.toFixed(1)}`;
    }
    if (result) dataset.result = JSON.stringify(result);
    else delete dataset.result;
  }

  /** Applies a change that is not an argument of draw(). The next draw() then draws. */
  #change(how: (stage: Stage) => void): void {
    if (this.stage) how(this.stage);
    this.#drawn = "";
  }

  /** Returns the position on the plate under a pointer; null if the pointer is above the horizon. */
  placeOf({ clientX, clientY }: PointerEvent): Place | null {
    const { left, top, width, height } = (this.stage ? this.canvas : this.#flat).getBoundingClientRect();
    if (this.stage) return this.stage.toPlate(clientX - left, clientY - top);
    const scale = 0.16 / Math.min(width, height); // the viewBox is 0.16 m wide and high
    return { right_m: (clientX - left - width / 2) * scale, away_m: (top + height / 2 - clientY) * scale };
  }
}

function label(name: string, side: number, height_m = targetTop_m): Label {
  return { element: element(`label-${name}`, HTMLSpanElement), side, place: start, height_m };
}
