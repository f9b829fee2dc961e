// "Wear it" in an emulated headset (iwer) in headless Chromium. It has not been run on a real headset.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test as once } from "node:test";
import { pathToFileURL } from "node:url";
import { accessible, choose, ended, frames, pageFolder, phase, saved, shoot, sources, text, visit } from "./browser.mjs";
import { optional, without } from "./emulated.mjs";
import { plateDouble, served } from "./plate_double.mjs";

const hrt = await import(pathToFileURL(join(pageFolder, "../npm/node.mjs"))), library = await hrt.load();

const worn = { motion: true, viewport: { width: 500, height: 400 } };
/** Runs a test once for each list in `masks`, in a browser without the optional properties of WebXR in the list. */
function test(name, use, script = "", masks = [[]]) {
  for (const lacking of masks) once(`${name}, without ${lacking}`, () => visit(use, { ...worn, script: without(lacking) + script }));
}
const caption = (page) => text(page, "#caption");
const start = [0.05, 1.2, -0.35];  // start of the fingertip, in the emulated room

async function enter(page, button = "#enter-vr") {
  await choose(page, "wear");
  await frames(page, 20, 2);
  await page.locator(`${button}:enabled`).click();
  assert.equal(await page.locator("#wear-unavailable").isVisible(), false);
  await page.waitForFunction(() => globalThis.headset.device.activeSession?.renderState.baseLayer !== undefined, null, { polling: 20 });
  await page.waitForTimeout(100);
  await frames(page, 11, 3);
}

/** Rests the fingertip at a position for two seconds. */
async function rest(page, tip, frame_ms = 100) {
  await page.evaluate(async ([place, elapsed_ms]) => {
    for (let i = 0; i < 2000 / elapsed_ms; ++i) {
      globalThis.headset.moveTip(...place);
      await globalThis.headset.frame(elapsed_ms);
    }
  }, [tip, frame_ms]);
}

/** Places the plate by a pinch of two seconds, then rests the fingertip, so that a slide begins. */
async function pinch(page, tip) {
  await page.evaluate(() => globalThis.headset.pinch(true));
  await rest(page, tip);
  await page.evaluate(() => globalThis.headset.pinch(false));
  await rest(page, tip);
}

/** Slides the fingertip by `length_m` in 1.5 s, or until the fraction `until` of that time, first in the direction
 *  `first_deg`; with `follows`, the finger then steers its perceived direction to the glass. In the frames `unseen`,
 *  from the first to before the second, the headset does not see the hand. Returns the tracked positions, to the right
 *  of and away from the start. */
function slide(page, { from = start, first_deg = 5, length_m = 0.1, follows = false, unseen = [0, 0], until = 1 } = {}) {
  return page.evaluate(async (how) => {
    const { headset } = globalThis, { dataset } = document.getElementById("stage"), seen = [];
    let x = 0, away = 0, heading_deg = how.first_deg;
    const count = 135;
    for (let i = 0; i <= count * how.until; ++i) {
      const s = i / count, step_m = how.length_m * (30 * s ** 2 - 60 * s ** 3 + 30 * s ** 4) / count;
      const wrong_deg = Number(dataset.feltDeg) - 5;  // direction of the glass
      if (how.follows && Math.abs(wrong_deg) > 1) heading_deg -= 0.5 * Math.sign(wrong_deg);
      x -= step_m * Math.sin(heading_deg * Math.PI / 180);
      away += step_m * Math.cos(heading_deg * Math.PI / 180);
      headset.see(i < how.unseen[0] || i >= how.unseen[1]);
      headset.moveTip(how.from[0] + x, how.from[1], how.from[2] - away);
      await headset.frame(1000 / 90);
      if (i < how.unseen[0] || i >= how.unseen[1]) seen.push([x, away]);
    }
    if (how.until === 1) for (let i = 0; i < 15; ++i) await headset.frame(40);
    return seen;
  }, { from, first_deg, length_m, follows, unseen, until });
}

const recorded = async (page) => (await saved(page, "#save-recording")).content;

const leave = async (page) => {
  await page.evaluate(() => globalThis.headset.leave());
  await frames(page, 20, 2);
};

once("without a headset the page says so", () => visit(async (page) => {
  await choose(page, "wear");
  await page.locator("#wear-unavailable", { hasText: "Not available here" }).waitFor();
  assert.deepEqual([await page.isEnabled("#enter-vr"), await page.isEnabled("#enter-ar")], [false, false]);
  await accessible(page);
  await shoot(page, "wear_unavailable");
}));

test("a reach of a tracked hand replays bit for bit", async (page) => {
  await enter(page);
  assert.equal(await phase(page), "placing");
  await shoot(page, "wear_placing", { fullPage: false });
  await rest(page, start);
  assert.equal(await phase(page), "placing", "a hand that does not pinch places nothing");
  await page.evaluate(() => globalThis.headset.restOther(-0.1, 0.9, -0.1));  // in the lap
  await page.evaluate(() => globalThis.headset.pinch(true));
  await page.evaluate(([x, y, z]) => { globalThis.headset.moveTip(x, y, z); for (let i = 0; i < 12; ++i) globalThis.drawFrame(50); }, start);
  assert.match(await caption(page), /^Hold: [123]$/);
  await shoot(page, "wear_countdown", { fullPage: false });
  await pinch(page, start);
  assert.equal(await phase(page), "sliding", await caption(page));
  assert.match(await caption(page), /^Slide to the orange glass\./);
  const places = await slide(page, { follows: true });
  const { toCylinder_mm, toGlass_mm, feltToGlass_mm } = await ended(page);
  assert.ok(toCylinder_mm < 9 && toGlass_mm > 9, `${toCylinder_mm} mm from the cylinder, ${toGlass_mm} from the glass`);
  assert.ok(feltToGlass_mm < 9, `felt ${feltToGlass_mm} mm from the glass`);
  await shoot(page, "wear_arrived", { fullPage: false });
  await leave(page);
  assert.equal(await caption(page), "You have left the headset.");
  assert.equal(await page.locator("#leave").isVisible(), false);

  const csv = await recorded(page), report = library.replay(csv);
  assert.equal(report.first_different_line, 0n);
  const columns = csv.split("\n").find((line) => line.startsWith("call,")).split(",");
  const rows = csv.split("\n").filter((line) => line.startsWith("update,")).map((line) => line.split(","));
  const sample = (row, name) => Number(row[columns.indexOf(name)]);
  // Transforms the joint's position in the world by the plate's pose, a rotation about the vertical axis.
  const moved = rows.slice(-places.length - 20).filter((row) => sample(row, "sample_flags") & 32).map((row) => {
    const angle = 2 * Math.atan2(sample(row, "plate_qy"), sample(row, "plate_qw")), cos = Math.cos(angle), sin = Math.sin(angle);
    const x = sample(row, "sample_x_m") - sample(row, "plate_x_m"), z = sample(row, "sample_z_m") - sample(row, "plate_z_m");
    return [cos * x - sin * z, sin * x + cos * z];
  });
  // The emulation uses numbers of 32 bits.
  const off = places.map(([right, away]) => Math.min(...moved.map(([x, z]) => Math.hypot(x - right, 0.05 - z - away))));
  assert.ok(Math.max(...off) < 1e-6, `positions as recorded are ${Math.max(...off)} m off`);
}, "", [[], optional]);

test("an error about missing hand tracking names the setting to switch on", async (page) => {
  await choose(page, "wear");
  await frames(page, 20, 2);
  await page.locator("#enter-vr:enabled").click();
  await page.waitForTimeout(200);
  await frames(page, 20, 2);
  assert.match(await caption(page), /^The headset cannot show the plate: no hands\. Switch hand tracking on in the headset's settings/);
}, 'navigator.xr.requestSession = async () => { throw new DOMException("no hands", "NotSupportedError"); }');

/** Returns the offset of the drawn hand from the tracked one, to the right and away, in metres. */
const shift = (page) => page.locator("#stage").evaluate(({ dataset }) => [dataset.shiftRightMm, dataset.shiftAwayMm].map((mm) => Number(mm) / 1000));

test("the hand is drawn where it is perceived: when it is seen at the glass, it meets a mug at the cylinder", async (page) => {
  await enter(page, "#enter-ar");
  await pinch(page, start);
  assert.deepEqual(await shift(page), [0, 0]);
  const [right, away] = (await slide(page, { follows: true, until: 0.97 })).at(-1), [moreRight, moreAway] = await shift(page);
  assert.equal(await phase(page), "sliding");
  const off_mm = (x, y, side) => 1000 * Math.hypot(x - side * 0.1 * Math.sin(Math.PI / 36), y - 0.1 * Math.cos(Math.PI / 36));
  const seen_mm = off_mm(right + moreRight, away + moreAway, -1), met_mm = off_mm(right, away, 1);
  assert.ok(seen_mm < 9 && met_mm < 9, `drawn ${seen_mm} mm from the glass, ${met_mm} mm from the cylinder`);
  await shoot(page, "wear_passthrough", { fullPage: false });
  await slide(page, { from: [start[0] + right, start[1], start[2] - away], length_m: 0 });
  await rest(page, [start[0] + right, start[1], start[2] - away]);
  assert.ok(Math.hypot(...await shift(page)) < 1e-3, "after the slide the hand is drawn where it is");
});

once("over a connected plate the hand is drawn where it is", () => visit(async (page) => {
  await page.click("#plate-serial");
  await served(page, 15);
  await enter(page);
  await pinch(page, start);
  await slide(page, { until: 0.6 });
  assert.deepEqual([await phase(page), await shift(page)], ["sliding", [0, 0]]);
}, { ...worn, script: `${without([])};(${plateDouble})()` }));

test("a short loss of the hand is bridged; a long one, a recentred headset and the end of the session end the reach", async (page) => {
  await enter(page, "#enter-ar");
  await pinch(page, start);
  await slide(page, { unseen: [60, 80] });
  const { toGlass_mm } = await ended(page);
  assert.ok(toGlass_mm < 1, `${toGlass_mm} mm from the glass`);
  await rest(page, start);
  await slide(page, { unseen: [60, 999], until: 0.6 });
  assert.deepEqual([await phase(page), await page.locator("#stage").getAttribute("data-lost")], ["sliding", "true"]);
  await frames(page, 50, 25);
  assert.equal(await phase(page), "ready");
  assert.match(await caption(page), /^The headset did not see your hand for a second\. Rest the tip/);
  await page.evaluate(() => globalThis.headset.see(true));
  await rest(page, start);
  await slide(page, { until: 0.4 });
  assert.equal(await phase(page), "sliding");
  await page.evaluate(() => globalThis.headset.recentre());
  await frames(page, 11, 2);
  assert.equal(await phase(page), "placing");
  assert.match(await caption(page), /^The headset was recentred, so the plate must be placed again\. Pinch your thumb and index/);
  await pinch(page, start.map((x) => x + 0.05));
  assert.equal(await phase(page), "sliding", "at the new position");
  await leave(page);
  assert.equal(await caption(page), "You have left the headset.");
  assert.deepEqual([await phase(page), library.replay(await recorded(page)).first_different_line], ["ready", 0n]);
  await choose(page, "watch");
  await frames(page, 100, 50);
  assert.equal(await page.locator("#results tbody tr").count(), 1);
  await enter(page);
  assert.equal(await phase(page), "placing");
  await page.evaluate(() => document.getElementById("leave").click());  // the emulator's picture covers it
  await page.waitForFunction(() => !globalThis.headset.device.activeSession, null, { polling: 20 });
});

// Marks of samples/plate/model/marks.csv, on a plate rotated by 20 degrees to the left about its centre.
test("touches of the marks place the plate, and a wrong touch is rejected", async (page) => {
  const marks = (await readFile(join(sources, "../plate/model/marks.csv"), "utf8")).trim().split("\n").slice(1)
    .map((line) => line.split(",").slice(1, 4).map(Number));
  const angle = 20 * Math.PI / 180, centre = [0.1, 1.1, -0.5];
  const place = ([x, y, z]) => [centre[0] + x * Math.cos(angle) + z * Math.sin(angle), centre[1] + y, centre[2] - x * Math.sin(angle) + z * Math.cos(angle)];
  const touch = async (touches) => {
    for (const mark of touches) {
      await rest(page, place(mark), 50);
      await page.evaluate((at) => {
        for (let i = 0; i < 5; ++i) {
          globalThis.headset.moveTip(at[0], at[1] + 0.02 * i, at[2]);
          globalThis.drawFrame(50);
        }
      }, place(mark));
    }
  };
  await choose(page, "wear");
  await choose(page, "marks");
  await enter(page);
  assert.match(await caption(page), /touch mark 1 .*"start" \(1 of 6\)/);
  await touch(marks.slice(0, 2));
  assert.match(await caption(page), /\(3 of 6\)/);
  await shoot(page, "wear_marks", { fullPage: false });
  await touch(marks.slice(2).map(() => marks[3]));
  assert.match(await caption(page), /^The measurements do not agree\. .*\(1 of 6\)/);
  const bad = marks.map((mark, i) => (i === 4 ? [mark[0] + 0.03, mark[1], mark[2]] : mark));
  await touch(bad);
  assert.equal(await phase(page), "ready");
  await rest(page, place([0, 0, 0.05]));
  assert.equal(await phase(page), "sliding", "the ring is at the registered start");
});
