// The emulated headset (headset.ts) as a script for a page.
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { require, sources } from "./browser.mjs";

const { outputFiles: [{ text }] } = await require("esbuild").build({
  entryPoints: [join(dirname(fileURLToPath(import.meta.url)), "headset.ts")], bundle: true, write: false, format: "iife",
  target: "es2022", tsconfigRaw: {}, nodePaths: [join(sources, "node_modules")], logLevel: "warning",
});
export const headset = text;
