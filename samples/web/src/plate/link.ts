// The host's side of the plate's line protocol: greeting, commands, heartbeats, and checks of the plate's reports
// (plugin/src/plate/protocol.md, rules 1 to 6). The caller passes the time and sends the lines.
import { angleText, decodeLine, encodeLine, LineReader, type PlateMessage, parseMessage } from "./line";

const greetingLimit_ms = 5000; // boards reset when their line is opened, and need 2 s to start
const greetingPeriod_ms = 200;
const beatPeriod_ms = 50;
const minPeriod_ms = 8; // between two commands
const silenceLimit_ms = 500;
const limitSlack_deg = 3;
const far_deg = 10;
const stuckLimit_ms = 1000;
const moved_deg = 1;

const stops: Readonly<Record<string, string>> = {
  limit: "refused an angle beyond its limits. Connect it again, so that the page reads its limits",
  fault: "reports that it is defective. Test it with hrt-plate show",
  emergency: "was stopped by its emergency stop. Release it, then connect the plate again",
  stuck: "reports that its servo is stuck. Switch it off, and remove the obstacle",
  sensor: "reports that its sensor and its servo count in opposite directions. Run hrt-plate commission",
  unhomed: "no longer knows its orientation. This page needs a plate that measures it with a sensor",
  supply: "has less than 4 V at its servo's supply. Check its adapter and its fuse",
};

/** The plate's answer to the greeting: its limits, its speed, and whether it has a sensor. */
export type PlateFacts = Extract<PlateMessage, { kind: "plate" }>;

export class PlateLink {
  facts: PlateFacts | null = null;
  /** Last reported orientation; NaN before the first report. */
  orientation_deg = NaN;
  /** Reason for which the link was closed; empty while it is open. Nothing is sent after a failure. */
  failure = "";

  /** Token that identifies the lines of this page. */
  readonly #token = String(1 + Math.floor(65535 * Math.random())).padStart(5, "0");
  readonly #reader = new LineReader();
  #began_ms = NaN;
  #received_ms = NaN;
  #reported_ms = NaN;
  #sent_ms = -Infinity;
  #unanswered = 0;
  #sequence = 0;
  #wanted_deg = NaN;
  #sent_deg = NaN;
  #hasReported = false;
  #movedAt_ms = NaN;
  #movedFrom_deg = NaN;

  /** `send` is called with whole lines. */
  constructor(private readonly send: (text: string) => void) {}

  /** True once the plate has greeted and reported. */
  get ready(): boolean {
    return this.#hasReported && this.failure === "";
  }

  /** Sets the wanted orientation. The plate receives the nearest equivalent angle (a multiple of 180° away) within its limits, or
   *  else the nearest limit. */
  turnTo(orientation_deg: number): void {
    if (Number.isFinite(orientation_deg)) this.#wanted_deg = orientation_deg;
  }

  receive(bytes: Uint8Array, now_ms: number): void {
    for (const line of this.#reader.take(bytes)) {
      const body = decodeLine(line),
        message = body === null ? null : parseMessage(body);
      if (message && !this.failure) this.#process(message, now_ms);
    }
  }

  /** Sends due commands and heartbeats, and checks that the plate has reported in time. Call it at least every 50 ms. */
  service(now_ms: number): void {
    if (this.failure) return;
    if (Number.isNaN(this.#began_ms)) this.#began_ms = now_ms;
    if (!this.facts) return this.#greet(now_ms);
    if (now_ms - this.#received_ms > silenceLimit_ms)
      return this.#fail("has sent nothing for half a second; check its cable and supply");
    if (now_ms - this.#reported_ms > silenceLimit_ms) {
      const since = Number.isNaN(this.orientation_deg) ? "since its greeting" : "for half a second";
      return this.#fail(`has not reported its orientation ${since}; connect it again`);
    }
    if (this.#hasReported) this.#sendOrientation(now_ms);
    if (now_ms - this.#sent_ms >= beatPeriod_ms) this.#sendCommand("BEAT", now_ms);
  }

  /** Stops the plate and closes this link. */
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

  #sendOrientation(now_ms: number): void {
    if (!this.facts || Number.isNaN(this.#wanted_deg) || now_ms - this.#sent_ms < minPeriod_ms) return;
    const angle_deg = Number(nearest(this.#wanted_deg, this.orientation_deg, this.facts).toFixed(2));
    if (angle_deg === this.#sent_deg) return;
    this.#sent_deg = angle_deg;
    this.#sendCommand(`SET ${angleText(angle_deg)}`, now_ms);
  }

  #process(message: PlateMessage, now_ms: number): void {
    this.#received_ms = now_ms;
    if (message.kind === "plate") return this.#processGreeting(message, now_ms);
    if (!this.facts) return;
    if (message.kind === "at") return this.#processReport(message.orientation_deg, now_ms);
    const restarted = message.kind === "boot" || (message.kind === "error" && message.why === "greeting");
    if (restarted) this.#fail("has restarted: its supply or its line failed; check both");
    if (message.kind === "error" && message.why === "session")
      this.#fail("receives commands from another program. Close that program");
    if (message.kind !== "stopped") return;
    const why = stops[message.why];
    if (why) this.#fail(why);
    else if (message.why === "heartbeat") this.#sent_deg = NaN; // so that the same command is sent again
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

  #processReport(orientation_deg: number, now_ms: number): void {
    const facts = this.facts;
    if (!facts) return;
    if (orientation_deg < facts.min_deg - limitSlack_deg || orientation_deg > facts.max_deg + limitSlack_deg) {
      return this.#fail(
        `reports ${orientation_deg.toFixed(1)}°, outside its limits of ${facts.min_deg}° to ${facts.max_deg}°. Check its sensor and its settings`,
      );
    }
    if (Number.isNaN(orientation_deg))
      return this.#fail("does not know its orientation. This page needs a plate that measures it with a sensor");
    this.orientation_deg = orientation_deg;
    this.#reported_ms = now_ms;
    this.#hasReported = true;
    this.#expectMotion(orientation_deg, now_ms);
  }

  #expectMotion(orientation_deg: number, now_ms: number): void {
    const far = Math.abs(this.#sent_deg - orientation_deg) > far_deg;
    if (!far || !(Math.abs(orientation_deg - this.#movedFrom_deg) < moved_deg)) {
      this.#movedFrom_deg = orientation_deg;
      this.#movedAt_ms = now_ms;
    } else if (now_ms - this.#movedAt_ms > stuckLimit_ms) {
      this.#fail(
        `is stuck at ${orientation_deg.toFixed(1)}°; it was commanded to ${this.#sent_deg.toFixed(1)}°. Remove the obstacle`,
      );
    }
  }

  #sendCommand(words: string, now_ms: number): void {
    this.#sequence = (this.#sequence + 1) & 0xffff;
    this.#sendLine(`${words} ${String(this.#sequence).padStart(5, "0")}`, now_ms);
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

function nearest(wanted_deg: number, plate_deg: number, { min_deg, max_deg }: PlateFacts): number {
  const first_deg = wanted_deg - 180 * Math.floor((wanted_deg - min_deg) / 180);
  if (first_deg > max_deg)
    return Math.abs(first_deg - max_deg) < Math.abs(first_deg - 180 - min_deg) ? max_deg : min_deg;
  let best_deg = first_deg;
  for (let angle_deg = first_deg; angle_deg <= max_deg; angle_deg += 180) {
    if (Math.abs(angle_deg - plate_deg) < Math.abs(best_deg - plate_deg)) best_deg = angle_deg;
  }
  return best_deg;
}
