// Opens a page in headless Chromium, and waits for what it posts to /shown.
import { spawn } from "node:child_process";
import { mkdtemp, rm } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";

/** What the page "/" posts. `answer(path)` gives { type, body } of a path, or nothing; a string in its place is the
 *  address of a server that is there already, whose page posts to the address in its query. */
export async function shownBy(answer) {
  let onShown;
  const shown = new Promise((resolve) => { onShown = resolve; });
  const server = createServer(async (request, response) => {
    response.setHeader("access-control-allow-origin", "*");
    if (request.url === "/shown") {
      let text = "";
      for await (const part of request) text += part;
      response.end();
      onShown(text);
      return;
    }
    const file = typeof answer === "string" ? undefined : await answer(request.url);
    if (file) response.setHeader("content-type", file.type).end(file.body);
    else response.writeHead(404).end();
  });
  await new Promise((resolve) => { server.listen(0, "127.0.0.1", resolve); });
  const here = `http://127.0.0.1:${server.address().port}/`;

  const profile = await mkdtemp(join(tmpdir(), "hrt_browser_"));
  const browser = spawn("chromium", [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", `--user-data-dir=${profile}`,
    "--remote-debugging-port=0", typeof answer === "string" ? `${answer}?${here}shown` : here,
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
  browser.kill("SIGKILL");
  await ended;
  server.close();
  server.closeAllConnections();
  await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  return text;
}
