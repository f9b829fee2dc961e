// A scripted visitor, who sees the dot with a delay, and steers it to the glass. The visitor knows neither the true
// position of the hand nor the plate orientation.

/** Returns a function that receives the position of the dot every `step_ms`, and returns the next motion of the hand,
 *  in metres. The visitor sees the dot as it was `delay_ms` ago, turns its direction of motion towards the glass with
 *  `gain` per second, and slows down near the glass. */
export function visitor({ glass, start, delay_ms, step_ms = 10, gain = 2, speed_m_s = 0.1 }) {
  const seen = [];
  let heading = Math.atan2(glass.right_m - start.right_m, glass.away_m - start.away_m), speed = 0;
  return (dot) => {
    seen.push({ ...dot });
    const late = seen[Math.max(0, seen.length - 1 - Math.round(delay_ms / step_ms))], before = seen[Math.max(0, seen.length - 6 - Math.round(delay_ms / step_ms))];
    const right_m = glass.right_m - late.right_m, away_m = glass.away_m - late.away_m, left_m = Math.hypot(right_m, away_m);
    const went = [late.right_m - before.right_m, late.away_m - before.away_m];
    if (Math.hypot(...went) > 1e-3) {
      const wrong = Math.atan2(right_m, away_m) - Math.atan2(...went);
      heading += (gain * step_ms / 1000) * Math.atan2(Math.sin(wrong), Math.cos(wrong));
    }
    speed += Math.min(speed_m_s * step_ms / 300, Math.min(speed_m_s, Math.max(0.01, 2.5 * left_m)) - speed);
    const step_m = speed * step_ms / 1000;
    return { right_m: step_m * Math.sin(heading), away_m: step_m * Math.cos(heading) };
  };
}

/** Returns the position of the ring, the glass or the dot in the window. */
export async function place(page, name) {
  const box = await page.locator("#view").boundingBox(), at = await page.locator("#stage").getAttribute(`data-${name}`);
  return at.split(" ").map((number, i) => Number(number) + [box.x, box.y][i]);
}

/** Lets a visitor steer the dot to the glass by mouse, on a page after stopTime(). `grip`: offset from the ring, in
 *  pixels, at which the button is pressed; null: it is not pressed. Stops when the fraction `until` of the path
 *  remains. Calls `drawn` with the duration of each frame. Returns the position of the mouse in the window. */
export async function steer(page, { delay_ms = 100, grip = null, until = 0, drawn = () => {} } = {}) {
  const step_ms = 40, frame = (elapsed_ms) => page.evaluate((ms) => globalThis.drawFrame(ms), elapsed_ms);
  for (let i = 0; i < 9; ++i) await frame(100);  // slow frames, after which the picture is simplified and drawn faster
  const ring = await place(page, "start"), glass = await place(page, "glass"), from = ring.map((x, i) => x + (grip?.[i] ?? 0));
  const px = Math.hypot(glass[0] - ring[0], glass[1] - ring[1]) / 0.1, onPlate = ([x, y]) => ({ right_m: x / px, away_m: -y / px });
  const go = visitor({ start: onPlate(ring), glass: onPlate(glass), delay_ms, step_ms });
  let [x, y] = from;
  await page.mouse.move(x, y);
  if (grip) await page.mouse.down();
  let dot = ring;
  for (let i = 0; dot && Math.hypot(glass[0] - dot[0], glass[1] - dot[1]) >= until * 0.1 * px; ++i) {
    if (i === 300) throw new Error("the dot has not come to the glass");
    const { right_m, away_m } = go(onPlate(dot));
    [x, y] = [x + right_m * px, y - away_m * px];
    await page.mouse.move(x, y);
    dot = await page.evaluate((elapsed_ms) => {
      globalThis.drawFrame(elapsed_ms);
      const { phase, dot } = document.getElementById("stage").dataset, { x, y } = document.getElementById("view").getBoundingClientRect();
      return phase === "arrived" ? null : dot.split(" ").map((number, k) => Number(number) + [x, y][k]);
    }, step_ms);
    await drawn(step_ms);
  }
  if (grip) await page.mouse.up();
  for (let i = 0; i < 10; ++i) {
    await frame(100);
    await drawn(100);
  }
  return [x, y];
}
