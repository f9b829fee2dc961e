// Costs of the page in headless Chromium: frames and memory at rest and while reaches are played, and sizes.
import assert from "node:assert/strict";
import { test } from "node:test";
import { choose, frames, visit } from "./browser.mjs";

const small = { width: 390, height: 560 };  // Chromium renders in software
const tools = (page) => page.context().newCDPSession(page);

/** Returns the size of the page's JavaScript objects after garbage collection, in bytes. */
async function heap(devtools) {
  for (let i = 0; i < 2; ++i) await devtools.send("HeapProfiler.collectGarbage");
  return (await devtools.send("Runtime.getHeapUsage")).usedSize;
}

/** Runs in the page: notes the times of its frames. */
function countFrames() {
  const request = requestAnimationFrame;
  globalThis.frameTimes = [];
  globalThis.requestAnimationFrame = (callback) => request((time) => {
    frameTimes.push(time);
    callback(time);
  });
}

test("a page at rest draws no frame in an hour, and its heap stays flat", (t) => visit(async (page) => {
  await page.waitForSelector("#stage[data-hand=yes]");
  await page.waitForTimeout(2000);
  const devtools = await tools(page), now = () => page.evaluate(() => performance.now());
  const began = await now(), bytes = await heap(devtools);
  await page.evaluate(() => { frameTimes.length = 0; });
  const passed = new Promise((done) => { devtools.once("Emulation.virtualTimeBudgetExpired", done); });
  await devtools.send("Emulation.setVirtualTimePolicy", { policy: "advance", budget: 3_600_000 });
  await passed;
  assert.ok(await now() - began >= 3_600_000, "an hour has passed in the page");
  assert.equal(await page.evaluate(() => frameTimes.length), 0);
  const grown = await heap(devtools) - bytes;
  t.diagnostic(`${bytes} bytes, ${grown} more after an hour at rest`);
  assert.ok(grown < 100_000, `${grown} bytes`);
}, { motion: "real", link: "", viewport: small, script: countFrames }));

test("the heap stays flat while reaches are played for ten minutes", (t) => visit(async (page) => {
  await page.waitForSelector("#stage[data-hand=yes]");
  const devtools = await tools(page), sizes = [];
  for (let i = 0; i < 3; ++i) {
    await frames(page, 1000, 200);  // each frame advances by one second
    sizes.push(await heap(devtools));
  }
  t.diagnostic(`${sizes} bytes`);
  assert.equal(await page.locator("#results tbody tr").count(), 10, "reaches were made");
  assert.ok(sizes[2] - sizes[1] < 500_000, `${sizes}`);
}, { motion: true, link: "#mode=watch", viewport: small }));

test("eight successive slow frames reduce the picture to the page's resolution", () => visit(async (page) => {
  const pixels = () => page.locator("#stage canvas").evaluate((canvas) => canvas.width / canvas.clientWidth);
  await frames(page, 100, 7);
  await frames(page, 16);
  await frames(page, 100, 7);
  assert.equal(await pixels(), 2);
  await frames(page, 100);
  assert.equal(await pixels(), 1);
}, { motion: true, script: () => Object.defineProperty(window, "devicePixelRatio", { value: 2 }) }));

test("the first picture takes 300 kB, and parts are loaded on demand", () => visit(async (page) => {
  const got = () => page.evaluate(() => Object.fromEntries(performance.getEntriesByType("resource").map(
    ({ name, encodedBodySize: size, startTime: from, responseEnd: to }) => [name.replace(/.*\//, ""), { size, from, to }])));
  await page.waitForSelector("#stage[data-hand=yes]");
  const all = await got(), hand = Object.keys(all).find((name) => name.endsWith(".glb"));
  const first = Object.entries(all).filter(([name]) => !/\.(wasm|glb)$/.test(name)), kB = first.reduce((sum, [, { size }]) => sum + size, 0) / 1000;
  assert.ok(kB < 300 && all["haptic_retargeting.wasm"].size < 450_000, `${kB} kB, and ${all["haptic_retargeting.wasm"].size} bytes of the plugin`);
  assert.ok(first.every(([, { to }]) => to <= all[hand].from), "the hand is loaded after the parts of the first picture");
  await page.goto(new URL("researchers.html", page.url()).href);
  await page.waitForSelector("#chart .uplot");
  const count = Object.keys(await got()).length;
  await choose(page, "wear");
  await page.locator("#wear-unavailable").waitFor();
  assert.ok(Object.keys(await got()).length > count, "the headset's part is loaded on demand");
}, { link: "" }));
