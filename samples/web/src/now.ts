// "What is felt now": the sum that makes the illusion, in words and numbers.
import { folded_deg } from "./geometry";
import { element, say, sideways, turned } from "./page";

/** Directions are NaN while the finger rests. `goal_deg`: where the glass lies, as a direction. */
export function showNow(plate_deg: number, finger_deg: number, felt_deg: number, goal_deg: number): void {
  const error_deg = felt_deg - goal_deg;
  const texts = {
    finger: sideways(finger_deg, 1),
    plate: sideways(folded_deg(plate_deg), 0),
    shift: turned(felt_deg - finger_deg),
    felt: sideways(felt_deg, 1),
    glass: sideways(goal_deg, 1),
    turn: Number.isNaN(error_deg) ? "–" : Math.abs(error_deg) < 1 ? "hardly" : error_deg > 0 ? "right" : "left",
  };
  for (const [name, text] of Object.entries(texts)) say(element(`now-${name}`, HTMLElement), text);
}
