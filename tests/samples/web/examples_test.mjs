// Runs the examples of plugin/bindings/web for three.js, A-Frame and react-three-fiber in an emulated headset. The packed package
// and the library are in node_modules, as a user installs them.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFile, mkdir, mkdtemp, readFile, rm, symlink, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, extname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { frames, pageFolder, sources, visit } from "./browser.mjs";
import { optional, without } from "./emulated.mjs";

const newest = join(dirname(fileURLToPath(import.meta.url)), "../../bindings/web/node_modules");
/** Selector of the button that enters the headset, and the copy of three.js that the library uses. */
const examples = { "three.html": ["#VRButton", "three"], "aframe.html": [".a-enter-vr-button", "aframe/node_modules/three"],
                   "fiber.jsx": ["#VRButton", "three"] };
let folder;
before(async () => {
  folder = await mkdtemp(join(tmpdir(), "hrt_examples_"));
  execFileSync("npm", ["pack", "--silent", join(pageFolder, "../npm")], { cwd: folder });
  execFileSync("sh", ["-c", "tar xzf haptic-retargeting-*.tgz"], { cwd: folder });
  for (const [name, [, three]] of Object.entries(examples)) {
    const from = join(sources, "../../plugin/bindings/web/examples", name), to = join(folder, name), modules = join(to, "node_modules");
    assert.ok((await readFile(from, "utf8")).trimEnd().split("\n").length <= 60, name);
    await mkdir(modules, { recursive: true });
    execFileSync("cp", ["-r", join(folder, "package"), join(modules, "haptic-retargeting")]);
    await symlink(join(newest, three), join(modules, "three"));
    await symlink(join(newest, "aframe"), join(modules, "aframe"));
    if (extname(name) === ".html") {
      await copyFile(from, join(to, "index.html"));
      continue;
    }
    await createRequire(join(newest, "../package.json"))("esbuild").build({
      stdin: { contents: await readFile(from, "utf8"), loader: "jsx", resolveDir: to }, outfile: join(to, "page.js"), bundle: true, format: "esm",
      jsx: "automatic", nodePaths: [newest], define: { "process.env.NODE_ENV": '"production"' }, target: "es2022" });
    await copyFile(join(folder, "package/haptic_retargeting.wasm"), join(to, "haptic_retargeting.wasm"));
    await writeFile(join(to, "index.html"), '<!doctype html><meta charset="utf-8"><body><script type="module" src="page.js"></script>');
  }
});
after(() => rm(folder, { recursive: true, force: true }));

// Each example runs in a browser with all optional properties of WebXR, and in one with none; that for three.js also without each one.
const runs = Object.keys(examples).flatMap((name) => [[name, []], [name, optional]]);
for (const [name, lacking] of [...runs, ...optional.map((each) => ["three.html", [each]])]) test(
  `${name} turns the plate for a reach of a tracked hand, without ${lacking}`, () => visit(async (page) => {
  await frames(page, 20, 5);
  await page.locator(examples[name][0]).click();
  await page.waitForFunction(() => globalThis.headset.device.activeSession?.renderState.baseLayer !== undefined, null, { polling: 20 });
  await page.waitForTimeout(200);
  await page.evaluate(() => {
    const eyes = globalThis.headset.device.position;
    for (let i = 0; i <= 180; ++i) {
      const s = Math.min(1, Math.max(0, i - 30) / 110), gone = 0.1 * (10 * s ** 3 - 15 * s ** 4 + 6 * s ** 5);
      globalThis.headset.moveTip(eyes.x, eyes.y - 0.35, eyes.z - 0.4 + 0.05 - gone);
      globalThis.drawFrame(1000 / 90);
    }
  });
  await page.locator("#words", { hasText: /^The finger ended (4|5)\.\d degrees from the cylinder\.$/ }).waitFor({ state: "attached" });  // straight ahead, 5 degrees from it
  await frames(page, 11, 2);
}, { motion: true, viewport: { width: 500, height: 400 }, script: without(lacking), folder, link: `${name}/`, ready: examples[name][0] }));
