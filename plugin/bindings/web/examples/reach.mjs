// The reach that every host runs (plugin/bindings/README.md), for a page and for node.

export function runReach(hrt, library) {
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

  const { sample, command } = session, { HRT_SAMPLE_PLATE_ORIENTATION, HRT_SAMPLE_PLATE_POSITION, HRT_SAMPLE_LIFTED } = hrt;
  let hash = 0xcbf29ce484222325n, seed = 7;
  const noise = () => {
    seed = seed * 16807 % 2147483647;
    return seed % 1001 - 500;
  };
  for (let i = 1; i <= 170; ++i) {
    const moved = Math.min(Math.max(i - 10, 0), 120), distance_um = Math.floor(moved * moved * (180 - moved) * 25 / 216);
    const lost = i % 40 === 7 || (i > 40 && i <= 52), lifted = i > 65 && i <= 75;
    sample.flags = HRT_SAMPLE_PLATE_ORIENTATION | (lost ? 0 : HRT_SAMPLE_PLATE_POSITION) | (lifted ? HRT_SAMPLE_LIFTED : 0);
    sample.time_ns = 20_000_000 * i + 400 * noise();
    sample.finger_position_m[0] = (Math.floor(distance_um * 87 / 1000) + noise()) / 1e6;
    sample.finger_position_m[1] = lifted ? 0.03 : 0.002;
    sample.finger_position_m[2] = (50_000 - distance_um + noise()) / 1e6;
    sample.plate_orientation_deg = command.plate_orientation_deg;
    if (i > 105 && i <= 108) continue;  // frames that the host drops
    session.update();
    hash = hashed(hash, command);
  }
  const summary = session.endReach();
  session.destroy();
  return { hash: `0x${hash.toString(16).padStart(16, "0")}`, summary };
}

// Continues FNV-1a over HRT_HASHED_FIELDS (recording.h), which are the fields of a command in their order.
function hashed(hash, command) {
  const fields = Object.entries(command), words = new DataView(new ArrayBuffer(8 * fields.length));
  fields.forEach(([name, value], i) => {
    if (name === "flags" || name === "paper_step") words.setBigInt64(8 * i, BigInt(value), true);
    else words.setFloat64(8 * i, value, true);
  });
  for (let i = 0; i < words.byteLength; ++i) {
    hash = BigInt.asUintN(64, (hash ^ BigInt(words.getUint8(i))) * 0x100000001b3n);
  }
  return hash;
}
