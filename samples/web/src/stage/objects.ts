// Objects on and above the plate: the cylinder, the glass, the hand, the perceived fingertip.
import * as THREE from "three";
import { cylinderRadius_m } from "../geometry";
import type { Colours } from "../theme";

/** Materials of real and virtual objects, in the page's colours. */
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

/** A solid cylinder whose base is at its origin. */
export class RealCylinder extends THREE.Group {
  constructor() {
    super();
    const cylinder = new THREE.Mesh(new THREE.CylinderGeometry(cylinderRadius_m, cylinderRadius_m, 0.03, 32), solid);
    cylinder.position.y = 0.015;
    cylinder.castShadow = true;
    this.add(cylinder);
  }
}

/** The virtual target, drawn as a transparent goblet. */
export class Glass extends THREE.Group {
  constructor() {
    super();
    const outline = [
      [0.006, 0],
      [0.006, 0.001],
      [0.0014, 0.003],
      [0.0012, 0.014],
      [0.0045, 0.018],
      [0.0062, 0.024],
      [0.0056, 0.03],
    ] as const;
    const points = outline.map(([r, y]) => new THREE.Vector2(r, y)),
      shape = new THREE.LatheGeometry(points, 12);
    this.add(new THREE.Mesh(shape, glass), new THREE.LineSegments(new THREE.EdgesGeometry(shape, 1), outlines));
  }
}

/** A pointing hand with its index fingertip at the origin; empty until its model is loaded. */
export class Finger extends THREE.Group {
  /** Fades by a dot pattern, so that inner surfaces do not show through. */
  readonly skin = new THREE.MeshStandardMaterial({ roughness: 0.6, alphaHash: true, side: THREE.DoubleSide });
  /** Adds the hand that `model` creates from a material; see hand_model.ts. */
  async become(model: (skin: THREE.Material) => Promise<THREE.Object3D>): Promise<void> {
    this.add(await model(this.skin));
  }
  /** Sets the opacity, from 0 (invisible) to 1. */
  fade(fraction: number): void {
    this.visible = fraction > 0;
    this.skin.opacity = fraction;
  }
}

/** Perceived position of the fingertip: a ring and a transparent ball. */
export class FeltTip extends THREE.Group {
  constructor() {
    super();
    const ball = new THREE.Mesh(new THREE.SphereGeometry(0.006, 20, 14), ballGlass);
    ball.position.y = 0.006;
    const ring = new THREE.Mesh(new THREE.RingGeometry(0.0062, 0.0078, 36), ringPaint);
    ring.rotation.x = -Math.PI / 2;
    ring.position.y = 0.003;
    ring.renderOrder = 6;
    this.add(ball, ring);
  }
}

export class StartMark extends THREE.Mesh {
  constructor() {
    super(new THREE.RingGeometry(0.0085, 0.0095, 40), startPaint);
    this.rotation.x = -Math.PI / 2;
    this.position.y = 0.003;
    this.renderOrder = 4;
  }
}

/** Colours the targets: real ones solid, virtual ones transparent. */
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
