// What only a headset shows: the tracked hand's joints, and a board with words behind the plate.
import { CanvasTexture, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, MeshStandardMaterial, PlaneGeometry, SphereGeometry,
         type ColorRepresentation } from "three";

const joints = 25;
const width_px = 1024, height_px = 320, margin_px = 36;

/** Of an XRFrame with hands; TypeScript's types lack them. */
interface JointFrame {
  fillPoses?(spaces: readonly XRSpace[], base: XRSpace, poses: Float32Array): boolean;
  fillJointRadii?(spaces: readonly XRJointSpace[], radii: Float32Array): boolean;
}

/** The 25 joints of a hand, as balls. Memory is taken once for each hand. */
export class HandJoints extends InstancedMesh<SphereGeometry, MeshStandardMaterial> {
  readonly #poses = new Float32Array(16 * joints);
  readonly #radii = new Float32Array(joints);
  readonly #matrix = new Matrix4();
  #hand: XRHand | undefined;
  #spaces: XRJointSpace[] = [];

  constructor() {
    super(new SphereGeometry(1, 12, 8), new MeshStandardMaterial({ roughness: 0.7, transparent: true, opacity: 0.75 }), joints);
    this.frustumCulled = false;
    this.visible = false;
  }

  setColour(colour: ColorRepresentation): void { this.material.color.set(colour); }

  /** In the space of the frames. Hides a hand that is lost, in part or whole. */
  show(frame: JointFrame, hand: XRHand | undefined, space: XRReferenceSpace): void {
    if (hand !== this.#hand) {
      this.#hand = hand;
      this.#spaces = hand ? [...hand.values()] : [];
    }
    this.visible = this.#spaces.length === joints && (frame.fillPoses?.(this.#spaces, space, this.#poses) ?? false) &&
      (frame.fillJointRadii?.(this.#spaces, this.#radii) ?? false);
    if (!this.visible) return;
    for (let i = 0; i < joints; ++i) {
      const radius_m = this.#radii[i] ?? 0;
      this.#matrix.fromArray(this.#poses, 16 * i);
      this.#matrix.elements[15] = 1;
      for (let j = 0; j < 12; ++j) this.#matrix.elements[j] = (this.#matrix.elements[j] ?? 0) * radius_m;
      this.setMatrixAt(i, this.#matrix);
    }
    this.instanceMatrix.needsUpdate = true;
  }
}

/** Words that stand behind the plate. Drawn anew only when they change. */
export class WordBoard extends Group {
  readonly #canvas = document.createElement("canvas");
  readonly #texture: CanvasTexture;
  #text = "";

  constructor() {
    super();
    this.#canvas.width = width_px;
    this.#canvas.height = height_px;
    this.#texture = new CanvasTexture(this.#canvas);
    const board = new Mesh(new PlaneGeometry(0.32, (0.32 * height_px) / width_px), new MeshBasicMaterial({ map: this.#texture }));
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
    pen.font = "bold 40px system-ui, sans-serif";
    pen.fillText(title, margin_px, 62);
    pen.font = "40px system-ui, sans-serif";
    let line = "", y = 122;
    for (const word of text.split(" ")) {
      if (pen.measureText(`${line} ${word}`).width > width_px - 2 * margin_px) {
        pen.fillText(line, margin_px, y);
        [line, y] = [word, y + 48];
      } else {
        line = line ? `${line} ${word}` : word;
      }
    }
    pen.fillText(line, margin_px, y);
    this.#texture.needsUpdate = true;
  }
}
