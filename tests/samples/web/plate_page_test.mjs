// The page turns a plate, in headless Chromium: with a test double of a serial port, and with the plate's firmware.
import assert from "node:assert/strict";
import { test } from "node:test";
import { accessible, arrived, frames, newest, phase, shoot, text, visit } from "./browser.mjs";

const small = { width: 700, height: 500 };  // Chromium renders in software

/** Runs in the page: a serial port with a plate that turns immediately, and garbage between its lines. */
function plateDouble() {
  const crc = (text) => [...text].reduce((sum, c) => {
    sum ^= c.charCodeAt(0) << 8;
    for (let bit = 0; bit < 8; ++bit) sum = sum & 0x8000 ? ((sum << 1) ^ 0x1021) & 0xffff : (sum << 1) & 0xffff;
    return sum;
  }, 0xffff).toString(16).toUpperCase().padStart(4, "0");
  const double = globalThis.plateDouble = { at: "+000.00", lines: [], closed: false };
  let toPage, rest = "";
  double.say = (body) => toPage.enqueue(new TextEncoder().encode(`\u0000x*\nAT +089.00 00001*0000\n${body}*${crc(body)}\n`));
  const port = {
    open: async () => {}, close: async () => { double.closed = true; },
    readable: new ReadableStream({ start(controller) { toPage = controller; } }),
    writable: new WritableStream({ write(chunk) {
      rest += new TextDecoder().decode(chunk);
      for (let end = rest.indexOf("\n"); end >= 0; end = rest.indexOf("\n")) {
        const [body, sum] = rest.slice(0, end).split("*");
        rest = rest.slice(end + 1);
        if (sum !== crc(body)) throw new Error(`a damaged line: ${body}`);
        const words = body.split(" ");
        double.lines.push(body);
        if (words[0] === "HELLO") double.say("PLATE 2 -90.00 90.00 300.00 20.00 measured");
        if (words[0] === "SET") double.at = words[1];
        double.say(`AT ${double.at} ${words[0] === "HELLO" ? "00000" : words.at(-2)}`);
      }
    } }),
  };
  Object.defineProperty(navigator, "serial", { configurable: true, value: { requestPort: async () => port } });
}

/** Draws frames with enough time between them for a port to answer. */
async function served(page, count) {
  for (let i = 0; i < count; ++i) {
    await frames(page, 40);
    await page.waitForTimeout(10);
  }
}

test("a plate on a serial line follows commands and is drawn, and its stop is reported", () => visit(async (page) => {
  await page.locator("label:has(input[value=hand])").click();
  await frames(page, 50, 3);
  await page.click("#plate-serial");
  await served(page, 15);
  assert.match(await text(page, "#plate-state"), /^Plate: -90° to 90° at 300°\/s; measured by its sensor\.$/);
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
  assert.equal(await text(page, "#plate-state"), "The plate was stopped by its emergency stop.");
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

test("the servo pulse of the firmware in the page turns the plate of a reach", () => visit(async (page) => {
  await page.click("#plate-firmware");
  await page.locator("#plate-stop").waitFor();  // until the emulator is loaded
  await frames(page, 50, 20);
  assert.match(await text(page, "#plate-state"), /^Emulated board: -90° to 90° at 200°\/s; measured .* (No pulse yet|Pulse \d+\.\d µs, servo at -?\d+\.\d°)\.$/);
  await page.selectOption("#speed", "1");
  await page.click("#again");
  for (let i = 0; i < 60 && await phase(page) !== "arrived"; ++i) await frames(page, 50);
  const result = await newest(page);
  assert.ok(arrived(result), `bearing error ${result.bearingErrorDeg}`);
  const [, pulse, servo] = /Pulse (\S+) µs, servo at (\S+)°/.exec(await text(page, "#plate-state"));
  assert.ok(Math.abs(Number(servo)) > 15 && Math.abs(Number(pulse) - 1500) > 150, "the plate turned");
  await shoot(page, "plate_firmware");
  await page.click("#plate-stop");
  assert.equal(await text(page, "#plate-state"), "The plate was disconnected.");
  assert.equal(await page.isEnabled("#plate-firmware"), true);
}, { motion: true, viewport: small }));
