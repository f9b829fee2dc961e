// Runs pages in Chromium and Firefox, on a machine without a display.
import { spawn } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";

const browsers = {
  chromium: (profile) => ["chromium", ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", `--user-data-dir=${profile}`, "--remote-debugging-port=0"]],
  firefox: (profile) => ["xvfb-run", ["-a", "firefox-esr", "--no-remote", "--profile", profile]],  // needs a display for WebGL
};
export const browserNames = Object.keys(browsers);
const quiet = ["browser.aboutwelcome.enabled", "browser.shell.checkDefaultBrowser", "datareporting.policy.dataSubmissionEnabled", "app.normandy.enabled",
               "extensions.update.enabled", "network.captive-portal-service.enabled", "browser.safebrowsing.downloads.remote.enabled"];

/** Opens a page in the browser `name`, and returns the text that the page posts, or an error. `answer`: a function that
 *  returns { type, body } of the page's files, or nothing; or the address of a running server, whose page posts to the
 *  address in its query. */
export async function shownBy(answer, name) {
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
  await writeFile(join(profile, "user.js"), quiet.map((setting) => `user_pref("${setting}", false);\n`).join(""));
  const [program, options] = browsers[name](profile);
  const browser = spawn(program, [...options, typeof answer === "string" ? `${answer}?${here}shown` : here],
    { stdio: ["ignore", "ignore", "pipe"], env: { ...process.env, HOME: profile }, detached: true });
  let complaints = "";
  browser.stderr.on("data", (data) => { complaints += data; });
  const ended = new Promise((resolve) => {
    browser.on("error", (error) => resolve(`${program} does not start: ${error.message}`));
    browser.on("exit", (code) => resolve(`${program} ended with ${code} before the page posted anything:\n${complaints}`));
  });
  const late = new Promise((resolve) => {
    setTimeout(resolve, 60_000, `the page posted nothing in 60 s:\n${complaints}`).unref();
  });

  const text = await Promise.race([shown, ended, late]);
  try { process.kill(-browser.pid, "SIGKILL"); } catch { /* it has ended */ }
  await ended;
  server.close();
  server.closeAllConnections();
  await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  return text;
}
