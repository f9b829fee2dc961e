// What only a headset shows: the tracked hand's joints, and a board with words behind the plate.
import { CanvasTexture, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, MeshStandardMaterial, PlaneGeometry, SphereGeometry,
         type ColorRepresentation } from "three";

const joints = 25;
const width_px = 1024, height_px = 320, margin_px = 36;

/** Of an XRFrame with hands; TypeScript's types lack them. */
interface JointFrame {
  fillPoses?(spaces: readonly XRSpace[], base: XRSpace, poses: Float32Array): boolean;
  fillJointRadii?(spaces: readonly XRJointSpace[], radii: Float32Array): boolean;
  getJointPose?(joint: XRJointSpace, base: XRSpace): XRJointPose | undefined;
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
    this.visible = this.#spaces.length === joints && (frame.fillPoses && frame.fillJointRadii
      ? frame.fillPoses(this.#spaces, space, this.#poses) && frame.fillJointRadii(this.#spaces, this.#radii) : this.#each(frame, space));
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

  /** Joint by joint, in browsers that do not give a hand at once. */
  #each(frame: JointFrame, space: XRReferenceSpace): boolean {
    return this.#spaces.every((joint, i) => {
      const pose = frame.getJointPose?.(joint, space);
      if (pose) this.#poses.set(pose.transform.matrix, 16 * i);
      this.#radii[i] = pose?.radius ?? 0.008;
      return pose !== undefined && pose !== null;
    });
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
    // As large as fits: an instruction is never cut.
    let size_px = 42, lines: string[] = [];
    do {
      size_px -= 2;
      pen.font = `${size_px}px system-ui, sans-serif`;
      lines = wrapped(text, (line) => pen.measureText(line).width <= width_px - 2 * margin_px);
    } while (size_px > 16 && (lines.length + 1.3) * 1.2 * size_px > height_px - margin_px);
    lines.forEach((line, i) => pen.fillText(line, margin_px, margin_px + (i + 2.1) * 1.2 * size_px));
    pen.font = `bold ${size_px}px system-ui, sans-serif`;
    pen.fillText(title, margin_px, margin_px + 0.8 * size_px);
    this.#texture.needsUpdate = true;
  }
}

/** Lines that fit; a word that is too long for one is broken. */
export function wrapped(text: string, fits: (line: string) => boolean): string[] {
  const lines: string[] = [];
  let line = "";
  for (let word of text.split(" ")) {
    if (line && !fits(`${line} ${word}`)) {
      lines.push(line);
      line = "";
    }
    for (let count = word.length; !fits(word) && count > 1;) {
      while (count > 1 && !fits(word.slice(0, count))) --count;
      lines.push(word.slice(0, count));
      word = word.slice(count);
      count = word.length;
    }
    line = line ? `${line} ${word}` : word;
  }
  return [...lines, line];
}
