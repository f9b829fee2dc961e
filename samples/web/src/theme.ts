// Colours from the style sheet, which is the one source for light, dark and high contrast. Colour-blind people can
// distinguish the blue of true and the orange of perceived values; lines differ in their dashes too.

const names = {
  text: "--text",
  muted: "--muted",
  panel: "--panel",
  line: "--line",
  stage: "--stage",
  desk: "--desk",
  plate: "--plate",
  ridges: "--ridges",
  hand: "--hand",
  real: "--real",
  felt: "--felt",
  chartPlate: "--chart-plate",
  weight: "--weight",
} as const;

export type Colours = Readonly<Record<keyof typeof names, string>>;

export function readColours(): Colours {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    Object.entries(names).map(([key, name]) => [key, style.getPropertyValue(name).trim()]),
  ) as Colours;
}
