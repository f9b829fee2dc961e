// The panel "Connect a plate": connects a plate on a serial line, shows its state, and passes commands to it.
import { element, messageOf, say } from "../page";
import { PlateLink } from "./link";

/** A port of the browser's Web Serial API, for which TypeScript has no types. */
export interface SerialPort {
  readonly readable: ReadableStream<Uint8Array> | null;
  readonly writable: WritableStream<Uint8Array> | null;
  open(options: { baudRate: number }): Promise<void>;
  close(): Promise<void>;
}

const baudRate = 115200;
/** The line is considered broken when more bytes than this wait to be sent. */
const maxUnsent = 4096;

/** An open serial port with the link to its plate. */
export class PlateDevice {
  readonly link: PlateLink = new PlateLink((text) => this.#send(text));
  // The page draws no frames while it is hidden or a headset is worn, but the plate must still receive heartbeats.
  readonly #timer = setInterval(() => this.link.service(performance.now()), 20);
  readonly #reading: Promise<void>;
  #unsent = 0;

  private constructor(
    private readonly port: SerialPort,
    private readonly reader: ReadableStreamDefaultReader<Uint8Array>,
    private readonly writer: WritableStreamDefaultWriter<Uint8Array>,
  ) {
    this.#reading = this.#read().catch((error: unknown) => this.#lose(messageOf(error)));
  }

  /** Rejects if the port cannot be opened, read and written. */
  static async open(port: SerialPort): Promise<PlateDevice> {
    await port.open({ baudRate });
    const reader = port.readable?.getReader(),
      writer = port.writable?.getWriter();
    if (!reader || !writer) throw new Error("the port cannot be read and written; close other programs that use it");
    return new PlateDevice(port, reader, writer);
  }

  get state(): string {
    const { failure, facts } = this.link;
    if (failure) return failure;
    if (!facts) return "The page waits for the plate's greeting.";
    const how = facts.measured ? "measured by its sensor" : "assumed from its commands: it has no sensor";
    return `The plate turns from ${facts.min_deg}° to ${facts.max_deg}° at ${facts.speed_deg_s}°/s; its orientation is ${how}.`;
  }

  async close(): Promise<void> {
    clearInterval(this.#timer);
    this.link.stop(performance.now());
    // Waits at most 300 ms for unsent bytes. Without heartbeats the plate stops by itself (rule 1 of the protocol).
    const patience = new Promise((done) => setTimeout(done, 300));
    for (const ending of [this.writer.close(), this.reader.cancel().then(() => this.#reading)])
      await Promise.race([ending.catch(() => undefined), patience]);
    for (const lock of [this.writer, this.reader]) lock.releaseLock();
    await this.port.close().catch(() => undefined);
  }

  #send(text: string): void {
    if (this.#unsent > maxUnsent) return this.#lose("it does not accept data");
    this.#unsent += text.length;
    this.writer.write(new TextEncoder().encode(text)).then(
      () => {
        this.#unsent -= text.length;
      },
      (error: unknown) => this.#lose(messageOf(error)),
    );
  }

  async #read(): Promise<void> {
    for (;;) {
      const { value, done } = await this.reader.read();
      if (done) throw new Error("it was closed");
      this.link.receive(value, performance.now());
    }
  }

  #lose(why: string): void {
    this.link.failure ||= `The line to the plate ended: ${why.replace(/\.$/, "")}. Check its cable, then connect it again.`;
  }
}

export class PlatePanel {
  readonly #connect = element("plate-serial", HTMLButtonElement);
  readonly #stop = element("plate-stop", HTMLButtonElement);
  readonly #state = element("plate-state", HTMLParagraphElement);
  /** Called with the plate's maximum speed when the plate has answered the greeting. */
  onReady: (speed_deg_s: number) => void = () => {};
  #device: PlateDevice | null = null;
  #known = false;

  constructor() {
    const { serial } = navigator as { serial?: { requestPort(): Promise<SerialPort> } };
    this.#connect.disabled = !serial;
    element("plate-unavailable", HTMLParagraphElement).hidden = serial !== undefined;
    this.#connect.addEventListener("click", async () => {
      this.#connect.disabled = true;
      try {
        if (serial) this.#device = await PlateDevice.open(await serial.requestPort());
        this.#known = false;
      } catch (error) {
        const why = messageOf(error).replace(/\.$/, "");
        say(this.#state, `No plate is connected: ${why}. Select "Connect a plate" and its port.`);
      }
      this.#show();
    });
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

  /** Call it in each frame. `command_deg`: orientation that the controller commands. */
  frame(now_ms: number, command_deg: number): void {
    if (!this.#device) return;
    const { link, state } = this.#device;
    link.turnTo(command_deg);
    link.service(now_ms);
    if (link.failure) return this.#end(link.failure);
    if (!this.#known && link.facts) {
      this.#known = true;
      this.onReady(link.facts.speed_deg_s);
    }
    say(this.#state, state);
  }

  #end(why: string): void {
    void this.#device?.close();
    this.#device = null;
    this.#show();
    say(this.#state, why);
  }

  #show(): void {
    this.#connect.disabled = this.connected;
    this.#stop.hidden = !this.connected;
  }
}
