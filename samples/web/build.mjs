// Bundles the page into a folder that any static server can serve. HRT_PAGE_URL is the address of the page there, which ends in
// a slash; the preview picture of links to the page needs it.
//   usage: node build.mjs FOLDER_OF_THE_NPM_PACKAGE FOLDER_OF_THE_PAGE
import { createHash } from "node:crypto";
import { appendFile, cp, mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";
import { build } from "esbuild";

const [, , packageFolder, pageFolder] = process.argv;
const here = dirname(fileURLToPath(import.meta.url)), modules = join(here, "node_modules"), hands = join(modules, "@webxr-input-profiles/assets");

// From a server, the page loads page.js for the first picture, and further parts when they are needed. A file: address cannot
// load parts, so offline.js contains everything. start.js chooses between the two.
const shared = {
  entryPoints: [{ in: join(here, "src/main.ts"), out: "page" }],
  outdir: pageFolder,
  bundle: true,
  minify: true,
  target: "es2022",
  platform: "browser",
  legalComments: "none",  // they are in licences.txt
  alias: { "haptic-retargeting": resolve(packageFolder), "haptic-retargeting/three": resolve(packageFolder, "three.mjs"),
           "marks.csv": join(here, "../plate/model/marks.csv"),
           "generic-hand": join(hands, "dist/profiles/generic-hand") },
  nodePaths: [modules],  // three.js, for the package
  define: { "import.meta.url": '"about:blank"' },
  tsconfigRaw: {},
  logLevel: "warning",
};
const loader = { ".csv": "text" };
await rm(pageFolder, { recursive: true, force: true });
await mkdir(pageFolder, { recursive: true });
const { metafile: { outputs } } = await build({ ...shared, metafile: true, format: "esm", splitting: true, chunkNames: "part_[hash]", assetNames: "[name]", loader: { ...loader, ".wasm": "file", ".glb": "file" } });
await build({ ...shared, entryPoints: [{ in: join(here, "src/main.ts"), out: "offline" }], format: "iife", loader: { ...loader, ".wasm": "binary", ".glb": "binary" } });
await cp(join(here, "src/page.css"), join(pageFolder, "page.css"));
await cp(join(here, "reveal.gif"), join(pageFolder, "reveal.gif"));
// start.js, which preloads the files of the first picture, is part of the page, so that the browser requests them immediately.
// The page's policy allows it by its hash.
const page = Object.entries(outputs).find(([name]) => basename(name) === "page.js")[1];
const parts = ["page.js", ...page.imports.filter(({ kind }) => kind === "import-statement").map(({ path }) => basename(path)),
               "haptic_retargeting.wasm"].map((name) => `"${name}"`);
const start = (await readFile(join(here, "src/start.js"), "utf8")).replace("/* parts */", parts.join(", "));
const html = (await readFile(join(here, "src/index.html"), "utf8")).replace(' src="start.js">', `>${start}`)
  .replace("script-src 'self'", `script-src 'self' 'sha256-${createHash("sha256").update(start).digest("base64")}'`)
  .replace('"reveal.gif"', `"${process.env.HRT_PAGE_URL ?? ""}reveal.gif"`);  // the preview of a link needs an absolute address
await writeFile(join(pageFolder, "index.html"), html);
await writeFile(join(pageFolder, "researchers.html"), html.replace("<body>", '<body class="researchers">').replaceAll("<details id=", "<details open id="));
await appendFile(join(pageFolder, "page.css"), await readFile(join(modules, "uplot/dist/uPlot.min.css")));

const licences = [["This page and the plugin", join(packageFolder, "LICENSE")],
                  ["Libraries within the plugin", join(packageFolder, "THIRD_PARTY_NOTICES.md")],
                  ["three.js", join(modules, "three/LICENSE")],
                  ["The hand's model, of webxr-input-profiles", join(hands, "LICENSE.md")],
                  ["uPlot", join(modules, "uplot/LICENSE")]];
const texts = await Promise.all(licences.map(async ([name, path]) => `# ${name}\n\n${await readFile(path, "utf8")}`));
await writeFile(join(pageFolder, "licences.txt"), texts.join("\n\n"));

// Compressed copies, at the highest quality, which takes too long for a request. A server may send them instead of the files.
for (const name of await readdir(pageFolder)) {
  if (["offline.js", "reveal.gif"].includes(name)) continue;  // not loaded by the page on a server
  await writeFile(join(pageFolder, `${name}.br`), brotliCompressSync(await readFile(join(pageFolder, name))));
}
