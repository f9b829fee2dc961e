// The mode "Try it": pointer or keys move the true hand, which is hidden until the slide ends. The visitor steers the
// dot, which is the perceived position of the fingertip, to the glass.
import type { Desk } from "../desk";
import { distance_m, length_m, type Place, start, virtualPlace } from "../geometry";
import { element, say } from "../page";
import type { Settings } from "../settings";
import type { Sounds } from "../sounds";
import type { VisitorReach } from "../visitor_reach";
import type { Compare } from "./compare";
import { Series } from "./series";

const keySpeed_m_s = 0.06;
const reveal_ms = 900;
/** A mouse pointer within grasp_m of the start moves the fingertip without a press. Its offset from the fingertip then
 *  decreases to 0 over the first fade_m of the path. */
const grasp_m = 0.008,
  fade_m = 0.03;
/** Smallest distance between dot and glass at the end of a slide that missed the glass. */
const missed_mm = 8;
const steering = ["ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight"];

export class SlideMode {
  active = false;
  readonly #series = new Series();
  readonly #keys = new Set<string>();
  /** Position of the pointer minus that of the fingertip, when the pointer began to move it. */
  #offset: Place = start;
  /** Identifier of the pointer that moves the fingertip; -1: none. */
  #held = -1;
  /** True if the offset decreases along the path; see fade_m. */
  #joins = false;
  #pressed = false;
  #plateOff = false;
  #shown_ms = 0;
  #pending_ms = 0;

  /** `guided`: slides over the controlled plate; `unguided`: over a plate at rest. `still`: the hand appears without an
   *  animation. */
  constructor(
    private readonly guided: VisitorReach,
    private readonly unguided: VisitorReach,
    private readonly desk: Desk,
    private readonly compare: Compare,
    private readonly sounds: Sounds,
    private settings: Readonly<Settings>,
    private readonly still: boolean,
  ) {
    const { frame, grip } = desk;
    grip.addEventListener("pointerdown", (event) => this.#press(event));
    window.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"] as const)
      window.addEventListener(end, (event) => this.#release(event));
    frame.addEventListener("keydown", (event) => this.#key(event, true));
    frame.addEventListener("keyup", (event) => this.#key(event, false));
    frame.addEventListener("blur", () => this.#keys.clear());
    element("restart", HTMLButtonElement).addEventListener("click", () => this.#again(false));
    element("plate-off", HTMLButtonElement).addEventListener("click", () => this.#again(true));
    this.#series.begin(settings);
  }

  get hand(): VisitorReach {
    return this.#plateOff ? this.unguided : this.guided;
  }

  /** True while frames must be drawn. */
  get busy(): boolean {
    return !this.hand.resting || this.#keys.size > 0 || (this.hand.phase === "arrived" && this.#shown_ms < reveal_ms);
  }

  apply(settings: Readonly<Settings>): void {
    this.settings = settings;
    this.unguided.apply({ ...settings, controller: "off" });
    this.guided.apply(settings);
    this.#plateOff = false;
    this.#series.begin(settings);
    this.compare.clear();
    this.restart();
  }

  /** Returns the hand to the ring. */
  restart(): void {
    this.hand.begin(this.#series.gap_deg);
    this.#series.skip();
    this.#letGo();
    this.#keys.clear();
    if (this.active) this.desk.setTargets(this.hand.course);
  }

  frame(elapsed_ms: number): void {
    const hand = this.hand,
      { phase, ridges } = hand;
    this.#moveByKeys(elapsed_ms / 1000);
    this.#pending_ms += elapsed_ms;
    const whole = Math.floor(this.#pending_ms);
    this.#pending_ms -= whole;
    hand.advance(whole);
    if (phase === "sliding" && hand.ridges !== ridges) this.sounds.ridge(hand.speed_m_s);
    if (this.#keys.size > 0 && hand.phase === "sliding") this.#guide();
    if (phase !== "arrived" && hand.phase === "arrived") this.#arrive();
    else if (hand.phase === "arrived") this.#shown_ms += elapsed_ms;
    this.#draw();
  }

  #guide(): void {
    const { felt, course } = this.hand,
      glass = virtualPlace(course);
    this.sounds.guide((glass.right_m - felt.right_m) / 0.015, length_m(felt, glass) / distance_m);
  }

  #again(plateOff: boolean): void {
    this.#plateOff = plateOff;
    this.restart();
    this.desk.frame.focus({ preventScroll: true });
    this.desk.frame.scrollIntoView({ block: "nearest" });
  }

  #press(event: PointerEvent): void {
    if (!this.active || event.button !== 0 || this.hand.phase === "arrived") return;
    this.#pressed = true;
    const at = this.desk.placeOf(event);
    if (this.#held < 0 && at) this.#grasp(event, at);
    this.desk.grip.setPointerCapture(event.pointerId); // for moves outside the window
  }

  /** Lets the fingertip follow the pointer, at the present offset. */
  #grasp({ pointerId, pointerType }: PointerEvent, at: Place): void {
    const { finger } = this.hand;
    this.#held = pointerId;
    this.#joins = pointerType === "mouse" && length_m(at, finger) < grasp_m;
    this.#offset = { right_m: at.right_m - finger.right_m, away_m: at.away_m - finger.away_m };
    document.documentElement.classList.add("steering");
  }

  #letGo(): void {
    this.#held = -1;
    this.#pressed = false;
    document.documentElement.classList.remove("steering");
  }

  #move(event: PointerEvent): void {
    const { hand } = this,
      at = this.desk.placeOf(event);
    if (!this.active || hand.phase === "arrived" || !at) return;
    const free = this.#held < 0 && event.pointerType === "mouse";
    if (free && length_m(at, start) < grasp_m && event.target === this.desk.grip) this.#grasp(event, at);
    if (event.pointerId !== this.#held) return;
    const kept = this.#joins ? Math.max(0, 1 - length_m(start, hand.finger) / fade_m) : 1;
    hand.moveTo(at.right_m - kept * this.#offset.right_m, at.away_m - kept * this.#offset.away_m);
  }

  #release(event: PointerEvent): void {
    const lifted = this.#pressed && event.pointerId === this.#held;
    this.#pressed = false;
    if (lifted && !(this.#joins && this.hand.phase === "waiting")) this.#end();
  }

  #key(event: KeyboardEvent, down: boolean): void {
    if (!this.active) return;
    if (steering.includes(event.key)) {
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
    const held = (key: string) => (this.#keys.has(key) ? keySpeed_m_s * seconds : 0),
      { wanted } = this.hand;
    this.hand.moveTo(
      wanted.right_m + held("ArrowRight") - held("ArrowLeft"),
      wanted.away_m + held("ArrowUp") - held("ArrowDown"),
    );
  }

  /** Lifts the fingertip. A slide that has arrived keeps its result. */
  #end(): void {
    if (this.hand.result) return;
    this.hand.end();
    if (this.hand.phase === "arrived") this.#arrive();
    else this.restart();
  }

  #arrive(): void {
    const { hand } = this,
      { result } = hand;
    this.#letGo();
    this.#shown_ms = 0;
    if (!this.#plateOff && result && result.feltToGlass_mm < missed_mm) this.#series.ask(result.gap_deg);
    this.compare.keep(this.#plateOff ? "off" : "on", hand.trace, hand.course);
    this.sounds.contact();
    say(element("spoken", HTMLParagraphElement), this.#text());
  }

  #draw(): void {
    const { hand, desk } = this,
      over = hand.phase === "arrived";
    desk.reveal(!over ? 0 : this.still ? 1 : Math.min(1, this.#shown_ms / reveal_ms));
    desk.draw(hand);
    desk.caption(hand.phase, this.#text());
    element("after", HTMLDivElement).hidden = !over || this.#series.asking;
    say(element("learnt", HTMLParagraphElement), over ? this.#learnt() : "");
    desk.write(hand.result, hand.felt);
  }

  #text(): string {
    const { phase, result, finger, felt } = this.hand;
    if (!result) {
      if (phase === "sliding") return "Steer the dot to the glass.";
      return this.#plateOff
        ? "The plate is off. Slide the dot from the ring to the glass."
        : "Slide the dot from the ring to the glass.";
    }
    const miss_mm = result.feltToGlass_mm,
      away_mm = 1000 * length_m(felt, finger);
    const went =
      miss_mm < missed_mm
        ? "You steered the dot to the glass."
        : length_m(start, felt) < 0.095
          ? "You stopped before the glass."
          : `The dot passed ${miss_mm.toFixed(0)} mm beside the glass.`;
    const hand = `Your hand is here, ${away_mm.toFixed(0)} mm from the dot`;
    return this.#plateOff
      ? `${went} ${hand}: the plate was off.`
      : `${went} ${hand} and ${result.toCylinder_mm.toFixed(0)} mm from the cylinder.`;
  }

  /** Describes the estimate of the tactile weight; "" with the plate off and for controllers other than "ours". */
  #learnt(): string {
    const { tactile_weight, tactile_weight_sd } = this.guided.command;
    if (this.#plateOff || this.settings.controller !== "ours") return "";
    const percent = (fraction: number) => (100 * Math.max(0, fraction)).toFixed(0);
    return (
      `The computer learnt from your slides: the ridges contribute ${percent(tactile_weight)} % to the direction of the dot ` +
      `(95 % interval: ${percent(tactile_weight - 1.96 * tactile_weight_sd)} to ` +
      `${percent(tactile_weight + 1.96 * tactile_weight_sd)} %).`
    );
  }
}
