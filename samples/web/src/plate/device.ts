// A connected plate: its link, and the serial line on which it is.
import { PlateLink } from "./link";
import { openPort, type SerialPort } from "./serial";

export class PlateDevice {
  // The page draws no frames while it is hidden or a headset is worn, but the plate must still receive heartbeats.
  readonly #timer = setInterval(() => this.advance(), 20);

  private constructor(
    readonly link: PlateLink,
    private readonly end: () => Promise<void>,
  ) {}

  /** Opens a port. Rejects if it cannot be opened. */
  static async open(port: SerialPort): Promise<PlateDevice> {
    const link: PlateLink = new PlateLink((text) => line.send(text));
    const line = await openPort(
      port,
      (bytes) => link.receive(bytes, performance.now()),
      (why) => {
        link.failure ||= `The line to the plate ended: ${why}. Check its cable, then connect it again.`;
      },
    );
    return new PlateDevice(link, () => line.close());
  }

  /** State of the plate, as text for people. */
  get state(): string {
    const { failure, facts } = this.link;
    if (failure) return failure;
    if (!facts) return "The page waits for the plate's greeting.";
    const how = facts.measured ? "measured by its sensor" : "assumed from its commands: it has no sensor";
    return `The plate turns from ${facts.min_deg}° to ${facts.max_deg}° at ${facts.speed_deg_s}°/s; its orientation is ${how}.`;
  }

  advance(): void {
    this.link.service(performance.now());
  }

  async close(): Promise<void> {
    clearInterval(this.#timer);
    this.link.stop(performance.now());
    await this.end();
  }
}
