// The mode "Be the finger": pointer or keys are where the visitor feels the finger. The hand is hidden until the end, and then
// shown where it really went.
import { pageCourse } from "../controller";
import type { Desk } from "../desk";
import { length_m, type Place, start, virtualPlace } from "../geometry";
import type { Hand } from "../hand";
import { showNow } from "../now";
import { element } from "../page";
import type { World } from "../person";
import type { Settings } from "../settings";
import type { Ticks } from "../ticks";
import type { Voice } from "../voice";

const keySpeed_m_s = 0.06;
const reveal_ms = 900;
/** A mouse that comes so near to the ring takes the finger along. */
const grasp_m = 0.008;

export class Sliding {
  /** Whether this mode is the one that is shown. */
  active = false;
  readonly #keys = new Set<string>();
  readonly #pointer: Place = { right_m: 0, away_m: 0 };
  readonly #grip: Place = { right_m: 0, away_m: 0 };
  /** Of the pointer that moves the finger; -1: none. */
  #held = -1;
  #plateOff = false;
  #shown_ms = 0;
  #owed_ms = 0;

  /** `still`: the hand is shown at once. */
  constructor(
    private readonly hand: Hand,
    private readonly world: World,
    private readonly desk: Desk,
    private readonly voice: Voice,
    private readonly ticks: Ticks,
    private settings: Readonly<Settings>,
    private readonly still: boolean,
  ) {
    const { frame } = desk;
    frame.addEventListener("pointerdown", (event) => this.#press(event));
    frame.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel", "pointerleave"] as const)
      frame.addEventListener(end, (event) => this.#release(event));
    frame.addEventListener("keydown", (event) => this.#key(event, true));
    frame.addEventListener("keyup", (event) => this.#key(event, false));
    frame.addEventListener("blur", () => this.#keys.clear());
    element("restart", HTMLButtonElement).addEventListener("click", () => this.#again(false));
    element("plate-off", HTMLButtonElement).addEventListener("click", () => this.#again(true));
  }

  apply(settings: Readonly<Settings>): void {
    this.settings = settings;
    this.hand.apply(this.#plateOff ? { ...settings, controller: "off" } : settings);
    this.restart();
  }

  restart(): void {
    this.hand.begin();
    if (this.active) this.desk.clearPaths(); // else they are another mode's
    this.#held = -1;
    this.#keys.clear();
    this.desk.frame.classList.remove("dragging");
  }

  frame(elapsed_ms: number): void {
    const hand = this.hand,
      { phase, ridges } = hand;
    this.#moveByKeys(elapsed_ms / 1000);
    this.#owed_ms += elapsed_ms;
    const whole = Math.floor(this.#owed_ms);
    this.#owed_ms -= whole;
    hand.advance(whole);
    if (phase === "sliding" && hand.ridges !== ridges) this.ticks.ridge();
    if (phase !== "arrived" && hand.phase === "arrived") this.#arrive();
    else if (hand.phase === "arrived") this.#shown_ms += elapsed_ms;
    this.#draw();
  }

  #again(plateOff: boolean): void {
    this.#plateOff = plateOff;
    this.apply(this.settings);
    this.desk.frame.focus({ preventScroll: true });
  }

  #press(event: PointerEvent): void {
    if (!this.active || event.button !== 0 || !this.desk.placeOf(event, this.#pointer)) return;
    this.ticks.wake();
    if (this.hand.phase === "arrived") this.restart();
    this.#grasp(event.pointerId);
    this.desk.frame.setPointerCapture(event.pointerId);
  }

  /** The finger moves as the pointer does, from wherever that is. */
  #grasp(pointer: number): void {
    this.#held = pointer;
    this.#grip.right_m = this.#pointer.right_m - this.hand.wanted.right_m;
    this.#grip.away_m = this.#pointer.away_m - this.hand.wanted.away_m;
    this.desk.frame.classList.add("dragging");
  }

  #move(event: PointerEvent): void {
    if (!this.active || !this.desk.placeOf(event, this.#pointer)) return;
    const idle = this.#held < 0 && event.pointerType === "mouse" && length_m(this.#pointer, start) < grasp_m;
    if (idle && this.hand.phase === "arrived" && this.#shown_ms > reveal_ms) this.restart();
    if (idle && this.hand.phase === "waiting") this.#grasp(event.pointerId);
    if (event.pointerId !== this.#held) return;
    this.hand.moveTo(this.#pointer.right_m - this.#grip.right_m, this.#pointer.away_m - this.#grip.away_m);
  }

  #release(event: PointerEvent): void {
    if (event.pointerId === this.#held) this.#end();
  }

  #key(event: KeyboardEvent, down: boolean): void {
    if (!this.active) return;
    if (event.key.startsWith("Arrow")) {
      if (down && !event.repeat && this.hand.phase === "arrived") this.restart();
      if (down) this.#keys.add(event.key);
      else this.#keys.delete(event.key);
    } else if (event.key === "Enter" && down && !event.repeat) {
      this.#end();
    } else if (event.key === "Escape" && down) {
      this.restart();
    } else {
      return;
    }
    this.ticks.wake();
    event.preventDefault();
  }

  #moveByKeys(seconds: number): void {
    if (this.#keys.size === 0) return;
    const held = (key: string) => (this.#keys.has(key) ? keySpeed_m_s * seconds : 0),
      { wanted } = this.hand;
    this.hand.moveTo(
      wanted.right_m + held("ArrowRight") - held("ArrowLeft"),
      wanted.away_m + held("ArrowUp") - held("ArrowDown"),
    );
  }

  /** The finger is lifted. */
  #end(): void {
    this.hand.end();
    if (this.hand.phase === "arrived") this.#arrive();
    else this.restart();
  }

  #arrive(): void {
    this.#held = -1;
    this.#shown_ms = 0;
    this.desk.frame.classList.remove("dragging");
    this.ticks.contact();
    this.voice.say(this.#text());
  }

  #draw(): void {
    const hand = this.hand,
      plate_deg = this.world.plate_deg(),
      over = hand.phase === "arrived";
    if (hand.phase !== "waiting") this.desk.extendPaths(hand.finger, hand.felt);
    this.desk.reveal(!over ? 0 : this.still ? 1 : Math.min(1, this.#shown_ms / reveal_ms));
    this.desk.draw(plate_deg, hand.finger, hand.felt);
    showNow(plate_deg, hand.finger_deg, hand.felt_deg, pageCourse(this.settings).virtual_deg);
    this.desk.caption(hand.phase, this.#text());
    this.desk.write(hand.result);
  }

  #text(): string {
    const hand = this.hand,
      { result } = hand;
    if (!result) {
      if (hand.phase === "sliding") return "You feel your finger here.";
      return this.#plateOff
        ? "The plate is off. Slide from the ring to the glass."
        : "Slide from the ring to the glass.";
    }
    const ghost = virtualPlace(pageCourse(this.settings)),
      off_m = length_m(hand.felt, ghost);
    const went =
      off_m < 1e-6
        ? "You went to the glass."
        : off_m > 0.02
          ? "You stopped before the glass."
          : `You went beside the glass, by ${(1000 * off_m).toFixed(0)} mm.`;
    const away_mm = 1000 * length_m(hand.felt, hand.finger);
    return `${went} Your hand is here, ${away_mm.toFixed(0)} mm away${this.#plateOff ? ": the plate was off" : ""}.`;
  }
}
