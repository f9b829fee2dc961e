// Files of the plugin: the last reach and what was learnt, to take away; a recording, which is run again and compared bit
// for bit, or a scene, to bring. Nothing leaves the machine. What is refused is refused in the plugin's words.
import { HRT_ENDING_COMPLETE, type Library } from "haptic-retargeting";
import { element, messageOf, say } from "../page";
import { type RecordedReach, readReach } from "./recording";
import { readScene, type VisitorScene } from "./scene";

const sceneAdvice =
  "A scene names its plate, its start and its targets by haptic roles: scene/README.md has them, samples/scenes/desk.gltf is one.";
const max_bytes = 32 * 1024 * 1024;

export class TakeAway {
  readonly #saveRecording = element("save-recording", HTMLButtonElement);
  readonly #refused = element("refused", HTMLParagraphElement);
  readonly #replayed = element("replayed", HTMLParagraphElement);

  /** `recording` and `profile` are asked when a button is pressed; `brought` gets what is to be shown. */
  constructor(
    private readonly library: Library,
    recording: () => string,
    profile: () => string,
    private readonly brought: { reach(reach: RecordedReach): void; scene(scene: VisitorScene): void },
  ) {
    this.#saveRecording.addEventListener("click", () => save("reach.csv", "text/csv", recording()));
    element("save-profile", HTMLButtonElement).addEventListener("click", () =>
      save("profile.json", "application/json", profile()),
    );
    onFiles(element("open-file", HTMLInputElement), (files) => this.#open(files));
  }

  /** Whether there is a reach to save. */
  allow(recorded: boolean): void {
    if (this.#saveRecording.disabled === recorded) this.#saveRecording.disabled = !recorded;
  }

  /** A recording, or a scene with the buffers that came along. */
  async #open(files: readonly File[]): Promise<void> {
    const file = files.find(({ name }) => /\.(gltf|glb|csv)$/i.test(name)),
      name = file?.name ?? files[0]?.name ?? "";
    try {
      if (!file)
        throw new Error(
          "this page opens a recording (.csv), or a scene (.glb, or .gltf with its .bin dropped together)",
        );
      const size = files.reduce((sum, each) => sum + each.size, 0);
      if (size > max_bytes)
        throw new Error(`${Math.ceil(size / 1048576)} MB; up to ${max_bytes / 1048576} are allowed`);
      if (/\.csv$/i.test(name)) this.brought.reach(this.#replay(name, await file.text()));
      else this.brought.scene(await this.#scene(file, files));
      this.#refused.hidden = true;
    } catch (error) {
      const message = messageOf(error);
      const advice = /\.(gltf|glb)$/i.test(name) ? ` ${sceneAdvice}` : "";
      this.#refused.hidden = false;
      say(this.#refused, (message.startsWith(name) ? message : `${name}: ${message}`) + advice);
    }
  }

  /** Targets by the plugin's loader; then the meshes, without which the scene is shown too. */
  async #scene(file: File, files: readonly File[]): Promise<VisitorScene> {
    const bytes = await file.arrayBuffer(),
      scene = readScene(this.library, bytes, file.name),
      { position_m, rotation } = scene.plate;
    try {
      const { readMeshes } = await import("../stage/meshes"); // with three.js' loader
      const others = new Map(
        await Promise.all(files.map(async (each) => [each.name, await each.arrayBuffer()] as const)),
      );
      scene.meshes = await readMeshes(bytes, others, position_m, rotation);
    } catch (error) {
      scene.meshProblem = messageOf(error);
    }
    return scene;
  }

  #replay(name: string, text: string): RecordedReach {
    const report = this.library.replay(text),
      reach = readReach(text, name);
    const same =
      report.first_different_line === 0n
        ? `All ${report.rows} calls gave the same numbers again, bit for bit.`
        : `Line ${report.first_different_line} gave other numbers than those recorded.`;
    const whole = report.ending === HRT_ENDING_COMPLETE ? "" : " The recording is not complete.";
    say(
      this.#replayed,
      `${name}: ${same}${whole} A recording does not hold what was felt: the chart shows what the ` +
        "controller believed.",
    );
    return reach;
  }
}

/** Offers a text for saving. */
function save(name: string, type: string, text: string): void {
  const link = document.createElement("a"),
    url = URL.createObjectURL(new Blob([text], { type }));
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Calls back with files that are chosen in `input`, or dropped anywhere on the page, together. */
function onFiles(input: HTMLInputElement, opened: (files: readonly File[]) => void): void {
  const take = (files: FileList | null | undefined) => {
    if (files?.length) opened([...files]);
  };
  input.addEventListener("change", () => {
    take(input.files);
    input.value = "";
  });
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    take(event.dataTransfer?.files);
  });
}
