// The panel "A plate": connects a plate, shows its state, and passes the controller's commands to it.
import { element, messageOf, say } from "../page";
import { FirmwarePlate, type PlateDevice, SerialPlate } from "./device";
import type { PlateFacts } from "./link";
import { serial } from "./serial";

export class PlatePanel {
  readonly #serial = element("plate-serial", HTMLButtonElement);
  readonly #firmware = element("plate-firmware", HTMLButtonElement);
  readonly #stop = element("plate-stop", HTMLButtonElement);
  readonly #state = element("plate-state", HTMLParagraphElement);
  /** Called when the plate has answered, with its limits for the controller. */
  onReady: (facts: PlateFacts) => void = () => {};
  #device: PlateDevice | null = null;
  #known = false;
  #shownAt_ms = -Infinity;

  constructor() {
    const available = serial() !== null;
    this.#serial.disabled = !available;
    element("plate-unavailable", HTMLParagraphElement).hidden = available;
    this.#connects(this.#serial, async () => {
      const port = await serial()?.requestPort();
      return port ? SerialPlate.open(port) : null;
    });
    this.#connects(this.#firmware, async () => {
      const { Board } = await import("./board"); // contains the emulator
      return new FirmwarePlate(new Board());
    });
    this.#stop.addEventListener("click", () => this.#end("The plate was disconnected."));
    window.addEventListener("pagehide", () => this.#device?.close());
  }

  get connected(): boolean {
    return this.#device !== null;
  }
  /** Orientation of the connected plate; NaN: no plate is connected, or it is not ready. */
  get orientation_deg(): number {
    return this.#device?.link.ready ? this.#device.orientation_deg : NaN;
  }

  /** Updates the plate once a frame, with the orientation that the controller commands. */
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

  #connects(button: HTMLButtonElement, open: () => Promise<PlateDevice | null>): void {
    button.addEventListener("click", async () => {
      button.disabled = true;
      try {
        this.#device = (await open()) ?? this.#device;
        this.#known = false;
        this.#shownAt_ms = -Infinity;
      } catch (error) {
        say(this.#state, `No plate is connected: ${messageOf(error)}`);
      }
      this.#show();
    });
  }

  async #end(why: string): Promise<void> {
    const device = this.#device;
    if (!device) return;
    this.#device = null;
    this.#show();
    say(this.#state, why);
    await device.close();
  }

  #show(): void {
    const connected = this.#device !== null;
    this.#serial.disabled = connected || serial() === null;
    this.#firmware.disabled = connected;
    this.#stop.hidden = !connected;
  }
}
