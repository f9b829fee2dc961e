// The mode "Be the finger": pointer and keys move the finger; what it would feel is drawn beside it.
import { pageCourse } from "../controller";
import type { Desk } from "../desk";
import { distance_m, length_m, start, virtualPlace, type Place } from "../geometry";
import type { Hand } from "../hand";
import type { Now } from "../now";
import { element, say, sideways } from "../page";
import type { World } from "../person";
import type { Voice } from "../voice";
import type { Settings } from "../settings";

const keySpeed_m_s = 0.05;
const keyTurn_deg_s = 40;
const longestFrame_ms = 100;
/** At an object. */
const near_m = 0.008;

export class Sliding {
  /** Whether this mode is the one that is shown. */
  active = false;
  readonly #hand: Hand;
  readonly #world: World;
  readonly #desk: Desk;
  readonly #now: Now;
  readonly #voice: Voice;
  readonly #caption = element("caption", HTMLParagraphElement);
  readonly #spoken = element("spoken", HTMLParagraphElement);
  readonly #hidden = element("hide-finger", HTMLInputElement);
  readonly #keys = new Set<string>();
  readonly #pointer: Place = { right_m: 0, away_m: 0 };
  readonly #grip: Place = { right_m: 0, away_m: 0 };
  #dragging = -1;
  #heading_deg = 0;
  #owed_ms = 0;
  #settings: Readonly<Settings>;

  constructor(hand: Hand, world: World, desk: Desk, now: Now, voice: Voice, settings: Readonly<Settings>) {
    this.#voice = voice;
    this.#hand = hand;
    this.#world = world;
    this.#desk = desk;
    this.#now = now;
    this.#settings = settings;
    const { frame } = desk;
    frame.addEventListener("pointerdown", (event) => this.#press(event));
    frame.addEventListener("pointermove", (event) => this.#drag(event));
    frame.addEventListener("pointerup", (event) => this.#release(event));
    frame.addEventListener("pointercancel", (event) => this.#release(event));
    frame.addEventListener("keydown", (event) => this.#key(event, true));
    frame.addEventListener("keyup", (event) => this.#key(event, false));
    frame.addEventListener("blur", () => this.#keys.clear());
    element("restart", HTMLButtonElement).addEventListener("click", () => this.restart());
    this.#hidden.addEventListener("change", () => this.restart());
  }

  apply(settings: Readonly<Settings>): void {
    this.#settings = settings;
    this.#hand.apply(settings);
    this.restart();
  }

  restart(): void {
    this.#hand.begin();
    this.#desk.clearPaths();
    this.#heading_deg = 0;
    this.#dragging = -1;
    this.#keys.clear();
    this.#desk.frame.classList.remove("dragging");
    this.#desk.frame.classList.toggle("blind", this.#hidden.checked);
  }

  frame(elapsed_ms: number): void {
    const elapsed = Math.min(elapsed_ms, longestFrame_ms);
    this.#moveByKeys(elapsed / 1000);
    this.#owed_ms += elapsed;
    const whole = Math.floor(this.#owed_ms);
    this.#owed_ms -= whole;
    this.#hand.advance(whole);
    this.#draw();
  }

  #press(event: PointerEvent): void {
    if (!this.active || this.#dragging >= 0 || event.button !== 0) return;
    if (!this.#desk.placeOf(event, this.#grip)) return;
    if (this.#hand.phase === "arrived") this.restart();
    this.#dragging = event.pointerId;
    // The finger moves as the pointer does, from wherever the drag begins: a thumb does not cover it.
    this.#grip.right_m -= this.#hand.wanted.right_m;
    this.#grip.away_m -= this.#hand.wanted.away_m;
    this.#desk.frame.setPointerCapture(event.pointerId);
    this.#desk.frame.classList.add("dragging");
  }

  #drag(event: PointerEvent): void {
    if (event.pointerId !== this.#dragging || !this.#desk.placeOf(event, this.#pointer)) return;
    this.#hand.moveTo(this.#pointer.right_m - this.#grip.right_m, this.#pointer.away_m - this.#grip.away_m);
  }

  #release(event: PointerEvent): void {
    if (event.pointerId !== this.#dragging) return;
    this.#dragging = -1;
    this.#desk.frame.classList.remove("dragging");
    this.#end();
  }

  #key(event: KeyboardEvent, down: boolean): void {
    if (!this.active) return;
    if (event.key.startsWith("Arrow")) {
      if (down && this.#hand.phase === "arrived") this.restart();
      if (down) this.#keys.add(event.key);
      else this.#keys.delete(event.key);
    } else if (event.key === "Enter" && down && !event.repeat) {
      this.#end();
    } else if (event.key === "Escape" && down) {
      this.restart();
    } else {
      return;
    }
    event.preventDefault();
  }

  #moveByKeys(seconds: number): void {
    if (this.#keys.size === 0) return;
    const held = (key: string) => (this.#keys.has(key) ? 1 : 0);
    this.#heading_deg += keyTurn_deg_s * seconds * (held("ArrowLeft") - held("ArrowRight"));
    const travel_m = keySpeed_m_s * seconds * (held("ArrowUp") - held("ArrowDown"));
    const { wanted } = this.#hand, heading = (this.#heading_deg * Math.PI) / 180;
    this.#hand.moveTo(wanted.right_m - travel_m * Math.sin(heading), wanted.away_m + travel_m * Math.cos(heading));
  }

  #end(): void {
    this.#hand.end();
    if (this.#hand.phase === "waiting") this.restart();
    if (this.#hand.phase !== "arrived") return;
    say(this.#spoken, this.#text());
    this.#voice.say(this.#text());
  }

  #draw(): void {
    const hand = this.#hand, plate_deg = this.#world.plate_deg();
    if (hand.phase !== "waiting") this.#desk.extendPaths(hand.finger, hand.felt);
    this.#desk.frame.dataset.phase = hand.phase;
    this.#desk.showFinger(!this.#hidden.checked || hand.phase !== "sliding");
    this.#desk.draw(plate_deg, hand.finger, hand.felt);
    this.#now.show(plate_deg, hand.finger_deg, hand.felt_deg, pageCourse(this.#settings).virtual_deg);
    say(this.#caption, this.#text());
    this.#write();
  }

  /** For those who check: the truth in numbers, beside the picture. */
  #write(): void {
    const { dataset } = this.#desk.frame, { result } = this.#hand;
    if (result) {
      dataset.toCylinderMm = String(result.toCylinder_mm);
      dataset.toGhostMm = String(result.toGhost_mm);
      dataset.feltToGhostMm = String(result.feltToGhost_mm);
    } else {
      delete dataset.toCylinderMm;
      delete dataset.toGhostMm;
      delete dataset.feltToGhostMm;
    }
  }

  #text(): string {
    const hand = this.#hand, { result } = hand;
    if (result) {
      const end = `Your finger ended ${result.toCylinder_mm.toFixed(0)} mm from the real cylinder and ` +
        `${result.toGhost_mm.toFixed(0)} mm from the ghost. With skin on these ridges you would have felt it ` +
        `${result.feltToGhost_mm.toFixed(0)} mm from the ghost.`;
      const near_mm = 1000 * near_m, { gap_deg } = this.#settings;
      if (result.feltToGhost_mm < near_mm && result.toCylinder_mm < near_mm && gap_deg > 0) return `That is the illusion. ${end}`;
      if (result.toGhost_mm < near_mm) return `${end} You went to the ghost: nothing bends a hand that does not feel.`;
      return end;
    }
    if (hand.phase === "waiting") {
      return `Slide the finger from the ring to the ghost, ${sideways(pageCourse(this.#settings).virtual_deg)}. The cylinder is ` +
        `${sideways(pageCourse(this.#settings).real_deg)}.`;
    }
    const ghost = virtualPlace(pageCourse(this.#settings));
    if (length_m(hand.felt, ghost) < near_m) return "The felt finger is at the ghost: let go, or press Enter.";
    if (length_m(start, hand.felt) > distance_m) return "The felt finger has passed beside the ghost: let go, or press Enter.";
    if (Number.isNaN(hand.felt_deg)) return "The finger rests: nothing is felt.";
    return `You move ${sideways(hand.finger_deg)}; on these ridges that would feel like ${sideways(hand.felt_deg)}.`;
  }
}
