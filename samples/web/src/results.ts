// The table of reaches, the newest first.
import { warnings } from "./controller";
import { addRow, element } from "./page";
import type { ControllerName } from "./settings";
import type { ReachResult } from "./simulated_reach";

const rowsKept = 10;
const arrived_deg = 1.5;
const controllerTexts: Readonly<Record<ControllerName, string>> = { off: "off", paper: "the paper's", ours: "ours" };

export class Results {
  readonly #body = element("result-rows", HTMLTableSectionElement);

  clear(): void {
    this.#body.replaceChildren();
  }

  add(result: Readonly<ReachResult>): void {
    const off = `${Math.abs(result.bearingError_deg).toFixed(1)}°, ${result.toCylinder_mm.toFixed(1)} mm`;
    const hit = Math.abs(result.bearingError_deg) <= arrived_deg;
    const learns = result.weightSd > 0 && result.controller === "ours";
    const estimate = learns
      ? `${result.weight.toFixed(2)} ± ${(1.96 * result.weightSd).toFixed(2)}`
      : result.controller === "paper"
        ? `${result.weight.toFixed(2)}, fixed`
        : "–";
    const cells = [
      String(result.number),
      controllerTexts[result.controller],
      `${hit ? "✓" : "✗"} ${off}`,
      `${result.peakFeltError_deg.toFixed(1)}°`,
      estimate,
      result.controller === "off" ? "" : warnings(result.flags).join("; "),
    ];
    const row = addRow(this.#body, cells, 0);
    for (const [name, value] of Object.entries(result)) {
      // peakFeltError_deg becomes peakFeltErrorDeg
      row.dataset[name.replace(/_(.)/g, (_, letter: string) => letter.toUpperCase())] = String(value);
    }
    while (this.#body.rows.length > rowsKept) this.#body.deleteRow(-1);
  }
}

/** Describes the result of a reach in a sentence. */
export function resultText(result: Readonly<ReachResult>): string {
  const end =
    `The hand is ${result.toCylinder_mm.toFixed(1)} mm from the cylinder; the simulated person feels it ` +
    `${result.feltToGlass_mm.toFixed(1)} mm from the glass.`;
  if (result.controller === "off") return `${end} The plate did not turn.`;
  return Math.abs(result.bearingError_deg) <= arrived_deg ? `Arrived. ${end}` : `Missed. ${end}`;
}
