// Draws reveal.gif, the animation of README.md: a scripted visitor steers the dot to the glass, then the hand is shown.
//   usage: node picture.mjs FOLDER_OF_THE_PAGE reveal.gif
import { writeFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import gifenc from "gifenc";
import { PNG } from "pngjs";
import { steer } from "../../tests/samples/web/visitor.mjs";
import { launch, stopTime } from "./headless.mjs";

const [, , folder, picture] = process.argv, shown_ms = 100;
if (!picture) {
  console.error("usage: node picture.mjs FOLDER_OF_THE_PAGE reveal.gif");
  process.exit(2);
}

const browser = await launch();
try {
  const page = await browser.newPage({ viewport: { width: 520, height: 640 } }), gif = gifenc.GIFEncoder();
  await page.addInitScript(stopTime);
  await page.goto(pathToFileURL(join(resolve(folder), "index.html")).href);
  await page.waitForSelector("#stage[data-hand=yes]");
  const shoot = async (delay) => {
    const { data, width, height } = PNG.sync.read(await page.locator("#stage").screenshot());
    const palette = gifenc.quantize(data, 48);
    gif.writeFrame(gifenc.applyPalette(data, palette), width, height, { palette, delay });
  };
  for (let i = 0; i < 15; ++i) await page.evaluate(() => globalThis.drawFrame(70));
  await shoot(1000);
  let passed_ms = 0;
  await steer(page, { drawn: async (elapsed_ms) => {
    passed_ms += elapsed_ms;
    if (passed_ms < shown_ms) return;
    passed_ms -= shown_ms;
    await shoot(shown_ms);
  } });
  await shoot(3000);
  gif.finish();
  await writeFile(picture, gif.bytes());
} finally {
  await browser.close();
}
