// Objects that only a headset shows: tracked hands, and a text board behind the plate.
import * as THREE from "three";
import type { GLTF } from "three/addons/loaders/GLTFLoader.js";
import { XRHandModelFactory } from "three/addons/webxr/XRHandModelFactory.js";
import { cover, readHand } from "./hand_model";
import type { Stage } from "./stage";

const margin_px = 36;

export class Headset {
  /** Both hands, drawn at an offset from their true positions; see shift(). */
  readonly #hands = new THREE.Group();
  readonly #eyes = new THREE.PerspectiveCamera(40, 1, 0.01, 50); // three.js replaces its pose by the headset's
  readonly #words = new WordBoard();
  readonly #skin = new THREE.MeshStandardMaterial({ roughness: 0.6, transparent: true, opacity: 0.75 });

  constructor(private readonly stage: Stage) {
    stage.mount.add(this.#words);
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

  /** While the headset is worn, shows the text board, and tracked hands instead of the finger. */
  show(worn: boolean): void {
    this.stage.finger.visible = !worn;
    this.#words.visible = worn;
  }

  say(title: string, text: string): void {
    const { colours } = this.stage;
    if (!colours) return;
    this.#skin.color.set(colours.hand);
    this.#words.say(title, text, colours.text, colours.panel);
  }

  /** Sets the offset on the plate from the hands' true positions to their drawn ones. */
  shift(right_m: number, away_m: number): void {
    this.#hands.position.set(right_m, 0, -away_m).applyQuaternion(this.stage.mount.quaternion);
  }

  /** Draws until the session ends. `frame` is called before each picture, `moved` after the space has moved. */
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

/** Inclined board behind the plate with a text, which is drawn again only when it changes. */
class WordBoard extends THREE.Mesh {
  readonly #canvas = Object.assign(document.createElement("canvas"), { width: 1024, height: 320 });
  readonly #texture = new THREE.CanvasTexture(this.#canvas);
  #text = "";

  constructor() {
    super(new THREE.PlaneGeometry(0.32, 0.1));
    this.material = new THREE.MeshBasicMaterial({ map: this.#texture });
    this.position.set(0, 0.09, -0.16);
    this.rotation.x = -0.35;
    this.visible = false;
  }

  say(title: string, text: string, ink: string, paper: string): void {
    const all = `${title}\n${text}\n${ink}${paper}`,
      pen = this.#canvas.getContext("2d"),
      { width, height } = this.#canvas;
    if (all === this.#text || !pen) return;
    this.#text = all;
    pen.fillStyle = paper;
    pen.fillRect(0, 0, width, height);
    pen.fillStyle = ink;
    // The largest size, from 40 down to 16 pixels, at which the whole text fits.
    let size_px = 42,
      lines: string[] = [];
    do {
      size_px -= 2;
      pen.font = `${size_px}px system-ui, sans-serif`;
      lines = wrapped(text, (line) => pen.measureText(line).width <= width - 2 * margin_px);
    } while (size_px > 16 && (lines.length + 1.3) * 1.2 * size_px > height - margin_px);
    for (const [i, line] of lines.entries()) pen.fillText(line, margin_px, margin_px + (i + 2.1) * 1.2 * size_px);
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
