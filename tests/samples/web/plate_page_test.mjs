// The page turns a plate on a serial line, in headless Chromium with a test double of the line.
import assert from "node:assert/strict";
import { test } from "node:test";
import { accessible, choose, frames, shoot, text, visit } from "./browser.mjs";
import { plateDouble, served } from "./plate_double.mjs";

const small = { width: 700, height: 500 };  // Chromium renders in software

test("a plate on a serial line follows commands and is drawn, and its stop is reported", () => visit(async (page) => {
  await choose(page, "hand");
  await frames(page, 50, 3);
  await page.click("#plate-serial");
  await served(page, 15);
  assert.match(await text(page, "#plate-state"), /^The plate turns from -90° to 90° at 300°\/s; its orientation is measured by its sensor\.$/);
  const at = () => page.evaluate(() => Number(globalThis.plateDouble.at));
  await page.locator("#stage").focus();
  await page.keyboard.down("ArrowUp");
  await served(page, 20);
  await page.keyboard.up("ArrowUp");
  assert.ok(Math.abs(await at()) > 15, `the plate was sent to ${await at()}`);
  await served(page, 3);
  const shown = Number(await page.locator("#stage").getAttribute("data-plate-deg"));
  assert.ok(Math.abs(shown - await at()) < 4, `drawn at ${shown}°, reported ${await at()}`);
  await accessible(page);
  await shoot(page, "plate_connected");
  await page.evaluate(() => globalThis.plateDouble.say("STOPPED emergency"));
  await served(page, 3);
  assert.equal(await text(page, "#plate-state"), "The plate was stopped by its emergency stop. Release it, then connect the plate again.");
  await page.waitForFunction(() => globalThis.plateDouble.closed, null, { polling: 20 });
  assert.match((await page.evaluate(() => globalThis.plateDouble.lines)).at(-1), /^STOP \d{5} \d{5}$/);
}, { motion: true, viewport: small, script: `(${plateDouble})()` }));

test("a browser without Web Serial is reported", () => visit(async (page) => {
  assert.equal(await page.isEnabled("#plate-serial"), false);
  assert.match(await text(page, "#plate-unavailable"), /no Web Serial/);
  assert.equal(await page.locator("#plate-unavailable").isVisible(), true);
}, { script: "Object.defineProperty(Navigator.prototype, 'serial', { value: undefined })" }));

test("a refused port is reported", () => visit(async (page) => {
  await page.click("#plate-serial");
  await page.locator("#plate-state", { hasText: "No plate is connected: No port selected by the user." }).waitFor();
  assert.equal(await page.isEnabled("#plate-serial"), true);
}, { script: `Object.defineProperty(navigator, "serial", { value: { requestPort: async () => { throw new Error("No port selected by the user."); } } })` }));
