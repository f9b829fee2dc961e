// Colours of the style sheet, which defines them for light and dark pages. Colour-blind people can distinguish the blue of true
// values from the orange of perceived ones, whose lines are also dashed.

const surfaces = ["panel", "line", "stage", "desk", "plate", "ridges", "hand"] as const,
  inks = ["text", "muted", "real", "felt", "chart", "weight"] as const,
  names = [...surfaces, ...inks];

export type Colours = Readonly<Record<(typeof names)[number], string>>;

export function readColours(): Colours {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()])) as Colours;
}
