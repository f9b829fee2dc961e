// Six interactive figures that explain the method. Their simulated person has a larger tactile weight than most people,
// so that the effect is visible.
import type { Library } from "haptic-retargeting";
import {
  ahead,
  bearing_deg,
  type Course,
  distance_m,
  feltDirection_deg,
  normal_deg,
  type Place,
  pageCourse,
  start,
} from "./geometry";
import { element, say } from "./page";
import { arrow, arrows, dot, paths, plate, targets, word } from "./plan";
import type { Settings } from "./settings";
import { SimulatedReach } from "./simulated_reach";

const settings: Settings = {
  controller: "ours",
  gap_deg: 10,
  tactile_weight: 0.3,
  pace_s: 2,
  noise_mm: 0.3,
  plate_deg_s: 400,
  person: 1,
};
const turned_deg = 50;

interface Figure {
  readonly caption: string;
  readonly altText: string;
  readonly height?: number;
  readonly range: readonly [min: number, max: number, value: number];
  /** Slider value for a drag to this position in the picture. The slider limits it to its range. */
  readonly value: (at: Place) => number;
  readonly draw: (value: number) => string;
  readonly text: (value: number) => string;
}

const side = (angle_deg: number): string =>
  Math.abs(angle_deg) < 1.5 ? "straight ahead" : angle_deg > 0 ? "to the left" : "to the right";
const handle = (at: Readonly<Place>): string => `<g class="handle">${dot("real", at, 6)}</g>`;
const felt = (plate_deg: number, hand_deg: number) => feltDirection_deg(settings.tactile_weight, plate_deg, hand_deg);

export function showFigures(library: Library): void {
  // A reach to a glass straight ahead, over ridges that do not turn.
  const straight: Course = { ...pageCourse(settings.gap_deg), virtual_deg: 0 },
    unguided = new SimulatedReach(library, { ...settings, controller: "off" }, () => straight);
  unguided.begin(turned_deg);
  unguided.finish();

  const reach = new SimulatedReach(library, settings);
  let off_mm = NaN;
  /** Draws the third reach of a person whom the plugin steers. */
  const guided = (gap_deg: number): string => {
    reach.apply({ ...settings, controller: "off" }); // a change of the controller discards the estimates
    reach.apply({ ...settings, gap_deg });
    reach.finish();
    for (let i = 0; i < 2; ++i) {
      reach.begin();
      reach.finish();
    }
    const last = reach.trace.at(-1)!;
    off_mm = reach.result?.toCylinder_mm ?? NaN;
    return (
      plate(reach.trace.filter(({ finger_deg }) => !Number.isNaN(finger_deg)).at(-1)!.plate_deg) +
      targets(reach.course) +
      paths(reach.trace) +
      dot("felt", last.felt, 4) +
      dot("real", last.finger, 3)
    );
  };

  const figures: readonly Figure[] = [
    {
      caption: "Drag the fingertip over the ridge. Skin feels a ridge that it crosses. Along a ridge it feels nothing.",
      altText: "A fingertip from the side, over one ridge",
      height: 100,
      range: [-70, 70, -40],
      value: ({ right_m }) => 1000 * right_m,
      draw: (x) => {
        // The skin is lifted above the ridge.
        const skin = Array.from({ length: 41 }, (_, i) => {
          const u = x - 25 + 1.25 * i,
            y = 30 - 13 * Math.exp(-((u / 7) ** 2));
          return `${u.toFixed(1)} ${Math.min(30 - 0.12 * Math.max(0, Math.abs(u - x) - 15) ** 2, y).toFixed(1)}`;
        });
        return (
          '<path class="table" d="M-75 32 H75 V45 H-75 Z"/><path class="bump" d="M-7 32 Q0 8 7 32 Z"/>' +
          `<path class="skin" d="M${skin.join(" L")} L${x + 23} -20 Q${x} -45 ${x - 23} -20 Z"/>`
        );
      },
      text: (x) => (Math.abs(x) < 25 ? "The ridge presses into the skin: felt!" : "Nothing is felt."),
    },
    {
      caption:
        "Drag around the plate to turn it. A fingertip cannot feel how it moves along a ridge. It only feels ridges that it " +
        "crosses, as a push at a right angle to them.",
      altText: "The plate from above, with the push of its ridges",
      range: [-60, 60, 40],
      value: (at) => bearing_deg(start, at),
      draw: (plate_deg) => plate(plate_deg) + arrow("touch", start, normal_deg(plate_deg, 0), 0.08),
      text: (plate_deg) => `The push, at a right angle to the ridges, points ${side(plate_deg)}.`,
    },
    {
      caption:
        "Turn it again. The hand goes straight ahead (blue). Muscles say so, the ridges say something else (green), and the " +
        "brain mixes the two (orange).",
      altText: "The plate with the true motion, the push of its ridges, and the perceived motion",
      range: [-60, 60, 40],
      value: (at) => bearing_deg(start, at),
      draw: (plate_deg) => plate(plate_deg) + arrows(start, plate_deg, 0, felt(plate_deg, 0), 0.08),
      text: (plate_deg) => `The hand goes straight ahead. It seems to go ${side(felt(plate_deg, 0))}.`,
    },
    {
      caption: "Now drag the hand. Find the direction that feels straight ahead.",
      altText: "The plate stays turned, and the hand goes another way",
      range: [-40, 40, 0],
      value: (at) => bearing_deg(start, at),
      draw: (hand_deg) =>
        plate(turned_deg) +
        arrows(start, turned_deg, hand_deg, felt(turned_deg, hand_deg), 0.08) +
        handle(ahead(start, hand_deg, 0.08)),
      text: (hand_deg) => `The hand goes ${side(hand_deg)}. It seems to go ${side(felt(turned_deg, hand_deg))}.`,
    },
    {
      caption:
        "Drag the hand to the glass. A person who slides there corrects the hand without thinking, until it feels right. Here " +
        "a computer plays the person.",
      altText: "A person slides to the glass over turned ridges",
      range: [0, 100, 100],
      value: ({ away_m }) => (100 * (away_m - start.away_m)) / distance_m,
      draw: (percent) => {
        const { trace } = unguided,
          gone = trace.slice(0, Math.max(1, Math.round((percent / 100) * trace.length))),
          at = gone.at(-1)!;
        return (
          plate(turned_deg) + targets(straight, true, false) + paths(gone) + dot("felt", at.felt, 4) + handle(at.finger)
        );
      },
      text: (percent) =>
        percent < 90
          ? "The person corrects the hand, so that it feels straight."
          : "The person feels the hand at the glass, but the hand is to the right of it.",
    },
    {
      caption:
        "Drag the cylinder. The computer turns the plate so that the hand ends there, while the person feels it go to the " +
        "glass. In three slides, it learns how much this person relies on touch.",
      altText: "The plate turns, and the hand ends at the cylinder while the glass is felt",
      range: [0, 30, 16],
      value: (at) => -2 * bearing_deg(start, at),
      draw: (gap_deg) => guided(Math.abs(gap_deg)) + word("real", { right_m: 0.045, away_m: 0.068 }, "drag it"),
      text: (gap_deg) =>
        (off_mm < 4 ? "The hand ends at the cylinder." : `The hand misses the cylinder by ${off_mm.toFixed(0)} mm.`) +
        (gap_deg > 22 ? " No plate can lead this person's hand that far aside." : ""),
    },
  ];
  for (const [i, figure] of figures.entries()) show(figure, i + 1);
}

function show(
  { caption, altText, height = 160, range: [min, max, first], value, draw, text }: Figure,
  i: number,
): void {
  element("figures-end", HTMLParagraphElement).insertAdjacentHTML(
    "beforebegin",
    `<figure>
      <figcaption><label for="see-${i}">${i}. ${caption}</label></figcaption>
      <svg id="figure-${i}" viewBox="-80 ${-height / 2} 160 ${height}" role="img" aria-label="${altText}"></svg>
      <p id="words-${i}" role="status"></p>
      <input type="range" id="see-${i}" min="${min}" max="${max}" value="${first}">
    </figure>`,
  );
  const svg = element(`figure-${i}`, SVGSVGElement),
    input = element(`see-${i}`, HTMLInputElement);
  const update = () => {
    svg.innerHTML = draw(Number(input.value));
    const said = text(Number(input.value));
    say(element(`words-${i}`, HTMLParagraphElement), said);
    input.setAttribute("aria-valuetext", said);
  };
  const drag = (event: PointerEvent) => {
    if (event.type === "pointermove" && !(event.buttons & 1)) return;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
    input.value = String(value({ right_m: x / 1000, away_m: -y / 1000 }));
    update();
  };
  svg.addEventListener("pointerdown", (event) => {
    svg.setPointerCapture(event.pointerId);
    drag(event);
  });
  svg.addEventListener("pointermove", drag);
  input.addEventListener("input", update);
  update();
}
