// A connected plate: a plate on a serial line, or the plate's firmware on an emulated board.
import type { Board } from "./board";
import { PlateLink } from "./link";
import { openPort, type SerialPort } from "./serial";

export interface PlateDevice {
  readonly link: PlateLink;
  /** Orientation of the plate; NaN: unknown. */
  readonly orientation_deg: number;
  /** Advances by one frame, `elapsed_ms` after the previous one. */
  advance(elapsed_ms: number): void;
  /** State of the plate, as text for people. */
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

/** Emulated board, which runs in the page's frames. Its plate orientation is the servo's. */
export class FirmwarePlate implements PlateDevice {
  readonly link = new PlateLink((text) => this.board.receive(text));

  constructor(private readonly board: Board) {
    const byte = new Uint8Array(1);
    this.board.onByte = (value) => {
      byte[0] = value;
      this.link.receive(byte, this.board.time_ms);
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

  /** Serves the line every 5 ms of the board's time. On a slow machine the board falls behind real time. */
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
  // The page's frames stop while it is hidden or a headset is worn; the heartbeat must continue.
  readonly #timer = setInterval(() => this.advance(), 20);

  private constructor(
    readonly link: PlateLink,
    private readonly end: () => Promise<void>,
  ) {}

  /** Opens a port. Rejects if it cannot be opened. */
  static async open(port: SerialPort): Promise<SerialPlate> {
    const link: PlateLink = new PlateLink((text) => line.send(text));
    const line = await openPort(
      port,
      (bytes) => link.receive(bytes, performance.now()),
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
