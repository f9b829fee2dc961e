// The package in node, whose fetch() does not read files.
import { readFile } from "node:fs/promises";
import * as web from "./index.mjs";
export * from "./index.mjs";

export async function load(source = new URL("./haptic_retargeting.wasm", import.meta.url)) {
  const isFile = (typeof source === "string" || source instanceof URL) && String(source).startsWith("file:");
  return web.load(isFile ? await readFile(new URL(source)) : source);
}
