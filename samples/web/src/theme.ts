// Colours from the style sheet, which is the one source for light, dark and high contrast. Colour-blind people can
// distinguish the blue of true and the orange of perceived values; lines differ in their dashes too.

const surfaces = ["panel", "line", "stage", "desk", "plate", "ridges", "hand"] as const,
  inks = ["text", "muted", "real", "felt", "chart", "weight"] as const,
  names = [...surfaces, ...inks];

export type Colours = Readonly<Record<(typeof names)[number], string>>;

export function readColours(): Colours {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()])) as Colours;
}
