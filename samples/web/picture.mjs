// Draws the README's moving picture: a visitor goes to the glass, and is shown the hand.
//   usage: node picture.mjs FOLDER_OF_THE_PAGE reveal.gif
import { writeFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import gifenc from "gifenc";
import { PNG } from "pngjs";
import { launch, stopTime } from "./headless.mjs";

const [, , folder, picture] = process.argv, frame_ms = 70;
if (!picture) {
  console.error("usage: node picture.mjs FOLDER_OF_THE_PAGE reveal.gif");
  process.exit(2);
}

const browser = await launch();
try {
  const page = await browser.newPage({ viewport: { width: 600, height: 620 } }), gif = gifenc.GIFEncoder();
  await page.addInitScript(stopTime);
  await page.goto(pathToFileURL(join(resolve(folder), "index.html")).href);
  await page.waitForSelector("html[data-ready=yes]");
  const shoot = async (delay) => {
    await page.evaluate((elapsed) => globalThis.drawFrame(elapsed), frame_ms);
    const { data, width, height } = PNG.sync.read(await page.locator("#stage").screenshot());
    const palette = gifenc.quantize(data, 96);
    gif.writeFrame(gifenc.applyPalette(data, palette), width, height, { palette, delay });
  };
  for (let i = 0; i < 15; ++i) await page.evaluate((elapsed) => globalThis.drawFrame(elapsed), frame_ms);
  await shoot(1000);
  const box = await page.locator("#view").boundingBox();
  const [ring, glass] = await page.locator("#stage").evaluate((stage) => ["start", "glass"].map((name) => stage.dataset[name].split(" ").map(Number)));
  for (let i = 0; i <= 20; ++i) {
    const s = i / 20, gone = s * s * (3 - 2 * s);
    await page.mouse.move(...ring.map((from, k) => [box.x, box.y][k] + from + gone * (glass[k] - from)));
    await shoot(frame_ms);
  }
  for (let i = 0; i < 14; ++i) await shoot(i === 13 ? 3000 : frame_ms);
  gif.finish();
  await writeFile(picture, gif.bytes());
} finally {
  await browser.close();
}
