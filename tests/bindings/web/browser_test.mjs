// The package in headless Chromium: serves a page that loads the module and runs the reach of all hosts, and prints
// the hash that the page shows.
//   usage: node browser_test.mjs FOLDER_OF_THE_PACKAGE FOLDER_OF_THE_EXAMPLE reach.csv
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { shownBy } from "./browser.mjs";

const [, , packageFolder, exampleFolder, recording] = process.argv;

const page = `<!doctype html><meta charset="utf-8"><title>reach</title><pre id="shown">running</pre>
<script type="module">
const shown = document.getElementById("shown");
try {
  const hrt = await import("/package/index.mjs");
  const { runReach } = await import("/example/reach.mjs");
  const { hash, summary } = runReach(hrt, await hrt.load(), await (await fetch("/reach.csv")).text());
  shown.textContent = "hash " + hash + "\\n" + "miss " + summary.bearing_error_deg.toFixed(2) + " deg (simulated)";
} catch (error) {
  shown.textContent = String(error.stack ?? error);
}
await fetch("/shown", { method: "POST", body: shown.textContent });
</script>`;

const files = new Map([["/reach.csv", [recording, "text/csv"]], ["/example/reach.mjs", [join(exampleFolder, "reach.mjs"), "text/javascript"]]]);
for (const [name, type] of [["index.mjs", "text/javascript"], ["abi.js", "text/javascript"], ["frame.mjs", "text/javascript"],
                            ["memory.mjs", "text/javascript"], ["numbers.mjs", "text/javascript"], ["pose.mjs", "text/javascript"],
                            ["haptic_retargeting.wasm", "application/wasm"]]) {
  files.set(`/package/${name}`, [join(packageFolder, name), type]);
}

const text = await shownBy(async (path) => {
  if (path === "/") return { type: "text/html", body: page };
  if (!files.has(path)) return undefined;
  const [file, type] = files.get(path);
  return { type, body: await readFile(file) };
});
console.log(text);
process.exit(text.startsWith("hash ") ? 0 : 1);
