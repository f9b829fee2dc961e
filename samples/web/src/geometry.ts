// Positions and directions on the plate. Positions are to the right of and away from the plate's centre, in metres.
// Directions are in degrees counter-clockwise from the mid-line, seen from above: positive is left.

export interface Place {
  right_m: number;
  away_m: number;
}

/** Start of the page's own reaches: the default of the plugin. */
export const start: Readonly<Place> = { right_m: 0, away_m: -0.05 };
/** Distance from the start to the cylinder and to the glass. */
export const distance_m = 0.1;
/** Radius of the plate. */
export const radius_m = 0.075;
export const cylinderRadius_m = 0.0055;
export const ridgeSpacing_m = 0.01;

/** Start and targets of a reach: directions and distances are seen from the start. */
export interface Course {
  readonly start: Readonly<Place>;
  readonly real_deg: number;
  readonly real_m: number;
  readonly virtual_deg: number;
  readonly virtual_m: number;
}

/** Returns the page's targets, each half of the gap from the mid-line: the cylinder right, the glass left. */
export function pageCourse(gap_deg: number): Course {
  return { start, real_deg: -gap_deg / 2, real_m: distance_m, virtual_deg: gap_deg / 2, virtual_m: distance_m };
}

export const degree = Math.PI / 180;

export function ahead(from: Readonly<Place>, direction_deg: number, length_m: number): Place {
  return {
    right_m: from.right_m - length_m * Math.sin(direction_deg * degree),
    away_m: from.away_m + length_m * Math.cos(direction_deg * degree),
  };
}

/** Returns the direction of a motion, from -180 to 180. */
export function direction_deg(right_m: number, away_m: number): number {
  return Math.atan2(-right_m, away_m) / degree;
}

export function bearing_deg(from: Readonly<Place>, to: Readonly<Place>): number {
  return direction_deg(to.right_m - from.right_m, to.away_m - from.away_m);
}

export function length_m(from: Readonly<Place>, to: Readonly<Place>): number {
  return Math.hypot(to.right_m - from.right_m, to.away_m - from.away_m);
}

function realPlace(course: Course): Place {
  return ahead(course.start, course.real_deg, course.real_m);
}
export function virtualPlace(course: Course): Place {
  return ahead(course.start, course.virtual_deg, course.virtual_m);
}

/** Distances at the end of a slide: of the fingertip from both targets, of the perceived fingertip from the glass. */
export interface SlideEnd {
  readonly toCylinder_mm: number;
  readonly toGlass_mm: number;
  readonly feltToGlass_mm: number;
}

export function slideEnd(finger: Readonly<Place>, felt: Readonly<Place>, course: Course): SlideEnd {
  const glass = virtualPlace(course);
  return {
    toCylinder_mm: 1000 * length_m(finger, realPlace(course)),
    toGlass_mm: 1000 * length_m(finger, glass),
    feltToGlass_mm: 1000 * length_m(felt, glass),
  };
}

/** Direction that touch alone would report: the ridges' normal on the side to which the fingertip moves. */
export function normal_deg(plate_deg: number, finger_deg: number): number {
  return plate_deg - 180 * Math.round((plate_deg - finger_deg) / 180);
}

/** Perceived direction of a motion: mean of its direction and of normal_deg(), weighted by the tactile weight. */
export function feltDirection_deg(tactile_weight: number, plate_deg: number, finger_deg: number): number {
  return finger_deg + tactile_weight * (normal_deg(plate_deg, finger_deg) - finger_deg);
}
