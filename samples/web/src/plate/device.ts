// A plate that is connected: one on a serial line, or the plate's firmware on an emulated board.
import type { Board } from "./board";
import { PlateLink } from "./link";
import { openPort, type SerialPort } from "./serial";

export interface PlateDevice {
  readonly link: PlateLink;
  /** Where the plate is; NaN: not known yet. */
  readonly orientation_deg: number;
  /** Once a frame, with the time since the last one. */
  advance(elapsed_ms: number): void;
  /** What there is to say of it, for people. */
  readonly state: string;
  close(): Promise<void> | void;
}

function stateOf(link: PlateLink): string {
  const { facts } = link;
  if (link.failure) return link.failure;
  if (!facts) return "Waiting for the plate's greeting.";
  return (
    `${facts.min_deg}° to ${facts.max_deg}° at ${facts.speed_deg_s}°/s; ` +
    `${facts.measured ? "measured by its sensor" : "assumed from its commands: it has no sensor"}`
  );
}

/** The emulated board runs in the page's frames. Its plate is the servo's. */
export class FirmwarePlate implements PlateDevice {
  readonly link = new PlateLink((text) => this.board.hear(text));

  constructor(private readonly board: Board) {
    const byte = new Uint8Array(1);
    this.board.onByte = (value) => {
      byte[0] = value;
      this.link.hear(byte, this.board.time_ms);
    };
  }

  get orientation_deg(): number {
    return this.board.servo_deg;
  }
  get state(): string {
    const { pulse_us, servo_deg } = this.board;
    const pulse =
      pulse_us === 0 ? "No pulse yet" : `Pulse ${pulse_us.toFixed(1)} µs, servo at ${servo_deg.toFixed(1)}°`;
    return `Emulated board: ${stateOf(this.link)}. ${pulse}`;
  }

  /** The line is looked at every 5 ms of the board's time. A slow machine's board runs late. */
  advance(elapsed_ms: number): void {
    for (let left_ms = Math.min(elapsed_ms, 100); left_ms > 0; left_ms -= 5) {
      this.link.service(this.board.time_ms);
      this.board.run(Math.min(5, left_ms));
    }
  }

  close(): void {
    this.link.stop(this.board.time_ms);
  }
}

/** A plate on a serial line. */
export class SerialPlate implements PlateDevice {
  // Frames stop while the page is hidden, or worn; the heartbeat must not.
  readonly #timer = setInterval(() => this.advance(), 20);

  private constructor(
    readonly link: PlateLink,
    private readonly end: () => Promise<void>,
  ) {}

  /** Rejects if the port cannot be opened. */
  static async open(port: SerialPort): Promise<SerialPlate> {
    const link: PlateLink = new PlateLink((text) => line.send(text));
    const line = await openPort(
      port,
      (bytes) => link.hear(bytes, performance.now()),
      (why) => {
        link.failure ||= `The line to the plate ended: ${why}.`;
      },
    );
    return new SerialPlate(link, () => line.close());
  }

  get orientation_deg(): number {
    return this.link.orientation_deg;
  }
  get state(): string {
    return `Plate: ${stateOf(this.link)}`;
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
