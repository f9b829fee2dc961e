// What only a headset shows: tracked hands, and a board with words behind the plate.
import {
  CanvasTexture,
  Group,
  type Loader,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  type Quaternion,
  type Vector3,
} from "three";
import type { GLTF } from "three/addons/loaders/GLTFLoader.js";
import { XRHandModelFactory } from "three/addons/webxr/XRHandModelFactory.js";
import { cover, readHand } from "./hand_model";
import type { Stage } from "./stage";

const width_px = 1024,
  height_px = 320,
  margin_px = 36;

/** Draws the stage in a headset. */
export class Headset {
  readonly #eyes = new PerspectiveCamera(40, 1, 0.01, 50); // the headset moves this one
  readonly #words = new WordBoard();
  readonly #skin = new MeshStandardMaterial({ roughness: 0.6, transparent: true, opacity: 0.75 });

  constructor(private readonly stage: Stage) {
    stage.mount.add(this.#words);
    const loader = {
      load: (file: string, use: (hand: GLTF) => void) => {
        void readHand(file === "left.glb" ? "left" : "right").then(use);
      },
    };
    const factory = new XRHandModelFactory(loader as unknown as Loader<GLTF>, (hand) => cover(hand, this.#skin));
    for (const hand of [0, 1].map((i) => stage.renderer.xr.getHand(i)))
      stage.scene.add(hand.add(factory.createHandModel(hand, "mesh")));
  }

  /** The plate and all about it lie there, in the space of the frames. */
  put(position: Vector3, rotation: Quaternion): void {
    const { mount } = this.stage;
    mount.position.copy(position);
    mount.quaternion.copy(rotation);
    mount.updateMatrixWorld(true);
  }

  /** Tracked hands stand for the finger, and words for the page. */
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

  /** Draws until the session ends: `frame` is called before each picture, with the space in which `mount` stands; `moved`
   *  when the headset has moved that space, as by its recentring. Rejects if the browser cannot. */
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

/** Words that stand behind the plate. Drawn anew only when they change. */
class WordBoard extends Group {
  readonly #canvas = document.createElement("canvas");
  readonly #texture: CanvasTexture;
  #text = "";

  constructor() {
    super();
    this.#canvas.width = width_px;
    this.#canvas.height = height_px;
    this.#texture = new CanvasTexture(this.#canvas);
    const board = new Mesh(
      new PlaneGeometry(0.32, (0.32 * height_px) / width_px),
      new MeshBasicMaterial({ map: this.#texture }),
    );
    board.position.set(0, 0.09, -0.16);
    board.rotation.x = -0.35;
    this.add(board);
    this.visible = false;
  }

  /** `title` is the first line. */
  say(title: string, text: string, ink: string, paper: string): void {
    const all = `${title}\n${text}\n${ink}${paper}`;
    if (all === this.#text) return;
    this.#text = all;
    const pen = this.#canvas.getContext("2d");
    if (!pen) return;
    pen.fillStyle = paper;
    pen.fillRect(0, 0, width_px, height_px);
    pen.fillStyle = ink;
    // As large as fits: an instruction is never cut.
    let size_px = 42,
      lines: string[] = [];
    do {
      size_px -= 2;
      pen.font = `${size_px}px system-ui, sans-serif`;
      lines = wrapped(text, (line) => pen.measureText(line).width <= width_px - 2 * margin_px);
    } while (size_px > 16 && (lines.length + 1.3) * 1.2 * size_px > height_px - margin_px);
    for (const [i, line] of lines.entries()) pen.fillText(line, margin_px, margin_px + (i + 2.1) * 1.2 * size_px);
    pen.font = `bold ${size_px}px system-ui, sans-serif`;
    pen.fillText(title, margin_px, margin_px + 0.8 * size_px);
    this.#texture.needsUpdate = true;
  }
}

/** Lines that fit, except for a word that is too long for one. */
export function wrapped(text: string, fits: (line: string) => boolean): string[] {
  const lines: string[] = [];
  for (const word of text.split(" ")) {
    const longer = lines.length > 0 ? `${lines.at(-1)} ${word}` : word;
    if (lines.length > 0 && fits(longer)) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
