// Runs the example of plugin/bindings/web for three.js in an emulated headset. The packed package and three.js are in
// node_modules, as a user installs them.
import { execFileSync } from "node:child_process";
import { copyFile, mkdir, mkdtemp, rename, rm, symlink } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { frames, pageFolder, sources, visit } from "./browser.mjs";
import { optional, without } from "./emulated.mjs";

const newest = join(dirname(fileURLToPath(import.meta.url)), "../../bindings/web/node_modules"), enter = "#VRButton";
let folder;
before(async () => {
  folder = await mkdtemp(join(tmpdir(), "hrt_examples_"));
  execFileSync("npm", ["pack", "--silent", join(pageFolder, "../npm")], { cwd: folder });
  execFileSync("sh", ["-c", "tar xzf haptic-retargeting-*.tgz"], { cwd: folder });
  const from = join(sources, "../../plugin/bindings/web/examples/three.html"), modules = join(folder, "node_modules");
  await mkdir(modules);
  await rename(join(folder, "package"), join(modules, "haptic-retargeting"));
  await symlink(join(newest, "three"), join(modules, "three"));
  await copyFile(from, join(folder, "index.html"));
});
after(() => rm(folder, { recursive: true, force: true }));

// In a browser with all optional properties of WebXR, in one with none, and in one without each property in turn.
for (const lacking of [[], optional, ...optional.map((each) => [each])]) test(
  `the example turns the plate for a reach of a tracked hand, without ${lacking}`, () => visit(async (page) => {
  await frames(page, 20, 5);
  await page.locator(enter).click();
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
  await page.locator("#words", { hasText: /^The finger ended (4|5)\.\d degrees from the cylinder\.$/ }).waitFor({ state: "attached" });  // it moved straight ahead
  await frames(page, 11, 2);
}, { motion: true, viewport: { width: 500, height: 400 }, script: without(lacking), folder, link: "", ready: enter }));
