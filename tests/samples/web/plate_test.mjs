// The page's link to a plate, under node, with test doubles of a plate and a port. No real plate is used.
import assert from "node:assert/strict";
import { test } from "node:test";
import { models } from "./models.mjs";

const { decodeLine, encodeLine, PlateDevice, PlateLink } = models;
const bytes = (text) => new TextEncoder().encode(text);

// plugin/src/plate/protocol.md gives the CRC of 123456789.
test("lines match the protocol, and damaged ones are dropped", () => {
  assert.equal(encodeLine("123456789"), "123456789*29B1\n");
  for (const line of ["HELLO 2*0C18", "SET -034.25 00001*2066", "BEAT 00002*3CC0", "AT -034.25 00002*6A12", "STOPPED host*002D",
                      "PLATE 2 -90.00 90.00 300.00 20.00 assumed*F76C"]) {
    assert.equal(encodeLine(line.split("*")[0]), `${line}\n`);
    assert.equal(decodeLine(line), line.split("*")[0]);
    for (let i = 0; i < line.length; ++i) {
      const damaged = line.slice(0, i) + String.fromCharCode(line.charCodeAt(i) ^ 4) + line.slice(i + 1);
      assert.equal(decodeLine(damaged), null, damaged);
    }
  }
});

const facts = "PLATE 2 -90.00 90.00 300.00 20.00 assumed";
/** Creates a link to a test double of a plate, which answers the greeting with `greeting` and other lines by `answer`,
 *  by default as a plate that turns to each command immediately. */
function plate({ greeting = [facts, "AT +000.00 00000"], answer } = {}) {
  let at = "+000.00", now_ms = 0;
  const sent = [], obey = ([verb, ...rest]) => {
    if (verb === "SET") at = rest[0];
    return [`AT ${at} ${rest.at(-2)}`];
  };
  const link = new PlateLink((text) => {
    const body = decodeLine(text.trimEnd()), words = body.split(" ");
    sent.push(body);
    say(...(words[0] === "HELLO" ? greeting : (answer ?? obey)(words)));
  });
  const say = (...bodies) => { for (const body of bodies) link.receive(bytes(encodeLine(body)), now_ms); };
  const run = (milliseconds) => {
    for (const end_ms = now_ms + milliseconds; now_ms < end_ms; now_ms += 5) link.service(now_ms);
  };
  return { link, sent, say, run, receive: (data) => link.receive(data, now_ms), stop: () => link.stop(now_ms) };
}

test("a plate is greeted without motion, follows commands, and receives heartbeats", () => {
  const { link, sent, run, stop } = plate();
  run(300);
  assert.match(sent[0], /^HELLO 2 \d{5}$/);
  assert.ok(sent.every((body) => body.endsWith(sent[0].slice(-6))));
  assert.ok(sent.slice(1).every((body) => body.startsWith("BEAT ")), "opening moves nothing");
  assert.equal(link.ready, true);
  link.turnTo(30.004);
  run(20);
  assert.equal(sent.at(-1).slice(0, 11), "SET +030.00");
  assert.equal(link.orientation_deg, 30);
  const before = sent.length;
  run(1000);
  assert.ok(sent.slice(before).every((body) => body.startsWith("BEAT ")) && sent.length - before >= 19);
  link.turnTo(NaN);
  run(50);
  assert.equal(link.orientation_deg, 30);
  stop();
  run(1000);
  assert.match(sent.at(-1), /^STOP \d{5} \d{5}$/, "nothing is sent after it");
});

// Rule 4 of the protocol: orientations that differ by 180 degrees are equivalent.
test("an angle beyond the limits is replaced by the equivalent one", () => {
  for (const [wanted_deg, angle] of [[100, "-080.00"], [-170, "+010.00"], [361, "+001.00"], [-90, "-090.00"]]) {
    const { link, sent, run } = plate();
    run(100);
    link.turnTo(wanted_deg);
    run(20);
    assert.equal(sent.findLast((body) => body.startsWith("SET")).split(" ")[1], angle, `${wanted_deg}`);
  }
});

test("the link fails for each reason of the protocol, with its message", () => {
  const said = (...more) => ({ greeting: [facts, "AT +000.00 00000", ...more], answer: () => [] });
  const stays = ([verb, ...rest]) => [`AT +000.00 ${rest.at(-2) ?? verb}`];
  for (const [how, time_ms, words] of [
    [{ greeting: [] }, 5300, /^The plate does not answer as a plate of protocol version 2 within 5 s; check port, cable and supply\.$/],
    [said(), 700, /sent nothing for half a second/],
    [said("STOPPED emergency"), 300, /emergency stop/],
    [said("STOPPED stuck"), 300, /servo is stuck/],
    [said("STOPPED supply"), 300, /less than 4 V/],
    [said("BOOT"), 300, /has restarted/],
    [said("ERROR greeting"), 300, /has restarted/],
    [said("ERROR session"), 300, /another program/],
    [said("AT unknown 00000"), 300, /does not know its orientation/],
    [said(facts), 300, /announced itself again/],
    [said("AT +095.00 00000"), 300, /95\.0°, outside its limits of -90° to 90°/],
    [{ greeting: [facts], answer: () => ["ERROR busy"] }, 700, /has not reported its orientation since its greeting/],
    [{ answer: stays }, 1700, /stuck at 0\.0°; it was commanded to 60\.0°/],
  ]) {
    const { link, sent, run } = plate(how);
    link.turnTo(60);
    run(time_ms);
    assert.match(link.failure, words);
    const { length } = sent;
    run(500);
    assert.equal(sent.length, length, "nothing is sent to a plate that was given up");
  }
});

test("garbage on the line changes nothing", () => {
  const { link, run, receive, say } = plate();
  run(100);
  say("", "AT", "AT -34.25 00002", "AT -034.25 2", "AT -034.25 65536", "AT -999.00 00001", "AT -034.25 00002 x", "BOOT now", "STOPPED why",
      "PLATE 1 -90.00 90.00 300.00 20.00 assumed", "PLATE 2 90.00 -90.00 300.00 20.00 assumed", "PLATE 2 -90.00 90.00 0 20.00 assumed",
      "PLATE 2 -90.00 90.00 1e3 20.00 assumed", "PLATE 2 -90 90 300 20 guessed", "PLATE 2 -90.00 90.00 300.00 2000 assumed", "constructor");
  receive(bytes(`${encodeLine("AT +010.00 00001").padStart(65, "x")}${"x".repeat(1e6)}\n`));
  let seed = 1;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 20_000; ++i) {
    const line = bytes(encodeLine(`AT ${random() < 0.5 ? "+" : "-"}0${String(Math.floor(90 * random())).padStart(2, "0")}.00 00001`));
    line[Math.floor(random() * (line.length - 1))] ^= 1 << Math.floor(8 * random());
    receive(line);
    receive(Uint8Array.from({ length: 10 }, () => 256 * random()));
    receive(bytes("\n"));
  }
  assert.deepEqual([link.orientation_deg, link.failure], [0, ""]);
  for (const byte of bytes(encodeLine("AT +020.00 00001").replace("\n", "\r\n"))) receive([byte]);
  assert.equal(link.orientation_deg, 20, "a line in parts is read");
});

function port() {
  const got = [], double = { got, closed: false };
  return Object.assign(double, {
    open: async () => {},
    close: async () => { double.closed = true; },
    readable: new ReadableStream({ start(controller) { double.line = controller; } }),
    writable: new WritableStream({ write(chunk) { got.push(new TextDecoder().decode(chunk)); } }),
  });
}
const soon = () => new Promise((done) => setTimeout(done, 60));

test("a port is read, written and closed, and its loss is reported", async () => {
  const one = port(), device = await PlateDevice.open(one);
  await soon();
  assert.match(one.got[0], /^HELLO 2 \d{5}\*/);
  one.line.enqueue(bytes(encodeLine(facts)));
  await soon();
  assert.equal(device.state, "The plate turns from -90° to 90° at 300°/s; its orientation is assumed from its commands: it has no sensor.");
  await device.close();
  assert.deepEqual([one.closed, /^STOP /.test(one.got.at(-1))], [true, true]);
  const other = port(), lost = await PlateDevice.open(other);
  other.line.error(new Error("The device has been lost."));
  await soon();
  assert.equal(lost.state, "The line to the plate ended: The device has been lost. Check its cable, then connect it again.");
  await lost.close();
  await assert.rejects(PlateDevice.open({ open: async () => { throw new Error("Failed to open serial port."); } }), /Failed to open/);
});
