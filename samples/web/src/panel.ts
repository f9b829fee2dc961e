// The settings: sliders and choices, in both directions between the page and a Settings object.
import { element, radios, say } from "./page";
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

const texts: Readonly<Record<SliderName, (value: number) => string>> = {
  tactile_weight: (value) => value.toFixed(2),
  gap_deg: (value) => `${value.toFixed(1)}°`,
  noise_mm: (value) => `${value.toFixed(1)} mm`,
  pace_s: (value) => `${value.toFixed(1)} s`,
  plate_deg_s: (value) => `${value} °/s`,
};

export class Panel {
  #settings: Settings;
  readonly #changed: () => void;

  /** Calls `changed` whenever the visitor has changed something. */
  constructor(settings: Readonly<Settings>, changed: () => void) {
    this.#settings = { ...settings };
    this.#changed = changed;
    for (const name of sliderNames) {
      const input = element(name, HTMLInputElement),
        { min, max, step } = sliders[name];
      Object.assign(input, { min: String(min), max: String(max), step: String(step) });
      input.addEventListener("input", () => this.#set({ [name]: onSlider(name, Number(input.value)) }));
    }
    for (const radio of radios("controller")) {
      radio.addEventListener("change", () => {
        const controller = controllerNames.find((name) => name === radio.value);
        if (controller) this.#set({ controller });
      });
    }
    element("another", HTMLButtonElement).addEventListener("click", () =>
      this.#set({ person: nextPerson(this.#settings.person) }),
    );
    element("reset", HTMLButtonElement).addEventListener("click", () => this.#set(defaultSettings()));
    this.#show();
  }

  get settings(): Readonly<Settings> {
    return this.#settings;
  }

  replace(settings: Readonly<Settings>): void {
    this.#set(settings);
  }

  /** How large a gap this person can be led over. */
  showMaxGap(max_deg: number): void {
    const { gap_deg } = this.#settings,
      holds = element("holds", HTMLParagraphElement);
    say(
      holds,
      gap_deg < max_deg
        ? `This person can be led over gaps up to ${max_deg.toFixed(1)}°.`
        : `Too far: this person can be led over gaps up to ${max_deg.toFixed(1)}°, with any controller.`,
    );
    holds.classList.toggle("problem", gap_deg >= max_deg);
  }

  #set(changes: Partial<Settings>): void {
    this.#settings = { ...this.#settings, ...changes };
    this.#show();
    this.#changed();
  }

  #show(): void {
    for (const name of sliderNames) {
      const input = element(name, HTMLInputElement),
        value = this.#settings[name],
        text = texts[name](value);
      if (Number(input.value) !== value) input.value = String(value);
      input.setAttribute("aria-valuetext", text);
      const output = document.querySelector(`output[for="${name}"]`);
      if (output) say(output, text);
    }
    for (const radio of radios("controller")) radio.checked = radio.value === this.#settings.controller;
  }
}
