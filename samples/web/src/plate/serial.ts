// A serial line, by the browser's Web Serial API. TypeScript has no types for it.
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
/** The line is considered broken when more bytes than this wait to be sent. */
const maxUnsent = 4096;

/** Returns the browser's Web Serial API; null if the browser has none, or does not offer it to this page. */
export function serial(): Serial | null {
  return (navigator as { serial?: Serial }).serial ?? null;
}

/** Opens a port. `heard` is called with the bytes that arrive, `ended` once if the line fails, with the reason. */
export async function openPort(port: SerialPort, heard: (bytes: Uint8Array) => void, ended: (why: string) => void) {
  await port.open({ baudRate });
  const reader = port.readable?.getReader(),
    writer = port.writable?.getWriter();
  if (!reader || !writer) throw new Error("the port cannot be read and written; close other programs that use it");
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
      if (unsent > maxUnsent) return fail("it does not accept data");
      unsent += text.length;
      writer.write(encoder.encode(text)).then(() => {
        unsent -= text.length;
      }, fail);
    },
    async close(): Promise<void> {
      open = false;
      // A blocked line is not waited for: unsent bytes are dropped, and the plate stops without heartbeats (rule 1 of the protocol).
      const patience = new Promise((done) => setTimeout(done, 300));
      const patiently = (what: Promise<void>) => Promise.race([what.catch(() => undefined), patience]);
      await patiently(writer.close());
      await patiently(reader.cancel().then(() => reading));
      for (const lock of [writer, reader]) lock.releaseLock();
      await port.close().catch(() => undefined);
    },
  };
}
