// A scripted visitor who sees the dot with a delay and steers it, without access to the true position of hand or plate.

/** Generates pointer motions, in metres on the plate, every `step_ms`; `seen()` returns the drawn dot. The visitor aims from the dot,
 *  as it was `delay_ms` ago, at the glass, corrects the error of direction by `gain` per second, and slows down near the glass. */
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
