// Instructions, spoken by the browser's speech synthesis; off until the visitor turns them on.
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
      if (this.#wanted.checked) this.say("Spoken instructions are on.");
      else this.#synthesis?.cancel();
    });
  }

  /** Writes a text for screen readers. If the visitor has turned the voice on, it speaks the text, and interrupts the previous one. */
  say(text: string): void {
    say(this.#written, text);
    if (!this.#synthesis || !this.#wanted.checked) return;
    this.#synthesis.cancel();
    const words = new SpeechSynthesisUtterance(text);
    words.lang = "en";
    this.#synthesis.speak(words);
  }
}
