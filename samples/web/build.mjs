// Bundles the page into a folder that any static server can serve.
//   usage: node build.mjs FOLDER_OF_THE_NPM_PACKAGE FOLDER_OF_THE_PAGE
// The environment variable HRT_PAGE_URL is the address, with a final slash, at which the folder will be served. Links
// to the page have a preview picture only if it is set.
import { createHash } from "node:crypto";
import { appendFile, cp, mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";
import { build } from "esbuild";

const [, , packageFolder, pageFolder] = process.argv;
const here = dirname(fileURLToPath(import.meta.url)), modules = join(here, "node_modules"), hands = join(modules, "@webxr-input-profiles/assets");

// Two bundles: a page from a server loads page.js and, when they are needed, further parts. A page at a file: address
// cannot load parts: start.js then loads offline.js, which contains everything.
const shared = {
  entryPoints: [{ in: join(here, "src/main.ts"), out: "page" }],
  outdir: pageFolder,
  bundle: true,
  minify: true,
  target: "es2022",
  platform: "browser",
  legalComments: "none",  // licences.txt contains them
  alias: { "haptic-retargeting": resolve(packageFolder), "haptic-retargeting/three": resolve(packageFolder, "three.mjs"),
           "marks.csv": join(here, "../plate/model/marks.csv"),
           "generic-hand": join(hands, "dist/profiles/generic-hand") },
  nodePaths: [modules],  // where three.mjs of the npm package finds three.js
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
// start.js becomes an inline script of index.html, so that the browser requests the files of the first picture
// immediately. The Content-Security-Policy of index.html allows the script by its hash.
const page = Object.entries(outputs).find(([name]) => basename(name) === "page.js")[1];
const parts = ["page.js", ...page.imports.filter(({ kind }) => kind === "import-statement").map(({ path }) => basename(path)),
               "haptic_retargeting.wasm"].map((name) => `"${name}"`);
const start = (await readFile(join(here, "src/start.js"), "utf8")).replace("/* parts */", parts.join(", "));
const html = (await readFile(join(here, "src/index.html"), "utf8")).replace(' src="start.js">', `>${start}`)
  .replace("script-src 'self'", `script-src 'self' 'sha256-${createHash("sha256").update(start).digest("base64")}'`)
  .replace('"reveal.gif"', `"${process.env.HRT_PAGE_URL ?? ""}reveal.gif"`);
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

// Copies compressed by Brotli, which a server may send instead of the files.
for (const name of await readdir(pageFolder)) {
  if (["offline.js", "reveal.gif"].includes(name)) continue;  // the served page does not load them
  await writeFile(join(pageFolder, `${name}.br`), brotliCompressSync(await readFile(join(pageFolder, name))));
}
