// Objects that only a headset shows: tracked hands, and a text board behind the plate.
import * as THREE from "three";
import type { GLTF } from "three/addons/loaders/GLTFLoader.js";
import { XRHandModelFactory } from "three/addons/webxr/XRHandModelFactory.js";
import { cover, readHand } from "./hand_model";
import type { Stage } from "./stage";

const width_px = 1024,
  margin_px = 36;
const poke_m = 0.015;

/** The stage in a headset. */
export class Headset {
  /** Both hands, drawn at an offset from their true positions; see shift(). */
  readonly #hands = new THREE.Group();
  readonly #again = new WordBoard(0.12, 0.05, new THREE.Vector3(0.15, 0.05, -0.1));
  readonly #eyes = new THREE.PerspectiveCamera(40, 1, 0.01, 50); // three.js replaces its pose by the headset's
  readonly #words = new WordBoard(0.32, 0.1, new THREE.Vector3(0, 0.09, -0.16));
  readonly #skin = new THREE.MeshStandardMaterial({ roughness: 0.6, transparent: true, opacity: 0.75 });

  constructor(private readonly stage: Stage) {
    stage.mount.add(this.#words, this.#again);
    stage.scene.add(this.#hands);
    const loader = {
      load: (file: string, use: (hand: GLTF) => void) => {
        void readHand(file === "left.glb" ? "left" : "right").then(use);
      },
    };
    const factory = new XRHandModelFactory(loader as unknown as THREE.Loader<GLTF>, (hand) => cover(hand, this.#skin));
    for (const hand of [0, 1].map((i) => stage.renderer.xr.getHand(i)))
      this.#hands.add(hand.add(factory.createHandModel(hand, "mesh")));
  }

  /** Places the plate and the objects on it, in the reference space of the frames. */
  put(position: THREE.Vector3, rotation: THREE.Quaternion): void {
    const { mount } = this.stage;
    mount.position.copy(position);
    mount.quaternion.copy(rotation);
    mount.updateMatrixWorld(true);
  }

  /** While the headset is worn, shows tracked hands instead of the finger, and the text board instead of the page. */
  show(worn: boolean): void {
    this.stage.finger.visible = !worn;
    this.#words.visible = worn;
  }

  /** Sets the text. `placed`: shows the button that places the plate again. */
  say(title: string, text: string, placed: boolean): void {
    const { colours } = this.stage;
    if (!colours) return;
    this.#skin.color.set(colours.hand);
    this.#words.say(title, text, colours.text, colours.panel);
    this.#again.say("", "Poke here to place the plate again", colours.panel, colours.text);
    this.#again.visible = placed;
  }

  /** Sets the offset on the plate from the hands' true positions to their drawn ones. */
  shift(right_m: number, away_m: number): void {
    this.#hands.position.set(right_m, 0, -away_m).applyQuaternion(this.stage.mount.quaternion);
  }

  /** Returns true once for each poke of a fingertip at the button. */
  poked(tip: Readonly<THREE.Vector3>, hand: string): boolean {
    return this.#again.visible && this.#again.poked(tip, hand);
  }

  /** Draws until the session ends. `frame` is called before each picture, with the reference space in which `mount` is placed;
   *  `moved` when the headset has moved that space, because it was recentred. Rejects if the browser cannot show the session. */
  async present(
    session: XRSession,
    passthrough: boolean,
    frame: (time_ms: number, frame: XRFrame, space: XRReferenceSpace) => void,
    moved: () => void,
  ): Promise<void> {
    const { renderer, scene, desk, mount } = this.stage,
      { xr } = renderer,
      { background } = scene;
    xr.enabled = true;
    xr.setReferenceSpaceType("local"); // seated or standing: no floor is needed
    session.addEventListener("end", () => {
      renderer.setAnimationLoop(null);
      xr.enabled = false;
      scene.background = background;
      desk.visible = true;
      this.#again.visible = false;
      mount.position.set(0, 0, 0);
      mount.quaternion.identity();
    });
    await xr.setSession(session);
    xr.getReferenceSpace()?.addEventListener("reset", moved);
    desk.visible = !passthrough;
    if (passthrough) scene.background = null;
    renderer.setAnimationLoop((time_ms: number, xrFrame: XRFrame | undefined) => {
      const space = xr.getReferenceSpace();
      if (xrFrame && space) frame(time_ms, xrFrame, space);
      renderer.render(scene, this.#eyes);
    });
  }
}

/** Inclined board with a text, such as that behind the plate. Drawn again only when the text changes. */
class WordBoard extends THREE.Mesh {
  readonly #canvas = document.createElement("canvas");
  readonly #texture: THREE.CanvasTexture;
  #text = "";
  #touched = "";

  constructor(
    private readonly width_m: number,
    private readonly height_m: number,
    at: THREE.Vector3,
  ) {
    super(new THREE.PlaneGeometry(width_m, height_m));
    this.#canvas.width = width_px;
    this.#canvas.height = (width_px * height_m) / width_m;
    this.#texture = new THREE.CanvasTexture(this.#canvas);
    this.material = new THREE.MeshBasicMaterial({ map: this.#texture });
    this.position.copy(at);
    this.rotation.x = -0.35;
    this.visible = false;
  }

  poked(tip: Readonly<THREE.Vector3>, hand: string): boolean {
    const { x, y, z } = this.worldToLocal(tip.clone());
    const touches = Math.abs(x) < this.width_m / 2 && Math.abs(y) < this.height_m / 2 && Math.abs(z) < poke_m;
    const before = this.#touched;
    if (touches) this.#touched = hand;
    else if (before === hand) this.#touched = "";
    return touches && before === "";
  }

  /** `title` is the first line. */
  say(title: string, text: string, ink: string, paper: string): void {
    const all = `${title}\n${text}\n${ink}${paper}`;
    if (all === this.#text) return;
    this.#text = all;
    const pen = this.#canvas.getContext("2d");
    if (!pen) return;
    pen.fillStyle = paper;
    const height_px = this.#canvas.height;
    pen.fillRect(0, 0, width_px, height_px);
    pen.fillStyle = ink;
    // Uses the largest size at which the whole text fits.
    const first = title ? 2.1 : 0.8; // number of the line on which the text begins
    let size_px = title ? 42 : 110,
      lines: string[] = [];
    do {
      size_px -= 2;
      pen.font = `${size_px}px system-ui, sans-serif`;
      lines = wrapped(text, (line) => pen.measureText(line).width <= width_px - 2 * margin_px);
    } while (size_px > 16 && (lines.length + first - 0.8) * 1.2 * size_px > height_px - margin_px);
    for (const [i, line] of lines.entries()) pen.fillText(line, margin_px, margin_px + (i + first) * 1.2 * size_px);
    pen.font = `bold ${size_px}px system-ui, sans-serif`;
    pen.fillText(title, margin_px, margin_px + 0.8 * size_px);
    this.#texture.needsUpdate = true;
  }
}

/** Breaks a text into lines that fit, except for a word that is too long for one line. */
export function wrapped(text: string, fits: (line: string) => boolean): string[] {
  const lines: string[] = [];
  for (const word of text.split(" ")) {
    const longer = lines.length > 0 ? `${lines.at(-1)} ${word}` : word;
    if (lines.length > 0 && fits(longer)) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
