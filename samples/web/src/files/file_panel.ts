// Saves the recording of the last reach, and the profile of the simulated person. Opens a scene, or a recording, which
// the plugin replays and compares bit for bit. The panel shows errors.
import { HRT_ENDING_COMPLETE, type Library } from "haptic-retargeting";
import { element, messageOf, say } from "../page";
import { type RecordedReach, readReach } from "./recording";
import { readScene, type VisitorScene } from "./scene";

const sceneAdvice =
  "A scene marks its plate, its start and its targets by haptic roles; see scene/README.md and the example samples/scenes/desk.gltf.";
const max_bytes = 32 * 1024 * 1024;

export class FilePanel {
  readonly #saveRecording = element("save-recording", HTMLButtonElement);
  readonly #refused = element("refused", HTMLParagraphElement);
  readonly #replayed = element("replayed", HTMLParagraphElement);

  /** `recording` and `profile` return the text to be saved; `brought` receives the content of an opened file. */
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

  allow(recorded: boolean): void {
    if (this.#saveRecording.disabled === recorded) this.#saveRecording.disabled = !recorded;
  }

  /** Opens a recording, or a scene together with the files to which it refers. */
  async #open(files: readonly File[]): Promise<void> {
    const file = files.find(({ name }) => /\.(gltf|glb|csv)$/i.test(name)),
      name = file?.name ?? files[0]?.name ?? "";
    try {
      if (!file)
        throw new Error("this page opens a recording (.csv), or a scene (.glb, or .gltf together with its .bin)");
      const size = files.reduce((sum, each) => sum + each.size, 0);
      if (size > max_bytes)
        throw new Error(`the files have ${Math.ceil(size / 1048576)} MB; open at most ${max_bytes / 1048576} MB`);
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

  /** Reads the targets, then the meshes. A scene whose meshes cannot be read is shown without them. */
  async #scene(file: File, files: readonly File[]): Promise<VisitorScene> {
    const bytes = await file.arrayBuffer(),
      scene = readScene(this.library, bytes, file.name),
      { position_m, rotation } = scene.plate;
    try {
      const { readMeshes } = await import("../stage/meshes"); // contains the glTF loader of three.js
      const named = new Map(files.map((each) => [each.name, each]));
      scene.meshes = await readMeshes(bytes, named, position_m, rotation);
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
        ? `All ${report.rows} calls gave the recorded numbers, bit for bit.`
        : `Line ${report.first_different_line} gave other numbers than those recorded.`;
    const whole = report.ending === HRT_ENDING_COMPLETE ? "" : " The recording was cut off or altered, or lacks calls.";
    say(
      this.#replayed,
      `${name}: ${same}${whole} A recording does not contain perceived directions: the chart shows the ` +
        "controller's estimates.",
    );
    return reach;
  }
}

function save(name: string, type: string, text: string): void {
  const link = document.createElement("a"),
    url = URL.createObjectURL(new Blob([text], { type }));
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Calls `opened` with all files that are chosen in `input` or dropped on the page together. */
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
