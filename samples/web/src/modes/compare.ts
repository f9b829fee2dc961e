// The visitor's own slides, to look at again: with the plate on and off side by side, moment by moment.
import type { Course } from "../geometry";
import { element, say, sideways } from "../page";
import { arrows, dot, normal_deg, path, plate, targets } from "../plan";
import type { Trace } from "../trace";

interface Slide {
  readonly trace: Trace;
  readonly course: Course;
}
const kinds = ["on", "off"] as const;

export class Compare {
  readonly #moment = element("moment", HTMLInputElement);
  readonly #slides: { on: Slide | null; off: Slide | null } = { on: null, off: null };

  constructor() {
    this.#moment.addEventListener("input", () => this.#show());
  }

  /** A slide that has ended; it stays until the next one of its kind. */
  keep(kind: (typeof kinds)[number], trace: Trace, course: Course): void {
    this.#slides[kind] = { trace, course };
    element("compare", HTMLElement).hidden = false;
    this.#moment.value = this.#moment.max;
    this.#show();
  }

  /** As settings of another person take them away. */
  clear(): void {
    this.#slides.on = this.#slides.off = null;
    element("compare", HTMLElement).hidden = true;
  }

  #show(): void {
    const share = Number(this.#moment.value) / Number(this.#moment.max),
      texts: string[] = [];
    for (const kind of kinds) {
      const slide = this.#slides[kind],
        at = slide?.trace[Math.round(share * (slide.trace.length - 1))],
        picture = element(`slide-${kind}`, SVGSVGElement);
      element(`slide-${kind}-missing`, HTMLElement).hidden = slide !== null;
      if (!slide || !at) {
        picture.innerHTML = plate(0);
        continue;
      }
      const { finger, felt, plate_deg, finger_deg, felt_deg } = at,
        gone = slide.trace.slice(0, slide.trace.indexOf(at) + 1);
      picture.innerHTML =
        plate(plate_deg) +
        targets(slide.course) +
        path(
          "real",
          gone.map((each) => each.finger),
        ) +
        path(
          "felt",
          gone.map((each) => each.felt),
        ) +
        arrows(finger, plate_deg, finger_deg, felt_deg) +
        dot("felt", felt) +
        dot("real", finger);
      texts.push(
        Number.isNaN(finger_deg)
          ? `Plate ${kind}: the hand rests.`
          : `Plate ${kind}: the hand moves ${sideways(finger_deg)}, the ridges push ` +
              `${sideways(normal_deg(plate_deg, finger_deg))}, it feels like ${sideways(felt_deg)}.`,
      );
    }
    say(element("moment-text", HTMLParagraphElement), texts.join(" "));
    this.#moment.setAttribute("aria-valuetext", texts.join(" "));
  }
}
