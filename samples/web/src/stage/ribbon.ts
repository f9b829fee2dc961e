// A path drawn flat on the plate, as a line that grows with the finger. Memory is taken once.
import type { InterleavedBufferAttribute } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

const capacity = 2000;
const minStep_m = 0.0005,
  maxStep_m = 0.001;

export class Ribbon extends LineSegments2 {
  readonly #buffer;
  #count = 0;
  #right_m = NaN;
  #away_m = NaN;
  #travelled_m = 0;
  #shown = 1;

  /** Dashes every `dash_m`, with round ends; 0: a solid line. */
  constructor(
    private readonly width_m: number,
    private readonly dash_m: number,
    height_m: number,
  ) {
    super(
      new LineSegmentsGeometry().setPositions(new Float32Array(6 * capacity)),
      new LineMaterial({
        worldUnits: true,
        linewidth: width_m,
        depthTest: false,
        transparent: true,
      }),
    );
    this.#buffer = (this.geometry.attributes.instanceStart as InterleavedBufferAttribute).data;
    this.position.y = height_m;
    this.frustumCulled = false;
    this.renderOrder = 5;
    this.reset();
  }

  reset(): void {
    this.#right_m = this.#away_m = NaN;
    this.#count = this.#travelled_m = 0;
    this.#show();
  }

  /** How much of it is drawn, from its start: 0 to 1. */
  set shown(share: number) {
    this.#shown = share;
    this.#show();
  }

  /** The path continues there. */
  extend(right_m: number, away_m: number): void {
    const far_m = Math.hypot(right_m - this.#right_m, away_m - this.#away_m),
      from = { right_m: this.#right_m, away_m: this.#away_m };
    if (far_m < minStep_m) return;
    // In pieces, so that a fast finger's dashes are as long as a slow one's; NaN: the first place.
    for (let i = 1, pieces = Math.ceil(far_m / maxStep_m) || 0; i <= pieces; ++i) {
      this.#extend(
        from.right_m + ((right_m - from.right_m) * i) / pieces,
        from.away_m + ((away_m - from.away_m) * i) / pieces,
        far_m / pieces,
      );
    }
    [this.#right_m, this.#away_m] = [right_m, away_m];
    this.#show();
  }

  #extend(right_m: number, away_m: number, far_m: number): void {
    const drawn = this.dash_m === 0 || this.#travelled_m % this.dash_m < this.dash_m / 2 - this.width_m / 2;
    if (drawn && this.#count < capacity) {
      this.#buffer.set([this.#right_m, 0, -this.#away_m, right_m, 0, -away_m], 6 * this.#count++);
      this.#buffer.needsUpdate = true;
    }
    this.#travelled_m += far_m;
    [this.#right_m, this.#away_m] = [right_m, away_m];
  }

  #show(): void {
    this.geometry.instanceCount = Math.round(this.#shown * this.#count);
  }
}
