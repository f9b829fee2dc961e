// The mode "Your scene": plate and targets of a glTF file, the table of feasible gaps, and reaches of the simulated person
// to its targets.
import type { Library } from "haptic-retargeting";
import { pageCourse } from "../controller";
import { type VisitorScene, weights } from "../files/scene";
import { addRow, element, say, sideways } from "../page";
import type { World } from "../person";
import type { Settings } from "../settings";
import { Watch } from "../watch";

export class Viewing {
  scene: VisitorScene | null = null;
  /** Reaches to the chosen pair of targets. */
  readonly watch: Watch;
  readonly #about = element("scene-about", HTMLParagraphElement);
  readonly #pair = element("scene-pair", HTMLSelectElement);

  /** `changed` is called when another pair is chosen. */
  constructor(library: Library, world: World, settings: Readonly<Settings>, changed: () => void) {
    this.watch = new Watch(library, world, settings, (now) => this.course ?? pageCourse(now));
    this.#pair.addEventListener("change", changed);
  }

  /** Targets of the chosen pair; null: no scene is open, or it has no pairs. */
  get course() {
    return this.scene?.pairs[this.#pair.selectedIndex]?.course ?? null;
  }

  show(scene: VisitorScene): void {
    this.scene = scene;
    const titles = element("held-titles", HTMLTableRowElement),
      body = element("held-rows", HTMLTableSectionElement);
    titles.replaceChildren();
    body.replaceChildren();
    for (const title of ["glass", "real", "gap", ...weights.map((weight) => `w = ${weight}`)]) {
      const cell = document.createElement("th");
      cell.scope = "col";
      cell.textContent = title;
      titles.append(cell);
    }
    for (const { virtual, real, gap_deg, plates_deg } of scene.pairs) {
      const plates = plates_deg.map((plate_deg) => (Number.isNaN(plate_deg) ? "–" : sideways(plate_deg)));
      addRow(body, [virtual, real, `${gap_deg.toFixed(1)}°`, ...plates]);
    }
    this.#pair.replaceChildren(
      ...scene.pairs.map(({ virtual, real }) => new Option(`${virtual}, felt; ${real}, reached`)),
    );
    const real = scene.targets.filter((target) => target.real).length;
    const meshes = scene.meshProblem ? ` Its meshes are not drawn: ${scene.meshProblem}.` : "";
    say(
      this.#about,
      `${scene.name}: a plate of ${(1000 * scene.plateRadius_m).toFixed(0)} mm radius, ${real} real and ` +
        `${scene.targets.length - real} virtual targets.${meshes}`,
    );
  }
}
