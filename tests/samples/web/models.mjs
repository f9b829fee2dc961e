// Bundles models.ts, for the tests under node.
//   usage of a test: node X_test.mjs FOLDER_OF_SAMPLES_WEB FOLDER_OF_THE_NPM_PACKAGE reach.hash
import { mkdtemp, rm } from "node:fs/promises";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const [, , page, packageFolder, reachHash] = process.argv;
export { reachHash };
const { build } = createRequire(resolve(page, "package.json"))("esbuild");
const folder = await mkdtemp(join(tmpdir(), "hrt_page_"));
await build({
  entryPoints: [join(dirname(fileURLToPath(import.meta.url)), "models.ts")],
  outfile: join(folder, "models.mjs"), bundle: true, format: "esm", platform: "node", target: "es2022", tsconfigRaw: {},
  alias: { "haptic-retargeting": resolve(packageFolder), "haptic-retargeting/three": resolve(packageFolder, "three.mjs"),
           "marks.csv": resolve(page, "../plate/model/marks.csv"),
           "generic-hand": resolve(page, "node_modules/@webxr-input-profiles/assets/dist/profiles/generic-hand") },
  nodePaths: [resolve(page, "node_modules")],
  loader: { ".wasm": "binary", ".glb": "binary", ".csv": "text" }, logLevel: "warning",
});
export const models = await import(pathToFileURL(join(folder, "models.mjs")));
await rm(folder, { recursive: true, force: true });
