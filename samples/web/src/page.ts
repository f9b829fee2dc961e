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
