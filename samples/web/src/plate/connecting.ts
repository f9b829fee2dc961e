// "A plate": connects one, says how it does, and gives it what the controller commands.
import { element, say } from "../page";
import { FirmwarePlate, type PlateDevice, SerialPlate } from "./device";
import type { PlateFacts } from "./link";
import { serial } from "./serial";

export class Connecting {
  readonly #serial = element("plate-serial", HTMLButtonElement);
  readonly #firmware = element("plate-firmware", HTMLButtonElement);
  readonly #stop = element("plate-stop", HTMLButtonElement);
  readonly #state = element("plate-state", HTMLParagraphElement);
  /** The plate has answered: the controller is to know what it can do. */
  onReady: (facts: PlateFacts) => void = () => {};
  #device: PlateDevice | null = null;
  #known = false;
  #shownAt_ms = -Infinity;

  constructor() {
    const available = serial() !== null;
    this.#serial.disabled = !available;
    element("plate-unavailable", HTMLParagraphElement).hidden = available;
    this.#serial.addEventListener(
      "click",
      () =>
        void this.#connect(this.#serial, async () => {
          const port = await serial()?.requestPort();
          return port ? SerialPlate.open(port) : null;
        }),
    );
    this.#firmware.addEventListener(
      "click",
      () =>
        void this.#connect(this.#firmware, async () => {
          const { Board } = await import("./board"); // with the emulator
          return new FirmwarePlate(new Board());
        }),
    );
    this.#stop.addEventListener("click", () => {
      void this.#end("The plate was disconnected.");
    });
    window.addEventListener("pagehide", () => {
      void this.#device?.close();
    });
  }

  /** Where the connected plate is; NaN: none is, or it is not ready. */
  get orientation_deg(): number {
    return this.#device?.link.ready ? this.#device.orientation_deg : NaN;
  }

  /** Once a frame, with what the controller commands. */
  frame(elapsed_ms: number, now_ms: number, command_deg: number): void {
    const device = this.#device;
    if (!device) return;
    device.link.turnTo(command_deg);
    device.advance(elapsed_ms);
    const { failure } = device.link;
    if (failure) return void this.#end(failure);
    if (!this.#known && device.link.facts) {
      this.#known = true;
      this.onReady(device.link.facts);
    }
    if (now_ms - this.#shownAt_ms < 250) return;
    this.#shownAt_ms = now_ms;
    say(this.#state, `${device.state}.`);
  }

  async #connect(button: HTMLButtonElement, open: () => Promise<PlateDevice | null>): Promise<void> {
    button.disabled = true;
    try {
      const device = await open();
      if (device) this.#begin(device);
    } catch (error) {
      say(this.#state, `No plate is connected: ${error instanceof Error ? error.message : String(error)}`);
    }
    if (!this.#device) button.disabled = false;
  }

  #begin(device: PlateDevice): void {
    this.#device = device;
    this.#known = false;
    this.#shownAt_ms = -Infinity;
    this.#show(true);
  }

  async #end(why: string): Promise<void> {
    const device = this.#device;
    if (!device) return;
    this.#device = null;
    this.#show(false);
    say(this.#state, why);
    await device.close();
  }

  #show(connected: boolean): void {
    this.#serial.disabled = connected || serial() === null;
    this.#firmware.disabled = connected;
    this.#stop.hidden = !connected;
  }
}
