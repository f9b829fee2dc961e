// Lines of the plate's protocol, version 2 (samples/plate/protocol.md): text to bytes and back. All that comes from a line
// is hostile until it has passed here.

/** With the line's end. */
const max_bytes = 64;

/** CRC-16 CCITT-FALSE of ASCII text. */
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

/** The body of a line without its end; null: damaged, or of another version. */
export function decodeLine(line: string): string | null {
  const parts = /^([\x20-\x29\x2b-\x7e]+)\*([0-9A-F]{4})$/.exec(line);
  const body = parts?.[1];
  return body !== undefined && crc16(body) === parseInt(parts?.[2] ?? "", 16) ? body : null;
}

/** Bytes to lines. A line that is too long is dropped whole. */
export class LineReader {
  #line = "";
  #tooLong = false;

  /** The line that this byte ends, without its end; null: none. */
  take(byte: number): string | null {
    if (byte !== 0x0a) {
      if (this.#line.length + 1 < max_bytes) this.#line += String.fromCharCode(byte);
      else this.#tooLong = true;
      return null;
    }
    const line = this.#tooLong ? null : this.#line.replace(/\r$/, "");
    this.#line = "";
    this.#tooLong = false;
    return line;
  }
}

export type PlateMessage =
  | { readonly kind: "boot" }
  | { readonly kind: "plate"; readonly min_deg: number; readonly max_deg: number; readonly speed_deg_s: number;
      readonly latency_ms: number; readonly measured: boolean }
  /** NaN: the plate does not know. */
  | { readonly kind: "at"; readonly orientation_deg: number; readonly sequence: number }
  | { readonly kind: "stopped" | "error"; readonly why: string };

const reasons = ["host", "heartbeat", "limit", "fault", "emergency", "stuck", "sensor", "unhomed"];
const refusals = ["length", "byte", "sum", "word", "number", "range", "greeting", "busy"];

/** What a body of the plate says; null: nothing that this page needs, or out of range. */
export function parseMessage(body: string): PlateMessage | null {
  const words = body.split(" "), [verb, ...rest] = words, first = rest[0] ?? "";
  if (verb === "BOOT" && rest.length === 0) return { kind: "boot" };
  if (verb === "STOPPED" && rest.length === 1 && reasons.includes(first)) return { kind: "stopped", why: first };
  if (verb === "ERROR" && rest.length === 1 && refusals.includes(first)) return { kind: "error", why: first };
  if (verb === "AT" && rest.length === 2) {
    const orientation_deg = /^[+-]\d{3}\.\d{2}$/.test(first) ? Number(first) : NaN;
    const sequence = /^\d{5}$/.test(rest[1] ?? "") ? Number(rest[1]) : NaN;
    const known = Math.abs(orientation_deg) <= 360 || first === "unknown";
    return known && sequence <= 65535 ? { kind: "at", orientation_deg, sequence } : null;
  }
  if (verb === "PLATE" && rest.length === 6 && first === "2") {
    const [min_deg, max_deg, speed_deg_s, latency_ms] = rest.slice(1, 5).map(number) as [number, number, number, number];
    const source = rest[5];
    const valid = Math.abs(min_deg) <= 360 && Math.abs(max_deg) <= 360 && min_deg < max_deg && speed_deg_s > 0 &&
      speed_deg_s <= 1e6 && latency_ms >= 0 && latency_ms <= 1000 && (source === "measured" || source === "assumed");
    return valid ? { kind: "plate", min_deg, max_deg, speed_deg_s, latency_ms, measured: source === "measured" } : null;
  }
  return null;
}

function number(text: string): number {
  return text.length <= 12 && /^[+-]?\d+(\.\d+)?$/.test(text) ? Number(text) : NaN;
}

/** An angle as SET has it; within 360. */
export function angleText(angle_deg: number): string {
  return (angle_deg < 0 ? "-" : "+") + Math.abs(angle_deg).toFixed(2).padStart(6, "0");
}
