// Reads a scene that the visitor opens: plate and targets of a glTF file, by the plugin's loader, and the plate
// orientation that sustains each gap, for several tactile weights.
import * as hrt from "haptic-retargeting";
import { bearing_deg, type Course, length_m, type Place, radius_m } from "../geometry";
import { motionBound_deg } from "../guided_reach";
import type { SceneMeshes } from "../stage/meshes";

/** Tactile weights for which plate orientations are computed: the columns of the table in index.html. */
const weights = [0.1, 0.15, 0.2, 0.25, 0.3] as const;

export interface SceneTarget {
  readonly name: string;
  readonly real: boolean;
  /** Position after scaling by VisitorScene.scale. */
  readonly drawn: Place;
}

/** A virtual target with the real target that is assigned to it. */
export interface ScenePair {
  readonly virtual: string;
  readonly real: string;
  readonly gap_deg: number;
  /** Start and targets in the size of the file, without VisitorScene.scale. */
  readonly course: Course;
  /** Plate orientation that sustains the gap, for each of `weights`; NaN: no orientation does. */
  readonly plates_deg: readonly number[];
}

export interface VisitorScene {
  readonly name: string;
  readonly plateRadius_m: number;
  /** Radius of the page's plate divided by that of the file's plate. */
  readonly scale: number;
  /** Meshes of the file. Null: they have not been read; if that has failed, `meshProblem` is the reason. */
  meshes: SceneMeshes | null;
  meshProblem: string;
  readonly plate: { readonly position_m: readonly number[]; readonly rotation: readonly number[] };
  /** Start after scaling by `scale`. */
  readonly start: Place;
  readonly targets: readonly SceneTarget[];
  readonly pairs: readonly ScenePair[];
}

/** Reads plate, targets and pairs of a glTF scene, without its meshes. Throws the error of the plugin's loader. */
export function readScene(library: hrt.Library, bytes: ArrayBuffer, name: string): VisitorScene {
  const scene = library.loadScene(bytes, name);
  const session = library.createSession({ guidance: hrt.HRT_GUIDANCE_ARRIVAL, motion_bound_deg: motionBound_deg });
  try {
    const { info, targets } = scene,
      ids = scene.register(session),
      scale = radius_m / info.plate_radius_m;
    const onPlate = ([x = 0, , z = 0]: readonly number[], by = 1): Place => ({ right_m: by * x, away_m: -by * z });
    const start = onPlate(info.start_position_m);
    const course = (real: Place, virtual: Place): Course => ({
      start,
      real_deg: bearing_deg(start, real),
      real_m: length_m(start, real),
      virtual_deg: bearing_deg(start, virtual),
      virtual_m: length_m(start, virtual),
    });
    return {
      name,
      plateRadius_m: info.plate_radius_m,
      scale,
      meshes: null,
      meshProblem: "",
      plate: { position_m: info.plate_position_m, rotation: info.plate_rotation },
      start: onPlate(info.start_position_m, scale),
      targets: targets.map((target) => ({
        name: target.name,
        real: target.role === hrt.HRT_TARGET_REAL,
        drawn: onPlate(target.position_m, scale),
      })),
      pairs: targets.flatMap((target, i) => {
        const real = targets[target.served_by];
        if (!real) return [];
        const held = heldBy(session, ids[target.served_by]!, ids[i]!),
          leads = course(onPlate(real.position_m), onPlate(target.position_m));
        return [{ virtual: target.name, real: real.name, course: leads, ...held }];
      }),
    };
  } finally {
    session.destroy();
    scene.destroy();
  }
}

function heldBy(session: hrt.Session, real: hrt.TargetId, virtual: hrt.TargetId) {
  let gap_deg = 0;
  const plates_deg = weights.map((tactile_weight) => {
    session.configure({ tactile_weight });
    const gap = session.gap(real, virtual);
    ({ gap_deg } = gap);
    return gap.reachable ? gap.plate_orientation_deg : NaN;
  });
  return { gap_deg, plates_deg };
}
