// Opens the page in headless Chromium, for the tests in this folder.
//   usage of a test: node X_test.mjs FOLDER_OF_SAMPLES_WEB FOLDER_OF_THE_PAGE reach.csv desk.gltf FOLDER_OF_SCREENSHOTS
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdir, readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";

export const [, , sources, pageFolder, recorded, desk, screenshots] = process.argv;
export const require = createRequire(resolve(sources, "package.json"));
export const { launch, stopTime } = await import(pathToFileURL(resolve(sources, "headless.mjs")));
const axe = await readFile(require.resolve("axe-core/axe.min.js"), "utf8");
export const desktop = { width: 1440, height: 900 }, tablet = { width: 820, height: 1180 }, phone = { width: 390, height: 844 };

let server, address, browser;
before(async () => {
  await mkdir(screenshots, { recursive: true });
  server = spawn(process.execPath, [join(sources, "serve.mjs"), pageFolder, "0"], { stdio: ["ignore", "pipe", "inherit"] });
  address = await new Promise((ready, failed) => {
    server.stdout.once("data", (line) => ready(/http\S+/.exec(String(line))[0]));
    server.once("exit", (code) => failed(new Error(`serve.mjs ended with ${code}`)));
  });
  browser = await launch();
});
after(async () => {
  await browser?.close();
  server?.kill();
});

/** Opens a page, by default that for researchers in the mode "Watch", and calls `use` once the element `ready` exists.
 *  `before` is called before the page is opened; `script` runs in the page. `motion`: false: reduced motion; true: time
 *  passes in calls of frames() only; "real": as usual. `folder`: files to serve instead of the page. If `strict`, an
 *  error of the page or a request to another machine fails the test. `more`: options of the browser's context. */
export async function visit(use, { motion = false, viewport = desktop, colorScheme = "light", link = "researchers.html#mode=watch", from = browser,
                            base = address, folder = null, strict = true, script = null, before = () => {}, ready = "html[data-ready=yes]", ...more } = {}) {
  const context = await from.newContext({ viewport, colorScheme, reducedMotion: motion ? "no-preference" : "reduce", ...more });
  const page = await context.newPage(), faults = [];
  page.setDefaultTimeout(300_000);  // software rendering on a machine that other programs use too
  const file = (request) => join(folder, new URL(request.url()).pathname.replace(/\/$/, "/index.html"));
  if (folder) await context.route(`${base}**`, (route) => route.fulfill({ path: file(route.request()) }));
  if (script) await page.addInitScript(script);
  if (motion === true) await page.addInitScript(stopTime);
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("console", (message) => { if (message.type() === "error") faults.push(message.text()); });
  page.on("request", (request) => {
    const url = request.url().replace(/^blob:/, "");
    if (!url.startsWith(base) && !url.startsWith("data:")) faults.push(`request for ${url}`);
  });
  try {
    await before(page);
    await page.goto(base + link);
    await page.waitForSelector(ready);
    await use(page);
    if (strict) assert.deepEqual(faults, []);
  } finally {
    await context.close();
  }
}

/** Saves a picture of the page, once its hand is loaded if the page has one. */
export async function shoot(page, name, { fullPage = true, hand = true } = {}) {
  if (hand) await page.waitForSelector("#stage[data-hand=yes], #no-view:not([hidden])", { state: "attached" });
  await page.screenshot({ path: join(screenshots, `${name}.png`), fullPage });
}
export const text = (page, selector) => page.locator(selector).textContent();

/** Lets the page draw frames `elapsed_ms` apart. */
export async function frames(page, elapsed_ms, count = 1) {
  await page.evaluate(([elapsed, frameCount]) => {
    for (let i = 0; i < frameCount; ++i) globalThis.drawFrame(elapsed);
  }, [elapsed_ms, count]);
}

/** Waits until the page has drawn the last change by the visitor. */
export function drawn(page) {
  return page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
}

export async function accessible(page) {
  await page.evaluate(axe);  // through the browser's tools, since the page's policy allows only its own scripts
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html.slice(0, 120))]), []);
}

export function drop(page, name, content) {
  return page.evaluate(([fileName, fileText]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([fileText], fileName));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, [name, content]);
}

export const newest = async (page) => JSON.parse(await page.locator("#results tbody tr").first().getAttribute("data-result"));
export async function ended(page) {
  assert.equal(await phase(page), "arrived", await text(page, "#caption"));
  return JSON.parse(await page.locator("#stage").getAttribute("data-result"));
}
export const choose = (page, mode) => page.locator(`label:has(input[value=${mode}])`).click();

export async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
  return { name: download.suggestedFilename(), content: await readFile(await download.path(), "utf8") };
}

export const arrived = (result) => Math.abs(result.bearingError_deg) <= 1.5;
export const phase = (page) => page.locator("#stage").getAttribute("data-phase");
