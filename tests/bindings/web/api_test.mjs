// Tests the package from JavaScript: the interface in index.d.ts, and invalid arguments.
//   usage: node --expose-gc api_test.mjs FOLDER_OF_THE_PACKAGE DESK_GLTF GOLDEN_RECORDING GOLDEN_HASH
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { inspect } from "node:util";

const [, , folder, deskGltf, goldenRecording, goldenHash] = process.argv;
const hrt = await import(pathToFileURL(`${folder}/node.mjs`));
const library = await hrt.load();

const ms = 1_000_000;

function newSession(config) {
  const session = library.createSession(config);
  const real = session.addTarget({ role: hrt.HRT_TARGET_REAL, name: "cylinder", direction_deg: -5 });
  const virtual = session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, name: "cup", direction_deg: 5 });
  return { session, real, virtual };
}

function sessionTest(name, run, config) {
  test(name, () => {
    const made = newSession(config);
    run(made);
    made.session.destroy();
  });
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

// The first test, because tests that store other types in fields for numbers make the engine allocate more.
sessionTest("a frame allocates no objects", ({ session, real, virtual }) => {
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
  frames(200_000, 0);  // until the engine has compiled the code
  globalThis.gc();
  const before = process.memoryUsage().heapUsed;
  frames(100_000, 200_000);
  const bytes = (process.memoryUsage().heapUsed - before) / 100_000;
  assert.ok(bytes < 48, `${bytes} bytes a frame`);  // at most two boxed numbers, and the measurement
});

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

sessionTest("a configuration has its defaults, and changes", ({ session }) => {
  assert.equal(session.config.plate_latency_ns, 30_000_000n);
  assert.equal(session.config.tactile_weight, 0.2);
  assert.equal(session.config.person_covariance.length, 55);
  session.configure({ tactile_weight: 0.25 });
  assert.equal(session.config.tactile_weight, 0.25);
  assert.deepEqual(session.config.start_position_m, [0, 0, 0.06]);
}, { plate_latency_ns: 30 * ms, start_position_m: [0, 0, 0.06] });

sessionTest("targets are found, changed, listed and removed", ({ session, real, virtual }) => {
  assert.deepEqual(session.targets(), [real, virtual]);
  assert.deepEqual(session.targets(hrt.HRT_TARGET_VIRTUAL), [virtual]);
  assert.equal(session.findTarget("cup"), virtual);
  session.setTarget(virtual, { direction_deg: 7, name: "Schüssel" });
  assert.equal(session.target(virtual).direction_deg, 7);
  assert.equal(session.findTarget("Schüssel"), virtual);
  assert.throws(() => session.findTarget("cup"), RangeError);
  session.removeTarget(virtual);
  throws(() => session.target(virtual), "HRT_ERROR_INVALID_HANDLE", "hrt_target_get");
});

test("a destroyed object is refused and does not change another session", () => {
  const { session, real, virtual } = newSession();
  session.beginReach(real, virtual);
  const { sample } = session;
  session.destroy();
  throws(() => session.targets(), "HRT_ERROR_INVALID_HANDLE", "session");
  throws(() => session.update(), "HRT_ERROR_INVALID_HANDLE", "session has been destroyed");
  session.destroy();  // no effect
  const other = library.createSession();
  assert.throws(() => { sample.time_ns = 5; }, TypeError);
  assert.throws(() => session.setFinger({ x: 1, y: 1, z: 1 }, 1), TypeError);
  sample.finger_position_m[0] = 9;
  assert.equal(other.sample.time_ns, 0);
  assert.equal(other.sample.finger_position_m[0], 0);
  other.destroy();
});

test("an object declared by `using` is destroyed at the end of its block", async () => {
  const dispose = Symbol.dispose ?? Symbol.for("Symbol.dispose"), scene = library.loadScene(await readFile(deskGltf), "desk.gltf");
  const { session, virtual } = newSession(), person = library.createPerson(1);
  for (const [object, use] of [[scene, () => scene.info], [person, () => person.begin(session, virtual)], [session, () => session.state]]) {
    use();
    object[dispose]();
    throws(use, "HRT_ERROR_INVALID_HANDLE", "");
  }
});

sessionTest("objects print and serialise", ({ session, real, virtual }) => {
  session.beginReach(real, virtual);
  slide(session, 30);
  assert.match(inspect(session.command), /^Command \{\s+flags: \d+,\s+plate_orientation_deg: -?\d/);
  assert.match(inspect(session), /sample: Sample \{[^]*finger_position_m: Float64Array\(3\) \[/);
  assert.deepEqual(JSON.parse(JSON.stringify(session.command)), { ...session.command });
  assert.deepEqual(JSON.parse(JSON.stringify(session.sample)).finger_position_m, [...session.sample.finger_position_m]);
  const summary = session.endReach();
  assert.equal(JSON.parse(JSON.stringify({ summary })).summary.samples, 30);
  assert.deepEqual(Object.keys(structuredClone(summary)), Object.keys(summary));
  assert.deepEqual(JSON.parse(JSON.stringify(session.gap(real, virtual))), { ...session.gap(real, virtual) });
  session.configure(JSON.parse(JSON.stringify(session.config)));
});

sessionTest("fingertip and plate are set from poses", ({ session, real, virtual }) => {
  const { sample } = session;
  // The mount is rotated by 90 degrees to the left about +Y: its right (+X) is the world's -Z.
  const half = Math.sqrt(0.5), turned = { x: 0, y: half, z: 0, w: half }, mount = { x: 0.5, y: 0.75, z: -0.25 };
  for (const pose of [{ position: mount, quaternion: turned }, { transform: { position: mount, orientation: turned } }]) {
    session.setPlate(pose);
    assert.deepEqual([session.config.plate_position_m, session.config.plate_rotation], [[0.5, 0.75, -0.25], [0, half, 0, half]]);
  }
  session.beginReach(real, virtual);
  const position = { x: 0.55, y: 0.75, z: -0.25 };
  for (const [pose, rotated] of [[{ transform: { position } }], [{ position }], [position], [{ position, orientation: turned }, true],
                                 [{ transform: { position, orientation: turned } }, true], [{ position, quaternion: turned }, true]]) {
    session.setFinger(pose, 12.5);
    const flags = hrt.HRT_SAMPLE_WORLD_POSITION | (rotated ? hrt.HRT_SAMPLE_JOINT_ROTATION : 0);
    assert.deepEqual([sample.time_ns, sample.flags], [12_500_000, flags]);
    assert.deepEqual([...sample.finger_position_m], [0.55, 0.75, -0.25]);
    if (rotated) assert.deepEqual([...sample.joint_rotation], [0, half, 0, half]);
    session.update();
  }
  // The plate's direction towards the user is the world's +X: the finger is at the start, 10 cm from the target.
  assert.ok(Math.abs(session.command.distance_to_go_m - 0.1) < 0.001, `${session.command.distance_to_go_m}`);
  for (const lost of [null, undefined, { x: NaN, y: 0, z: 0 }]) {
    session.setFinger(lost, 20);
    assert.equal(sample.flags, 0);
  }
  session.update();
  for (const time of [NaN, undefined, Infinity]) {
    assert.throws(() => session.setFinger({ x: 0, y: 0, z: 0 }, time), /time_ms is (NaN|undefined|Infinity); a finite number is needed/);
  }
  assert.throws(() => session.setFinger({}, 30), /no transform.position, no position, and no x, y, z/);
  session.cancelReach();
  for (const bad of [undefined, mount, { position: { ...mount, x: NaN }, quaternion: turned }]) {
    assert.throws(() => session.setPlate(bad), /the plate's pose lacks/);
  }
  throws(() => session.setPlate({ position: mount, quaternion: { ...turned, w: 2 } }), "HRT_ERROR_OUT_OF_RANGE", "plate_rotation");
});

sessionTest("setPlate ends a registration", ({ session }) => {
  session.setPlate({ position: { x: 0, y: 0, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } });
  assert.equal(session.config.flags, hrt.HRT_SESSION_PLATE_WAITS);
}, { flags: hrt.HRT_SESSION_REGISTERED | hrt.HRT_SESSION_PLATE_WAITS });

test("a file is not fetched without node.mjs", async () => {
  const web = await import(pathToFileURL(`${folder}/index.mjs`));
  await assert.rejects(web.load(), /a file, which a page cannot fetch/);
  assert.equal(web.HapticRetargetingError, hrt.HapticRetargetingError);
});

sessionTest("a session has a state, and assigns targets", ({ session, real, virtual }) => {
  assert.equal(session.state, hrt.HRT_STATE_READY);
  session.beginReach(real, virtual, undefined, true);
  assert.equal(session.state, hrt.HRT_STATE_REACHING);
  session.cancelReach();
  const [assigned] = session.assign([virtual], [real], true);
  assert.deepEqual(assigned, session.gap(real, virtual));
});

sessionTest("a reach turns the plate, is recorded, and replays to the same bits", ({ session, real, virtual }) => {
  session.startRecording();
  session.beginReach(real, virtual, 10);
  slide(session, 270);
  assert.ok(session.command.plate_orientation_deg > 10);
  const summary = session.endReach();
  assert.equal(summary.samples, 270n);
  const recording = session.stopRecording();
  const report = library.replay(recording);
  assert.deepEqual([report.complete, report.rows, report.first_different_line], [1, 272n, 0n]);
  throws(() => session.stopRecording(), "HRT_ERROR_WRONG_STATE", "recording");
  throws(() => library.replay("time,x\n"), "HRT_ERROR_BAD_FORMAT", "does not begin");
});

sessionTest("a recording of more calls than its buffer holds loses no calls", ({ session, real, virtual }) => {
  session.startRecording();
  session.beginReach(real, virtual);
  slide(session, 20_000);
  session.endReach();
  assert.equal(library.replay(session.stopRecording()).rows, 20_002n);
});

test("the golden recording gives the golden hash", async () => {
  const report = library.replay(await readFile(goldenRecording, "utf8"));
  assert.deepEqual([report.complete, report.first_different_line], [1, 0n]);
  assert.equal(report.hash, BigInt(goldenHash));
});

function recordedTimes(recording) {
  const rows = recording.split("\n").filter((line) => line !== "" && !line.startsWith("#")).map((line) => line.split(","));
  return rows.filter((cells) => cells[0] === "update").map((cells) => cells[rows[0].indexOf("time_ns")]);
}

sessionTest("samples arrive as they are written, or are refused by name", ({ session, real, virtual }) => {
  const { sample } = session;
  session.startRecording();
  session.beginReach(real, virtual);
  sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
  sample.finger_position_m = [0, 0, 0.05];
  const refuse = (name, value, kind) => {
    const before = sample[name];
    sample[name] = value;
    assert.throws(() => session.update(), (error) => error instanceof kind && error.message.startsWith(name));
    sample[name] = before;
  };
  for (const time of [NaN, 2 ** 60, undefined, "soon"]) refuse("time_ns", time, RangeError);
  for (const flags of [-1, 0.5, 2 ** 32, undefined]) refuse("flags", flags, RangeError);
  for (const position of [[1, 2], undefined, 3]) refuse("finger_position_m", position, TypeError);
  assert.throws(() => { sample.finger_positon_m = [0, 0, 0]; }, /not extensible/);
  const times = [Number.MIN_SAFE_INTEGER, -(2 ** 32) - 1, -1, 0, 1, 2 ** 32, 1e15 + 1, Number.MAX_SAFE_INTEGER];
  for (const time of times) {
    sample.time_ns = time;
    session.update();
  }
  session.cancelReach();
  assert.deepEqual(recordedTimes(session.stopRecording()), times.map(String));
});

sessionTest("bad arguments are refused by name", ({ session, real, virtual }) => {
  assert.throws(() => library.createSession({ horizont: 3 }), /no field horizont; it has control, guidance,/);
  assert.throws(() => library.createSession({ struct_size: 3 }), TypeError);
  assert.throws(() => library.createSession({ horizon: 2.5 }), /horizon is 2.5; a whole number/);
  assert.throws(() => library.createSession({ horizon: -1 }), /horizon is -1/);
  assert.throws(() => library.createSession({ tactile_weight: "0.2" }), /tactile_weight is 0.2; a number is needed/);
  assert.throws(() => library.createSession().addTarget({ name: 5 }), /name is 5; a string is needed/);
  assert.throws(() => library.createSession({ start_position_m: [1, 2] }), /start_position_m is not an array of 3/);
  for (const id of [undefined, "cup", 1.5, -1]) {
    const refused = (name) => new RegExp(`^RangeError: ${name} is ${id}; the id of a target, as addTarget\\(\\) returns it, is needed`);
    assert.throws(() => session.target(id), refused("target"));
    assert.throws(() => session.gap(real, id), refused("virtualTarget"));
    if (id !== undefined) assert.throws(() => session.setTarget(virtual, { served_by: id }), refused("served_by"));
  }
  session.setTarget(virtual, { served_by: real });
  assert.deepEqual([session.target(virtual).served_by, Number.isSafeInteger(real)], [real, true]);
  assert.equal(session.target(Number(JSON.parse(JSON.stringify({ real })).real)).name, "cylinder");
  throws(() => library.createSession({ horizon: 21 }), "HRT_ERROR_OUT_OF_RANGE", "horizon is 21; allowed: 1 to 20");
  throws(() => library.createSession({ tactile_weight: NaN }), "HRT_ERROR_OUT_OF_RANGE", "tactile_weight");
  assert.throws(() => library.createSession().addTarget({ name: "ü".repeat(32) }), /64 bytes in UTF-8; allowed: up to 63/);
});

sessionTest("conditions are kept, and a new person has the defaults", ({ session }) => {
  session.configure({ tactile_weight: 0.3 });
  session.setConditions({ plate: "desk 1", tracker: "Ultraleap", time_s: 1767225600 });
  assert.deepEqual({ ...session.conditions }, { differing: 0, time_s: 0n, plate: "", tracker: "" });
  session.beginSetup(hrt.HRT_SETUP_CALIBRATION, { max_slides: 60 });
  session.cancelSetup();
  session.newPerson();
  assert.equal(session.config.tactile_weight, 0.2);
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

sessionTest("a session continues when the memory grows", ({ session, real, virtual }) => {
  const others = Array.from({ length: 12 }, () => library.createSession());
  others.forEach((other) => other.startRecording());  // a few MB each, together more than the module's initial memory
  session.beginReach(real, virtual);
  slide(session, 30);
  assert.equal(session.endReach().samples, 30n);
  others.forEach((other) => other.destroy());
});
