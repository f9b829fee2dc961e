// Six interactive figures that explain the method. Their simulated person has a larger tactile weight than most people,
// so that the effect is visible.
import type { Library } from "haptic-retargeting";
import { pageCourse } from "./controller";
import { ahead, bearing_deg, distance_m, type Place, start } from "./geometry";
import { element, say } from "./page";
import { places, type World } from "./person";
import { arrow, arrows, dot, normal_deg, paths, plate, targets, word } from "./plan";
import { defaultSettings } from "./settings";
import { SimulatedReach } from "./simulated_reach";

const strong = 0.3,
  turned_deg = 50;

interface Figure {
  /** Slider value for a drag to this position in the picture; clamped to the slider's range. */
  readonly value: (at: Place) => number;
  readonly draw: (value: number) => string;
  /** Description of the picture in words. */
  readonly text: (value: number) => string;
}

const side = (angle_deg: number): string =>
  Math.abs(angle_deg) < 1.5 ? "straight ahead" : angle_deg > 0 ? "to the left" : "to the right";
const handle = (at: Readonly<Place>): string => `<g class="handle">${dot("real", at, 6)}</g>`;

export function showFigures(library: Library, world: World): void {
  const settings = { ...defaultSettings(), tactile_weight: strong, noise_mm: 0.3, pace_s: 2 },
    watch = new SimulatedReach(library, world, settings);
  const still = () => {
    world.set_person(1, strong, 2);
    world.set_apparatus(0, settings.plate_deg_s);
  };
  const felt = (plate_deg: number, hand_deg: number) => hand_deg + world.felt_shift_deg(plate_deg, hand_deg);

  /** True and perceived positions of a reach to a glass straight ahead, over ridges that do not turn. */
  const unguided: ReturnType<typeof places>[] = [];
  still();
  world.begin_reach(1, start.right_m, start.away_m, 0, distance_m, turned_deg);
  for (let ms = 0; world.over() === 0 && ms < 10_000; ++ms) {
    world.advance();
    if (ms % 20 === 0) unguided.push(places(world));
  }

  let off_mm = NaN;
  /** Draws the third reach of a person whom the plugin steers. */
  const guided = (gap_deg: number): string => {
    watch.apply({ ...settings, person: watch.number, gap_deg });
    watch.apply({ ...settings, gap_deg });
    for (let reach = 1; ; ++reach) {
      while (watch.phase !== "arrived") watch.advance();
      if (reach === 3) break;
      watch.begin();
    }
    const last = watch.trace.at(-1)!;
    off_mm = watch.result?.toCylinder_mm ?? NaN;
    return (
      plate(watch.trace.filter(({ finger_deg }) => !Number.isNaN(finger_deg)).at(-1)!.plate_deg) +
      targets(watch.course) +
      paths(watch.trace) +
      dot("felt", last.felt, 4) +
      dot("real", last.finger, 3)
    );
  };
  const ended = () =>
    off_mm < 4 ? "The hand ends at the cylinder." : `The hand misses the cylinder by ${off_mm.toFixed(0)} mm.`;

  const figures: readonly Figure[] = [
    {
      value: ({ right_m }) => 1000 * right_m,
      draw: (x) => {
        // the skin is lifted above the ridge
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
      value: (at) => bearing_deg(start, at),
      draw: (plate_deg) => plate(plate_deg) + arrow("touch", start, normal_deg(plate_deg, 0), 0.08),
      text: (plate_deg) => `The push, at a right angle to the ridges, points ${side(plate_deg)}.`,
    },
    {
      value: (at) => bearing_deg(start, at),
      draw: (plate_deg) => plate(plate_deg) + arrows(start, plate_deg, 0, felt(plate_deg, 0), 0.08),
      text: (plate_deg) => `The hand goes straight ahead. It seems to go ${side(felt(plate_deg, 0))}.`,
    },
    {
      value: (at) => bearing_deg(start, at),
      draw: (hand_deg) =>
        plate(turned_deg) +
        arrows(start, turned_deg, hand_deg, felt(turned_deg, hand_deg), 0.08) +
        handle(ahead(start, hand_deg, 0.08)),
      text: (hand_deg) => `The hand goes ${side(hand_deg)}. It seems to go ${side(felt(turned_deg, hand_deg))}.`,
    },
    {
      value: ({ away_m }) => (100 * (away_m - start.away_m)) / distance_m,
      draw: (percent) => {
        const gone = unguided.slice(0, Math.max(1, Math.round((percent / 100) * unguided.length))),
          at = gone.at(-1)!;
        return (
          plate(turned_deg) +
          targets({ ...pageCourse(settings), virtual_deg: 0 }, true, false) +
          paths(gone) +
          dot("felt", at.felt, 4) +
          handle(at.finger)
        );
      },
      text: (percent) =>
        percent < 90
          ? "The person corrects the hand, so that it feels straight."
          : "The person feels the hand at the glass. It really is to the right of it.",
    },
    {
      value: (at) => -2 * bearing_deg(start, at),
      draw: (gap_deg) => guided(Math.abs(gap_deg)) + word("real", { right_m: 0.045, away_m: 0.068 }, "drag it"),
      text: (gap_deg) => `${ended()}${gap_deg > 22 ? " No plate can lead this person's hand that far aside." : ""}`,
    },
  ];

  for (const [i, { value, draw, text }] of figures.entries()) {
    const picture = element(`figure-${i + 1}`, SVGSVGElement),
      input = element(`see-${i + 1}`, HTMLInputElement),
      words = element(`words-${i + 1}`, HTMLParagraphElement);
    const show = () => {
      still();
      picture.innerHTML = draw(Number(input.value));
      const said = text(Number(input.value));
      say(words, said);
      input.setAttribute("aria-valuetext", said);
    };
    const drag = (event: PointerEvent) => {
      if (event.type === "pointermove" && !(event.buttons & 1)) return;
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(picture.getScreenCTM()!.inverse());
      input.value = String(value({ right_m: x / 1000, away_m: -y / 1000 }));
      show();
    };
    picture.addEventListener("pointerdown", (event) => {
      picture.setPointerCapture(event.pointerId);
      drag(event);
    });
    picture.addEventListener("pointermove", drag);
    input.addEventListener("input", show);
    show();
  }
}
