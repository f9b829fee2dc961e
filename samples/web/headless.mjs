// Headless Chromium that renders in software, and a replacement of a page's clock; used by picture.mjs and the tests.
import { chromium } from "playwright-core";

export function launch(...more) {
  return chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--disable-dev-shm-usage",
    "--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...more] });
}

/** Runs in the page: performance.now() and animation frames then advance by drawFrame() only. */
export function stopTime() {
  let now_ms = 0, waiting = [];
  performance.now = () => now_ms;
  globalThis.requestAnimationFrame = (callback) => waiting.push(callback);
  globalThis.framesWaiting = () => waiting.length;
  globalThis.drawFrame = (elapsed_ms) => {
    now_ms += elapsed_ms;
    for (const callback of waiting.splice(0)) callback(now_ms);
  };
}
