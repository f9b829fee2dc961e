// The reach that every host runs (plugin/bindings/README.md), for a page and for node.

export function runReach(hrt, library, recording) {
  const session = library.createSession({
    horizon: 20,
    guidance: hrt.HRT_GUIDANCE_ARRIVAL,
    adaptation: hrt.HRT_ADAPTATION_REACH,
    plate_max_speed_deg_s: 200,
    plate_max_acceleration_deg_s2: 20000,
    plate_latency_ns: 30_000_000,
    plate_lower_stop_deg: -360,
    plate_upper_stop_deg: 360,
  });
  const cylinder = session.addTarget({ role: hrt.HRT_TARGET_REAL, name: "cylinder", direction_deg: -5 });
  const cup = session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, name: "cup", direction_deg: 5 });
  session.beginReach(cylinder, cup);

  const { sample, command } = session;
  let hash = 0xcbf29ce484222325n;
  for (const row of updates(recording)) {
    sample.time_ns = Number(row.time_ns);
    sample.flags = Number(row.sample_flags);
    sample.finger_position_m[0] = Number(row.sample_x_m);
    sample.finger_position_m[1] = Number(row.sample_y_m);
    sample.finger_position_m[2] = Number(row.sample_z_m);
    sample.plate_orientation_deg = Number(row.measured_plate_deg);
    session.update();
    hash = hashed(hash, command);
  }
  const summary = session.endReach();
  session.destroy();
  return { hash: `0x${hash.toString(16).padStart(16, "0")}`, summary };
}

// The rows "update", each as an object; an empty cell is "", of which Number() makes 0.
function* updates(recording) {
  const [header, ...rows] = recording.split("\n").filter((line) => line !== "" && !line.startsWith("#"));
  const columns = header.split(",");
  for (const row of rows) {
    const cells = row.split(",");
    if (cells[0] === "update") yield Object.fromEntries(columns.map((name, i) => [name, cells[i]]));
  }
}

// FNV-1a of HRT_HASHED_FIELDS (study.h).
function hashed(hash, command) {
  const words = new DataView(new ArrayBuffer(112));
  words.setBigUint64(0, BigInt(command.flags), true);
  words.setBigInt64(8, BigInt(command.step), true);
  [command.plate_orientation_deg, command.finger_direction_deg, command.perceived_direction_deg,
   command.aimed_direction_deg, command.distance_to_go_m, command.tactile_weight, command.tactile_weight_sd,
   command.time_to_go_s, command.felt_error_deg, command.predicted_miss_deg, command.misfit, command.miss_sd_deg]
    .forEach((value, i) => words.setFloat64(16 + 8 * i, value, true));
  for (let i = 0; i < words.byteLength; ++i) {
    hash = BigInt.asUintN(64, (hash ^ BigInt(words.getUint8(i))) * 0x100000001b3n);
  }
  return hash;
}
