// Reads a reach of a recording, to show it.
import { HRT_SAMPLE_PLATE_POSE, HRT_SAMPLE_PLATE_POSITION, HRT_SAMPLE_WORLD_POSITION } from "haptic-retargeting";
import { Quaternion, Vector3 } from "three";
import { type Course, start } from "../geometry";
import { maxTrace, type Trace } from "../guided_reach";

export interface RecordedReach {
  readonly name: string;
  readonly course: Course;
  /** Trace of the first `maxTrace` samples, without those that have no position. */
  readonly samples: Trace;
}

/** Converts `world_m`, which is modified, to plate coordinates. `rotation`: quaternion x, y, z, w of the plate. */
function onPlate(world_m: Vector3, position_m: readonly number[], rotation: readonly number[]): Vector3 {
  return world_m
    .sub(new Vector3().fromArray(position_m))
    .applyQuaternion(new Quaternion().fromArray(rotation).invert());
}

/** Returns the first reach of a recording that Library.replay() has accepted. Throws if the recording has no
 *  reach, or the reach no sample with a position. */
export function readReach(recording: string, name: string): RecordedReach {
  const config = JSON.parse(/^# config (.*)$/m.exec(recording)?.[1] ?? "{}"),
    [header = [], ...rows] = recording
      .split("\n")
      .filter((line) => line !== "" && !line.startsWith("#"))
      .map((line) => line.split(","));
  const number = (cells: readonly string[], column: string): number => {
    const text = cells[header.indexOf(column)];
    return text ? Number(text) : NaN;
  };
  const accepted = rows.filter((cells) => number(cells, "result") === 0),
    first = accepted.findIndex(([call]) => call === "begin"),
    count = accepted.slice(first + 1).findIndex(([call = ""]) => ["begin", "end", "cancel"].includes(call)),
    begin = accepted[first],
    updates = accepted.slice(first + 1, count < 0 ? undefined : first + 1 + count),
    samples: Trace = [];
  for (const cells of begin ? updates.filter(([call]) => call === "update").slice(0, maxTrace) : []) {
    const flags = number(cells, "sample_flags"),
      numbers = (...names: string[]) => names.map((column) => number(cells, column));
    if (!begin || !(flags & (HRT_SAMPLE_PLATE_POSITION | HRT_SAMPLE_WORLD_POSITION))) continue;
    let tip = new Vector3().fromArray(numbers("sample_x_m", "sample_y_m", "sample_z_m"));
    const rotation = numbers("plate_qx", "plate_qy", "plate_qz", "plate_qw");
    if (flags & HRT_SAMPLE_PLATE_POSE) tip = onPlate(tip, numbers("plate_x_m", "plate_y_m", "plate_z_m"), rotation);
    else if (flags & HRT_SAMPLE_WORLD_POSITION) tip = onPlate(tip, config.plate_position_m, config.plate_rotation);
    const moving = number(cells, "bearing_deg") !== 0;
    samples.push({
      time_ms: (number(cells, "time_ns") - number(updates[0]!, "time_ns")) / 1e6,
      finger: {
        right_m: tip.x - number(begin, "start_right_m") + start.right_m,
        away_m: -tip.z - number(begin, "start_away_m") + start.away_m,
      },
      felt: { right_m: NaN, away_m: NaN }, // recordings do not contain perceived positions
      plate_deg: number(cells, "plate_orientation_deg"),
      finger_deg: moving ? number(cells, "bearing_deg") : NaN,
      felt_deg: moving ? number(cells, "perceived_direction_deg") : NaN,
      weight: number(cells, "tactile_weight"),
      weight_sd: number(cells, "tactile_weight_sd"),
    });
  }
  if (!begin || samples.length === 0)
    throw new Error(
      "the recording has no reach with positions on the plate; record samples with HRT_SAMPLE_PLATE_POSITION or HRT_SAMPLE_WORLD_POSITION",
    );
  const real_m = number(begin, "real_distance_m"),
    real_deg = number(begin, "real_direction_deg"),
    virtual_deg = number(begin, "virtual_direction_deg");
  return { name, course: { start, real_deg, real_m, virtual_deg, virtual_m: real_m }, samples };
}
