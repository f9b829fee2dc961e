// The settings: sliders and choices, in both directions between the page and a Settings object.
import { check, element, radios, say } from "./page";
import {
  controllerNames,
  defaultSettings,
  nextPerson,
  onSlider,
  type Settings,
  type SliderName,
  sliderNames,
  sliders,
} from "./settings";

/** Formats of each value: as text, and in words for screen readers. */
const formats: Readonly<Record<SliderName, (value: number) => readonly [string, string]>> = {
  tactile_weight: (value) => [value.toFixed(2), `${(100 * value).toFixed(0)} percent touch`],
  gap_deg: (value) => [`${value.toFixed(1)}°`, `${value} degrees`],
  noise_mm: (value) => [`${value.toFixed(1)} mm`, `${value} millimetres`],
  pace_s: (value) => [`${value.toFixed(1)} s`, `${value} seconds`],
  plate_deg_s: (value) => [`${value} °/s`, `${value} degrees a second`],
};

export class Panel {
  /** `changed` is called after each change of a setting. */
  constructor(
    public settings: Readonly<Settings>,
    private readonly changed: () => void,
  ) {
    for (const name of sliderNames) {
      const input = element(name, HTMLInputElement),
        { min, max, step } = sliders[name];
      Object.assign(input, { min: String(min), max: String(max), step: String(step) });
      input.addEventListener("input", () => this.change({ [name]: onSlider(name, Number(input.value)) }));
    }
    for (const radio of radios("controller")) {
      radio.addEventListener("change", () => {
        const controller = controllerNames.find((name) => name === radio.value);
        if (controller) this.change({ controller });
      });
    }
    element("another", HTMLButtonElement).addEventListener("click", () =>
      this.change({ person: nextPerson(this.settings.person) }),
    );
    element("reset", HTMLButtonElement).addEventListener("click", () => this.change(defaultSettings()));
    this.#show();
  }

  /** Shows the largest feasible gap for this person. */
  showMaxGap(max_deg: number): void {
    const far = this.settings.gap_deg >= max_deg,
      holds = element("holds", HTMLParagraphElement),
      text = `the hand of this person over gaps of up to ${max_deg.toFixed(1)}°`;
    say(holds, far ? `Too far: a plate can lead ${text}, with any controller.` : `A plate can lead ${text}.`);
    holds.classList.toggle("problem", far);
  }

  change(changes: Partial<Settings>): void {
    this.settings = { ...this.settings, ...changes };
    this.#show();
    this.changed();
  }

  #show(): void {
    for (const name of sliderNames) {
      const input = element(name, HTMLInputElement),
        value = this.settings[name],
        [text, words] = formats[name](value);
      if (Number(input.value) !== value) input.value = String(value);
      input.setAttribute("aria-valuetext", words);
      const output = document.querySelector(`output[for="${name}"]`);
      if (output) say(output, text);
    }
    check("controller", this.settings.controller);
  }
}
