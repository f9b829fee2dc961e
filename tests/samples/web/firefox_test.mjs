// The page in Firefox: a slide by keys, and a watched reach. A script that is added to the page operates it.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { extname, join, resolve } from "node:path";
import { test } from "node:test";
import { shownBy } from "../../bindings/web/browser.mjs";

const folder = resolve(process.argv[3]);
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".glb": "model/gltf-binary" };

/** Runs in the page. */
async function visit() {
  const faults = [], at = (selector) => document.querySelector(selector);
  addEventListener("error", ({ message }) => faults.push(message));
  addEventListener("unhandledrejection", ({ reason }) => faults.push(String(reason)));
  const until = async (what) => { while (!at(what)) await new Promise((done) => setTimeout(done, 50)); };
  await until("html[data-ready=yes]");
  await until("#stage[data-hand=yes]");
  at("#stage").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowUp" }));
  await until("#stage[data-phase=arrived]");
  const slid = at("#spoken").textContent;
  at("input[value=watch]").click();
  await until("#results tbody tr");
  await fetch("/shown", { method: "POST", body: JSON.stringify({ slid, watched: at("#spoken").textContent, drawn: at("#no-view").hasAttribute("hidden"), faults }) });
}

test("a slide by keys and a watched reach work in Firefox", async () => {
  const { slid, watched, drawn, faults } = JSON.parse(await shownBy(async (path) => {
    const name = path === "/" ? "index.html" : path.slice(1);
    if (name === "visit.js") return { type: types[".js"], body: `(${visit})()` };
    if (!types[extname(name)]) return undefined;
    const body = await readFile(join(folder, name));
    return { type: types[extname(name)], body: name === "index.html" ? String(body).replace("</body>", '<script src="visit.js"></script></body>') : body };
  }, "firefox"));
  assert.match(slid, /Your hand is here, \d+ mm from the dot and \d+ mm from the cylinder\.$/);
  assert.match(watched, /^Arrived\. The hand is \d+\.\d mm from the cylinder/);
  assert.deepEqual([drawn, faults], [true, []]);
});
