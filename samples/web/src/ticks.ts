// What a fingertip would feel, for the ear and, where there is a motor, the hand: a tick at each ridge, a soft contact at the end.
import { element, say } from "./page";

const key = "haptic-retargeting-ticks";

export class Ticks {
  readonly #button = element("ticks", HTMLButtonElement);
  #on: boolean;
  #audio: AudioContext | null = null;

  /** `still`: off until the visitor asks. The choice is remembered where the browser allows it. */
  constructor(still: boolean) {
    const kept = remembered();
    this.#on = kept === null ? !still : kept === "on";
    this.#show();
    this.#button.addEventListener("click", () => {
      this.#on = !this.#on;
      this.#show();
      try {
        localStorage.setItem(key, this.#on ? "on" : "off");
      } catch {
        /* for this visit only */
      }
      this.wake();
      this.ridge();
    });
  }

  /** Browsers give sound only once the visitor has pressed something. */
  wake(): void {
    if (!this.#on || typeof AudioContext === "undefined") return;
    this.#audio ??= new AudioContext();
    if (this.#audio.state === "suspended") void this.#audio.resume();
  }

  ridge(): void {
    this.#sound(1800, 0.012, 0.12, 4);
  }
  contact(): void {
    this.#sound(140, 0.16, 0.3, 25);
  }

  #sound(pitch_hz: number, length_s: number, loudness: number, shake_ms: number): void {
    if (!this.#on) return;
    if (navigator.userActivation?.hasBeenActive) navigator.vibrate?.(shake_ms);
    const audio = this.#audio;
    if (audio?.state !== "running") return;
    const tone = audio.createOscillator(),
      gain = audio.createGain(),
      now_s = audio.currentTime;
    tone.frequency.value = pitch_hz;
    gain.gain.setValueAtTime(loudness, now_s);
    gain.gain.exponentialRampToValueAtTime(1e-3, now_s + length_s);
    tone.connect(gain).connect(audio.destination);
    tone.start(now_s);
    tone.stop(now_s + length_s);
  }

  #show(): void {
    this.#button.setAttribute("aria-pressed", String(this.#on));
    say(this.#button, this.#on ? "Sound: on" : "Sound: off");
  }
}

function remembered(): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}
