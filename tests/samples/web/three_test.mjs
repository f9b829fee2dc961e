// The example for three.js developers as its document says: the packed package and three.js in node_modules, a static server,
// an emulated headset.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFile, mkdir, mkdtemp, readFile, rm, symlink } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";
import { after, before, test } from "node:test";
import { frames, pageFolder, require, screenshots, sources, visit } from "./browser.mjs";
import { headset } from "./emulated.mjs";

const types = { ".html": "text/html", ".mjs": "text/javascript", ".js": "text/javascript", ".wasm": "application/wasm" };
let folder, server;
before(async () => {
  folder = await mkdtemp(join(tmpdir(), "hrt_three_"));
  const example = join(sources, "../../plugin/bindings/web/examples/three.html");
  assert.ok((await readFile(example, "utf8")).trimEnd().split("\n").length <= 60);
  await copyFile(example, join(folder, "index.html"));
  await mkdir(join(folder, "node_modules"));
  await symlink(join(require.resolve("three"), "../.."), join(folder, "node_modules/three"));
  execFileSync("npm", ["pack", "--silent", join(pageFolder, "../npm")], { cwd: folder });
  execFileSync("sh", ["-c", "tar xzf haptic-retargeting-*.tgz && mv package node_modules/haptic-retargeting"], { cwd: folder });
  server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname)).replace(/^\/$/, "/index.html");
    try {
      const bytes = await readFile(join(folder, path));
      response.writeHead(200, { "content-type": types[extname(path)] ?? "application/octet-stream" }).end(bytes);
    } catch {
      response.writeHead(path === "/favicon.ico" ? 204 : 404).end();
    }
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
});
after(async () => {
  server?.close();
  await rm(folder, { recursive: true, force: true });
});

test("the three.js example leads a reach of a worn hand", () => visit(async (page) => {
  await page.locator("#VRButton", { hasText: "ENTER VR" }).click();
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
  assert.match(await page.textContent("#words"), /^The finger ended (4|5)\.\d degrees from the cylinder\.$/, "straight ahead, 5 degrees from it");
  await page.screenshot({ path: join(screenshots, "three_example.png") });
  await frames(page, 11, 2);
}, { motion: true, viewport: { width: 500, height: 400 }, script: headset, base: `http://127.0.0.1:${server.address().port}/`, ready: "#VRButton" }));
