// The page's modules that need no document, under node: reaches of each kind, and the package for three.js.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { models, reachHash } from "./models.mjs";
import { visitor } from "./visitor.mjs";

const library = await models.load(models.pluginModule);

const settings = (changes = {}) => ({ controller: "ours", gap_deg: 10, tactile_weight: 0.17, pace_s: 1.5, noise_mm: 1.2, plate_deg_s: 400,
                                      person: 1, ...changes });
const near = (value, expected, tolerance, what) =>
  assert.ok(Math.abs(value - expected) <= tolerance, `${what}: ${value}, expected ${expected} within ${tolerance}`);

function watch(changes, count = 1) {
  const reach = new models.SimulatedReach(library, settings(changes)), results = [];
  while (results.length < count) {
    if (results.length > 0) reach.begin();
    reach.finish();
    results.push(reach.result);
  }
  return { results, reach };
}

function reaching() {
  const { hrt } = models, session = library.createSession();
  session.beginReach(session.addTarget({ role: hrt.HRT_TARGET_REAL, direction_deg: -5 }),
                     session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, direction_deg: 5 }));
  return session;
}

// This test must be the first: after the other tests' doubles of hands and frames, the engine allocates more numbers.
test("a frame of a hand allocates no objects", (t) => {
  const plate = new models.HapticPlate(), position = { x: 0, y: 0.002, z: 0.05 }, pose = { transform: { position } };
  const hand = new Map([["index-finger-tip", 1]]), frame = { getJointPose: () => pose };
  let time_ms = 0;
  const session = reaching(), reach = new models.HandReach(session, plate);
  const run = (count) => {
    for (let i = 0; i < count; ++i) {
      time_ms += 11;
      reach.updateFromHand(time_ms, frame, hand, 0);
    }
  };
  // The smallest of several measurements excludes allocations before the engine has compiled the code.
  let us = Infinity, bytes = Infinity;
  for (let i = 0; i < 8; ++i) {
    globalThis.gc();
    const before = process.memoryUsage().heapUsed, began = performance.now();
    run(20_000);
    us = Math.min(us, (performance.now() - began) / 20);
    bytes = Math.min(bytes, (process.memoryUsage().heapUsed - before) / 20_000);
  }
  t.diagnostic(`${bytes.toFixed(1)} bytes and ${us.toFixed(1)} us a frame`);
  assert.ok(us < 1000, `${us} us a frame`);
  // The engine boxes one or two numbers of 16 bytes each; an object of three numbers takes at least 48 bytes.
  assert.ok(bytes < 48, `${bytes} bytes a frame`);
  session.destroy();
});

test("a reach depends only on its settings and its number", () => {
  const first = watch({ person: 3 }, 2).results, again = watch({ person: 3 }, 2).results;
  assert.deepEqual(first, again);
  assert.notEqual(first[0].toCylinder_mm, first[1].toCylinder_mm);
  assert.notEqual(watch({ person: 4 }).results[0].toCylinder_mm, first[0].toCylinder_mm);
});

// The person steers the perceived direction (1 - w) P + w T, of a hand that moves in the direction P over a plate at T,
// to the direction V of the glass. Over a plate at T = 0, the hand ends at P = V / (1 - w).
test("over a plate that does not turn the hand ends slightly beyond the glass", () => {
  const { results, reach } = watch({ controller: "off", pace_s: 3, gap_deg: 12, tactile_weight: 0.2 }, 20);
  const mean = results.reduce((sum, result) => sum + result.bearingError_deg, 0) / results.length;
  near(mean, 12 / 2 / 0.8 + 12 / 2, 0.8, "mean bearing from the cylinder");
  assert.ok(results.every((result) => result.bearingError_deg > 1.5), "no reach ends at the cylinder");
  assert.ok(reach.trace.every(({ plate_deg }) => plate_deg === 0), "the plate does not turn");
});

test("time, plate speed and noise of the settings are those of the reach", () => {
  const { trace } = watch({ pace_s: 4, plate_deg_s: 50 }).reach, moving = trace.filter(({ finger_deg }) => !Number.isNaN(finger_deg));
  near(moving.at(-1).time_ms - moving[0].time_ms, 4000, 50, "duration");
  near(trace.at(-1).time_ms, 4900, 50, "0.6 s and 0.3 s of rest");
  const speeds = trace.slice(1).map(({ plate_deg }, i) => Math.abs(plate_deg - trace[i].plate_deg) * 90);
  near(Math.max(...speeds), 50, 0.1, "speed of the plate");
  for (const { plate_deg, weight } of trace) assert.ok(Math.abs(plate_deg) <= 90 && weight > 0);
  for (const noise_mm of [0, 3]) {
    const { reach } = watch({ noise_mm }), rows = reach.recording.split("\n"), column = rows.find((row) => row.startsWith("call,")).split(",").indexOf("sample_x_m");
    const rest = rows.filter((row) => row.startsWith("update,")).slice(0, 50).map((row) => 1000 * Number(row.split(",")[column]));
    near(Math.sqrt(rest.reduce((sum, x) => sum + x * x, 0) / 50), noise_mm, 0.3 * noise_mm + 1e-4, "SD of the tracker");
  }
});

test("estimates are kept for another gap and plate, and discarded for another person", () => {
  const { reach, results } = watch({ tactile_weight: 0.25 }, 4);
  assert.equal(reach.apply(settings({ tactile_weight: 0.25, gap_deg: 6, plate_deg_s: 300, noise_mm: 0.5 })), false);
  assert.equal(reach.number, 5);
  near(reach.command.tactile_weight, results[3].weight, 0.02, "the estimated weight");
  assert.equal(reach.apply(settings({ tactile_weight: 0.26, gap_deg: 6 })), true);
  assert.equal(reach.number, 1);
});

function steer(hand, how) {
  hand.begin();
  hand.advance(700);
  const go = visitor({ start: models.start, glass: models.virtualPlace(hand.course), ...how });
  for (let i = 0; hand.phase !== "arrived" && i < 1000; ++i) {
    const { right_m, away_m } = go(hand.felt);
    hand.moveTo(hand.finger.right_m + right_m, hand.finger.away_m + away_m);
    hand.advance(10);
  }
  assert.equal(hand.phase, "arrived");
  return hand.result;
}

for (const delay_ms of [100, 200]) {
  test(`a visitor who sees the dot ${delay_ms} ms late ends at the cylinder, and without the plate at the glass`, () => {
    const led = new models.VisitorReach(library, settings()), plain = new models.VisitorReach(library, settings({ controller: "off" }));
    for (let slide = 0; slide < 5; ++slide) {
      const on = steer(led, { delay_ms });
      assert.ok(on.toCylinder_mm < 8 && on.feltToGlass_mm < 8, JSON.stringify(on));
      const off = steer(plain, { delay_ms });
      assert.ok(off.toGlass_mm < 5 && off.toCylinder_mm > 12, JSON.stringify(off));
    }
    assert.ok(led.command.tactile_weight_sd < 0.06 && Math.abs(led.command.tactile_weight - 0.17) < 0.08, "it has learnt this hand");
    assert.ok(led.ridges > 20, `${led.ridges} ridges`);
  });
}

test("a hand that is not steered ends at the glass, and the dot misses it", () => {
  const { toGlass_mm, feltToGlass_mm, gap_deg } = steer(new models.VisitorReach(library, settings()), { delay_ms: 0, gain: 0 });
  assert.ok(toGlass_mm < 1 && feltToGlass_mm > 12 && gap_deg > 7, `${toGlass_mm} ${feltToGlass_mm} ${gap_deg}`);
});

// By hand: perceived = true + w (plate - true), so a motion at 0 over a plate at 50 degrees is perceived at 50 w.
test("the dot moves in the weighted mean of true direction and plate orientation", () => {
  const hand = new models.VisitorReach(library, settings({ controller: "off", tactile_weight: 0.2, gap_deg: 0 }));
  hand.plateConnected_deg = 50;
  for (let i = 0; i < 20; ++i) {
    hand.moveTo(0, models.start.away_m + 0.003 * i);
    hand.advance(10);
  }
  near(models.bearing_deg(models.start, hand.felt), 10, 1e-6, "felt direction");
  near(models.length_m(models.start, hand.finger), models.length_m(models.start, hand.felt), 1e-12, "as far");
});

test("a hand ignores NaN, arrives at a far position, and restarts after a short slide", () => {
  const hand = new models.VisitorReach(library, settings());
  hand.moveTo(NaN, 1);
  hand.advance(16);
  assert.deepEqual({ ...hand.finger }, { ...models.start });
  hand.end();
  assert.equal(hand.phase, "waiting");
  hand.moveTo(50, -50);
  hand.advance(100);
  assert.equal(hand.phase, "arrived");
  for (const value of Object.values(hand.felt)) assert.ok(Number.isFinite(value));
  hand.begin();
  const back = models.ahead(models.start, 180, 0.01);
  hand.moveTo(back.right_m, back.away_m);
  hand.advance(16);
  hand.end();
  assert.equal(hand.phase, "waiting", "a short slide starts again");
});

test("the plate follows after its latency at its speed", () => {
  const hand = new models.VisitorReach(library, settings({ plate_deg_s: 200 }));
  hand.advance(30);
  assert.equal(hand.plate_deg, 0);
  hand.advance(100);
  near(Math.abs(hand.plate_deg), 20, 1e-9, "100 ms at 200 degrees a second");
  hand.advance(500);
  near(hand.plate_deg, hand.command.plate_orientation_deg, 1, "the plate is at its command");
});

test("an hour of rest is not recorded", () => {
  const hand = new models.VisitorReach(library, settings());
  hand.advance(2000);
  assert.equal(hand.resting, true);
  for (let s = 0; s < 3600; ++s) hand.advance(1000);
  assert.equal(hand.trace.length, 0);
  hand.moveTo(0, models.start.away_m + 0.05);
  hand.advance(500);
  assert.equal(hand.resting, false);
  for (let s = 0; s < 3600; ++s) hand.advance(1000);
  hand.end();
  assert.ok(hand.recording.length < 200_000 && hand.trace.length < 200, `${hand.recording.length} bytes`);
  assert.equal(library.replay(hand.recording).first_different_line, 0n);
});

// The simulated observer has a threshold of 9 degrees, a slope of 3 and no lapses.
test("six answers estimate the threshold with a wide interval, sixty answers precisely", () => {
  let seed = 1;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const after = (answers) => {
    const quest = new models.QuestPlus(2, 12.75);
    for (let i = 0; i < answers; ++i) {
      const gap = quest.next_deg();
      assert.ok(gap >= 2 && gap <= 12.7501, `${gap}`);
      quest.answer(gap, random() < 1 - 0.95 * Math.exp(-((gap / 9) ** 3)));
    }
    return quest.threshold();
  };
  const six = after(6), sixty = after(60);
  assert.ok(six.upper_deg - six.lower_deg > 3 && six.lower_deg < six.deg && six.deg < six.upper_deg, JSON.stringify(six));
  assert.ok(sixty.lower_deg < 9 && 9 < sixty.upper_deg && sixty.upper_deg - sixty.lower_deg < 5, JSON.stringify(sixty));
});

/** Returns the contact covariance after a reach to the cylinder in a headset, over a registered plate. */
function meet(hasCylinder) {
  const plate = new models.HapticPlate(), tip = { x: 0, y: 0, z: 0.05 };
  const hand = new Map([["index-finger-tip", 1]]), eyes = { transform: { orientation: { x: 0, y: 0, z: 0, w: 1 } } };
  const frame = { getJointPose: () => ({ transform: { position: tip } }), getViewerPose: () => eyes };
  const wear = new models.HeadsetReach(library, plate, settings({ controller: "off" }));
  wear.session.configure({ flags: wear.session.config.flags | models.hrt.HRT_SESSION_REGISTERED,
                           plate_covariance: [1e-4, 0, 1e-6, 0, 0, 1e-6] });
  wear.hasCylinder = hasCylinder;
  wear.plateConnected_deg = 0;
  wear.restart();
  const end = models.ahead({ right_m: 0, away_m: 0 }, models.pageCourse(10).real_deg, models.distance_m - 0.0045);
  for (let time_ms = 0; wear.phase !== "arrived" && time_ms < 6000; time_ms += 11) {
    const s = Math.min(1, Math.max(0, (time_ms - 1500) / 1500)), share = s ** 3 * (10 - 15 * s + 6 * s * s);
    Object.assign(tip, { x: share * end.right_m, z: 0.05 - share * end.away_m });
    wear.frame(time_ms, frame, hand, 0);
  }
  assert.equal(wear.phase, "arrived");
  near(wear.result.toCylinder_mm, 4.5, 0.5, "at the cylinder's side");
  wear.apply(settings({ controller: "off", person: 2 }));
  return wear.session.config.contact_covariance;
}

test("contact with the cylinder corrects the registration, and other settings keep it", () => {
  assert.ok(meet(true).some((value) => value > 0));
  assert.deepEqual(meet(false), Array(10).fill(0));
});

// The reach that all hosts run, as frames of a headset. The plate is at the origin, so that no digit is lost.
test("frames of a hand reproduce the golden hash of all hosts", async () => {
  const { runReach } = await import("../../../plugin/bindings/web/examples/reach.mjs");
  const plate = new models.HapticPlate();
  const tracked = { createSession: (config) => {
    const session = library.createSession(config), reach = new models.HandReach(session, plate), hand = new Map([["index-finger-tip", 1]]);
    const given = { finger_position_m: [0, 0, 0] };
    return { addTarget: (target) => session.addTarget(target), beginReach: (...pair) => session.beginReach(...pair), sample: given,
             command: session.command, endReach: () => session.endReach(), destroy: () => session.destroy(),
             update() {
               const [x, y, z] = given.finger_position_m;
               reach.measuredPlate_deg = given.flags & models.hrt.HRT_SAMPLE_PLATE_ORIENTATION ? given.plate_orientation_deg : NaN;
               reach.lifted = (given.flags & models.hrt.HRT_SAMPLE_LIFTED) !== 0;
               const seen = given.flags & models.hrt.HRT_SAMPLE_PLATE_POSITION ? { transform: { position: { x, y, z } } } : null;
               reach.updateFromHand(given.time_ns / 1e6, { getJointPose: () => seen }, hand, 0);
             } };
  } };
  assert.equal(runReach(models.hrt, tracked).hash, (await readFile(reachHash, "utf8")).trim());
});

test("the plate turns counter-clockwise seen from above, within its mount", () => {
  const plate = new models.HapticPlate();
  plate.orientation_deg = 30;
  const mark = plate.children[0].children[2].getWorldPosition(new models.Vector3());
  const expected = models.ahead({ right_m: 0, away_m: 0 }, 30, 0.075);
  near(mark.x, expected.right_m, 1e-12, "to the left");
  near(-mark.z, expected.away_m, 1e-12, "away");
  near(plate.rotation.y, 0, 0, "the mount");
});

test("text on the board is wrapped", () => {
  const fits = (line) => line.length <= 10;
  assert.deepEqual(models.wrapped("rest your fingertip at abcdefghijklmno", fits), ["rest your", "fingertip", "at", "abcdefghijklmno"]);
  assert.deepEqual(models.wrapped("", fits), [""]);
});
