// The page in headless Chromium, used by mouse and keyboard, in windows 390, 820 and 1440 pixels wide, light, dark and
// with forced colours. Screenshots are saved in FOLDER_OF_SCREENSHOTS (see browser.mjs), for inspection by people.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { place, steer } from "./visitor.mjs";
import { accessible, arrived, choose, desk, desktop, drawn, drop, ended, frames, launch, newest, pageFolder, phase, phone, recorded, require, saved,
         shoot, stopTime, tablet, text, visit } from "./browser.mjs";

const { PNG } = require("pngjs");

test("a reach ends at the cylinder and is perceived to end at the glass, and is shown as a chart and a table", () => visit(async (page) => {
  const result = await newest(page);
  assert.equal(result.controller, "ours");
  assert.ok(arrived(result), `bearing error ${result.bearingError_deg}`);
  assert.ok(result.feltToGlass_mm < 8 && result.toCylinder_mm < 8);
  await drawn(page);
  assert.match(await text(page, "#caption"), /^Arrived\. The hand is \d+\.\d mm from the cylinder/);
  // Three strips, each with the values under the cursor; the last one shows the estimated weight.
  assert.equal(await page.locator("#chart .uplot").count(), 3);
  await page.locator("#chart .u-over").last().hover();  // at its centre
  await page.locator("#chart .u-legend", { hasText: /perceived:?\s*-?\d+\.\d°/ }).waitFor();
  assert.match(await page.locator("#chart .u-legend").last().innerText(), /estimate:?\s*0\.[12]\d/);
  assert.match(await page.locator("#trace tbody tr").nth(5).innerText(), /^1\.0 s\s+\d+° (left|right)\s+\d+\.\d° (left|right)/);
}));

test("a reach misses without the plate, and with the paper's controller for another person", () => visit(async (page) => {
  await page.locator("input[value=ours]").focus();
  await page.keyboard.press("ArrowLeft");
  const paper = await newest(page);
  assert.deepEqual([paper.controller, arrived(paper)], ["paper", false]);
  await page.keyboard.press("ArrowLeft");
  const off = await newest(page);
  assert.deepEqual([off.controller, arrived(off)], ["off", false]);
  assert.ok(off.bearingError_deg > 8, "towards the glass");
  await drawn(page);
  assert.match(await text(page, "#caption"), /^The hand is 2\d\.\d mm from the cylinder/);
  assert.match(await page.locator("#trace tbody tr").nth(5).innerText(), /^1\.0 s\s+straight ahead/, "the table is this reach's");
  await shoot(page, "watch_still_plate");
}, { link: "researchers.html#mode=watch&tactile_weight=0.3" }));

test("each setting moves by keyboard, and starts another reach", () => visit(async (page) => {
  for (const [slider, ...texts] of [["gap_deg", "0.0°", "20.0°"], ["tactile_weight", "0.05", "0.40"], ["pace_s", "0.6 s", "4.0 s"],
                                    ["noise_mm", "0.0 mm", "3.0 mm"], ["plate_deg_s", "50 °/s", "800 °/s"]]) {
    for (const [i, key] of ["Home", "End"].entries()) {
      const before = await newest(page);
      await page.locator(`#${slider}`).press(key);
      assert.notDeepEqual(await newest(page), before);
      assert.equal(await text(page, `output[for=${slider}]`), texts[i]);
      assert.equal(await page.locator(`#${slider}`).getAttribute("aria-valuetext"), texts[i]);
    }
  }
  const link = () => page.evaluate(() => location.hash);
  for (const person of ["12", "0", ""]) {  // the last two are not allowed, and ignored
    await page.fill("input[name=person]", person);
    assert.equal(await link(), "#mode=watch&gap_deg=20&tactile_weight=0.4&pace_s=4&noise_mm=3&plate_deg_s=800&person=12");
  }
  await page.click("#defaults");
  assert.equal(await link(), "#mode=watch");
}));

test("a gap that is not feasible is reported", () => visit(async (page) => {
  assert.match(await text(page, "#holds"), /^Too far: .* 6\.0°/);
  assert.equal(arrived(await newest(page)), false);
  for (let i = 0; i < 4; ++i) await page.click("#again");
  assert.match(await page.locator("#results tbody tr").first().innerText(), /no plate orientation sustains the gap/);
  await shoot(page, "watch_too_far");
}, { link: "researchers.html#mode=watch&tactile_weight=0.08&gap_deg=15" }));

test("each of the six figures follows a drag and keys, and describes its state", () => visit(async (page) => {
  for (let i = 1; i <= 6; ++i) {
    const figure = page.locator(`#figure-${i}`), said = new Set();
    await figure.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await figure.boundingBox(), drawings = [await figure.innerHTML()];
    for (const share of [0.05, 0.5, 0.85]) {
      await page.mouse.move(x + 0.5 * width, y + 0.5 * height);
      await page.mouse.down();
      await page.mouse.move(x + share * width, y + (i === 5 ? 1 - share : 0.2) * height, { steps: 3 });
      await page.mouse.up();
      drawings.push(await figure.innerHTML());
      said.add(await text(page, `#words-${i}`));
      assert.equal(await page.locator(`#see-${i}`).getAttribute("aria-valuetext"), await text(page, `#words-${i}`));
    }
    assert.ok(new Set(drawings).size >= 3 && said.size >= 2, `figure ${i}: ${[...said]}`);
    await page.locator(`#see-${i}`).press("ArrowLeft");
    assert.notEqual(await figure.innerHTML(), drawings.at(-1));
  }
  // The arrow shows the push of the ridges, which is along their normal.
  const turned = await page.locator("#figure-2").evaluate((figure) => {
    const [x, y] = figure.querySelector("path.touch").getAttribute("d").match(/-?[\d.]+/g).slice(2).map(Number);
    return [Math.atan2(x, -(y - 50)) * 180 / Math.PI, Number(/rotate\((.*)\)/.exec(figure.querySelector(".ridge").getAttribute("transform"))[1])];
  });
  assert.ok(Math.abs(turned[0] - turned[1]) < 1, `${turned}`);
  assert.doesNotMatch(await page.locator(".figures").innerText(), /w_?T|°|degree/, "words for a reader of twelve");
}, { link: "" }));

test("a reach plays, pauses and steps", () => visit(async (page) => {
  await page.selectOption("#speed", "1");
  await page.click("#again");
  await frames(page, 100, 12);
  assert.equal(await phase(page), "sliding");
  await page.click("#play");
  await shoot(page, "watch_sliding");
  const finger = await text(page, "#caption");
  assert.match(finger, /^The hand moves \d+° (left|right); over these ridges that feels like/);
  await frames(page, 100, 3);
  assert.equal(await text(page, "#caption"), finger, "a paused reach does not move");
  for (let i = 0; i < 40 && await phase(page) !== "arrived"; ++i) {
    await page.click("#step");
    await frames(page, 20);
  }
  assert.match(await text(page, "#spoken"), /^Arrived|^Missed/);
  await page.click("#play");
  await frames(page, 100, 25);
  assert.equal(await phase(page), "waiting", "the next reach begins by itself");
  await frames(page, 100, 25);
  assert.equal(await page.locator("#results tbody tr").count(), 2);
}, { motion: true }));

const hidden = (page) => page.locator("#label-finger").isHidden();
const own = { motion: true, link: "", viewport: { width: 390, height: 560 } };  // small, because Chromium renders in software

// The mouse moves the finger from the ring without a click.
test("the hand is hidden during the slide, then shown at the cylinder under the cursor", () => visit(async (page) => {
  await frames(page, 100, 12);
  assert.equal(await text(page, "#caption"), "Slide the dot from the ring to the glass.");
  assert.equal(await page.locator(".stand-in").innerText(), "Here your eye stands in for your fingertip.");
  await shoot(page, "hand_waiting");
  await steer(page, { until: 0.4 });
  assert.deepEqual([await phase(page), await hidden(page)], ["sliding", true]);
  assert.equal(await page.locator("#grip").evaluate((grip) => getComputedStyle(grip).cursor), "none");
  const unseen = await skin(page);
  await shoot(page, "hand_sliding");
  await page.locator("#stage").press("Escape");
  const cursor = await steer(page);
  const { toCylinder_mm, toGlass_mm, feltToGlass_mm } = await ended(page);
  assert.ok(toCylinder_mm < 8 && toGlass_mm > 12 && feltToGlass_mm < 4, `${toCylinder_mm} mm from the cylinder, ${toGlass_mm} from the glass`);
  assert.match(await text(page, "#caption"), /^You steered the dot to the glass\. Your hand is here, (1|2)\d mm from the dot and \d mm from the cylinder\.$/);
  assert.equal(await text(page, "#spoken"), await text(page, "#caption"));
  const glass = await place(page, "glass");
  assert.ok(Math.hypot(cursor[0] - glass[0], cursor[1] - glass[1]) > 20, "the cursor is not at the glass");
  assert.notEqual(await page.locator("#grip").evaluate((grip) => getComputedStyle(grip).cursor), "none");
  assert.equal(await hidden(page), false);
  assert.ok(await skin(page) > unseen + 3000, `the hand is seen: ${unseen} pixels like skin before`);
  await shoot(page, "hand_arrived");
  // The replay shows the three arrows; no slide with the plate off has been made.
  const text_on = await text(page, "#moment-text"), path = () => page.locator("#slide-on path.real").first().getAttribute("d"), whole = await path();
  await page.locator("#moment").press("Home");
  for (let i = 0; i < 50; ++i) await page.keyboard.press("ArrowRight");
  assert.match(await text(page, "#moment-text"), /^Plate on: the hand moves \d+° (left|right), the ridges push \d+° (left|right), that feels like \d+° (left|right)\.$/);
  assert.notEqual(await text(page, "#moment-text"), text_on);
  assert.ok((await path()).length < whole.length && await page.locator("#slide-on path.tip").count() === 3);
  assert.equal(await text(page, "#slide-off-missing"), "– not yet");
  await shoot(page, "hand_compare");
  // A finished slide is kept when the visitor clicks elsewhere.
  await page.mouse.click(...await place(page, "start"));
  await page.mouse.click(...glass);
  await page.mouse.click(20, 300);
  await frames(page, 33);
  assert.equal((await ended(page)).toCylinder_mm, toCylinder_mm);
}, own));

test("six answers estimate the visitor's threshold, with a note on its meaning", () => visit(async (page) => {
  const gaps = [];
  for (let i = 1; i <= 6; ++i) {
    await steer(page);
    assert.equal(await page.locator("#after").isVisible(), false, "the buttons are hidden until the question is answered");
    if (i === 2) await shoot(page, "hand_question");
    gaps.push((await place(page, "glass"))[0]);
    if (i === 6) assert.match(await text(page, "#learnt"), /^The computer learnt from your slides: the ridges contribute (1\d|2\d) % to the direction of the dot \(95 % interval: \d+ to \d+ %\)\.$/);
    await page.click(i % 2 ? "#noticed-no" : "#noticed-yes");
    if (i < 6) assert.match(await text(page, "#limit"), new RegExp(`^Answer ${i} of 6\\.`));
    await frames(page, 20);
    assert.equal(await phase(page), "arrived", "an answer leaves the result");
    await page.click("#restart");
  }
  assert.ok(new Set(gaps.map(Math.round)).size > 1, `the gap varies: ${gaps}`);
  const [, limit, lower, upper] = /^Your limit after 6 answers: if your hand is led (\d+) mm aside, .* the limit is (\d+) to (\d+) mm with 95 % .* It is not the limit of your touch/.exec(await text(page, "#limit")).map(Number);
  assert.ok(lower < limit && limit < upper, `${lower} ${limit} ${upper}`);
  await shoot(page, "hand_limit");
}, own));

test("keys steer the hand, and a lifted finger is reported", () => visit(async (page) => {
  await page.locator("#stage").focus();
  await page.keyboard.down("ArrowUp");
  await frames(page, 40, 20);
  await page.keyboard.up("ArrowUp");
  await page.keyboard.press("Enter");
  await frames(page, 100, 10);
  assert.match(await text(page, "#caption"), /^You stopped before the glass\. Your hand is here, \d+ mm from the dot/);
  assert.equal(await page.locator("#question").isVisible(), false, "such a slide is not asked about");
  await page.click("#plate-off");
  await frames(page, 20);
  assert.match(await text(page, "#caption"), /^The plate is off\./);
}, own));

test("a thumb on the disc drags the dot, also outside the window; a short drag restarts", () => visit(async (page) => {
  await steer(page, { grip: [80, -20], until: 0.9 });
  assert.equal(await phase(page), "waiting");
  await steer(page, { grip: [60, -20] });
  assert.ok((await ended(page)).toCylinder_mm < 8);
  await page.click("#noticed-yes");
  await frames(page, 20);
  await page.click("#restart");
  await frames(page, 50, 15);
  const [x, y] = await place(page, "start");
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (const [dx, dy] of [[20, -30], [900, -30], [900, -2000], [0, -60]]) {
    await page.mouse.move(x + dx, y + dy, { steps: 2 });
    if (dx < 100) await frames(page, 20, 4);
  }
  assert.equal(await phase(page), "sliding", "the window's edge ends nothing");
  await page.mouse.up();
}, { ...own, viewport: phone }));

test("ridges and guiding tones are audible, louder when fast, and one switch turns them off", () => visit(async (page) => {
  const heard = () => page.evaluate(() => globalThis.heard.splice(0));
  const slide = async () => {
    await page.locator("#stage").focus();
    await page.keyboard.press("Escape");
    await page.keyboard.down("ArrowUp");
    await frames(page, 40, 50);
    await page.keyboard.up("ArrowUp");
    return heard();
  };
  const sounds = await slide(), ridges = sounds.filter(([what]) => what === 1800), tones = sounds.filter(([what]) => what === "tone");
  assert.ok(ridges.length >= 6 && ridges.length <= 20 && ridges.every(([, loud]) => loud > 0.05 && loud < 0.4), JSON.stringify(ridges));
  assert.deepEqual(sounds.at(-1), [180, 0.8]);
  assert.ok(tones.length >= 3 && tones.some(([, side]) => side !== 0), JSON.stringify(tones));
  assert.ok((await page.evaluate(() => globalThis.shaken)).every((ms) => ms >= 20));
  await page.click("#ticks");
  assert.deepEqual(await slide(), []);
  assert.equal(await text(page, "#ticks"), "Sound: off");
}, { ...own, script: `(${() => {
  globalThis.heard = [];
  globalThis.shaken = [];
  navigator.vibrate = (ms) => shaken.push(ms);
  let pitch = 0, loud = 0, side = 0;
  const node = (more) => ({ connect: (to) => to, stop() {}, ...more });
  globalThis.AudioContext = class {
    state = "running"; sampleRate = 1000;
    get currentTime() { return performance.now() / 1000; }
    createBuffer() { return { getChannelData: () => new Float32Array(10) }; }
    createBufferSource() { return node({ start() { heard.push([pitch, loud]); } }); }
    createBiquadFilter() { return node({ frequency: { set value(hz) { pitch = hz; } } }); }
    createOscillator() { return node({ frequency: {}, start() { heard.push(["tone", side]); } }); }
    createStereoPanner() { return node({ pan: { set value(to) { side = to; } } }); }
    createGain() { return node({ gain: { setValueAtTime(to) { loud = to; }, exponentialRampToValueAtTime() {} } }); }
  };
}})()` }));

test("the first screen has a title, a mark and two controls; a thumb scrolls beside the disc", async () => {
  for (const viewport of [phone, tablet, desktop]) await visit(async (page) => {
    await page.waitForSelector("#stage[data-hand=yes]");
    assert.match((await page.innerText("body")).trim(), /^Simulation\s+A turning plate/);
    const seen = await page.evaluate(() => [...document.querySelectorAll("h1, .mark, #caption, #view, button, select, fieldset, summary, input[type=range], a")].filter((each) => {
      const { top, bottom, width } = each.getBoundingClientRect();
      return width > 1 && top < innerHeight - 50 && bottom > 0 && each.checkVisibility() && !each.closest(".figures");
    }).map((each) => each.id || each.className || each.localName));
    assert.deepEqual(seen, ["mark", "title", "caption", "view", "modes", "ticks"]);
    const touch = (x, y) => page.evaluate(([right, down]) => {
      const box = document.getElementById("view").getBoundingClientRect();
      return getComputedStyle(document.elementFromPoint(box.x + right * box.width, box.y + down * box.height)).touchAction;
    }, [x, y]);
    assert.deepEqual([await touch(0.5, 0.5), await touch(0.02, 0.02), await touch(0.98, 0.98)], ["none", "pan-y pinch-zoom", "pan-y pinch-zoom"]);
    // The caption does not cover the picture, and the plate has more than 90 % of the width of a phone.
    const boxes = await page.evaluate(() => ["caption", "view"].map((id) => document.getElementById(id).getBoundingClientRect()).map(({ top, bottom }) => [top, bottom]));
    assert.ok(boxes[0][1] <= boxes[1][0]);
    const disc = await page.locator("#grip").boundingBox();
    assert.ok(viewport !== phone || disc.width > 0.9 * viewport.width, `the plate is ${disc.width} pixels wide`);
  }, { link: "", viewport });
});

test("a restored WebGL context draws again", () => visit(async (page) => {
  await page.waitForSelector("#stage[data-hand=yes]");
  await frames(page, 100, 15);
  assert.ok(await skin(page) > 2000);
  await page.evaluate(async () => {
    const lose = document.getElementById("view").getContext("webgl2").getExtension("WEBGL_lose_context"), canvas = document.getElementById("view");
    const until = (event) => new Promise((done) => canvas.addEventListener(event, done, { once: true }));
    const lost = until("webglcontextlost"), restored = until("webglcontextrestored");
    lose.loseContext();
    await lost;
    setTimeout(() => lose.restoreContext(), 50);
    await restored;
  });
  await frames(page, 100, 3);
  assert.ok(await skin(page) > 2000, "the hand is seen again");
}, { ...own, link: "researchers.html#mode=watch", strict: false }));

test("a part that cannot be loaded is reported, with a button to retry", () => visit(async (page) => {
  await page.route("**/part_*", (route) => route.abort());
  await choose(page, "wear");
  await page.locator("#problem-text", { hasText: /^The part for headsets could not be loaded: / }).waitFor();
  await page.unroute("**/part_*");
  await page.click("#retry");
  await page.waitForSelector("html[data-ready=yes]");
  assert.equal(await page.locator("#problem").isVisible(), false);
}, { link: "", strict: false }));

test("a plugin that cannot be loaded is reported, and a retry keeps the settings of the link", () => visit(async (page) => {
  await page.route("**/haptic_retargeting.wasm", (route) => route.abort());
  await page.reload();
  await page.locator("#problem-text", { hasText: /^The page cannot start: / }).waitFor();
  assert.deepEqual([await page.locator("#modes").isVisible(), await page.locator("#retry").isVisible()], [false, true]);
  await shoot(page, "cannot_start", { hand: false });
  await page.unroute("**/haptic_retargeting.wasm");
  await page.click("#retry");
  await page.waitForSelector("html[data-ready=yes]");
  assert.deepEqual([await page.locator("#problem").isVisible(), await text(page, "output[for=gap_deg]")], [false, "7.0°"]);
}, { link: "researchers.html#mode=watch&gap_deg=7", strict: false }));

test("without JavaScript the page says that it needs it", () => visit(async (page) => {
  assert.equal(await page.locator("noscript p").innerText(), "This page needs JavaScript, because it computes everything that it shows.");
  assert.deepEqual([await page.locator("noscript p").isVisible(), await page.locator("#modes").isVisible()], [true, false]);
  await shoot(page, "without_javascript", { hand: false });
}, { link: "", javaScriptEnabled: false, ready: "noscript p", viewport: phone }));

test("recording and profile are saved, and the recording replays", () => visit(async (page) => {
  await drawn(page);
  const recording = await saved(page, "#save-recording"), profile = await saved(page, "#save-profile");
  assert.deepEqual([recording.name, profile.name], ["reach.csv", "profile.json"]);
  assert.ok(JSON.parse(profile.content).tactile_weight > 0);
  const lines = recording.content.split("\n");
  assert.match(lines[0], /^# haptic retargeting recording/);
  assert.ok(lines.filter((line) => line.startsWith("update,0,")).length > 200);

  await page.setInputFiles("#open-file", { name: "mine.csv", mimeType: "text/csv", buffer: Buffer.from(lines.join("\n")) });
  await page.locator("#replayed", { hasText: /^mine\.csv: All 2\d\d calls gave the recorded numbers, bit for bit\. A rec/ }).waitFor();
  await drawn(page);
  assert.deepEqual([await text(page, "#slide-on-name"), await page.locator("#slide-on path.real").count() >= 1], ["mine.csv", true]);
  await accessible(page);
  await shoot(page, "replay");
}));

test("a recording of another host replays, and an altered one is reported", () => visit(async (page) => {
  const reach = await readFile(recorded, "utf8");
  const lines = reach.split("\n"), rows = lines.filter((line) => /^(begin|update|end),/.test(line)).length;
  const altered = lines.map((line) => line.startsWith("update,")).lastIndexOf(true), cells = lines[altered].split(",");
  cells[lines.find((line) => line.startsWith("call,")).split(",").indexOf("plate_orientation_deg")] = "12.5";
  await drop(page, "altered.csv", [...lines.slice(0, altered), cells.join(","), ...lines.slice(altered + 1)].join("\n"));
  await page.locator("#replayed", { hasText: new RegExp(`^altered\\.csv: Line ${altered + 1} gave other numbers than those recorded\\. The recording is not`) }).waitFor();
  await drop(page, "reach.csv", reach);
  await page.locator("#replayed", { hasText: `reach.csv: All ${rows} calls gave the recorded numbers` }).waitFor();
}));

// A plate within 75 degrees of the motion sustains gaps of up to 75 w degrees, for a tactile weight w.
test("a dropped scene is shown with its feasible gaps", () => visit(async (page) => {
  await drop(page, "desk.gltf", await readFile(desk, "utf8"));
  await page.waitForSelector("#scene-mode:not([hidden])");
  assert.equal(await text(page, "#scene-about"), "desk.gltf: a plate of 75 mm radius, 1 real and 3 virtual targets.");
  const rows = await page.locator("#held tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
  assert.deepEqual(rows.map((row) => row.slice(0, 3)), [["bottle", "cylinder", "6.0°"], ["goblet", "cylinder", "-8.0°"],
                                                         ["pawn", "cylinder", "12.0°"]]);
  assert.deepEqual(rows.map((row) => row.slice(3).map((cell) => cell !== "–")), [
    [true, true, true, true, true], [false, true, true, true, true], [false, false, true, true, true]]);
  assert.equal(rows[0][5], "30° left");
  assert.deepEqual(await page.locator("#labels .label:visible").allTextContents(), ["hand", "felt here", "pawn", "bottle", "cylinder", "goblet"]);
  // Reaches lead to the targets of the file: the bottle with a gap of 6 degrees, the goblet with one of -8 degrees.
  const bottle = await newest(page);
  assert.ok(Math.abs(bottle.gap_deg - 6) < 1e-6 && arrived(bottle) && bottle.feltToGlass_mm < 8, JSON.stringify(bottle));
  await page.selectOption("#scene-pair", { label: "goblet; the hand ends at cylinder" });
  const goblet = await newest(page);
  assert.ok(Math.abs(goblet.gap_deg + 8) < 1e-6 && arrived(goblet), JSON.stringify(goblet));
  await drawn(page);
  await accessible(page);
  await shoot(page, "scene");
  await choose(page, "watch");
  assert.deepEqual(await page.locator("#labels .label:visible").allTextContents(), ["cylinder", "glass", "hand", "felt here"]);
}));

async function refuses(page, name, content, words) {
  await drop(page, name, content);
  await page.locator("#refused:not([hidden])").waitFor();
  assert.match(await text(page, "#refused"), words);
  assert.deepEqual([await page.locator("#scene-mode").isVisible(), await text(page, "#replayed")], [false, ""]);
  await page.evaluate(() => { document.getElementById("refused").hidden = true; });
}

test("a bad file is refused with the plugin's error", () => visit(async (page) => {
  const reach = await readFile(recorded, "utf8"), scene = await readFile(desk, "utf8");
  for (const [name, content, words] of [
    ["x.csv", "", /^x\.csv: .*does not begin/], ["x.csv", "call,result\n<script>", /does not begin/],
    ["x.csv", reach.replace(/version \d+/, "version 999"), /^x\.csv: .+/],
    ["bad.gltf", "", /^bad\.gltf: /], ["bad.gltf", "{", /^bad\.gltf: /], ["bad.gltf", "{}", /^bad\.gltf: /],
    ["bad.gltf", scene.replace('"radius_m": 0.075', '"radius_m": -1'), /^bad\.gltf: .*Plate.*radius_m/],
    ["bad.gltf", scene.replace('"role": "real"', '"role": "<img src=x>"'), /^bad\.gltf: .*role/],
    ["picture.png", "\x89PNG", /^picture\.png: this page opens a recording \(\.csv\), or a scene/]]) await refuses(page, name, content, words);
}));

test("a scene whose meshes cannot be drawn is shown without them, and nothing is fetched", () => visit(async (page) => {
  const scene = JSON.parse(await readFile(desk, "utf8")), changed = (change) => {
    const copy = structuredClone(scene);
    change(copy);
    return JSON.stringify(copy);
  };
  for (const [content, words] of [[changed(({ accessors }) => { accessors[0].count = 1e9; }), /Its meshes are not drawn: ./],
                                  [changed(({ meshes }) => { meshes[0].primitives[0].attributes.POSITION = 999; }), /Its meshes are not drawn: ./],
                                  [changed(({ buffers }) => { buffers[0].uri = "https://127.0.0.1:9/desk.bin"; }), /lie in another file: open or drop it together with this one/],
                                  [changed(({ nodes, scenes }) => { while (nodes.length < 2000) scenes[0].nodes.push(nodes.push({ mesh: 6 }) - 1); }), /draw \d{7} vertices/]]) {
    await drop(page, "bad.gltf", content);
    await page.locator("#scene-about, #refused:not([hidden])").filter({ hasText: words }).first().waitFor();
    await page.evaluate(() => { for (const id of ["refused", "scene-about"]) document.getElementById(id).textContent = ""; });
  }
}));

test("a scene opens with its separate buffer file", () => visit(async (page) => {
  const scene = JSON.parse(await readFile(desk, "utf8")), buffer = Buffer.from(scene.buffers[0].uri.split(",")[1], "base64");
  scene.buffers[0].uri = "the%20desk.bin";
  const open = (...files) => page.setInputFiles("#open-file", files.map(([name, content]) => ({ name, mimeType: "", buffer: Buffer.from(content) })));
  await open(["the desk.bin", buffer], ["desk.gltf", JSON.stringify(scene)]);
  await page.locator("#scene-about", { hasText: "desk.gltf: a plate of" }).waitFor();
  assert.equal(await text(page, "#scene-about"), "desk.gltf: a plate of 75 mm radius, 1 real and 3 virtual targets.", "with its meshes");
}));

test("an error in a link is reported, and its valid part is used", () => visit(async (page) => {
  assert.equal(await text(page, "#problem-text"), "Ignored in the link: gap_deg is \"99\"; allowed: 0 to 20.");
  assert.equal(await text(page, "output[for=noise_mm]"), "0.3 mm");
}, { link: "researchers.html#mode=watch&gap_deg=99&noise_mm=0.3" }));

test("the page's policy blocks requests to other machines", () => visit(async (page) => {
  const refused = await page.evaluate(async () => {
    const tries = [fetch("https://127.0.0.1:9/"), fetch("https://localhost/"), import("data:text/javascript,1")];
    return (await Promise.allSettled(tries)).map(({ status }) => status);
  });
  assert.deepEqual(refused, ["rejected", "rejected", "rejected"]);
}, { strict: false }));

/** Returns the number of pixels of a picture in colours of lit skin. */
async function skin(page) {
  const { data } = PNG.sync.read(await page.locator("#view").screenshot());
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const red = data[i], warm = (red - data[i + 1]) / red, cold = (data[i + 1] - data[i + 2]) / red;
    if (red > 90 && warm > 0.16 && warm < 0.4 && cold > 0.1 && cold < 0.3) ++count;
  }
  return count;
}

test("a hand is visible in Watch, where a drag or the arrows rotate the picture; Try it keeps its view", () => visit(async (page) => {
  const glass = async () => {
    await drawn(page);
    return page.locator("#label-glass").evaluate((label) => label.style.transform);
  };
  await page.waitForSelector("#stage[data-hand=yes]");
  const seen = [await glass()], { x, y, width, height } = await page.locator("#view").boundingBox();
  assert.ok(await skin(page) > 5000, `${await skin(page)} pixels of skin`);
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 120, y + height / 2, { steps: 4 });
  await page.mouse.up();
  seen.push(await glass());
  await page.locator("#stage").focus();
  for (const key of ["ArrowLeft", "ArrowUp"]) {
    await page.keyboard.press(key);
    seen.push(await glass());
  }
  assert.equal(new Set(seen).size, 4, seen.join());
  await shoot(page, "watch_turned");
  await page.locator("label:has(input[value=watch])").press("ArrowLeft");
  const above = await glass();
  await page.locator("#stage").press("ArrowLeft");
  assert.equal(await glass(), above);
}));

test("the page opens from a folder without a server", () => visit(async (page) => {
  assert.equal(arrived(await newest(page)), true);
}, { base: pathToFileURL(join(resolve(pageFolder), "index.html")).href.replace(/index\.html$/, ""), link: "researchers.html#mode=watch" }));

test("a flat picture is drawn without WebGL", async () => {
  const plain = await launch("--disable-3d-apis");
  try {
    await visit(async (page) => {
      assert.equal(await page.locator("#no-view").isVisible(), true);
      assert.equal(arrived(await newest(page)), true);
      await choose(page, "hand");
      await drawn(page);
      const { x, y, width, height } = await page.locator("#no-view").boundingBox(), scale = Math.min(width, height) / 160;
      await page.mouse.move(x + width / 2, y + height / 2 + 50 * scale);
      await page.mouse.move(x + width / 2 - 9 * scale, y + height / 2 - 60 * scale, { steps: 40 });
      await page.waitForSelector("#stage[data-phase=arrived]");
      assert.equal(await page.locator("#no-view path").count() >= 3, true, "ridges and two paths");
      await shoot(page, "without_webgl");
    }, { from: plain, strict: false });
  } finally {
    await plain.close();
  }
});

// Colours do not change the layout, so that each of them needs one width only.
for (const [size, viewport] of Object.entries({ desktop, tablet, phone })) {
  const looks = [{ colorScheme: "light" }, { colorScheme: "dark" }, { colorScheme: "light", forcedColors: "active" }];
  for (const look of size === "desktop" ? looks : [looks[0]]) {
    const suffix = `${size}_${look.forcedColors ? "forced" : look.colorScheme}`;
    test(`accessible and within the window: ${suffix}`, () => visit(async (page) => {
      const check = async (name) => {
        await accessible(page);
        assert.doesNotMatch(await page.innerText("body"), /ghost|real cylinder|real object|virtual target(?!s\.)|turntable|be led|felt error|cues|the finger\b/i, "one name each");
        const [inner, outer] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
        assert.ok(inner <= outer, `${inner} pixels wide in a window of ${outer}`);
        await shoot(page, `${name}_${suffix}`);
      };
      await drop(page, "desk.gltf", await readFile(desk, "utf8"));
      await page.waitForSelector("#scene-mode:not([hidden])");
      for (const mode of ["watch", "hand", "wear", "scene"]) {
        await choose(page, mode);
        await page.waitForTimeout(300);
        await check(mode);
      }
      await page.addInitScript(stopTime);
      await page.goto(new URL("index.html", page.url()).href);
      await page.waitForSelector("html[data-ready=yes] #stage[data-hand=yes]");
      await check("visitor");
      if (look !== looks[0]) return;
      await steer(page);
      assert.ok((await ended(page)).toCylinder_mm < 8, "led to the cylinder");
      await check("hand_question");
      await page.click("#noticed-no");
      await frames(page, 20);
      await page.click("#plate-off");
      await steer(page);
      assert.ok((await ended(page)).toGlass_mm < 5, "not led");
      assert.match(await text(page, "#moment-text"), /^Plate on: .*Plate off: /);
      await check("hand_both");
    }, { viewport, ...look }));
  }
}
