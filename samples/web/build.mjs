// Bundles the page into a folder that any static server can serve.
//   usage: node build.mjs FOLDER_OF_THE_NPM_PACKAGE person.wasm plate_firmware.hex FOLDER_OF_THE_PAGE
import { cp, mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const [, , packageFolder, personModule, firmware, pageFolder] = process.argv;
const here = dirname(fileURLToPath(import.meta.url));

await mkdir(pageFolder, { recursive: true });
await build({
  entryPoints: [join(here, "src/main.ts")],
  outfile: join(pageFolder, "page.js"),
  bundle: true,
  minify: true,
  format: "iife",  // a module would not load from a file: address
  target: "es2022",
  platform: "browser",
  legalComments: "none",  // licences.txt has them
  alias: { "haptic-retargeting": resolve(packageFolder), "haptic-retargeting/three": resolve(packageFolder, "three.mjs"), "person.wasm": resolve(personModule),
           "plate_firmware.hex": resolve(firmware), "marks.csv": join(here, "../plate/model/marks.csv") },
  nodePaths: [join(here, "node_modules")],  // three.js, for the package
  loader: { ".wasm": "binary", ".hex": "text", ".csv": "text" },
  define: { "import.meta.url": '"about:blank"' },
  tsconfigRaw: {},
  logLevel: "warning",
});
for (const file of ["index.html", "page.css"]) await cp(join(here, "src", file), join(pageFolder, file));

const licences = [["This page and the plugin", join(packageFolder, "LICENSE")],
                  ["Libraries within the plugin", join(packageFolder, "THIRD_PARTY_NOTICES.md")],
                  ["three.js", join(here, "node_modules/three/LICENSE")],
                  ["avr8js", join(here, "node_modules/avr8js/LICENSE")]];
const texts = await Promise.all(licences.map(async ([name, path]) => `# ${name}\n\n${await readFile(path, "utf8")}`));
await writeFile(join(pageFolder, "licences.txt"), texts.join("\n\n"));
