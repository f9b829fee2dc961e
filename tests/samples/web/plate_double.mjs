// A test double of Web Serial, with a plate that turns to each command immediately.
import { frames } from "./browser.mjs";

/** Runs in the page: gives the page a serial port, whose plate also sends damaged lines. */
export function plateDouble() {
  const crc = (text) => [...text].reduce((sum, c) => {
    sum ^= c.charCodeAt(0) << 8;
    for (let bit = 0; bit < 8; ++bit) sum = sum & 0x8000 ? ((sum << 1) ^ 0x1021) & 0xffff : (sum << 1) & 0xffff;
    return sum;
  }, 0xffff).toString(16).toUpperCase().padStart(4, "0");
  const double = globalThis.plateDouble = { at: "+000.00", lines: [], closed: false };
  let toPage, rest = "";
  double.say = (body) => toPage.enqueue(new TextEncoder().encode(`\u0000x*\nAT +089.00 00001*0000\n${body}*${crc(body)}\n`));
  const port = {
    open: async () => {}, close: async () => { double.closed = true; },
    readable: new ReadableStream({ start(controller) { toPage = controller; } }),
    writable: new WritableStream({ write(chunk) {
      rest += new TextDecoder().decode(chunk);
      for (let end = rest.indexOf("\n"); end >= 0; end = rest.indexOf("\n")) {
        const [body, sum] = rest.slice(0, end).split("*");
        rest = rest.slice(end + 1);
        if (sum !== crc(body)) throw new Error(`a damaged line: ${body}`);
        const words = body.split(" ");
        double.lines.push(body);
        if (words[0] === "HELLO") double.say("PLATE 2 -90.00 90.00 300.00 20.00 measured");
        if (words[0] === "SET") double.at = words[1];
        double.say(`AT ${double.at} ${words[0] === "HELLO" ? "00000" : words.at(-2)}`);
      }
    } }),
  };
  Object.defineProperty(navigator, "serial", { configurable: true, value: { requestPort: async () => port } });
}

/** Draws frames with enough time between them for the port to answer. */
export async function served(page, count) {
  for (let i = 0; i < count; ++i) {
    await frames(page, 40);
    await page.waitForTimeout(10);
  }
}
