// A path that is drawn flat on the plate, and grows with each position.
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";

const capacity = 2000;
const minStep_m = 0.0005;

export class Ribbon extends Line2 {
  readonly #points: number[] = [];
  #shown = 1;

  /** `dash_m`: period of the dashes; 0: a solid line. */
  constructor(width_m: number, dash_m: number, height_m: number) {
    const dashes = { dashed: dash_m > 0, dashSize: dash_m / 2, gapSize: dash_m / 2 };
    super(
      new LineGeometry(),
      new LineMaterial({ worldUnits: true, linewidth: width_m, depthTest: false, transparent: true, ...dashes }),
    );
    this.position.y = height_m;
    this.frustumCulled = false;
    this.renderOrder = 5;
    this.reset();
  }

  reset(): void {
    this.#points.length = 0;
    this.visible = false;
  }

  /** Fraction of the path that is drawn, from its start: 0 to 1. */
  set shown(fraction: number) {
    this.#shown = fraction;
    this.#show();
  }

  extend(right_m: number, away_m: number): void {
    const [x = NaN, , z = NaN] = this.#points.slice(-3);
    if (Math.hypot(right_m - x, -away_m - z) < minStep_m || this.#points.length >= 3 * capacity) return;
    this.#points.push(right_m, 0, -away_m);
    if (this.#points.length < 6) return;
    this.geometry.dispose();
    this.geometry = new LineGeometry().setPositions(this.#points);
    this.computeLineDistances();
    this.#show();
  }

  #show(): void {
    this.geometry.instanceCount = Math.round(this.#shown * (this.#points.length / 3 - 1));
    this.visible = this.geometry.instanceCount > 0;
  }
}
