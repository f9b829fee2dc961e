// The mode "Your scene": plate and targets of a glTF file, feasible gaps, and reaches of the simulated person to them.
import type { Library } from "haptic-retargeting";
import type { VisitorScene } from "../files/scene";
import { pageCourse } from "../geometry";
import { addRow, element, say, sideways } from "../page";
import type { Settings } from "../settings";
import { SimulatedReach } from "../simulated_reach";

export class SceneMode {
  scene: VisitorScene | null = null;
  /** Reaches of the simulated person to the chosen pair of targets. */
  readonly watch: SimulatedReach;
  readonly #about = element("scene-about", HTMLParagraphElement);
  readonly #pair = element("scene-pair", HTMLSelectElement);

  constructor(library: Library, settings: Readonly<Settings>, changed: () => void) {
    this.watch = new SimulatedReach(library, settings, ({ gap_deg }) => this.course ?? pageCourse(gap_deg));
    this.#pair.addEventListener("change", changed);
  }

  /** Targets of the chosen pair; null: no scene is open, or it has no pairs. */
  get course() {
    return this.scene?.pairs[this.#pair.selectedIndex]?.course ?? null;
  }

  show(scene: VisitorScene): void {
    this.scene = scene;
    const body = element("held-rows", HTMLTableSectionElement);
    body.replaceChildren();
    for (const { virtual, real, gap_deg, plates_deg } of scene.pairs)
      addRow(body, [virtual, real, `${gap_deg.toFixed(1)}°`, ...plates_deg.map((plate_deg) => sideways(plate_deg))]);
    this.#pair.replaceChildren(
      ...scene.pairs.map(({ virtual, real }) => new Option(`${virtual}; the hand ends at ${real}`)),
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
