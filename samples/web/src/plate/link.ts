// The host's side of the plate's line protocol, version 2 (plugin/src/plate/protocol.md): greeting, commands,
// heartbeats, and checks of the plate's reports. The caller passes the time and sends the lines.

/** Length of the longest line in bytes, including its end. */
const max_bytes = 64;
const greetingLimit_ms = 5000; // boards reset when their line is opened, and need 2 s to start
const greetingPeriod_ms = 200;
const beatPeriod_ms = 50;
const minPeriod_ms = 8; // between a line and the next SET
const silenceLimit_ms = 500;
const limitSlack_deg = 3;
const far_deg = 10;
const stuckLimit_ms = 1000;
const moved_deg = 1;

const restarted = "has restarted: its supply or its line failed; check both";
/** Lines from the plate that end the session, and the rest of the sentence "The plate ..." that the page then shows. */
const failures = new Map([
  ["BOOT", restarted],
  ["ERROR greeting", restarted],
  ["ERROR session", "receives commands from another program. End that program"],
  ["STOPPED limit", "refused an angle beyond its limits. Connect it again, so that the page reads its limits"],
  [
    "STOPPED fault",
    "is defective or could not store its settings. Save them again (hrt-plate set); if it fails, exchange the board",
  ],
  ["STOPPED emergency", "was stopped by its emergency stop. Release it, then connect the plate again"],
  ["STOPPED stuck", "reports that its servo is stuck. Switch it off, and remove the obstacle"],
  ["STOPPED sensor", "reports that its sensor and its servo count in opposite directions. Run hrt-plate commission"],
  ["STOPPED unhomed", "no longer knows its orientation. This page needs a plate that measures it with a sensor"],
  ["STOPPED supply", "has less than 4 V at its servo's supply. Check its adapter and its fuse"],
]);

/** Computes the CRC-16 CCITT-FALSE of ASCII text. */
function crc16(text: string): string {
  let sum = 0xffff;
  for (const character of text) {
    sum ^= character.charCodeAt(0) << 8;
    for (let bit = 0; bit < 8; ++bit) sum = sum & 0x8000 ? ((sum << 1) ^ 0x1021) & 0xffff : (sum << 1) & 0xffff;
  }
  return sum.toString(16).toUpperCase().padStart(4, "0");
}

export function encodeLine(body: string): string {
  return `${body}*${crc16(body)}\n`;
}

/** Returns the body of a line without its end; null if a byte is not allowed or the CRC is missing or wrong. */
export function decodeLine(line: string): string | null {
  const [, body = "", sum] = /^([\x20-\x29\x2b-\x7e]+)\*([0-9A-F]{4})$/.exec(line) ?? [];
  return sum === crc16(body) ? body : null;
}

/** The plate's answer to the greeting: its limits, its speed, and whether it has a sensor. */
interface PlateFacts {
  readonly min_deg: number;
  readonly max_deg: number;
  readonly speed_deg_s: number;
  readonly measured: boolean;
}

/** Parses an answer to the greeting. Null: the body is not one, or a value is out of range. */
function parseFacts(body: string): PlateFacts | null {
  if (!/^PLATE 2( [+-]?\d+(\.\d+)?){4} (measured|assumed)$/.test(body)) return null;
  const words = body.split(" ").slice(2),
    [min_deg = NaN, max_deg = NaN, speed_deg_s = NaN, latency_ms = NaN] = words.map(Number);
  if (words.some(({ length }) => length > 12) || !(-360 <= min_deg && min_deg < max_deg && max_deg <= 360)) return null;
  if (!(speed_deg_s > 0 && speed_deg_s <= 1e6 && latency_ms >= 0 && latency_ms <= 1000)) return null;
  return { min_deg, max_deg, speed_deg_s, measured: words[4] === "measured" };
}

export class PlateLink {
  facts: PlateFacts | null = null;
  /** Last reported orientation; NaN before the first report. */
  orientation_deg = NaN;
  /** Sentence that says why the link was closed; empty while it is open. */
  failure = "";

  /** Token that identifies the lines of this page. */
  readonly #token = fiveDigits(1 + Math.floor(65535 * Math.random()));
  #partialLine = "";
  #began_ms = NaN;
  #received_ms = NaN;
  #reported_ms = NaN;
  #sent_ms = -Infinity;
  #unanswered = 0;
  #sequence = 0;
  #wanted_deg = NaN;
  #sent_deg = NaN;
  #movedAt_ms = NaN;
  #movedFrom_deg = NaN;

  /** `send` is called with whole lines. */
  constructor(private readonly send: (text: string) => void) {}

  /** True from the first report of the orientation until a failure. */
  get ready(): boolean {
    return !Number.isNaN(this.orientation_deg) && this.failure === "";
  }

  /** Sets the wanted orientation; NaN is ignored. service() sends the equivalent angle that nearest() returns. */
  turnTo(orientation_deg: number): void {
    if (Number.isFinite(orientation_deg)) this.#wanted_deg = orientation_deg;
  }

  receive(bytes: Uint8Array, now_ms: number): void {
    const lines = (this.#partialLine + Array.from(bytes, (byte) => String.fromCharCode(byte)).join("")).split("\n");
    this.#partialLine = (lines.pop() ?? "").slice(0, max_bytes);
    for (const line of lines) {
      const body = line.length < max_bytes ? decodeLine(line.replace(/\r$/, "")) : null;
      if (body !== null && !this.failure) this.#process(body, now_ms);
    }
  }

  /** Sends due commands and heartbeats, and checks that the plate reports in time. Call it at least every 50 ms. */
  service(now_ms: number): void {
    if (this.failure) return;
    if (Number.isNaN(this.#began_ms)) this.#began_ms = now_ms;
    if (!this.facts) return this.#greet(now_ms);
    if (now_ms - this.#received_ms > silenceLimit_ms)
      return this.#fail("has sent nothing for half a second; check its cable and supply");
    if (now_ms - this.#reported_ms > silenceLimit_ms) {
      const since = this.ready ? "for half a second" : "since its greeting";
      return this.#fail(`has not reported its orientation ${since}; connect it again`);
    }
    if (this.ready) this.#sendOrientation(this.facts, now_ms);
    if (now_ms - this.#sent_ms >= beatPeriod_ms) this.#sendCommand("BEAT", now_ms);
  }

  stop(now_ms: number): void {
    const connected = this.facts && !this.failure;
    this.failure ||= "The plate was disconnected.";
    if (connected) this.#sendCommand("STOP", now_ms);
  }

  #greet(now_ms: number): void {
    if (now_ms - this.#began_ms > greetingLimit_ms)
      return this.#fail("does not answer as a plate of protocol version 2 within 5 s; check port, cable and supply");
    if (now_ms - this.#sent_ms < greetingPeriod_ms) return;
    ++this.#unanswered;
    this.#sendLine("HELLO 2", now_ms);
  }

  #sendOrientation(facts: PlateFacts, now_ms: number): void {
    if (Number.isNaN(this.#wanted_deg) || now_ms - this.#sent_ms < minPeriod_ms) return;
    const text = nearest(this.#wanted_deg, this.orientation_deg, facts).toFixed(2);
    if (Number(text) === this.#sent_deg) return;
    this.#sent_deg = Number(text);
    this.#sendCommand(`SET ${this.#sent_deg < 0 ? "-" : "+"}${text.replace("-", "").padStart(6, "0")}`, now_ms);
  }

  #process(body: string, now_ms: number): void {
    const facts = parseFacts(body),
      [, angle, sequence] = /^AT ([+-]\d{3}\.\d{2}|unknown) (\d{5})$/.exec(body) ?? [],
      failure = failures.get(body);
    this.#received_ms = now_ms;
    if (facts) this.#processGreeting(facts, now_ms);
    if (!this.facts) return;
    if (angle === "unknown")
      this.#fail("does not know its orientation. This page needs a plate that measures it with a sensor");
    else if (angle && Math.abs(Number(angle)) <= 360 && Number(sequence) <= 65535)
      this.#processReport(Number(angle), this.facts, now_ms);
    if (failure) this.#fail(failure);
    if (body === "STOPPED heartbeat") this.#sent_deg = NaN; // so that the same command is sent again
  }

  #processGreeting(facts: PlateFacts, now_ms: number): void {
    if (!this.facts) {
      this.facts = facts;
      this.#reported_ms = now_ms;
    } else if (this.#unanswered <= 0) {
      this.#fail("has announced itself again: it was reset, or another plate answers. Connect it again");
    }
    --this.#unanswered;
  }

  #processReport(orientation_deg: number, { min_deg, max_deg }: PlateFacts, now_ms: number): void {
    const text = `${orientation_deg.toFixed(1)}°`;
    if (orientation_deg < min_deg - limitSlack_deg || orientation_deg > max_deg + limitSlack_deg)
      return this.#fail(
        `reports ${text}, outside its limits of ${min_deg}° to ${max_deg}°. Check its sensor and its settings`,
      );
    this.orientation_deg = orientation_deg;
    this.#reported_ms = now_ms;
    const far = Math.abs(this.#sent_deg - orientation_deg) > far_deg;
    if (!far || !(Math.abs(orientation_deg - this.#movedFrom_deg) < moved_deg)) {
      this.#movedFrom_deg = orientation_deg;
      this.#movedAt_ms = now_ms;
    } else if (now_ms - this.#movedAt_ms > stuckLimit_ms) {
      this.#fail(`is stuck at ${text}; it was commanded to ${this.#sent_deg.toFixed(1)}°. Remove the obstacle`);
    }
  }

  #sendCommand(words: string, now_ms: number): void {
    this.#sequence = (this.#sequence + 1) & 0xffff;
    this.#sendLine(`${words} ${fiveDigits(this.#sequence)}`, now_ms);
  }

  #sendLine(body: string, now_ms: number): void {
    this.#sent_ms = now_ms;
    this.send(encodeLine(`${body} ${this.#token}`));
  }

  #fail(why: string): void {
    if (this.failure) return;
    this.failure = `The plate ${why}.`;
    if (this.facts) this.#sendCommand("STOP", this.#sent_ms);
  }
}

function fiveDigits(number: number): string {
  return String(number).padStart(5, "0");
}

/** Returns the angle nearest to `plate_deg` among those within the limits that are equivalent to `wanted_deg` (ridges
 *  are the same after 180°); if there is none, the limit nearest to an equivalent angle. */
function nearest(wanted_deg: number, plate_deg: number, { min_deg, max_deg }: PlateFacts): number {
  const turns = [-4, -3, -2, -1, 0, 1, 2, 3, 4].map((halfTurns) => (wanted_deg % 180) + 180 * halfTurns),
    allowed = turns.filter((angle_deg) => angle_deg >= min_deg && angle_deg <= max_deg),
    off = (angle_deg: number) => Math.abs(angle_deg - plate_deg),
    beyond = (angle_deg: number) => Math.max(min_deg - angle_deg, angle_deg - max_deg);
  if (allowed.length > 0) return allowed.reduce((best, angle_deg) => (off(angle_deg) < off(best) ? angle_deg : best));
  const closest_deg = turns.reduce((best, angle_deg) => (beyond(angle_deg) < beyond(best) ? angle_deg : best));
  return Math.min(max_deg, Math.max(min_deg, closest_deg));
}
