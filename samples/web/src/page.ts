// Access to the elements and colours of the page, messages to the visitor, and the format of directions.

/** Returns the element with this id. Throws if the page has none, or if its type is another. */
export function element<Type extends Element>(id: string, type: new () => Type): Type {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`the page has no ${type.name} "${id}"`);
  return found;
}

export function radios(name: string): HTMLInputElement[] {
  return [...document.querySelectorAll<HTMLInputElement>(`input[name="${name}"]`)];
}

export function chosen(name: string): string | undefined {
  return radios(name).find(({ checked }) => checked)?.value;
}
export function check(name: string, value: string): void {
  for (const radio of radios(name)) radio.checked = radio.value === value;
}

export function addRow(body: HTMLTableSectionElement, texts: readonly string[], index = -1): HTMLTableRowElement {
  const row = body.insertRow(index);
  for (const text of texts) row.insertCell().textContent = text;
  return row;
}

export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** Sets a text only if it differs, so that an unchanged text causes no layout. */
export function say(where: Element, text: string): void {
  if (where.textContent !== text) where.textContent = text;
}

/** Formats a direction, for example as "12° left"; "–" for NaN. */
export function sideways(angle_deg: number, digits = 0): string {
  if (Number.isNaN(angle_deg)) return "–";
  const size = Math.abs(angle_deg).toFixed(digits);
  return Number(size) === 0 ? "straight ahead" : `${size}° ${angle_deg > 0 ? "left" : "right"}`;
}

/** Shows an error until it is called with "". `retry`: offers to reload the page, whose address keeps the settings. */
export function report(text: string, retry = false): void {
  element("problem", HTMLDivElement).hidden = text === "";
  say(element("problem-text", HTMLSpanElement), text);
  element("retry", HTMLButtonElement).hidden = !retry;
}

/** Waits for a part that is loaded on demand. If that fails, shows an error and returns null. */
export async function part<Type>(name: string, loading: Promise<Type>): Promise<Type | null> {
  try {
    return await loading;
  } catch (error) {
    report(`${name} could not be loaded: ${messageOf(error)}. Check the connection, then try again.`, true);
    return null;
  }
}

const surfaces = ["panel", "line", "stage", "desk", "plate", "ridges", "hand"] as const,
  inks = ["text", "muted", "real", "felt", "chart", "weight"] as const,
  names = [...surfaces, ...inks];

/** Colours of the style sheet, which defines them for light and dark pages. */
export type Colours = Readonly<Record<(typeof names)[number], string>>;

export function readColours(): Colours {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()])) as Colours;
}
