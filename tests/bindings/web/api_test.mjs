// The package from JavaScript: everything that index.d.ts names, and what hosts get wrong.
//   usage: node --expose-gc api_test.mjs FOLDER_OF_THE_PACKAGE DESK_GLTF GOLDEN_RECORDING GOLDEN_HASH
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const [, , folder, deskGltf, goldenRecording, goldenHash] = process.argv;
const hrt = await import(pathToFileURL(`${folder}/index.mjs`));
const library = await hrt.load();

const ms = 1_000_000;

function newSession(config) {
  const session = library.createSession(config);
  const real = session.addTarget({ role: hrt.HRT_TARGET_REAL, name: "cylinder", direction_deg: -5 });
  const virtual = session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, name: "cup", direction_deg: 5 });
  return { session, real, virtual };
}

function throws(run, codeName, part) {
  assert.throws(run, (error) => {
    assert.ok(error instanceof hrt.HapticRetargetingError, String(error));
    assert.equal(error.codeName, codeName);
    assert.equal(error.code, hrt[codeName]);
    assert.ok(error.message.includes(part), `"${error.message}" does not mention "${part}"`);
    return true;
  });
}

function slide(session, frames) {
  session.sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
  for (let i = 0; i < frames; ++i) {
    session.sample.time_ns = i * 11 * ms;
    session.sample.finger_position_m[2] = 0.05 - (i * 0.1) / frames;
    session.update();
  }
}

test("versions agree", async () => {
  const { major, minor, patch } = library.version;
  assert.deepEqual([major, minor, patch], [hrt.HRT_VERSION_MAJOR, hrt.HRT_VERSION_MINOR, hrt.HRT_VERSION_PATCH]);
  assert.equal(JSON.parse(await readFile(`${folder}/package.json`, "utf8")).version, `${major}.${minor}.${patch}`);
});

test("the module exports every function of the headers", async () => {
  const module = new WebAssembly.Module(await readFile(`${folder}/haptic_retargeting.wasm`));
  const exported = WebAssembly.Module.exports(module).map((e) => e.name).filter((name) => name.startsWith("hrt_"));
  assert.deepEqual(exported.sort(), [...hrt.functions].sort());
});

test("a module can be loaded from bytes, from a module, and twice", async () => {
  const bytes = await readFile(`${folder}/haptic_retargeting.wasm`);
  for (const source of [bytes, new WebAssembly.Module(bytes), pathToFileURL(`${folder}/haptic_retargeting.wasm`)]) {
    const other = await hrt.load(source);
    const session = other.createSession();
    assert.equal(session.config.horizon, 3);
    session.destroy();
  }
});

test("a configuration has its defaults, and changes", () => {
  const { session } = newSession({ plate_latency_ns: 30 * ms, start_position_m: [0, 0, 0.06] });
  assert.equal(session.config.plate_latency_ns, 30_000_000n);
  assert.equal(session.config.tactile_weight, 0.2);
  assert.equal(session.config.person_covariance.length, 45);
  session.configure({ tactile_weight: 0.25 });
  assert.equal(session.config.tactile_weight, 0.25);
  assert.deepEqual(session.config.start_position_m, [0, 0, 0.06]);
  session.destroy();
});

test("targets are found, changed, listed and removed", () => {
  const { session, real, virtual } = newSession();
  assert.deepEqual(session.targets(), [real, virtual]);
  assert.deepEqual(session.targets(hrt.HRT_TARGET_VIRTUAL), [virtual]);
  assert.equal(session.findTarget("cup"), virtual);
  session.setTarget(virtual, { direction_deg: 7, name: "Schüssel" });
  assert.equal(session.target(virtual).direction_deg, 7);
  assert.equal(session.findTarget("Schüssel"), virtual);
  throws(() => session.findTarget("cup"), "HRT_ERROR_NOT_FOUND", "cup");
  session.removeTarget(virtual);
  throws(() => session.target(virtual), "HRT_ERROR_INVALID_HANDLE", "hrt_target_get");
  session.destroy();
  throws(() => session.targets(), "HRT_ERROR_INVALID_HANDLE", "session");
});

test("authority is computed before a reach", () => {
  const { session, real, virtual } = newSession({ tactile_weight: 0.15 });
  const authority = session.authority(real, virtual);
  assert.equal(authority.reachable, 1);
  assert.ok(Math.abs(authority.gap_deg - 10) < 1e-12);
  assert.deepEqual(session.bestAuthority(virtual), authority);
  session.destroy();
});

test("a reach is retargeted and cancelled, and targets are assigned", () => {
  const { session, real, virtual } = newSession();
  assert.equal(session.state, hrt.HRT_STATE_READY);
  session.beginReach(real, virtual, undefined, true);
  session.setTarget(virtual, { direction_deg: 7 });
  session.retargetReach(real, virtual);
  throws(() => session.retargetReach(virtual, virtual), "HRT_ERROR_OUT_OF_RANGE", "real_target");
  assert.equal(session.state, hrt.HRT_STATE_REACHING);
  session.cancelReach();
  assert.equal(session.state, hrt.HRT_STATE_READY);
  const [assigned] = session.assign([virtual], [real], true);
  assert.deepEqual(assigned, session.authority(real, virtual));
  session.destroy();
});

test("a reach turns the plate, is recorded, and replays to the same bits", () => {
  const { session, real, virtual } = newSession();
  session.startRecording();
  session.beginReach(real, virtual, 10);
  slide(session, 270);
  assert.ok(session.command.plate_orientation_deg > 10);
  assert.equal(session.command.step, 27);
  const summary = session.endReach();
  assert.equal(summary.samples, 270n);
  const recording = session.stopRecording();
  const report = library.replay(recording);
  assert.deepEqual([report.complete, report.rows, report.first_different_line], [1, 272n, 0n]);
  throws(() => session.stopRecording(), "HRT_ERROR_WRONG_STATE", "nothing is being recorded");
  throws(() => library.replay("time,x\n"), "HRT_ERROR_BAD_FORMAT", "does not begin");
  session.destroy();
});

test("a recording of more calls than wait at a time loses none", () => {
  const { session, real, virtual } = newSession();
  session.startRecording();
  session.beginReach(real, virtual);
  slide(session, 20_000);
  session.endReach();
  assert.equal(library.replay(session.stopRecording()).rows, 20_002n);
  session.destroy();
});

test("the golden recording gives the golden hash", async () => {
  const report = library.replay(await readFile(goldenRecording, "utf8"));
  assert.deepEqual([report.complete, report.first_different_line], [1, 0n]);
  assert.equal(report.hash, BigInt(goldenHash));
});

test("samples hold what they are given", () => {
  const { session } = newSession();
  const { sample } = session;
  for (const time of [0, 1, -1, 2 ** 32, -(2 ** 32) - 1, 1e15 + 1, Number.MAX_SAFE_INTEGER, Number.MIN_SAFE_INTEGER]) {
    sample.time_ns = time;
    assert.equal(sample.time_ns, time);
  }
  sample.time_ns = 1.5e6 + 0.25;
  assert.equal(sample.time_ns, 1_500_000);
  assert.throws(() => { sample.time_ns = NaN; }, RangeError);
  assert.throws(() => { sample.time_ns = 2 ** 60; }, RangeError);
  assert.throws(() => { sample.flags = -1; }, RangeError);
  session.destroy();
});

test("bad arguments are refused by name", () => {
  assert.throws(() => library.createSession({ horizont: 3 }), /no field horizont; it has horizon,/);
  assert.throws(() => library.createSession({ struct_size: 3 }), TypeError);
  assert.throws(() => library.createSession({ horizon: 2.5 }), /horizon is 2.5; a whole number/);
  assert.throws(() => library.createSession({ horizon: -1 }), /horizon is -1/);
  assert.throws(() => library.createSession({ tactile_weight: "0.2" }), /tactile_weight is 0.2; a number is needed/);
  assert.throws(() => library.createSession({ start_position_m: [1, 2] }), /start_position_m is not an array of 3/);
  throws(() => library.createSession({ horizon: 51 }), "HRT_ERROR_OUT_OF_RANGE", "horizon is 51; allowed: 1 to 50");
  throws(() => library.createSession({ tactile_weight: NaN }), "HRT_ERROR_OUT_OF_RANGE", "tactile_weight");
  const { session, real, virtual } = newSession();
  assert.throws(() => session.addTarget({ name: "ü".repeat(32) }), /64 bytes in UTF-8; up to 63/);
  throws(() => session.addTarget({ name: "cup" }), "HRT_ERROR_NAME_TAKEN", "cup");
  throws(() => session.update(), "HRT_ERROR_WRONG_STATE", "no reach is under way");
  throws(() => session.beginReach(virtual, real), "HRT_ERROR_OUT_OF_RANGE", "is a virtual one");
  session.beginReach(real, virtual);
  session.sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
  session.sample.finger_position_m[0] = NaN;
  throws(() => session.update(), "HRT_ERROR_OUT_OF_RANGE", "finger_position_m");
  session.destroy();
});

test("profiles are kept and loaded", () => {
  const { session } = newSession({ tactile_weight: 0.2 });
  const profile = session.profile;
  assert.equal(JSON.parse(profile).tactile_weight, 0.2);
  const other = library.createSession();
  other.loadProfile(profile);
  assert.equal(other.config.tactile_weight, 0.2);
  throws(() => other.loadProfile("{"), "HRT_ERROR_BAD_FORMAT", "JSON");
  session.destroy();
  other.destroy();
});

// A person of the model at rest: the finger settles where w T + (1 - w) P is the goal, with a little noise.
test("a calibration finds the share of touch", () => {
  const session = library.createSession();
  const calibration = session.createCalibration({ goal_direction_deg: 0 });
  throws(() => calibration.solve(), "HRT_ERROR_INSUFFICIENT_DATA", "10");
  const weight = 0.2;
  let seed = 1;
  const noise = () => (seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5;
  const { sample } = calibration;
  for (let trial = 0; trial < 15; ++trial) {
    const plate = [-60, -30, 0, 30, 60][trial % 5];
    let direction = 0, perceived = 0, x = 0, z = 0.05;
    calibration.beginTrial(plate);
    sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
    for (let i = 0; i < 360; ++i) {
      sample.time_ns = i * 10 * ms;
      if (i >= 60) {
        if (i % 10 === 0) {
          perceived = weight * plate + (1 - weight) * direction;
          direction += -0.7 * perceived + noise();
        }
        x -= (0.1 / 300) * Math.sin((direction * Math.PI) / 180);
        z -= (0.1 / 300) * Math.cos((direction * Math.PI) / 180);
      }
      sample.finger_position_m[0] = x + 0.0002 * noise();
      sample.finger_position_m[2] = z + 0.0002 * noise();
      calibration.addSample();
    }
    calibration.endTrial();
  }
  const result = calibration.solve();
  assert.equal(result.trials_used, 15);
  assert.equal(result.tactile_weight.known, 1);
  assert.ok(Math.abs(result.tactile_weight.value - weight) < 0.02, `${result.tactile_weight.value}`);
  session.applyCalibration(result);
  assert.equal(session.config.tactile_weight, result.tactile_weight.value);
  calibration.destroy();
  session.destroy();
});

test("a scene is registered", async () => {
  const scene = library.loadScene(await readFile(deskGltf), "desk.gltf");
  assert.equal(scene.info.plate_radius_m, 0.075);
  assert.deepEqual(scene.targets.map((target) => target.name), ["cylinder", "bottle", "goblet", "pawn"]);
  const session = library.createSession();
  const ids = scene.register(session);
  assert.equal(session.findTarget("pawn"), ids[3]);
  scene.destroy();
  throws(() => scene.info, "HRT_ERROR_INVALID_HANDLE", "scene");
  throws(() => library.loadScene(new Uint8Array([1, 2]), "bad.gltf"), "HRT_ERROR_BAD_FORMAT", "bad.gltf");
  session.destroy();
});

test("views stay true when the memory grows", () => {
  const { session, real, virtual } = newSession();
  session.sample.finger_position_m[1] = 0.25;
  const before = session.sample.finger_position_m.buffer;
  const others = Array.from({ length: 12 }, () => library.createSession());
  others.forEach((other) => other.startRecording());  // a few MB each
  assert.notEqual(session.sample.finger_position_m.buffer, before);
  assert.equal(session.sample.finger_position_m[1], 0.25);
  session.sample.finger_position_m[1] = 0;
  session.beginReach(real, virtual);
  slide(session, 30);
  assert.equal(session.endReach().samples, 30n);
  [session, ...others].forEach((each) => each.destroy());
});

test("a frame makes no objects, and the module's memory stays", () => {
  const { session, real, virtual } = newSession();
  session.beginReach(real, virtual);
  const frames = (count, from) => {
    const { sample, command } = session;
    let sum = 0;
    for (let i = 0; i < count; ++i) {
      sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
      sample.time_ns = (from + i) * 11 * ms;
      sample.finger_position_m[2] = 0.05 - (i % 100) * 0.001;
      session.update();
      sum += command.plate_orientation_deg + command.flags;
    }
    return sum;
  };
  frames(200_000, 0);  // until it is compiled
  const pages = session.sample.finger_position_m.buffer;
  globalThis.gc();
  const before = process.memoryUsage().heapUsed;
  frames(100_000, 200_000);
  const bytes = (process.memoryUsage().heapUsed - before) / 100_000;
  assert.ok(bytes < 48, `${bytes} bytes a frame`);  // a boxed number or two at most, and what measuring takes
  assert.equal(session.sample.finger_position_m.buffer, pages);
  session.destroy();
});
