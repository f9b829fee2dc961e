// The mode "Watch": plays reaches of the simulated person one after the other at the chosen speed, and describes them.
import type { Desk } from "../desk";
import { element, say, sideways } from "../page";
import { places, type World } from "../person";
import { type Results, resultText } from "../results";
import type { Settings } from "../settings";
import type { SimulatedReach } from "../simulated_reach";
import type { Voice } from "../voice";

/** Time for which the end of a reach is shown. */
const pause_ms = 2200;
const step_ms = 100;

export class WatchMode {
  playing = false;
  #scale = 1;
  readonly #play = element("play", HTMLButtonElement);
  readonly #speed = element("speed", HTMLSelectElement);
  #pending_ms = 0;
  #shownFor_ms = 0;

  /** `still`: reaches are shown at their end immediately, unless the visitor plays or steps them. */
  constructor(
    private watch: SimulatedReach,
    private world: World,
    private readonly desk: Desk,
    private readonly results: Results,
    private settings: Readonly<Settings>,
    private readonly voice: Voice,
    private readonly still: boolean,
  ) {
    this.#play.addEventListener("click", () => this.#setPlaying(!this.playing));
    element("step", HTMLButtonElement).addEventListener("click", () => this.#step());
    element("again", HTMLButtonElement).addEventListener("click", () => this.resume());
    this.#setPlaying(!still);
  }

  apply(settings: Readonly<Settings>): void {
    this.settings = settings;
    if (this.watch.apply(settings)) this.results.clear();
    this.#shown();
    this.#finishIfStill();
  }

  /** Plays these reaches from now on, drawn `scale` times as large. */
  play(watch: SimulatedReach, world: World, scale: number): void {
    if (watch === this.watch) return;
    this.watch = watch;
    this.world = world;
    this.#scale = scale;
    this.results.clear();
  }

  /** Begins the next reach, when the mode is shown again or the visitor asks for it. */
  resume(): void {
    this.#begin();
    this.#finishIfStill();
  }

  frame(elapsed_ms: number): void {
    if (this.playing) {
      if (this.watch.phase === "arrived") {
        this.#shownFor_ms += elapsed_ms;
        if (this.#shownFor_ms >= pause_ms) this.#begin();
      } else {
        this.#pending_ms += elapsed_ms * Number(this.#speed.value);
        const whole = Math.floor(this.#pending_ms);
        this.#pending_ms -= whole;
        this.#advance(whole);
      }
    }
    this.#draw();
  }

  #finishIfStill(): void {
    if (!this.still || this.playing) return;
    while (this.watch.phase !== "arrived") this.#advance(step_ms);
  }

  #setPlaying(playing: boolean): void {
    this.playing = playing;
    say(this.#play, playing ? "Pause" : "Play");
  }

  #step(): void {
    this.#setPlaying(false);
    if (this.watch.phase === "arrived") this.#begin();
    else this.#advance(step_ms);
  }

  #begin(): void {
    this.watch.begin();
    this.#shown();
  }

  #shown(): void {
    this.desk.clearPaths();
    this.#pending_ms = this.#shownFor_ms = 0;
  }

  #advance(milliseconds: number): void {
    const world = this.world;
    for (let i = 0; i < milliseconds && this.watch.phase !== "arrived"; ++i) {
      this.watch.advance();
      if (i % 5 === 0) this.#extend();
    }
    this.#extend();
    const { result } = this.watch;
    if (!result || this.watch.phase !== "arrived" || world.over() === 0) return;
    this.results.add(result);
    this.voice.say(resultText(result));
  }

  #extend(): void {
    const { finger, felt } = places(this.world, this.#scale);
    this.desk.extendPaths(finger, felt);
  }

  #draw(): void {
    const { finger, felt } = places(this.world, this.#scale);
    this.#extend();
    this.desk.draw(this.world.plate_deg(), finger, felt);
    this.desk.caption(this.watch.phase, this.#text());
  }

  #text(): string {
    const { phase, result } = this.watch,
      { finger_deg, felt_deg } = this.watch.directions();
    if (phase === "arrived" && result) return resultText(result);
    if (Number.isNaN(finger_deg)) {
      if (phase === "sliding") return "The hand has stopped.";
      return this.settings.controller === "off"
        ? "The hand rests in the ring. The plate does not turn."
        : "The hand rests in the ring. The plate turns for the beginning of the slide.";
    }
    return (
      `The hand moves ${sideways(finger_deg)}; over these ridges that feels like ${sideways(felt_deg)}. ` +
      `The glass lies ${sideways(this.watch.course.virtual_deg)}.`
    );
  }
}
