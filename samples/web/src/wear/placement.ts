// Places the plate in the headset's world: by touches of its marks, in a set-up of the plugin, or by a pinch.
import * as hrt from "haptic-retargeting";
import marksFile from "marks.csv";
import { Quaternion, Vector3 } from "three";
import { start } from "../geometry";

/** Marks of the plate (samples/plate/model/marks.csv), in the order in which they are touched. */
const marks = marksFile
  .trim()
  .split("\n")
  .slice(1)
  .map((line) => {
    const [name = "", ...numbers] = line.split(",");
    return { name, place_m: numbers.slice(0, 3).map(Number) };
  });
const marks_m = marks.flatMap(({ place_m }) => place_m);

const pointRadius_m = 0.012,
  hold_ms = 1500,
  count_ms = 500;
const pinch =
  "Pinch your thumb and index finger where slides should start, and hold. The plate's centre will be 5 cm further away.";

export class RestDetector {
  /** Position at which the rest began. */
  readonly place = new Vector3();
  #since_ms = NaN;
  #taken = false;

  /** A fingertip rests when it stays within `radius_m` of its first position for `time_ms`. */
  constructor(
    private readonly radius_m: number,
    private readonly time_ms: number,
  ) {}

  /** Returns true once for each rest; the fingertip must then move away. `tip`: null if it is not tracked. */
  update(now_ms: number, tip: Vector3 | null): boolean {
    if (!tip) {
      this.#since_ms = NaN;
      return false;
    }
    if (Number.isNaN(this.#since_ms) || tip.distanceTo(this.place) > this.radius_m) {
      this.#taken &&= tip.distanceTo(this.place) <= this.radius_m;
      this.#since_ms = now_ms;
      this.place.copy(tip);
    }
    if (this.#taken || this.held_ms(now_ms) < this.time_ms) return false;
    this.#taken = true;
    return true;
  }

  held_ms(now_ms: number): number {
    return Number.isNaN(this.#since_ms) ? 0 : now_ms - this.#since_ms;
  }

  /** Forgets the rest: the next one may be at the same position. */
  reset(): void {
    this.#since_ms = NaN;
    this.#taken = false;
  }
}

export class Placement {
  text = pinch;
  /** Pose of the plate in the world, once placed. */
  readonly position = new Vector3();
  readonly rotation = new Quaternion();

  readonly #rest = new RestDetector(pointRadius_m, hold_ms);

  /** `session`: registers the plate in this session by its marks; null: places it by a pinch. */
  constructor(private readonly session: hrt.Session | null) {
    if (!session) return;
    if (session.state & hrt.HRT_STATE_SETTING_UP) session.cancelSetup();
    session.beginSetup(hrt.HRT_SETUP_REGISTRATION, {
      mark_count: marks.length,
      marks_m: Array.from({ length: hrt.HRT_MARK_NUMBERS }, (_, i) => marks_m[i] ?? 0),
    });
    this.text = "Turn the plate to 0°, then touch its marks.";
  }

  /** Returns true once the plate is placed. `tip`: null if not tracked. `forward`: where the visitor looks. */
  update(time_ms: number, tip: Vector3 | null, forward: Vector3, pinches: boolean): boolean {
    if (this.session) return this.#touch(this.session, time_ms, tip);
    const placed = this.#rest.update(time_ms, pinches ? tip : null),
      left_ms = hold_ms - this.#rest.held_ms(time_ms);
    this.text = left_ms < hold_ms ? `Hold: ${Math.max(1, Math.ceil(left_ms / count_ms))}` : pinch;
    return placed && this.#point(forward);
  }

  #point(forward: Vector3): boolean {
    const yaw = Math.atan2(-forward.x, -forward.z);
    this.rotation.setFromAxisAngle(new Vector3(0, 1, 0), yaw);
    const toStart = new Vector3(start.right_m, 0, -start.away_m).applyQuaternion(this.rotation);
    this.position.copy(this.#rest.place).sub(toStart);
    return true;
  }

  #touch(session: hrt.Session, time_ms: number, tip: Vector3 | null): boolean {
    session.setFinger(tip, time_ms);
    const { instruction, text, number, done, of } = session.updateSetup(),
      name = marks[number]?.name ?? "";
    this.text =
      instruction === hrt.HRT_STEP_TOUCH_MARK
        ? `${text} Mark ${number + 1} is "${name}" (${done + 1} of ${of}).`
        : text;
    if (instruction !== hrt.HRT_STEP_FINISH || session.finishSetup().left) return false;
    const { plate_position_m, plate_rotation } = session.config;
    this.position.fromArray(plate_position_m);
    this.rotation.fromArray(plate_rotation);
    return true;
  }
}
