// Where the plate is in the headset's world: touched mark by mark, with the plugin's registration, or put where the
// visitor points.
import { HRT_REGISTRATION_HOLDS, HRT_REGISTER_UP, type Library, type Registration } from "haptic-retargeting";
import { Quaternion, Vector3 } from "three";
import marksFile from "marks.csv";
import { start } from "../geometry";
import { Rest } from "./rest";

interface Mark { readonly name: string; readonly place_m: [number, number, number] }

/** The plate's marks (samples/plate/model/marks.csv), in the order in which they are touched. */
export const marks: readonly Mark[] = marksFile.trim().split("\n").slice(1).map((line) => {
  const [name = "", ...numbers] = line.split(",");
  return { name, place_m: numbers.slice(0, 3).map(Number) as [number, number, number] };
});

const markRadius_m = 0.008, pointRadius_m = 0.012, rest_ms = 900;

export class Placing {
  /** What the visitor is to do. */
  text = "";
  /** The plate's pose in the world, once placed. */
  readonly position = new Vector3();
  readonly rotation = new Quaternion();
  /** By marks; null: by pointing, or not yet. */
  registration: Registration | null = null;

  readonly #library: Library;
  readonly #byMarks: boolean;
  readonly #rest: Rest;
  #touches: { mark_m: number[]; touched_m: number[] }[] = [];

  constructor(library: Library, byMarks: boolean) {
    this.#library = library;
    this.#byMarks = byMarks;
    this.#rest = new Rest(byMarks ? markRadius_m : pointRadius_m, rest_ms);
    this.text = byMarks ? this.#ask() : "Hold your index fingertip still where slides are to start. The plate will lie ahead of it.";
  }

  /** True once the plate has a place. `forward`: where the visitor looks. */
  update(time_ms: number, tip: Vector3 | null, forward: Vector3): boolean {
    if (!this.#rest.update(time_ms, tip)) return false;
    return this.#byMarks ? this.#touch() : this.#point(forward);
  }

  #point(forward: Vector3): boolean {
    const yaw = Math.atan2(-forward.x, -forward.z);
    this.rotation.setFromAxisAngle(new Vector3(0, 1, 0), yaw);
    const toStart = new Vector3(start.right_m, 0, -start.away_m).applyQuaternion(this.rotation);
    this.position.copy(this.#rest.place).sub(toStart);
    return true;
  }

  #touch(): boolean {
    const mark = marks[this.#touches.length];
    if (mark) this.#touches.push({ mark_m: mark.place_m, touched_m: this.#rest.place.toArray() });
    if (this.#touches.length < marks.length) {
      this.text = this.#ask();
      return false;
    }
    const fit = this.#library.fitRegistration(this.#touches, { flags: HRT_REGISTER_UP });
    this.#touches = [];
    if (fit.verdict !== HRT_REGISTRATION_HOLDS) {
      this.text = `These touches place no plate: ${fit.advice}. ${this.#ask()}`;
      return false;
    }
    this.registration = fit;
    this.position.fromArray(fit.plate_position_m);
    this.rotation.fromArray(fit.plate_rotation);
    return true;
  }

  #ask(): string {
    const { length } = this.#touches, mark = marks[length];
    return `Touch the mark "${mark?.name ?? ""}" with your index fingertip and hold still (${length + 1} of ${marks.length}). The plate stands at 0.`;
  }
}
