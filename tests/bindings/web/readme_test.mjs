// Compiles the README's examples as strict TypeScript with the types of three.js, and runs them, with test doubles of
// a renderer and a headset's frames.
//   usage: node readme_test.mjs PACKAGE README MODULES TYPES FOLDER    MODULES has typescript and three, TYPES the types of three.js
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
for (const [name, block] of Object.entries({ reach, setup, hand })) writeFileSync(join(folder, `${name}.mjs`), block);

test("the examples compile as strict TypeScript", () => {
  writeFileSync(join(folder, "reach.ts"), reach);
  writeFileSync(join(folder, "setup.ts"), setup);
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

test("reach and set-up print what the README shows", async () => {
  const shown = [...text.matchAll(/^```text\n(.*?)^```/gms)].map((found) => found[1]);
  assert.equal(shown.length, 2);
  for (const [i, name] of ["reach", "setup"].entries()) {
    const said = [], { log } = console;
    console.log = (line) => said.push(`${line}\n`);
    await run(name).finally(() => { console.log = log; });
    assert.equal(said.join(""), shown[i]);
  }
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
    [registered, [0, 0, 0], bySession(here)], [registered, [5, 5, 5], byHand(here)],  // the plate is drawn at another position
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
