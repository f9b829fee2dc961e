// What can be set on the page: ranges, defaults, and the link that carries them.

export const controllerNames = ["off", "paper", "ours"] as const;
export type ControllerName = (typeof controllerNames)[number];

/** What the visitor does. The last one needs a file. */
export const modes = ["hand", "watch", "wear", "scene"] as const;
export type Mode = (typeof modes)[number];
const linkedModes = modes.slice(0, 3);

export const sliders = {
  /** Share of touch in the direction that is felt; the controller does not know it. */
  tactile_weight: { min: 0.05, max: 0.4, step: 0.01, start: 0.17 },
  /** Between the real and the virtual target, seen from the start. */
  gap_deg: { min: 0, max: 20, step: 0.5, start: 10 },
  /** White noise of the tracker, standard deviation of a coordinate. */
  noise_mm: { min: 0, max: 3, step: 0.1, start: 1.2 },
  /** Duration of a reach; the controller does not know it. */
  pace_s: { min: 0.6, max: 4, step: 0.1, start: 1.5 },
  /** Greatest speed of the plate's servo. */
  plate_deg_s: { min: 50, max: 800, step: 10, start: 400 },
};
export type SliderName = keyof typeof sliders;
export const sliderNames = Object.keys(sliders) as SliderName[];
const maxPerson = 9999;

export interface Settings extends Record<SliderName, number> {
  controller: ControllerName;
  /** Chooses the person: how fast they correct, how late they feel, where they set out. */
  person: number;
}

export function defaultSettings(): Settings {
  const starts = Object.fromEntries(sliderNames.map((name) => [name, sliders[name].start]));
  return { ...starts, controller: "ours", person: 1 } as Settings;
}

/** The nearest value that the slider has. */
export function onSlider(name: SliderName, value: number): number {
  const { min, max, step } = sliders[name];
  const steps = Math.round((Math.min(max, Math.max(min, value)) - min) / step);
  return Number((min + steps * step).toFixed(3));
}

/** The part of a link after #: what differs from the defaults. */
export function toLink(settings: Readonly<Settings>, mode: Mode): string {
  const defaults = defaultSettings(),
    parts = new URLSearchParams();
  if (mode !== "hand" && linkedModes.includes(mode)) parts.set("mode", mode);
  for (const name of [...sliderNames, "controller", "person"] as const) {
    if (settings[name] !== defaults[name]) parts.set(name, String(settings[name]));
  }
  return parts.toString();
}

/** Settings and mode of a link, and what in it was left out because it is unknown or not allowed. */
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
      problems.push(`nothing is called "${name.slice(0, 20)}"`);
    }
  }
  return { settings, mode, problems };
}

/** Another person than `person`. */
export function nextPerson(person: number): number {
  return (person % maxPerson) + 1;
}

function isSlider(name: string): name is SliderName {
  return Object.hasOwn(sliders, name);
}
