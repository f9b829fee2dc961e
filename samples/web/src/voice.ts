// Spoken cues, by the browser's own voice; off until the visitor asks for them.
import { element, say } from "./page";

export class Voice {
  readonly #written = element("spoken", HTMLParagraphElement);
  readonly #wanted = element("speak", HTMLInputElement);
  readonly #synthesis = "speechSynthesis" in window ? window.speechSynthesis : null;

  constructor() {
    if (!this.#synthesis) {
      this.#wanted.disabled = true;
      say(element("speak-help", HTMLSpanElement), " This browser has no voice.");
    }
    this.#wanted.addEventListener("change", () => {
      if (this.#wanted.checked) this.say("Spoken cues are on.");
      else this.#synthesis?.cancel();
    });
  }

  /** Writes this for screen readers, and, if asked to, speaks it instead of what is being said. */
  say(text: string): void {
    say(this.#written, text);
    if (!this.#synthesis || !this.#wanted.checked) return;
    this.#synthesis.cancel();
    const words = new SpeechSynthesisUtterance(text);
    words.lang = "en";
    this.#synthesis.speak(words);
  }
}
