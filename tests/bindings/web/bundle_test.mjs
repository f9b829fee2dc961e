// Tests the package without a bundler, and bundled by esbuild, Vite (also its development server) and webpack,
// configured as in the README, without warnings or imports of node's modules. Runs the README's example and the reach
// of all hosts in Chromium and Firefox.
//   usage: node bundle_test.mjs FOLDER_OF_THE_PACKAGE FOLDER_OF_THE_EXAMPLE reach.hash FOLDER_TO_WORK_IN
import assert from "node:assert/strict";
import { cp, mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { extname, join, resolve } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";
import esbuild from "esbuild";
import * as vite from "vite";
import webpack from "webpack";
import { browserNames, shownBy } from "./browser.mjs";

const [packageFolder, exampleFolder, hashFile, work] = process.argv.slice(2).map((path) => resolve(path));
const readme = await readFile(join(exampleFolder, "../README.md"), "utf8");
const [, example] = /^```js\n(.*?)^```/ms.exec(readme), [, shown] = /^```text\n(.*?)^```/ms.exec(readme);
const expected = `${shown}hash ${(await readFile(hashFile, "utf8")).trim()}`;
const types = { ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm" };

const main = (module) => `import * as hrt from "haptic-retargeting";
import { runReach } from "./reach.mjs";
${module}
let shown = "";
try {
  console.log = (line) => { shown += line + "\\n"; };
  await import("./readme.js");
  const { hash } = runReach(hrt, await hrt.load(${module && "wasm"}));
  shown += "hash " + hash;
} catch (error) {
  shown += String(error.stack ?? error);
}
await fetch(location.search.slice(1) || "/shown", { method: "POST", body: shown });
`;
const html = (script) => `<!doctype html><meta charset="utf-8"><title>reach</title><script type="module" src="${script}"></script>`;

/** Creates a user's project, with the package copied into node_modules as by npm. `module`: a statement that imports
 *  the WebAssembly module as `wasm`, which is passed to load(). */
async function project(name, module = "") {
  const folder = join(work, name);
  await rm(folder, { recursive: true, force: true });
  await mkdir(join(folder, "node_modules"), { recursive: true });
  await cp(packageFolder, join(folder, "node_modules/haptic-retargeting"), { recursive: true });
  await cp(join(exampleFolder, "reach.mjs"), join(folder, "reach.mjs"));
  await writeFile(join(folder, "main.js"), main(module));
  await writeFile(join(folder, "readme.js"), module ? `${module}\n${example.replace("hrt.load()", "hrt.load(wasm)")}` : example);
  await writeFile(join(folder, "index.html"), html("/main.js"));
  return folder;
}

async function runs(folder) {
  for (const name of await readdir(folder, { recursive: true })) {
    if (/\.m?js$/.test(name)) assert.doesNotMatch(await readFile(join(folder, name), "utf8"), /["'`]node:/, name);
  }
  for (const browser of browserNames) {
    assert.equal(await shownBy(async (path) => {
      const file = join(folder, path === "/" ? "index.html" : path);
      return types[extname(file)] && { type: types[extname(file)], body: await readFile(file) };
    }, browser), expected, browser);
  }
}

/** Adds a page to the bundle in dist/, and returns this folder. */
async function served(folder) {
  const out = join(folder, "dist");
  await writeFile(join(out, "index.html"), html("/main.js"));
  return out;
}

async function esbuildBundle(name, module, options) {
  const folder = await project(name, module);
  const { warnings } = await esbuild.build({ absWorkingDir: folder, entryPoints: ["main.js"], outdir: join(folder, "dist"), bundle: true,
    minify: true, format: "esm", logLevel: "silent", ...options });
  assert.deepEqual(warnings, []);
  return served(folder);
}

test("no bundler, the package's folder on the server", async () => {
  const folder = await project("none");
  for (const script of ["main.js", "readme.js"]) {
    const text = await readFile(join(folder, script), "utf8");
    await writeFile(join(folder, script), text.replace('"haptic-retargeting"', '"./node_modules/haptic-retargeting/index.mjs"'));
  }
  await rm(join(folder, "node_modules/haptic-retargeting/node.mjs"));
  await runs(folder);
});

test("esbuild, with the module copied beside the bundle", async () => {
  const out = await esbuildBundle("esbuild", "");
  await cp(join(packageFolder, "haptic_retargeting.wasm"), join(out, "haptic_retargeting.wasm"));
  await runs(out);
});

for (const [loader, where] of [["file", "as a separate file"], ["binary", "inside the bundle"]]) test(`esbuild, with the module ${where}`, async () => {
  await runs(await esbuildBundle(`esbuild_${loader}`, 'import wasm from "haptic-retargeting/haptic_retargeting.wasm";', { loader: { ".wasm": loader } }));
});

// Vite's configuration in the README.
const config = /^```js\n\/\/ vite\.config\.js\n(.*?)^```/ms.exec(readme)[1];
const { default: ofReadme } = await import(`data:text/javascript,${encodeURIComponent(config)}`);

function viteConfig(folder, warnings) {
  const warn = (text) => warnings.push(text);
  return { root: folder, configFile: false, logLevel: "warn", cacheDir: join(folder, ".vite"),
    customLogger: { info() {}, warn, warnOnce: warn, error: warn, clearScreen() {}, hasErrorLogged: () => false, hasWarned: false } };
}

test("Vite, built", async () => {
  const folder = await project("vite"), warnings = [];
  await vite.build({ ...viteConfig(folder, warnings), ...ofReadme });
  assert.deepEqual(warnings, []);
  await runs(join(folder, "dist"));
});

test("Vite, served while developing", async () => {
  const folder = await project("vite_served"), warnings = [];
  const server = await vite.createServer({ ...viteConfig(folder, warnings), server: { host: "127.0.0.1", port: 0, hmr: false, ws: false },
    ...ofReadme });
  await server.listen();
  for (const browser of browserNames) {
    assert.equal(await shownBy(`http://127.0.0.1:${server.httpServer.address().port}/`, browser), expected, browser);
  }
  await server.close();
  assert.deepEqual(warnings, []);
});

test("webpack", async () => {
  const folder = await project("webpack");
  const stats = await promisify(webpack)({ context: folder, entry: "./main.js", mode: "production", output: { path: join(folder, "dist") },
    performance: { hints: false } });
  const { errors, warnings } = stats.toJson({ errors: true, warnings: true });
  assert.deepEqual([errors, warnings], [[], []]);
  await runs(await served(folder));
});
