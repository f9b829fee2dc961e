// A path drawn flat on the plate, as a band that grows with the finger. Memory is taken once.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial, type ColorRepresentation } from "three";

const capacity = 2000;
const minStep_m = 0.0005, maxStep_m = 0.001;

export class Ribbon extends Mesh<BufferGeometry, MeshBasicMaterial> {
  readonly #halfWidth_m: number;
  readonly #dash_m: number;
  readonly #positions: BufferAttribute;
  #count = 0;
  #right_m = NaN;
  #away_m = NaN;
  #travelled_m = 0;
  #shown = 1;

  /** Dashes and gaps of `dash_m`; 0: a solid band. */
  constructor(width_m: number, dash_m: number, height_m: number) {
    const geometry = new BufferGeometry();
    const positions = new BufferAttribute(new Float32Array(capacity * 6 * 3), 3);
    geometry.setAttribute("position", positions);
    geometry.setDrawRange(0, 0);
    super(geometry, new MeshBasicMaterial({ side: DoubleSide, depthTest: false, transparent: true }));
    this.#positions = positions;
    this.#halfWidth_m = width_m / 2;
    this.#dash_m = dash_m;
    this.position.y = height_m;
    this.frustumCulled = false;
    this.renderOrder = 5;
  }

  setColour(colour: ColorRepresentation): void { this.material.color.set(colour); }

  reset(): void {
    this.#count = 0;
    this.#right_m = this.#away_m = NaN;
    this.#travelled_m = 0;
    this.geometry.setDrawRange(0, 0);
  }

  /** How much of it is drawn, from its start: 0 to 1. */
  set shown(share: number) {
    this.#shown = share;
    this.#show();
  }

  /** The path continues there. */
  extend(right_m: number, away_m: number): void {
    if (Number.isNaN(this.#right_m)) {
      this.#right_m = right_m;
      this.#away_m = away_m;
      return;
    }
    // In pieces, so that a fast finger's dashes are as long as a slow one's.
    const far_m = Math.hypot(right_m - this.#right_m, away_m - this.#away_m), pieces = Math.ceil(far_m / maxStep_m);
    if (far_m < minStep_m) return;
    const from = { right_m: this.#right_m, away_m: this.#away_m };
    for (let i = 1; i <= pieces; ++i) {
      this.#extend(from.right_m + ((right_m - from.right_m) * i) / pieces, from.away_m + ((away_m - from.away_m) * i) / pieces);
    }
  }

  #extend(right_m: number, away_m: number): void {
    const dx = right_m - this.#right_m, dz = -(away_m - this.#away_m), length = Math.hypot(dx, dz);
    if (this.#count === capacity) return;
    const drawn = this.#dash_m === 0 || Math.floor(this.#travelled_m / this.#dash_m) % 2 === 0;
    if (drawn) this.#addBand(dx / length, dz / length, right_m, -away_m);
    this.#travelled_m += length;
    this.#right_m = right_m;
    this.#away_m = away_m;
  }

  /** From the last point to (x, z), as two triangles; (ux, uz) is the unit vector along it. */
  #addBand(ux: number, uz: number, x: number, z: number): void {
    const w = this.#halfWidth_m, x0 = this.#right_m, z0 = -this.#away_m, to = this.#positions, at = 6 * this.#count;
    const sx = -uz * w, sz = ux * w;  // sideways
    to.setXYZ(at, x0 + sx, 0, z0 + sz);
    to.setXYZ(at + 1, x0 - sx, 0, z0 - sz);
    to.setXYZ(at + 2, x + sx, 0, z + sz);
    to.setXYZ(at + 3, x + sx, 0, z + sz);
    to.setXYZ(at + 4, x0 - sx, 0, z0 - sz);
    to.setXYZ(at + 5, x - sx, 0, z - sz);
    ++this.#count;
    to.needsUpdate = true;
    this.#show();
  }

  #show(): void { this.geometry.setDrawRange(0, 6 * Math.round(this.#shown * this.#count)); }
}
