// The page's elements, and how numbers are written in them.

/** The element of this id, which must be of this type. */
export function element<Type extends Element>(id: string, type: new () => Type): Type {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`the page has no ${type.name} "${id}"`);
  return found;
}

export function radios(name: string): HTMLInputElement[] {
  return [...document.querySelectorAll<HTMLInputElement>(`input[name="${name}"]`)];
}

/** The value of the radio button that is chosen. */
export function chosen(name: string): string | undefined {
  return radios(name).find(({ checked }) => checked)?.value;
}
export function check(name: string, value: string): void {
  for (const radio of radios(name)) radio.checked = radio.value === value;
}

/** A row of a table; `index` -1: its last. */
export function addRow(body: HTMLTableSectionElement, texts: readonly string[], index = -1): HTMLTableRowElement {
  const row = body.insertRow(index);
  for (const text of texts) row.insertCell().textContent = text;
  return row;
}

/** What a caught error says. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** Sets a text if it is another one: unchanged texts cost no layout. */
export function say(where: Element, text: string): void {
  if (where.textContent !== text) where.textContent = text;
}

/** A direction for people; "–" if there is none. */
export function sideways(angle_deg: number, digits = 0, none = "straight ahead", to = ""): string {
  if (Number.isNaN(angle_deg)) return "–";
  const size = Math.abs(angle_deg).toFixed(digits);
  return Number(size) === 0 ? none : `${size}° ${to}${angle_deg > 0 ? "left" : "right"}`;
}

/** A turn for people. */
export function turned(angle_deg: number): string {
  return sideways(angle_deg, 1, "nothing", "to the ");
}

/** Says what went wrong, until it is said that nothing did (""). `retry`: loading the page again may help; its address keeps
 *  the settings. */
export function report(text: string, retry = false): void {
  element("problem", HTMLDivElement).hidden = text === "";
  say(element("problem-text", HTMLSpanElement), text);
  element("retry", HTMLButtonElement).hidden = !retry;
}

/** A part that is loaded when it is asked for; null if it could not be, which is said. */
export async function part<Type>(name: string, loading: Promise<Type>): Promise<Type | null> {
  try {
    return await loading;
  } catch (error) {
    report(`${name} could not be loaded: ${messageOf(error)}.`, true);
    return null;
  }
}
