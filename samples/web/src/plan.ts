// Draws the plate from above, as the content of an SVG picture in millimetres: for replayed slides, for the figures,
// and for the desk in a browser without WebGL.
import {
  ahead,
  type Course,
  cylinderRadius_m,
  normal_deg,
  type Place,
  radius_m,
  ridgeSpacing_m,
  start,
} from "./geometry";

export type Kind = "real" | "felt" | "touch";

const mm = (place: Readonly<Place>): string =>
  `${(1000 * place.right_m).toFixed(1)} ${(-1000 * place.away_m).toFixed(1)}`;
const line = (places: readonly Readonly<Place>[]): string => `M${places.map(mm).join(" L")}`;

export const dot = (kind: Kind, at: Readonly<Place>, radius_mm = 5): string =>
  Number.isNaN(at.right_m) ? "" : `<circle class="${kind}" r="${radius_mm}" transform="translate(${mm(at)})"/>`;
export const word = (kind: Kind, at: Readonly<Place>, text: string, anchor = "middle"): string =>
  `<text class="${kind}" text-anchor="${anchor}" transform="translate(${mm(at)})">${text}</text>`;
const path = (kind: Kind, places: readonly Readonly<Place>[]): string =>
  places.length < 2 ? "" : `<path class="${kind}" d="${line(places)}"/>`;

type Step = Readonly<Record<"finger" | "felt", Readonly<Place>>>;
/** Draws the paths of the true and the perceived positions. With `all` false, only the latter. */
export function paths(steps: readonly Step[], all = true): string {
  const felt = steps.map((step) => step.felt).filter(({ right_m }) => !Number.isNaN(right_m)),
    real = all ? steps.map(({ finger }) => finger) : [];
  return path("real", real) + path("felt", felt);
}

export function arrow(kind: Kind, from: Readonly<Place>, direction_deg: number, length_m: number): string {
  if (Number.isNaN(direction_deg)) return "";
  const tip = ahead(from, direction_deg, length_m),
    sides = [150, 210].map((turn) => ahead(tip, direction_deg + turn, 0.007));
  return `<path class="${kind}" d="${line([from, tip])}"/><path class="tip ${kind}" d="${line([...sides, tip])} Z"/>`;
}

/** Draws the plate, whose ridges have their normal at `plate_deg`, and the ring at the start. */
export function plate(plate_deg: number): string {
  const ridges = [];
  for (let away_m = -0.07; away_m < 0.071; away_m += ridgeSpacing_m) {
    const half_m = Math.sqrt(radius_m ** 2 - away_m ** 2);
    ridges.push(line([-half_m, half_m].map((right_m) => ({ right_m, away_m }))));
  }
  return (
    `<circle class="disc" r="${1000 * radius_m}"/><path class="ridge" transform="rotate(${(-plate_deg).toFixed(1)})" ` +
    `d="${ridges.join("")}"/><circle class="ring" r="8" transform="translate(${mm(start)})"/>`
  );
}

/** Draws cylinder and glass, with their names if `named`. With `all` false, only the glass. */
export function targets({ real_deg, real_m, virtual_deg, virtual_m }: Course, named = true, all = true): string {
  const real = ahead(start, real_deg, real_m),
    glass = ahead(start, virtual_deg, virtual_m),
    beside = (at: Place, sign: number) => ({ right_m: at.right_m + sign * 0.009, away_m: at.away_m + 0.004 });
  const side = real.right_m < glass.right_m ? -1 : 1,
    anchor = (sign: number) => (sign < 0 ? "end" : "start");
  return (
    (all
      ? dot("real", real, 1000 * cylinderRadius_m) +
        (named ? word("real", beside(real, side), "cylinder", anchor(side)) : "")
      : "") +
    dot("felt", glass, 6) +
    (named ? word("felt", beside(glass, -side), "glass", anchor(-side)) : "")
  );
}

/** Draws arrows from one point for the true direction, the direction by touch alone, and the perceived direction. */
export function arrows(at: Place, plate_deg: number, finger_deg: number, felt_deg: number, length_m = 0.03): string {
  return (
    arrow("touch", at, normal_deg(plate_deg, finger_deg), length_m) +
    arrow("real", at, finger_deg, length_m) +
    arrow("felt", at, felt_deg, length_m)
  );
}
