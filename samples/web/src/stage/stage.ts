// The desk in three dimensions. It draws the positions and orientations that it is given.
import { HapticPlate } from "haptic-retargeting/three";
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { VisitorScene } from "../files/scene";
import { ahead, type Course, type Place, radius_m, ridgeSpacing_m, start } from "../geometry";
import type { Trace } from "../guided_reach";
import type { Colours } from "../page";
import { colourTargets, colourThings, Finger, feltTip, goblet, Ribbon, realCylinder, startMark } from "./objects";

const fieldOfView_deg = 30; // from top to bottom
/** Direction from `middle` to the camera, before the visitor rotates the view. */
const seat = new THREE.Vector3(0, 0.85, 0.53);
const middle = new THREE.Vector3(0, 0, 0.002);
/** Radius of the plate, as a fraction of the radius of the disc that the picture must contain. */
const fill = 0.97;

export interface Shown {
  readonly plate_deg: number;
  readonly finger: Readonly<Place>;
  readonly felt: Readonly<Place>;
  readonly trace: Trace;
}

export class Stage {
  readonly #truePath = new Ribbon(0);
  readonly #feltPath = new Ribbon(0.008);
  #trace: Trace = [];
  #traced = 0;
  readonly renderer: THREE.WebGLRenderer;
  readonly scene = new THREE.Scene();
  /** Parent of all objects on and above the plate, in plate coordinates. In a headset it has the pose of the plate. */
  readonly mount = new THREE.Group();
  readonly orbit: OrbitControls;
  readonly #camera = new THREE.PerspectiveCamera(fieldOfView_deg, 1, 0.01, 5);
  readonly #disc = new THREE.MeshStandardMaterial({ roughness: 0.85 });
  readonly #ridges = new THREE.MeshStandardMaterial({ roughness: 0.6 });
  readonly #mark = new THREE.MeshStandardMaterial({ roughness: 0.6 });
  // Ridges are drawn larger than they are, so that they are visible from the visitor's seat.
  readonly plate = new HapticPlate({
    radius_m,
    ridgeSpacing_m,
    ridgeWidth_m: 0.0016,
    ridgeHeight_m: 0.0022,
    discMaterial: this.#disc,
    ridgeMaterial: this.#ridges,
    markMaterial: this.#mark,
  });
  readonly desk = new THREE.Mesh(
    new THREE.BoxGeometry(1.2, 0.02, 0.9),
    new THREE.MeshStandardMaterial({ roughness: 1 }),
  );
  readonly #real = realCylinder();
  readonly #glass = goblet();
  readonly finger = new Finger();
  readonly #felt = feltTip();
  readonly #start = startMark();
  readonly #visited = new THREE.Group();
  colours: Colours | null = null;
  readonly #lamp = new THREE.DirectionalLight(0xfff4e6, 1.7);
  readonly #ray = new THREE.Raycaster();
  #width = 1;
  #height = 1;
  #maxPixelRatio = 2;

  /** Throws if the browser has no WebGL. */
  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.orbit = new OrbitControls(this.#camera, canvas);
    Object.assign(this.orbit, { enableZoom: false, enablePan: false, maxPolarAngle: 1.4 });
    canvas.style.touchAction = "pan-y pinch-zoom"; // a thumb can still scroll the page
    this.desk.position.y = -0.018;
    this.desk.receiveShadow = true;
    this.#start.position.x = start.right_m;
    this.#start.position.z = -start.away_m;
    this.#lamp.position.set(-0.25, 0.5, 0.15);
    this.#lamp.castShadow = true;
    this.#lamp.shadow.mapSize.set(1024, 1024);
    Object.assign(this.#lamp.shadow, { radius: 6, intensity: 0.7, normalBias: 0.0005 });
    Object.assign(this.#lamp.shadow.camera, { left: -0.2, right: 0.2, top: 0.2, bottom: -0.2, near: 0.1, far: 1.2 });
    this.mount.add(this.desk, this.plate, this.#real, this.#glass, this.finger, this.#felt, this.#start);
    this.mount.add(this.#visited, this.#truePath, this.#feltPath, this.#lamp, this.#lamp.target);
    this.scene.add(this.mount, new THREE.HemisphereLight(0xffffff, 0x9a8f86, 1.9));
  }

  setColours(colours: Colours): void {
    this.colours = colours;
    colourTargets(this.#visited, colours.real, colours.felt);
    colourThings(colours);
    this.scene.background = new THREE.Color(colours.stage);
    this.desk.material.color.set(colours.desk);
    this.#disc.color.set(colours.plate);
    this.#ridges.color.set(colours.ridges);
    this.#mark.color.set(colours.chart);
    this.#truePath.material.color.set(colours.real);
    this.#feltPath.material.color.set(colours.felt);
    this.finger.skin.color.set(colours.hand);
  }

  setTargets({ real_deg, real_m, virtual_deg, virtual_m }: Course): void {
    const real = ahead(start, real_deg, real_m),
      glass = ahead(start, virtual_deg, virtual_m);
    this.#real.position.set(real.right_m, 0, -real.away_m);
    this.#glass.position.set(glass.right_m, 0, -glass.away_m);
  }

  /** Shows a visitor's scene, scaled to the page's plate; null: shows the page's own desk and targets. */
  setScene(scene: VisitorScene | null): void {
    this.#visited.traverse((part) => {
      // Frees graphics memory. three.js uploads meshes that are shown again.
      if (!(part instanceof THREE.Mesh)) return;
      (part.geometry as THREE.BufferGeometry).dispose();
      for (const material of [part.material].flat() as THREE.Material[]) material.dispose();
    });
    this.#visited.clear();
    for (const own of [this.#real, this.#glass]) own.visible = !scene;
    this.desk.visible = !scene?.meshes;
    if (scene?.meshes) {
      const { group } = scene.meshes;
      group.scale.setScalar(scene.scale);
      this.#visited.add(group);
      if (this.colours) colourTargets(group, this.colours.real, this.colours.felt);
    }
    const from = scene?.start ?? start;
    this.#start.position.set(from.right_m, this.#start.position.y, -from.away_m);
    for (const { name, real, drawn } of scene?.targets ?? []) {
      if (scene?.meshes?.targets.has(name)) continue;
      const thing = real ? realCylinder() : goblet();
      thing.position.set(drawn.right_m, 0, -drawn.away_m);
      this.#visited.add(thing);
    }
  }

  /** Shows the view from the visitor's seat. `turns`: a drag rotates it. */
  setView(turns: boolean): void {
    this.orbit.target.copy(middle);
    this.orbit.enabled = turns;
    this.#fit();
  }

  /** Moves the camera along `seat` to the nearest distance at which the whole plate is visible. */
  #fit(): void {
    let near = 0.1,
      far = 1.5;
    while (far - near > 1e-4) {
      const distance = (near + far) / 2;
      this.#camera.position.copy(middle).addScaledVector(seat, distance);
      this.orbit.update();
      const { left, top, width, height } = this.discOnCanvas();
      const inside = left >= 0 && top >= 0 && left + width <= this.#width && top + height <= this.#height;
      if (inside) far = distance;
      else near = distance;
    }
  }

  /** Returns the bounding box of the plate's disc with a margin, in CSS pixels of the canvas. */
  discOnCanvas(): { left: number; top: number; width: number; height: number } {
    this.#camera.updateMatrixWorld();
    const edge = Array.from({ length: 32 }, (_, i) =>
        this.toCanvas(ahead({ right_m: 0, away_m: 0 }, (i * 360) / 32, radius_m / fill), 0),
      ),
      xs = edge.map(({ x }) => x),
      ys = edge.map(({ y }) => y);
    const [left, top] = [Math.min(...xs), Math.min(...ys)];
    return { left, top, width: Math.max(...xs) - left, height: Math.max(...ys) - top };
  }

  /** Fades in the true hand and draws its path by this fraction, from 0 to 1. At 0, the cylinder is hidden. */
  reveal(fraction: number): void {
    this.finger.fade(fraction);
    this.#truePath.shown = fraction;
    this.#real.visible = fraction > 0 && this.#glass.visible;
  }

  /** Moves hand, plate and paths. `scale`: factor from the size of the reach's plate to that of the page's. */
  place({ plate_deg, finger, felt, trace }: Shown, scale = 1): void {
    this.plate.orientation_deg = plate_deg;
    this.finger.position.set(scale * finger.right_m, 0.002, -scale * finger.away_m);
    this.#felt.position.set(scale * felt.right_m, 0, -scale * felt.away_m);
    if (trace === this.#trace && trace.length === this.#traced) return;
    [this.#trace, this.#traced] = [trace, trace.length];
    const scaled = ({ right_m, away_m }: Place) => ({ right_m: scale * right_m, away_m: scale * away_m });
    this.#truePath.follow(trace.map((step) => scaled(step.finger)));
    this.#feltPath.follow(trace.map((step) => scaled(step.felt)));
  }

  /** Sets the size of the canvas, in CSS pixels. */
  resize(width: number, height: number, pixelRatio: number): void {
    if (width < 1 || height < 1) return;
    this.#width = width;
    this.#height = height;
    this.renderer.setPixelRatio(Math.min(pixelRatio, this.#maxPixelRatio));
    this.renderer.setSize(width, height, false);
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    this.#fit();
  }

  /** Simplifies the picture for software rendering: no shadows, one pixel per CSS pixel. */
  lighten(): void {
    this.#lamp.castShadow = false;
    this.#maxPixelRatio = 1;
    this.resize(this.#width, this.#height, 1);
  }

  draw(): void {
    this.renderer.render(this.scene, this.#camera);
  }

  /** Converts a point of the canvas, in CSS pixels, to a position on the plate's plane; null beyond the horizon. */
  toPlate(x: number, y: number): Place | null {
    this.#ray.setFromCamera(new THREE.Vector2((2 * x) / this.#width - 1, 1 - (2 * y) / this.#height), this.#camera);
    const at = this.#ray.ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 1, 0), 0), new THREE.Vector3());
    return at && { right_m: at.x, away_m: -at.z };
  }

  /** Returns the position on the canvas, in CSS pixels, of a point above the plate. */
  toCanvas({ right_m, away_m }: Readonly<Place>, height_m: number): { x: number; y: number } {
    const { x, y } = new THREE.Vector3(right_m, height_m, -away_m).project(this.#camera);
    return { x: ((x + 1) / 2) * this.#width, y: ((1 - y) / 2) * this.#height };
  }
}
