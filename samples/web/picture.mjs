// Draws the README's first picture: a simulated reach of the page, at its end.
//   usage: node picture.mjs FOLDER_OF_THE_PAGE picture.jpg
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [, , folder = join(dirname(fileURLToPath(import.meta.url)), "../../build/wasm/page"), picture] = process.argv;
if (!picture) {
  console.error("usage: node picture.mjs FOLDER_OF_THE_PAGE picture.jpg");
  process.exit(2);
}

const browser = await chromium.launch({ executablePath: "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
try {
  // With reduced motion the page shows a reach at its end, at once.
  const page = await browser.newPage({ viewport: { width: 1240, height: 1000 }, reducedMotion: "reduce", deviceScaleFactor: 1.25 });
  await page.goto(pathToFileURL(join(resolve(folder), "index.html")).href);
  await page.waitForSelector("html[data-ready=yes]");
  await page.evaluate(() => document.getElementById("again")?.click());  // the second reach: the person is known by now
  await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
  await page.locator("#stage").screenshot({ path: picture, type: "jpeg", quality: 80 });
} finally {
  await browser.close();
}
