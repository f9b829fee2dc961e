// Encodes and decodes lines of the plate's protocol, version 2 (plugin/src/plate/protocol.md). Received text is untrusted until
// it has been checked here.

/** Length of the longest line in bytes, including its end. */
const max_bytes = 64;

/** Computes the CRC-16 CCITT-FALSE of ASCII text. */
export function crc16(text: string): number {
  let sum = 0xffff;
  for (let i = 0; i < text.length; ++i) {
    sum ^= text.charCodeAt(i) << 8;
    for (let bit = 0; bit < 8; ++bit) sum = sum & 0x8000 ? ((sum << 1) ^ 0x1021) & 0xffff : (sum << 1) & 0xffff;
  }
  return sum;
}

export function encodeLine(body: string): string {
  return `${body}*${crc16(body).toString(16).toUpperCase().padStart(4, "0")}\n`;
}

/** Returns the body of a line without its end; null if the line is damaged or of another version. */
export function decodeLine(line: string): string | null {
  const parts = /^([\x20-\x29\x2b-\x7e]+)\*([0-9A-F]{4})$/.exec(line);
  const body = parts?.[1];
  return body !== undefined && crc16(body) === parseInt(parts?.[2] ?? "", 16) ? body : null;
}

/** Splits bytes into lines without their ends. A line that is too long is dropped. */
export class LineReader {
  #rest = "";

  take(bytes: Uint8Array): string[] {
    const lines = (this.#rest + Array.from(bytes, (byte) => String.fromCharCode(byte)).join("")).split("\n");
    this.#rest = (lines.pop() ?? "").slice(0, max_bytes);
    return lines.filter(({ length }) => length < max_bytes).map((line) => line.replace(/\r$/, ""));
  }
}

export type PlateMessage =
  | { readonly kind: "boot" }
  | {
      readonly kind: "plate";
      readonly min_deg: number;
      readonly max_deg: number;
      readonly speed_deg_s: number;
      readonly latency_ms: number;
      readonly measured: boolean;
    }
  /** A report. The orientation is NaN if the plate does not know it. */
  | { readonly kind: "at"; readonly orientation_deg: number; readonly sequence: number }
  | { readonly kind: "stopped" | "error"; readonly why: string };

const reasons = ["host", "heartbeat", "limit", "fault", "emergency", "stuck", "sensor", "unhomed", "supply"];
const refusals = ["length", "byte", "sum", "word", "number", "range", "greeting", "busy", "step", "session"];

/** Parses the body of a line from the plate. Null: the page does not use this message, or a value is out of range. */
export function parseMessage(body: string): PlateMessage | null {
  const [verb, first = "", ...rest] = body.split(" "),
    alone = rest.length === 0;
  if (body === "BOOT") return { kind: "boot" };
  if (verb === "STOPPED" && alone && reasons.includes(first)) return { kind: "stopped", why: first };
  if (verb === "ERROR" && alone && refusals.includes(first)) return { kind: "error", why: first };
  const at = /^AT ([+-]\d{3}\.\d{2}|unknown) (\d{5})$/.exec(body);
  if (at) {
    const orientation_deg = Number(at[1]),
      sequence = Number(at[2]);
    return !(Math.abs(orientation_deg) > 360) && sequence <= 65535 ? { kind: "at", orientation_deg, sequence } : null;
  }
  if (!/^PLATE 2( [+-]?\d+(\.\d+)?){4} (measured|assumed)$/.test(body) || rest.some(({ length }) => length > 12))
    return null;
  const [min_deg, max_deg, speed_deg_s, latency_ms] = rest.slice(0, 4).map(Number) as [number, number, number, number];
  const limits = -360 <= min_deg && min_deg < max_deg && max_deg <= 360;
  const valid = limits && speed_deg_s > 0 && speed_deg_s <= 1e6 && latency_ms >= 0 && latency_ms <= 1000;
  return valid ? { kind: "plate", min_deg, max_deg, speed_deg_s, latency_ms, measured: rest[4] === "measured" } : null;
}

/** Formats an angle from -360 to 360 degrees for the command SET. */
export function angleText(angle_deg: number): string {
  return (angle_deg < 0 ? "-" : "+") + Math.abs(angle_deg).toFixed(2).padStart(6, "0");
}
