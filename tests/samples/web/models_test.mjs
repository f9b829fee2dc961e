// The page's modules that need no document, under node: simulation, reaches of each kind, settings and links.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { models, reachHash } from "./models.mjs";
import { visitor } from "./visitor.mjs";

const library = await models.load(models.pluginModule);
const world = await models.createWorld();

const settings = (changes = {}) => ({ ...models.defaultSettings(), ...changes });
const near = (value, expected, tolerance, what) =>
  assert.ok(Math.abs(value - expected) <= tolerance, `${what}: ${value}, expected ${expected} within ${tolerance}`);

/** Returns the results of `count` successive reaches. */
function watch(changes, count = 1) {
  const reaches = new models.SimulatedReach(library, world, settings(changes)), results = [];
  while (results.length < count) {
    if (results.length > 0) reaches.begin();
    while (reaches.phase !== "arrived") reaches.advance();
    results.push(reaches.result);
  }
  return { results, trace: reaches.trace, watch: reaches };
}
const hits = (results) => results.filter((result) => Math.abs(result.bearingError_deg) <= 1.5).length;

/** Creates a session that is within a reach. */
function reaching() {
  const { hrt } = models, session = library.createSession();
  session.beginReach(session.addTarget({ role: hrt.HRT_TARGET_REAL, direction_deg: -5 }),
                     session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, direction_deg: 5 }));
  return session;
}

// This test must be the first: once the engine has seen other tests' doubles of hands and frames, it allocates more numbers.
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

test("the world computes core's illusion", () => {
  world.set_person(1, 0.2, 1.5);
  near(world.felt_shift_deg(40, 0), 8, 1e-12, "weight times the angle from the motion to the normal");
  near(world.felt_shift_deg(-30, 10), -8, 1e-12, "the angle is the plate orientation minus the direction of the motion");
  near(world.felt_shift_deg(100, 0), -16, 1e-12, "ridges repeat every half turn");
  near(world.max_gap_deg(75), 15, 1e-12, "75 w");
});

test("the plate follows after its latency at its speed", () => {
  world.set_apparatus(0, 200);
  world.begin_hand(0);
  world.command(50);
  const latency = world.plate_latency_ms();
  for (let ms = 0; ms < latency + 100; ++ms) world.advance();
  near(world.plate_deg(), 20, 0.41, "100 ms at 200 degrees a second");
  for (let ms = 0; ms < 400; ++ms) world.advance();
  near(world.plate_deg(), 50, 1e-9, "the plate is at its command");
});

test("a reach depends only on its settings and its number", () => {
  const first = watch({ person: 3 }, 2).results, again = watch({ person: 3 }, 2).results;
  assert.deepEqual(first, again);
  assert.notEqual(first[0].toCylinder_mm, first[1].toCylinder_mm);
  assert.notEqual(watch({ person: 4 }).results[0].toCylinder_mm, first[0].toCylinder_mm);
});

// The person steers the perceived direction (1 - w) P + w T, of a hand that moves in the direction P over a plate at T, to the
// direction V of the glass. Over a plate at T = 0, the hand ends at P = V / (1 - w).
test("over a plate that does not turn the hand ends slightly beyond the glass", () => {
  const { results } = watch({ controller: "off", pace_s: 3, gap_deg: 12, tactile_weight: 0.2 }, 20);
  const mean = results.reduce((sum, result) => sum + result.bearingError_deg, 0) / results.length;
  near(mean, 12 / 2 / 0.8 + 12 / 2, 0.8, "mean bearing from the cylinder");
  assert.equal(hits(results), 0);
  for (const result of results) near(result.plateFastest_deg_s, 0, 0, "a still plate");
});

test("estimates are kept for another gap and plate, and discarded for another person", () => {
  const { watch: reaches, results } = watch({ tactile_weight: 0.25 }, 4);
  const learnt = results[3].weight;
  reaches.apply(settings({ tactile_weight: 0.25, gap_deg: 6, plate_deg_s: 300, noise_mm: 0.5 }));
  assert.equal(reaches.number, 5);
  for (let ms = 0; ms < 20; ++ms) reaches.advance();
  near(reaches.command.tactile_weight, learnt, 0.02, "the estimated weight");
  reaches.apply(settings({ tactile_weight: 0.26, gap_deg: 6 }));
  assert.equal(reaches.number, 1);
});

test("the trace does not exceed its capacity and contains finite numbers", () => {
  const { trace } = watch({ pace_s: 4, plate_deg_s: 50 });
  assert.equal(trace.length, 490);  // 0.6 s at rest, 4 s, 0.3 s at rest
  for (const { plate_deg, weight } of trace) assert.ok(Math.abs(plate_deg) <= 90 && weight > 0);
});

/** Lets a visitor steer the dot to the glass. */
function steer(hand, how, gap_deg = settings().gap_deg) {
  hand.begin(gap_deg);
  hand.advance(700);
  const go = visitor({ start: models.start, glass: models.virtualPlace(models.pageCourse(settings({ gap_deg }))), ...how });
  for (let i = 0; hand.phase !== "arrived" && i < 1000; ++i) {
    const { right_m, away_m } = go(hand.felt.place);
    hand.moveTo(hand.finger.right_m + right_m, hand.finger.away_m + away_m);
    hand.advance(10);
  }
  assert.equal(hand.phase, "arrived");
  return hand.result;
}

for (const delay_ms of [100, 200]) {
  test(`a visitor who sees the dot ${delay_ms} ms late ends at the cylinder, and without the plate at the glass`, () => {
    const led = new models.VisitorReach(library, world, settings()), plain = new models.VisitorReach(library, world, settings({ controller: "off" }));
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
  const { toGlass_mm, feltToGlass_mm, gap_deg } = steer(new models.VisitorReach(library, world, settings()), { delay_ms: 0, gain: 0 });
  assert.ok(toGlass_mm < 1 && feltToGlass_mm > 12 && gap_deg > 7, `${toGlass_mm} ${feltToGlass_mm} ${gap_deg}`);
});

// Derived by hand: perceived = true + w (plate - true), so that 0 over a plate at 50 degrees is perceived as 50 w.
test("the dot moves in the weighted mean of true direction and plate orientation", () => {
  const hand = new models.VisitorReach(library, world, settings({ controller: "off", tactile_weight: 0.2, gap_deg: 0 }));
  hand.plateConnected_deg = 50;
  for (let i = 0; i < 20; ++i) {
    hand.moveTo(0, models.start.away_m + 0.003 * i);
    hand.advance(10);
  }
  near(models.bearing_deg(models.start, hand.felt.place), 10, 1e-6, "felt direction");
  near(models.length_m(models.start, hand.finger), models.length_m(models.start, hand.felt.place), 1e-12, "as far");
});

test("a hand ignores NaN, arrives at a far position, and restarts after a short slide", () => {
  const hand = new models.VisitorReach(library, world, settings());
  hand.moveTo(NaN, 1);
  hand.advance(16);
  assert.deepEqual({ ...hand.finger }, { ...models.start });
  hand.end();
  assert.equal(hand.phase, "waiting");
  hand.moveTo(50, -50);
  hand.advance(100);
  assert.equal(hand.phase, "arrived");
  for (const value of Object.values(hand.felt.place)) assert.ok(Number.isFinite(value));
  hand.begin();
  const back = models.ahead(models.start, 180, 0.01);
  hand.moveTo(back.right_m, back.away_m);
  hand.advance(16);
  hand.end();
  assert.equal(hand.phase, "waiting", "a short slide starts again");
});

test("an hour of rest is not recorded", () => {
  const hand = new models.VisitorReach(library, world, settings());
  hand.advance(2000);
  assert.equal(hand.resting, true);
  const before_ms = world.time_ms();
  for (let s = 0; s < 3600; ++s) hand.advance(1000);
  assert.deepEqual([world.time_ms(), hand.trace.length], [before_ms, 0]);
  hand.moveTo(0, models.start.away_m + 0.05);
  hand.advance(500);
  assert.equal(hand.resting, false);
  for (let s = 0; s < 3600; ++s) hand.advance(1000);
  hand.end();
  assert.ok(hand.recording.length < 200_000 && hand.trace.length < 200, `${hand.recording.length} bytes`);
  assert.equal(library.replay(hand.recording).first_different_line, 0n);
});

// The simulated observer has a threshold of 9 degrees, and answers with the probabilities of the psychometric function.
test("six answers estimate the threshold with a wide interval, sixty answers precisely", () => {
  let seed = 1;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const after = (answers) => {
    world.begin_series(2, 12.75);
    for (let i = 0; i < answers; ++i) {
      const gap = world.next_gap_deg();
      assert.ok(gap >= 2 && gap <= 12.7501, `${gap}`);
      world.answer(gap, random() < 1 - 0.95 * Math.exp(-((gap / 9) ** 3)) ? 1 : 0);
    }
    return { limit: world.limit_deg(), lower: world.limit_lower_deg(), upper: world.limit_upper_deg() };
  };
  const six = after(6), sixty = after(60);
  assert.ok(six.upper - six.lower > 3 && six.lower < six.limit && six.limit < six.upper, JSON.stringify(six));
  assert.ok(sixty.lower < 9 && 9 < sixty.upper && sixty.upper - sixty.lower < 5, JSON.stringify(sixty));
});

/** Returns the registration after a reach to the cylinder, in a headset with a connected plate whose marks were touched. */
function meet(hasCylinder) {
  const plate = new models.HapticPlate(), tip = { x: 0, y: 0, z: 0.05 };
  const hand = new Map([["index-finger-tip", 1]]), eyes = { transform: { orientation: { x: 0, y: 0, z: 0, w: 1 } } };
  const frame = { getJointPose: () => ({ transform: { position: tip } }), getViewerPose: () => eyes };
  const wear = new models.HeadsetReach(library, world, plate, settings({ controller: "off" }));
  wear.session.configure({ flags: wear.session.config.flags | models.hrt.HRT_SESSION_REGISTERED,
                           plate_covariance: [1e-4, 0, 1e-6, 0, 0, 1e-6] });
  wear.hasCylinder = hasCylinder;
  wear.plateConnected_deg = 0;
  wear.restart();
  const end = models.ahead({ right_m: 0, away_m: 0 }, models.pageCourse(settings()).real_deg, models.distance_m - 0.0045);
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

/** Makes a straight, slow reach, and returns its commands. `see(session)` returns a function that passes a time and a position in
 *  plate coordinates to the plugin. */
function slide(see) {
  const session = reaching(), seeing = see(session), commands = [];
  for (let i = 0; i < 200; ++i) {
    seeing(i * 11, new models.Vector3(0.0001 * i, 0.002, 0.05 - 0.0005 * Math.max(0, i - 40)));
    commands.push([session.command.plate_orientation_deg, session.command.paper_step, session.command.flags]);
  }
  session.destroy();
  return commands;
}

// Uses three.js and the package's entry for it. The frames are test doubles, without a headset or its emulation.
test("a hand tracked in the world gives the same reach as positions on the plate", () => {
  const direct = slide((session) => (time_ms, place) => {
    session.sample.flags = models.hrt.HRT_SAMPLE_PLATE_POSITION;
    session.sample.time_ns = time_ms * 1e6;
    session.sample.finger_position_m.set(place.toArray());
    session.update();
  });
  const scene = new models.Scene(), plate = new models.HapticPlate();
  plate.position.set(0.3, 0.75, -0.4);
  plate.rotation.set(0.1, 0.8, -0.05);
  scene.add(plate);
  const tracked = slide((session) => {
    const reach = new models.HandReach(session, plate), hand = new Map([["index-finger-tip", "tip"]]);
    return (time_ms, place) => {
      const frame = { getJointPose: (joint, space) => {
        assert.deepEqual([joint, space], ["tip", "local"]);
        return { transform: { position: plate.localToWorld(place) } };
      } };
      const command = reach.updateFromHand(time_ms, frame, hand, "local");
      assert.equal(reach.lost, false);
      assert.equal(plate.orientation_deg, command.plate_orientation_deg);
    };
  });
  assert.ok(Math.abs(direct[199][0]) > 10, "the plate turned");
  for (const [i, [plate_deg, step, flags]] of tracked.entries()) {
    near(plate_deg, direct[i][0], 1e-6, `plate in frame ${i}`);
    assert.deepEqual([step, flags], direct[i].slice(1));
  }
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

test("a lost hand is a dropout until it is tracked again", () => {
  const plate = new models.HapticPlate();
  slide((session) => {
    const reach = new models.HandReach(session, plate), hand = new Map([["index-finger-tip", 1]]);
    return (time_ms, position) => {
      const i = Math.round(time_ms / 11), before_deg = plate.orientation_deg;
      const pose = [null, undefined, { transform: { position: { x: NaN, y: 0, z: 0 } } }][i % 3];
      const lost = i >= 90 && i < 100, noHand = i === 95 ? [null, undefined, new Map()][i % 3] : hand;
      // A browser without hand tracking has no getJointPose, a starting session no reference space.
      const getJointPose = i === 96 ? undefined : () => (lost && i !== 97 ? pose : { transform: { position } });
      reach.updateFromHand(time_ms, { getJointPose }, noHand, i === 97 ? null : 0);
      assert.equal(reach.lost, lost);
      if (lost) assert.equal(plate.orientation_deg, before_deg, "the plate keeps its orientation");
    };
  });
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

test("a link contains the settings, and its errors are listed", () => {
  const chosen = settings({ tactile_weight: 0.3, gap_deg: 7.5, controller: "paper", person: 12 });
  assert.equal(models.toLink(settings(), "hand"), "");
  assert.equal(models.toLink(chosen, "watch"), "mode=watch&tactile_weight=0.3&gap_deg=7.5&controller=paper&person=12");
  assert.deepEqual(models.fromLink(models.toLink(chosen, "wear")), { settings: chosen, mode: "wear", problems: [] });
  for (const bad of ["gap_deg=21", "gap_deg=-1", "gap_deg=1e1", "gap_deg=NaN", "noise_mm=", "controller=mine", "mode=replay", "person=0",
                     "person=1.5", "toString=1", "__proto__=1", "tactile_weight=<b>"]) {
    const { settings: got, problems } = models.fromLink(bad);
    assert.deepEqual(got, settings(), bad);
    assert.equal(problems.length, 1, bad);
  }
  assert.match(models.fromLink("gap_deg=21").problems[0], /gap_deg is "21"; allowed: 0 to 20/);
});

test("text on the board is wrapped", () => {
  const fits = (line) => line.length <= 10;
  assert.deepEqual(models.wrapped("rest your fingertip at abcdefghijklmno", fits), ["rest your", "fingertip", "at", "abcdefghijklmno"]);
  assert.deepEqual(models.wrapped("", fits), [""]);
});
