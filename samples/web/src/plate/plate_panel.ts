// The panel "Connect a plate": connects a plate, shows its state, and passes the controller's commands to it.
import { element, messageOf, say } from "../page";
import { PlateDevice } from "./device";
import type { PlateFacts } from "./link";
import { serial } from "./serial";

export class PlatePanel {
  readonly #connect = element("plate-serial", HTMLButtonElement);
  readonly #stop = element("plate-stop", HTMLButtonElement);
  readonly #state = element("plate-state", HTMLParagraphElement);
  /** Called when the plate has answered, with its limits for the controller. */
  onReady: (facts: PlateFacts) => void = () => {};
  #device: PlateDevice | null = null;
  #known = false;
  #shownAt_ms = -Infinity;

  constructor() {
    const available = serial() !== null;
    this.#connect.disabled = !available;
    element("plate-unavailable", HTMLParagraphElement).hidden = available;
    this.#connect.addEventListener("click", () => this.#open());
    this.#stop.addEventListener("click", () => this.#end("The plate was disconnected."));
    window.addEventListener("pagehide", () => this.#device?.close());
  }

  get connected(): boolean {
    return this.#device !== null;
  }
  /** Orientation of the connected plate; NaN: no plate is connected, or it is not ready. */
  get orientation_deg(): number {
    return this.#device?.link.ready ? this.#device.link.orientation_deg : NaN;
  }

  /** Updates the plate once a frame, with the orientation that the controller commands. */
  frame(now_ms: number, command_deg: number): void {
    const device = this.#device;
    if (!device) return;
    const { link } = device;
    link.turnTo(command_deg);
    device.advance();
    if (link.failure) return void this.#end(link.failure);
    if (!this.#known && link.facts) {
      this.#known = true;
      this.onReady(link.facts);
    }
    if (now_ms - this.#shownAt_ms < 250) return;
    this.#shownAt_ms = now_ms;
    say(this.#state, device.state);
  }

  async #open(): Promise<void> {
    this.#connect.disabled = true;
    try {
      const port = await serial()?.requestPort();
      if (port) this.#device = await PlateDevice.open(port);
      this.#known = false;
      this.#shownAt_ms = -Infinity;
    } catch (error) {
      say(this.#state, `No plate is connected: ${messageOf(error)}`);
    }
    this.#show();
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
    this.#connect.disabled = this.connected || serial() === null;
    this.#stop.hidden = !this.connected;
  }
}
