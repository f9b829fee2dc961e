// Compiles the README's examples as strict TypeScript with the types of three.js, and runs them with test doubles of a renderer, a
// headset's frames and a user.
//
//   node readme_test.mjs PACKAGE README MODULES TYPES FOLDER    MODULES has typescript and three, TYPES the types of three.js
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

const [npm, readme, modules, types, folder] = process.argv.slice(2).map((path) => resolve(path)), text = readFileSync(readme, "utf8");
const blocks = [...text.matchAll(/^```js\n(.*?)^```/gms)].map((found) => found[1]);
assert.equal(blocks.length, 4, "examples of the README");
const [reach, setup, , hand] = blocks;

rmSync(folder, { recursive: true, force: true });
mkdirSync(join(folder, "node_modules/@types"), { recursive: true });
cpSync(npm, join(folder, "node_modules/haptic-retargeting"), { recursive: true });
symlinkSync(join(modules, "three"), join(folder, "node_modules/three"));
for (const name of ["@types/three", "@types/webxr"]) symlinkSync(join(types, name), join(folder, "node_modules", name));
writeFileSync(join(folder, "package.json"), '{ "type": "module" }');
for (const [name, block] of Object.entries({ reach, setup: `import * as hrt from "haptic-retargeting";\n${setup}`, hand })) {
  writeFileSync(join(folder, `${name}.mjs`), block);
}

test("the examples compile as strict TypeScript", () => {
  writeFileSync(join(folder, "reach.ts"), reach);
  writeFileSync(join(folder, "setup.ts"), `import * as hrt from "haptic-retargeting";
import type { WebGLRenderer } from "three";
declare const session: hrt.Session, renderer: WebGLRenderer;
declare function fingertip(frame: XRFrame | undefined): XRJointPose | undefined;
declare function show(text: string, place_m: number[]): void;
declare function turnPlate(orientation_deg: number): void;
${setup}`);
  writeFileSync(join(folder, "hand.ts"), `import type { Session, TargetId } from "haptic-retargeting";
import type { Camera, Scene, WebGLRenderer } from "three";
declare const session: Session, cylinder: TargetId, cup: TargetId, scene: Scene, camera: Camera, renderer: WebGLRenderer;
${hand}`);
  for (const [module, resolution] of [["es2022", "bundler"], ["nodenext", "nodenext"]]) {
    const { status, stdout } = spawnSync(process.execPath, [join(modules, "typescript/bin/tsc"), "--noEmit", "--strict", "--preserveSymlinks",
      "--target", "es2022", "--lib", "es2022,dom,dom.iterable", "--module", module, "--moduleResolution", resolution,
      "reach.ts", "setup.ts", "hand.ts"], { cwd: folder, encoding: "utf8" });
    assert.equal(status, 0, `${resolution}:\n${stdout}`);
  }
});

const run = (name) => import(pathToFileURL(join(folder, `${name}.mjs`)));
const hrt = await import(pathToFileURL(join(folder, "node_modules/haptic-retargeting/node.mjs"))), library = await hrt.load();

test("the reach prints what the README shows", async () => {
  const said = [], { log } = console;
  console.log = (line) => said.push(`${line}\n`);
  await run("reach").finally(() => { console.log = log; });
  assert.equal(said.join(""), /^```text\n(.*?)^```/ms.exec(text)[1]);
  assert.ok(reach.split("\n").length <= 30);
});

// Pose of a plate that is rotated by 20 degrees to the left.
const angle = 20 * Math.PI / 180, cos = Math.cos(angle), sin = Math.sin(angle);
const inWorld = ([x, y, z]) => [0.3 + cos * x + sin * z, 0.75 + y, -0.4 - sin * x + cos * z];

/** Rotation of the finger for the words of an instruction, as a quaternion; to the left is positive. */
const attitudes = { "turned to the left": [0, 0.42, 0, 0.91], "turned to the right": [0, -0.34, 0, 0.94], "leant to the left": [0, 0, 0.3, 0.95],
                    "leant to the right": [0, 0, -0.26, 0.97], steeply: [-0.34, 0, 0, 0.94], "": [0, 0, 0, 1] };

// The simulated user follows the instructions: lifts the finger and touches each shown position. The joint is 8 mm above the skin.
test("the set-up measures the plate and the skin of a user who follows its instructions", async () => {
  const session = library.createSession();
  let place_m = [0, 0, 0], words = "", since = 0, loop, attitude = attitudes[""];
  Object.assign(globalThis, {
    session,
    renderer: { setAnimationLoop: (frame) => { loop = frame; } },
    show: (said, place) => {
      if (said !== words && said.startsWith("Lift")) [since, attitude] = [0, attitudes[Object.keys(attitudes).find((how) => said.includes(how))]];
      [words, place_m] = [said, [...place]];
    },
    turnPlate: () => {},
    fingertip: () => {
      const [x, y, z, w] = attitude.map((part) => part / Math.hypot(...attitude));
      const up = [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)], lift_m = ++since < 20 ? 0.05 : 0;  // of the joint
      const [right, height, near] = inWorld(place_m).map((part, i) => part + 0.008 * up[i]);
      return { transform: { position: { x: right, y: height + lift_m, z: near }, orientation: { x, y, z, w } } };
    },
  });
  await run("setup");
  for (let frame = 0; loop; ++frame) {
    assert.ok(frame < 5000, words);
    loop(11 * frame, {});
  }
  const near = (values, expected) => values.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-6, `${values}`));
  near(session.config.fingertip_offset_m, [0, -0.008, 0]);
  near(session.config.plate_position_m, [0.3, 0.75, -0.4]);
  near(session.config.plate_rotation, [0, Math.sin(angle / 2), 0, Math.cos(angle / 2)]);
  session.destroy();
});

test("with three.js a registered plate and the skin beside the joint are those of the session", async () => {
  const { HandReach, HapticPlate } = await import(pathToFileURL(join(folder, "node_modules/haptic-retargeting/three.mjs")));
  const half = Math.sqrt(0.5), at = (x, y, z) => ({ position: { x, y, z }, orientation: { x: 0, y: half, z: 0, w: half } });
  const frame = (transform) => ({ session: { inputSources: [] }, getJointPose: () => ({ transform }) }), hand = { get: () => ({}) };
  // The joint's axes are rotated to the left by 90 degrees, so that the skin is 14 mm to the left of the joint.
  const toGo_mm = (config, place, update) => {
    const session = library.createSession({ fingertip_offset_m: [0, 0, -0.014], ...config });
    const [real, virtual] = [hrt.HRT_TARGET_REAL, hrt.HRT_TARGET_VIRTUAL].map((role) => session.addTarget({ role, direction_deg: 0 }));
    const plate = new HapticPlate(), reach = new HandReach(session, plate);
    plate.position.fromArray(place);
    session.beginReach(real, virtual);
    for (let i = 0; i < 30; ++i) update(session, reach, 11 * i);
    assert.equal(reach.lost, update.lost ?? true);
    session.destroy();
    return 1000 * session.command.distance_to_go_m;
  };
  const byHand = (joint) => Object.assign((_, reach, time) => reach.updateFromHand(time, frame(joint), hand, {}), { lost: false });
  const bySession = (joint) => (session, _, time) => { session.setFinger(joint, time); session.update(); };
  const registered = { flags: hrt.HRT_SESSION_REGISTERED, plate_position_m: [0, 0.7, -0.3] }, here = at(0.04, 0.7, -0.3);
  const expected = Math.hypot(40 - 14, 50);  // from a position 26 mm to the right of the centre to the target
  for (const [config, place, update] of [
    [registered, [0, 0, 0], bySession(here)], [registered, [5, 5, 5], byHand(here)],  // drawn at another position
    [{}, [0, 0.7, -0.3], byHand(here)], [{ plate_position_m: [5, 5, 5] }, [0, 0.7, -0.3], byHand(here)],
  ]) assert.ok(Math.abs(toGo_mm(config, place, update) - expected) < 0.5, `${toGo_mm(config, place, update)} mm`);
});

test("with three.js a reach of a tracked hand turns the drawn plate, and a lost hand keeps its orientation", async () => {
  const session = library.createSession(), cylinder = session.addTarget({ role: hrt.HRT_TARGET_REAL, direction_deg: -5 });
  const cup = session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, direction_deg: 5 }), tip = {}, space = {}, plates = [];
  let loop, gone_m = 0, seen = true, drawn = 0;
  Object.assign(globalThis, {
    session, cylinder, cup, camera: {}, scene: { add: (plate) => plates.push(plate) },
    renderer: { setAnimationLoop: (frame) => { loop = frame; }, render: () => { ++drawn; }, xr: { getReferenceSpace: () => space } },
  });
  await run("hand");
  const frame = { session: { inputSources: [{ hand: new Map([["index-finger-tip", tip]]) }] },
                  getJointPose: (joint, from) => (joint === tip && from === space && seen ? { transform: { position: { x: 0, y: 0, z: 0.05 - gone_m } } } : null) };
  loop(0, undefined);  // before the headset session
  for (let i = 1; i < 400 && !(session.command.flags & hrt.HRT_COMMAND_ARRIVED); ++i) {
    gone_m = 0.1 * Math.min(1, i / 130);
    seen = i !== 60;
    const before = session.command.plate_orientation_deg;
    loop(11 * i, frame);
    if (!seen) assert.equal(session.command.plate_orientation_deg, before);
    assert.equal(plates[0].orientation_deg, session.command.plate_orientation_deg);
    assert.equal(drawn, i + 1);
  }
  assert.ok(Math.abs(plates[0].orientation_deg) > 5, `${plates[0].orientation_deg}`);
  assert.ok(Math.abs(session.endReach().miss_deg - 5) < 1, "it went straight ahead");
  session.destroy();
});
