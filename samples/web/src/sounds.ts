// Sounds and vibration for what a fingertip would feel: a burst of noise at each ridge, louder for a faster finger, and
// a contact at the end. For visitors who steer by keys, tones indicate where the glass lies: side and distance.
import { element, say } from "./page";

const loud_m_s = 0.2,
  minVibration_ms = 20,
  guidePeriod_s = 0.3;

export class Sounds {
  readonly #button = element("ticks", HTMLButtonElement);
  #on: boolean;
  #audio: AudioContext | null = null;
  #noise: AudioBuffer | null = null;
  #guided_s = -Infinity;

  constructor(still: boolean) {
    this.#on = !still;
    this.#show();
    this.#button.addEventListener("click", () => {
      this.#on = !this.#on;
      this.#show();
      this.#wake();
      this.ridge(loud_m_s);
    });
    // Browsers allow sound only after the visitor has pressed any key or button.
    for (const press of ["pointerdown", "keydown"])
      window.addEventListener(press, () => this.#wake(), { capture: true });
  }

  #wake(): void {
    if (!this.#on || typeof AudioContext === "undefined") return;
    this.#audio ??= new AudioContext();
    if (this.#audio.state === "suspended") void this.#audio.resume();
  }

  ridge(speed_m_s: number): void {
    this.#burst(1800, 0.015, 0.5 * Math.min(1, Math.max(0.1, speed_m_s / loud_m_s)));
  }
  contact(): void {
    this.#burst(180, 0.12, 0.8);
  }

  /** Plays a tone, at most every guidePeriod_s. `side`: where the glass lies, -1 (left) to 1. `way`: fraction of the
   *  path that remains. */
  guide(side: number, way: number): void {
    const audio = this.#ready();
    if (!audio || audio.currentTime - this.#guided_s < guidePeriod_s) return;
    this.#guided_s = audio.currentTime;
    const tone = audio.createOscillator(),
      pan = audio.createStereoPanner();
    tone.frequency.value = 880 - 440 * Math.min(1, way);
    pan.pan.value = Math.max(-1, Math.min(1, side));
    tone
      .connect(this.#fading(audio, 0.08, 0.2))
      .connect(pan)
      .connect(audio.destination);
    tone.start();
    tone.stop(audio.currentTime + 0.08);
  }

  #ready(): AudioContext | null {
    return this.#on && this.#audio?.state === "running" ? this.#audio : null;
  }

  #fading(audio: AudioContext, length_s: number, loudness: number): GainNode {
    const gain = audio.createGain();
    gain.gain.setValueAtTime(loudness, audio.currentTime);
    gain.gain.exponentialRampToValueAtTime(1e-3, audio.currentTime + length_s);
    return gain;
  }

  /** Plays a burst of noise around this pitch, and vibrates the device if it can. */
  #burst(pitch_hz: number, length_s: number, loudness: number): void {
    if (this.#on && navigator.userActivation?.hasBeenActive)
      navigator.vibrate?.(Math.max(minVibration_ms, 1000 * length_s));
    const audio = this.#ready();
    if (!audio) return;
    if (!this.#noise) {
      this.#noise = audio.createBuffer(1, Math.ceil(0.2 * audio.sampleRate), audio.sampleRate);
      this.#noise.getChannelData(0).forEach((_, i, samples) => {
        samples[i] = 2 * Math.random() - 1;
      });
    }
    const source = audio.createBufferSource(),
      filter = audio.createBiquadFilter();
    source.buffer = this.#noise;
    filter.type = "bandpass";
    filter.frequency.value = pitch_hz;
    source
      .connect(filter)
      .connect(this.#fading(audio, length_s, loudness))
      .connect(audio.destination);
    source.start(0, 0, length_s);
  }

  #show(): void {
    this.#button.setAttribute("aria-pressed", String(this.#on));
    say(this.#button, this.#on ? "Sound: on" : "Sound: off");
  }
}
