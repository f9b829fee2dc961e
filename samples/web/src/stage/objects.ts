// Objects on and above the plate: the cylinder, the glass, the hand, the perceived fingertip, and the paths of both.
import * as THREE from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { cylinderRadius_m, type Place } from "../geometry";
import type { Colours } from "../page";

// Materials, whose colours colourThings() sets.
const solid = new THREE.MeshStandardMaterial({ roughness: 0.35, metalness: 0.2 });
const glass = new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.25, depthWrite: false });
const outlines = new THREE.LineBasicMaterial();
const ballGlass = new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.4, depthWrite: false });
const ringPaint = new THREE.MeshBasicMaterial({ depthTest: false, transparent: true });
const startPaint = new THREE.MeshBasicMaterial({ depthTest: false, transparent: true });

export function colourThings({ real, felt, text }: Colours): void {
  solid.color.set(real);
  for (const material of [glass, outlines, ballGlass, ringPaint]) material.color.set(felt);
  startPaint.color.set(text);
}

/** The origin is at the base. */
export function realCylinder(): THREE.Group {
  const cylinder = new THREE.Mesh(new THREE.CylinderGeometry(cylinderRadius_m, cylinderRadius_m, 0.03, 32), solid);
  cylinder.position.y = 0.015;
  cylinder.castShadow = true;
  return new THREE.Group().add(cylinder);
}

/** Radius and height of the points of the goblet's outline, in metres. */
const outline: readonly (readonly [number, number])[] = [
  [0.006, 0],
  [0.006, 0.001],
  [0.0014, 0.003],
  [0.0012, 0.014],
  [0.0045, 0.018],
  [0.0062, 0.024],
  [0.0056, 0.03],
];

export function goblet(): THREE.Group {
  const points = outline.map(([radius_m, y_m]) => new THREE.Vector2(radius_m, y_m)),
    shape = new THREE.LatheGeometry(points, 12);
  return new THREE.Group().add(
    new THREE.Mesh(shape, glass),
    new THREE.LineSegments(new THREE.EdgesGeometry(shape, 1), outlines),
  );
}

/** A pointing hand with its index fingertip at the origin; empty until its model is loaded. */
export class Finger extends THREE.Group {
  /** Fades by a dot pattern, so that inner surfaces do not show through. */
  readonly skin = new THREE.MeshStandardMaterial({ roughness: 0.6, alphaHash: true, side: THREE.DoubleSide });
  /** Adds the hand that `model` creates from a material; see hand_model.ts. */
  async become(model: (skin: THREE.Material) => Promise<THREE.Object3D>): Promise<void> {
    this.add(await model(this.skin));
  }
  fade(fraction: number): void {
    this.visible = fraction > 0;
    this.skin.opacity = fraction;
  }
}

/** Creates a ring that lies on the plate and is drawn in front of other objects. */
function flatRing(inner_m: number, outer_m: number, paint: THREE.Material, renderOrder: number): THREE.Mesh {
  const ring = new THREE.Mesh(new THREE.RingGeometry(inner_m, outer_m, 40), paint);
  ring.rotation.x = -Math.PI / 2;
  ring.position.y = 0.003;
  ring.renderOrder = renderOrder;
  return ring;
}

/** Perceived position of the fingertip: a ring and a transparent ball. */
export function feltTip(): THREE.Group {
  const ball = new THREE.Mesh(new THREE.SphereGeometry(0.006, 20, 14), ballGlass);
  ball.position.y = 0.006;
  return new THREE.Group().add(ball, flatRing(0.0062, 0.0078, ringPaint, 6));
}

export function startMark(): THREE.Mesh {
  return flatRing(0.0085, 0.0095, startPaint, 4);
}

const minStep_m = 0.0005;

/** A path that is drawn flat on the plate. */
export class Ribbon extends Line2 {
  #shown = 1;
  #segments = 0;

  /** `dash_m`: period of the dashes; 0: a solid line. */
  constructor(dash_m: number) {
    const dashes = { dashed: dash_m > 0, dashSize: dash_m / 2, gapSize: dash_m / 2 };
    super(
      new LineGeometry(),
      new LineMaterial({ worldUnits: true, linewidth: 0.0022, depthTest: false, transparent: true, ...dashes }),
    );
    this.position.y = 0.003;
    this.frustumCulled = false;
    this.renderOrder = 5;
  }

  /** Fraction of the path that is drawn, from its start: 0 to 1. */
  set shown(fraction: number) {
    this.#shown = fraction;
    this.#show();
  }

  follow(path: readonly Place[]): void {
    const points: number[] = [];
    let last: Place | null = null;
    for (const place of path) {
      if (last && Math.hypot(place.right_m - last.right_m, place.away_m - last.away_m) < minStep_m) continue;
      points.push(place.right_m, 0, -place.away_m);
      last = place;
    }
    this.geometry.dispose();
    this.geometry = new LineGeometry();
    this.#segments = Math.max(0, points.length / 3 - 1);
    if (this.#segments > 0) {
      this.geometry.setPositions(points);
      this.computeLineDistances();
    }
    this.#show();
  }

  #show(): void {
    this.geometry.instanceCount = Math.round(this.#shown * this.#segments);
    this.visible = this.geometry.instanceCount > 0;
  }
}

/** Colours the targets of a visitor's scene: real ones solid, virtual ones transparent. */
export function colourTargets(group: THREE.Group, real: string, felt: string): void {
  group.traverse((node) => {
    const { haptic } = node.userData as { haptic?: { role?: unknown } };
    const role = haptic?.role;
    if (role !== "real" && role !== "virtual") return;
    node.traverse((part) => {
      if (!(part instanceof THREE.Mesh)) return;
      part.material =
        role === "real"
          ? new THREE.MeshStandardMaterial({ color: real, roughness: 0.4 })
          : new THREE.MeshBasicMaterial({ color: felt, transparent: true, opacity: 0.5, depthWrite: false });
    });
  });
}
