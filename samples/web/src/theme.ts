// Colours, from the style sheet, so that light, dark and high contrast have one source. The blue and orange
// of true and felt can be separated by colour-blind people; lines differ in their dashes too.

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
