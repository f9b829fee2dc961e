// Draws the animation of the README: a visitor steers the dot to the glass, then the hand is shown.
//   usage: node picture.mjs FOLDER_OF_THE_PAGE reveal.gif
import { writeFile } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import gifenc from "gifenc";
import { PNG } from "pngjs";
import { visitor } from "../../tests/samples/web/visitor.mjs";
import { launch, stopTime } from "./headless.mjs";

const [, , folder, picture] = process.argv, step_ms = 20, shown_ms = 100;
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
  const draw = (ms) => page.evaluate((elapsed) => globalThis.drawFrame(elapsed), ms);
  const shoot = async (delay) => {
    const { data, width, height } = PNG.sync.read(await page.locator("#stage").screenshot());
    const palette = gifenc.quantize(data, 48);
    gif.writeFrame(gifenc.applyPalette(data, palette), width, height, { palette, delay });
  };
  for (let i = 0; i < 15; ++i) await draw(70);
  await shoot(1000);
  const box = await page.locator("#view").boundingBox();
  const [ring, glass] = await page.locator("#stage").evaluate((stage) => ["start", "glass"].map((name) => stage.dataset[name].split(" ").map(Number)));
  const px = Math.hypot(glass[0] - ring[0], glass[1] - ring[1]) / 0.1, onPlate = ([x, y]) => ({ right_m: x / px, away_m: -y / px });
  const go = visitor({ start: onPlate(ring), glass: onPlate(glass), delay_ms: 100, step_ms });
  let [x, y] = ring, dot = ring;
  await page.mouse.move(box.x + x, box.y + y);
  for (let ms = step_ms; dot && ms < 5000; ms += step_ms) {
    const { right_m, away_m } = go(onPlate(dot));
    [x, y] = [x + right_m * px, y - away_m * px];
    await page.mouse.move(box.x + x, box.y + y);
    await draw(step_ms);
    dot = await page.locator("#stage").evaluate(({ dataset }) => (dataset.phase === "arrived" ? null : dataset.dot.split(" ").map(Number)));
    if (ms % shown_ms === 0) await shoot(shown_ms);
  }
  for (let i = 0; i < 10; ++i) {
    await draw(shown_ms);
    await shoot(i === 9 ? 3000 : shown_ms);
  }
  gif.finish();
  await writeFile(picture, gif.bytes());
} finally {
  await browser.close();
}
