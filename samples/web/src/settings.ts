// Settings of the page: a form, whose elements in index.html define ranges and defaults, and its values in links.
import { element, say } from "./page";

export type ControllerName = "off" | "paper" | "ours";

/** Modes "Try it", "Watch", "Wear it" and "Your scene". A link cannot choose the last one, which needs a file. */
export const modes = ["hand", "watch", "wear", "scene"] as const;
export type Mode = (typeof modes)[number];
const linkedModes = modes.slice(0, 3);

export interface Settings {
  controller: ControllerName;
  /** Angle between the real and the virtual target, seen from the start. */
  gap_deg: number;
  /** Fraction of touch in the perceived direction. The controller does not know it. */
  tactile_weight: number;
  /** Duration of a reach; the controller does not know it. */
  pace_s: number;
  /** White noise of the tracker, as the SD of each coordinate. */
  noise_mm: number;
  /** Maximum speed of the plate's servo. */
  plate_deg_s: number;
  /** Seed of the simulated person's other parameters and of the noise. */
  person: number;
}

export class SettingsForm {
  readonly #form = element("settings", HTMLFormElement);
  readonly #defaults: FormData;

  /** `changed` is called after each change of a setting, except by fromLink(). */
  constructor(private readonly changed: () => void) {
    this.#form.reset(); // browsers restore values when a page is reloaded
    this.#defaults = new FormData(this.#form);
    this.#form.addEventListener("submit", (event) => event.preventDefault());
    this.#form.addEventListener("input", ({ target }) => {
      if (!(target instanceof HTMLInputElement) || !target.validity.valid) return;
      this.#show();
      changed();
    });
    element("defaults", HTMLButtonElement).addEventListener("click", () => {
      this.#form.reset();
      this.#show();
      changed();
    });
    this.#show();
  }

  get settings(): Settings {
    const entries = [...new FormData(this.#form)].map(([name, text]) => [name, Number(text)]);
    return { ...Object.fromEntries(entries), controller: new FormData(this.#form).get("controller") };
  }

  /** Sets the plate's speed to the value of its slider that is nearest. */
  setPlateSpeed(speed_deg_s: number): void {
    element("plate_deg_s", HTMLInputElement).value = String(speed_deg_s);
    this.#show();
    this.changed();
  }

  showMaxGap(max_deg: number): void {
    const far = this.settings.gap_deg >= max_deg,
      holds = element("holds", HTMLParagraphElement),
      text = `the hand of this person over gaps of up to ${max_deg.toFixed(1)}°`;
    say(holds, far ? `Too far: a plate can lead ${text}, with any controller.` : `A plate can lead ${text}.`);
    holds.classList.toggle("problem", far);
  }

  /** Returns the part of a link after #: the changed settings, and the mode, unless it is "hand" or "scene". */
  toLink(mode: Mode): string {
    const link = new URLSearchParams(mode !== "hand" && linkedModes.includes(mode) ? { mode } : {});
    for (const [name, value] of new FormData(this.#form))
      if (value !== this.#defaults.get(name)) link.set(name, String(value));
    return link.toString();
  }

  /** Sets the settings from the first 500 characters after # in a link. `problems` describes the ignored parts. */
  fromLink(link: string): { mode: Mode; problems: string[] } {
    const problems: string[] = [];
    let mode: Mode = "hand";
    this.#form.reset();
    for (const [name, text] of new URLSearchParams(link.slice(0, 500))) {
      const chosen = linkedModes.find((each) => each === text),
        allowed = name === "mode" ? (chosen ? "" : linkedModes.join(", ")) : this.#set(name, text);
      if (name === "mode") mode = chosen ?? mode;
      if (allowed === null) problems.push(`"${name.slice(0, 20)}" is not a setting`);
      else if (allowed) problems.push(`${name} is "${text.slice(0, 20)}"; allowed: ${allowed}`);
    }
    this.#show();
    return { mode, problems };
  }

  /** Sets a value and returns "". For a value that is not allowed, sets a slider to its default and returns the allowed
   *  values; null: no such setting. */
  #set(name: string, text: string): string | null {
    const control = this.#form.elements.namedItem(name);
    if (control instanceof RadioNodeList) {
      control.value = text;
      return control.value === text ? "" : [...control].map((each) => (each as HTMLInputElement).value).join(", ");
    }
    if (!(control instanceof HTMLInputElement)) return null;
    control.value = text; // a slider moves to its nearest value
    const { min, max } = control,
      number = /^\d{1,6}(\.\d{1,6})?$/.test(text) ? Number(text) : NaN;
    if (number >= Number(min) && number <= Number(max) && control.validity.valid) return "";
    control.value = control.defaultValue;
    return `${min} to ${max}`;
  }

  #show(): void {
    for (const output of this.#form.querySelectorAll("output")) {
      const input = element(output.htmlFor.value, HTMLInputElement),
        digits = input.step.split(".")[1]?.length ?? 0,
        text = Number(input.value).toFixed(digits) + (output.dataset.unit ?? "");
      say(output, text);
      input.setAttribute("aria-valuetext", text);
    }
  }
}
