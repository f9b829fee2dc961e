// The package in headless Chromium: serves a page that loads the module and runs the reach of all hosts, and prints
// the hash that the page shows.
//   usage: node browser_test.mjs FOLDER_OF_THE_PACKAGE FOLDER_OF_THE_EXAMPLE reach.csv
import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [, , packageFolder, exampleFolder, recording] = process.argv;

const page = `<!doctype html><meta charset="utf-8"><title>reach</title><pre id="shown">running</pre>
<script type="module">
const shown = document.getElementById("shown");
try {
  const hrt = await import("/package/index.mjs");
  const { runReach } = await import("/example/reach.mjs");
  const { hash, summary } = runReach(hrt, await hrt.load(), await (await fetch("/reach.csv")).text());
  shown.textContent = "hash " + hash + "\\n" + "miss " + summary.final_miss_deg.toFixed(2) + " deg (simulated)";
} catch (error) {
  shown.textContent = String(error.stack ?? error);
}
await fetch("/shown", { method: "POST", body: shown.textContent });
</script>`;

const files = new Map([["/reach.csv", [recording, "text/csv"]], ["/example/reach.mjs", [join(exampleFolder, "reach.mjs"), "text/javascript"]]]);
for (const [name, type] of [["index.mjs", "text/javascript"], ["abi.js", "text/javascript"],
                            ["haptic_retargeting.wasm", "application/wasm"]]) {
  files.set(`/package/${name}`, [join(packageFolder, name), type]);
}

let onShown;
const shown = new Promise((resolve) => { onShown = resolve; });
const server = createServer(async (request, response) => {
  if (request.url === "/") {
    response.setHeader("content-type", "text/html").end(page);
  } else if (request.url === "/shown") {
    let text = "";
    for await (const part of request) text += part;
    response.end();
    onShown(text);
  } else if (files.has(request.url)) {
    const [path, type] = files.get(request.url);
    response.setHeader("content-type", type).end(await readFile(path));
  } else {
    response.writeHead(404).end();
  }
});
await new Promise((resolve) => { server.listen(0, "127.0.0.1", resolve); });

const profile = await mkdtemp(join(tmpdir(), "hrt_browser_"));
const browser = spawn("chromium", [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", `--user-data-dir=${profile}`,
  "--remote-debugging-port=0", `http://127.0.0.1:${server.address().port}/`,
], { stdio: ["ignore", "ignore", "pipe"] });
let complaints = "";
browser.stderr.on("data", (data) => { complaints += data; });
const ended = new Promise((resolve) => {
  browser.on("error", (error) => resolve(`chromium does not start: ${error.message}`));
  browser.on("exit", (code) => resolve(`chromium ended with ${code} before the page showed anything:\n${complaints}`));
});
const late = new Promise((resolve) => {
  setTimeout(resolve, 60_000, `the page showed nothing in 60 s:\n${complaints}`).unref();
});

const text = await Promise.race([shown, ended, late]);
console.log(text);
browser.kill("SIGKILL");
await ended;
server.close();
server.closeAllConnections();
await rm(profile, { recursive: true, force: true, maxRetries: 5 });
process.exit(text.startsWith("hash ") ? 0 : 1);
