// Settings of the page: ranges, defaults, and the link that contains them.

export const controllerNames = ["off", "paper", "ours"] as const;
export type ControllerName = (typeof controllerNames)[number];

/** Modes of the page: "Try it", "Watch", "Wear it" and "Your scene". The last one needs a file, so a link cannot choose it. */
export const modes = ["hand", "watch", "wear", "scene"] as const;
export type Mode = (typeof modes)[number];
const linkedModes = modes.slice(0, 3);

export const sliders = {
  /** Tactile weight: the fraction of touch in the perceived direction. The controller does not know it. */
  tactile_weight: { min: 0.05, max: 0.4, step: 0.01, start: 0.17 },
  /** Angle between the real and the virtual target, seen from the start. */
  gap_deg: { min: 0, max: 20, step: 0.5, start: 10 },
  /** White noise of the tracker, as the SD of each coordinate. */
  noise_mm: { min: 0, max: 3, step: 0.1, start: 1.2 },
  /** Duration of a reach; the controller does not know it. */
  pace_s: { min: 0.6, max: 4, step: 0.1, start: 1.5 },
  /** Maximum speed of the plate's servo. */
  plate_deg_s: { min: 50, max: 800, step: 10, start: 400 },
};
export type SliderName = keyof typeof sliders;
export const sliderNames = Object.keys(sliders) as SliderName[];
const maxPerson = 9999;

export interface Settings extends Record<SliderName, number> {
  controller: ControllerName;
  /** Seed of the person: correction gain, delay of touch and start direction. */
  person: number;
}

export function defaultSettings(): Settings {
  const starts = Object.fromEntries(sliderNames.map((name) => [name, sliders[name].start]));
  return { ...starts, controller: "ours", person: 1 } as Settings;
}

/** Rounds to the nearest value of the slider. */
export function onSlider(name: SliderName, value: number): number {
  const { min, max, step } = sliders[name];
  const steps = Math.round((Math.min(max, Math.max(min, value)) - min) / step);
  return Number((min + steps * step).toFixed(3));
}

/** Returns the part of a link after #: the mode, and the settings that differ from their defaults. */
export function toLink(settings: Readonly<Settings>, mode: Mode): string {
  const defaults = defaultSettings(),
    parts = new URLSearchParams();
  if (mode !== "hand" && linkedModes.includes(mode)) parts.set("mode", mode);
  for (const name of [...sliderNames, "controller", "person"] as const) {
    if (settings[name] !== defaults[name]) parts.set(name, String(settings[name]));
  }
  return parts.toString();
}

/** Reads settings and mode from the part of a link after #. `problems` describes the parts that were ignored. */
export function fromLink(link: string): { settings: Settings; mode: Mode; problems: string[] } {
  const settings = defaultSettings(),
    problems: string[] = [];
  let mode: Mode = "hand";
  for (const [name, text] of new URLSearchParams(link.slice(0, 500))) {
    const value = /^\d{1,6}(\.\d{1,6})?$/.test(text) ? Number(text) : NaN;
    const refuse = (allowed: string) => problems.push(`${name} is "${text.slice(0, 20)}"; allowed: ${allowed}`);
    if (isSlider(name)) {
      const { min, max } = sliders[name];
      if (value >= min && value <= max) settings[name] = onSlider(name, value);
      else refuse(`${min} to ${max}`);
    } else if (name === "mode") {
      mode = linkedModes.find((each) => each === text) ?? mode;
      if (mode !== text) refuse(linkedModes.join(", "));
    } else if (name === "controller") {
      settings.controller = controllerNames.find((each) => each === text) ?? settings.controller;
      if (settings.controller !== text) refuse(controllerNames.join(", "));
    } else if (name === "person") {
      if (Number.isInteger(value) && value >= 1 && value <= maxPerson) settings.person = value;
      else refuse(`1 to ${maxPerson}`);
    } else {
      problems.push(`"${name.slice(0, 20)}" is not a setting`);
    }
  }
  return { settings, mode, problems };
}

export function nextPerson(person: number): number {
  return (person % maxPerson) + 1;
}

function isSlider(name: string): name is SliderName {
  return Object.hasOwn(sliders, name);
}
