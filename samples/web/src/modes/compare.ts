// Replay of two slides side by side: with the plate on (or of an opened recording), and with the plate off.
import { type Course, normal_deg } from "../geometry";
import type { Trace } from "../guided_reach";
import { element, say, sideways } from "../page";
import { arrows, dot, paths, plate, targets } from "../plan";

interface Slide {
  readonly trace: Trace;
  readonly course: Course;
  readonly name: string;
}
const kinds = ["on", "off"] as const;

export class Compare {
  readonly #moment = element("moment", HTMLInputElement);
  readonly #slides: { on: Slide | null; off: Slide | null } = { on: null, off: null };

  constructor() {
    this.#moment.addEventListener("input", () => this.#show());
  }

  keep(kind: (typeof kinds)[number], trace: Trace, course: Course, name = `Plate ${kind}`): void {
    this.#slides[kind] = { trace, course, name };
    element("compare", HTMLElement).hidden = false;
    this.#moment.value = this.#moment.max;
    this.#show();
  }

  clear(): void {
    this.#slides.on = this.#slides.off = null;
    element("compare", HTMLElement).hidden = true;
  }

  #show(): void {
    const fraction = Number(this.#moment.value) / Number(this.#moment.max),
      texts: string[] = [];
    for (const kind of kinds) {
      const slide = this.#slides[kind],
        at = slide?.trace[Math.round(fraction * (slide.trace.length - 1))],
        picture = element(`slide-${kind}`, SVGSVGElement);
      element(`slide-${kind}-missing`, HTMLElement).hidden = slide !== null;
      if (!slide || !at) {
        picture.innerHTML = plate(0);
        continue;
      }
      const { finger, felt, plate_deg, finger_deg, felt_deg } = at,
        dots = dot("felt", felt) + dot("real", finger);
      picture.innerHTML =
        plate(plate_deg) +
        targets(slide.course) +
        paths(slide.trace.slice(0, slide.trace.indexOf(at) + 1)) +
        arrows(finger, plate_deg, finger_deg, felt_deg) +
        dots;
      say(element(`slide-${kind}-name`, HTMLElement), slide.name);
      const moves = `the hand moves ${sideways(finger_deg)}, the ridges push ${sideways(normal_deg(plate_deg, finger_deg))}`;
      texts.push(
        `${slide.name}: ${Number.isNaN(finger_deg) ? "the hand rests" : `${moves}, that feels like ${sideways(felt_deg)}`}.`,
      );
    }
    say(element("moment-text", HTMLParagraphElement), texts.join(" "));
    this.#moment.setAttribute("aria-valuetext", texts.join(" "));
  }
}
