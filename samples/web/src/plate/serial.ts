// A serial line by the browser's Web Serial API, whose types TypeScript does not include.
import { messageOf } from "../page";

export interface SerialPort {
  readonly readable: ReadableStream<Uint8Array> | null;
  readonly writable: WritableStream<Uint8Array> | null;
  open(options: { baudRate: number }): Promise<void>;
  close(): Promise<void>;
}
interface Serial {
  requestPort(): Promise<SerialPort>;
}

const baudRate = 115200;
/** Largest number of unsent bytes, above which the line is considered broken. */
const maxUnsent = 4096;

/** Returns the browser's serial API; null if it has none, or not for this address. */
export function serial(): Serial | null {
  return (navigator as { serial?: Serial }).serial ?? null;
}

/** Opens a port. `heard` receives bytes as they arrive; `ended` is called once if the line fails. */
export async function openPort(port: SerialPort, heard: (bytes: Uint8Array) => void, ended: (why: string) => void) {
  await port.open({ baudRate });
  const reader = port.readable?.getReader(),
    writer = port.writable?.getWriter();
  if (!reader || !writer) throw new Error("the port cannot be read and written");
  const encoder = new TextEncoder();
  let open = true,
    unsent = 0;
  const fail = (error: unknown): void => {
    if (open) ended(messageOf(error));
    open = false;
  };
  const read = async (): Promise<void> => {
    for (;;) {
      const { value, done } = await reader.read();
      if (done) throw new Error("it was closed");
      heard(value);
    }
  };
  const reading = read().catch(fail);
  return {
    send(text: string): void {
      if (!open) return;
      if (unsent > maxUnsent) return fail("it takes no bytes");
      unsent += text.length;
      writer.write(encoder.encode(text)).then(() => {
        unsent -= text.length;
      }, fail);
    },
    async close(): Promise<void> {
      open = false;
      // Does not wait for a blocked line: unsent bytes are dropped, and rule 1 of the protocol stops the plate.
      const patience = new Promise((done) => setTimeout(done, 300));
      const patiently = (what: Promise<void>) => Promise.race([what.catch(() => undefined), patience]);
      await patiently(writer.close());
      await patiently(reader.cancel().then(() => reading));
      for (const lock of [writer, reader]) lock.releaseLock();
      await port.close().catch(() => undefined);
    },
  };
}
