// The page's link to a plate, under node, with test doubles of a plate and a port. No real plate is used.
import assert from "node:assert/strict";
import { test } from "node:test";
import { models } from "./models.mjs";

const { crc16, decodeLine, encodeLine, LineReader, parseMessage, PlateLink } = models;
const bytes = (text) => new TextEncoder().encode(text);

// The examples of plugin/src/plate/protocol.md.
test("checksums and lines match the protocol", () => {
  assert.equal(crc16("123456789"), 0x29b1);
  for (const line of ["HELLO 2*0C18", "SET -034.25 00001*2066", "BEAT 00002*3CC0", "AT -034.25 00002*6A12", "STOPPED host*002D",
                      "PLATE 2 -90.00 90.00 300.00 20.00 assumed*F76C"]) {
    const body = line.split("*")[0];
    assert.equal(encodeLine(body), `${line}\n`);
    assert.equal(decodeLine(line), body);
    for (let i = 0; i < line.length; ++i) {
      const damaged = line.slice(0, i) + String.fromCharCode(line.charCodeAt(i) ^ 4) + line.slice(i + 1);
      assert.equal(decodeLine(damaged), null, damaged);
    }
  }
  assert.deepEqual(parseMessage("AT -034.25 00002"), { kind: "at", orientation_deg: -34.25, sequence: 2 });
});

test("a line that is not a message of the protocol is ignored", () => {
  for (const body of ["", "AT", "AT -34.25 00002", "AT -034.25 2", "AT -034.25 65536", "AT -999.00 00001", "AT -034.25 00002 x", "BOOT now",
                      "STOPPED why", "PLATE 1 -90.00 90.00 300.00 20.00 assumed", "PLATE 2 90.00 -90.00 300.00 20.00 assumed",
                      "PLATE 2 -90.00 90.00 0 20.00 assumed", "PLATE 2 -90.00 90.00 1e3 20.00 assumed", "PLATE 2 -90 90 300 20 guessed",
                      "PLATE 2 -90.00 90.00 NaN 20.00 assumed", "PLATE 2 -90.00 90.00 300.00 2000 assumed", "constructor", "__proto__ 1"]) {
    assert.equal(parseMessage(body), null, body);
  }
});

test("a reader drops a line that is too long, and reads the next one", () => {
  const reader = new LineReader(), take = (text) => [...bytes(text)].flatMap((byte) => reader.take([byte]));
  assert.deepEqual(take("one\r\ntwo\n"), ["one", "two"]);
  assert.deepEqual(reader.take(bytes("one\r\ntwo\nth")), ["one", "two"]);
  assert.deepEqual(take("ree\n"), ["three"]);
  assert.deepEqual(take(`${"x".repeat(63)}\n${"x".repeat(64)}\n${"x".repeat(1e6)}\nthree\n`), ["x".repeat(63), "three"]);
});

/** Creates a test double of a plate, with the replies of `answer` and the clock `now`. */
function double(answer) {
  const said = [], state = { now: 0, said, link: null };
  const link = new PlateLink((text) => {
    const body = decodeLine(text.trimEnd());
    said.push(body);
    for (const reply of answer(body, state) ?? []) link.receive(bytes(encodeLine(reply)), state.now);
  });
  state.link = link;
  state.run = (milliseconds) => {
    for (const end = state.now + milliseconds; state.now < end; state.now += 5) link.service(state.now);
  };
  return state;
}
const facts = "PLATE 2 -90.00 90.00 300.00 20.00 assumed";
/** Creates a plate that turns to each command immediately. */
function obedient() {
  let at = "+000.00";
  return double((body) => {
    const [verb, ...rest] = body.split(" ");
    if (verb === "HELLO") return [facts, `AT ${at} 00000`];
    if (verb === "SET") at = rest[0];
    return [`AT ${at} ${rest.at(-2)}`];
  });
}

test("a plate is greeted without motion, follows commands, and receives heartbeats", () => {
  const plate = obedient();
  plate.run(300);
  assert.match(plate.said[0], /^HELLO 2 \d{5}$/);
  const token = plate.said[0].slice(-6);
  assert.ok(plate.said.every((body) => body.endsWith(token)));
  assert.ok(plate.said.slice(1).every((body) => body.startsWith("BEAT ")), "opening moves nothing");
  assert.equal(plate.link.ready, true);
  plate.link.turnTo(30.004);
  plate.run(20);
  assert.equal(plate.said.at(-1).slice(0, 11), "SET +030.00");
  assert.equal(plate.link.orientation_deg, 30);
  const before = plate.said.length;
  plate.run(1000);
  assert.ok(plate.said.slice(before).every((body) => body.startsWith("BEAT ")) && plate.said.length - before >= 19);
  plate.link.turnTo(NaN);
  plate.run(50);
  assert.equal(plate.link.orientation_deg, 30);
  plate.link.stop(plate.now);
  assert.match(plate.said.at(-1), /^STOP \d{5} \d{5}$/);
  plate.run(1000);
  assert.match(plate.said.at(-1), /^STOP/, "nothing after it");
});

// Rule 4: orientations that differ by 180 degrees are equivalent.
test("an angle beyond the limits is replaced by the equivalent one", () => {
  for (const [wanted, sent] of [[100, "-080.00"], [-170, "+010.00"], [361, "+001.00"], [-90, "-090.00"]]) {
    const plate = obedient();
    plate.run(100);
    plate.link.turnTo(wanted);
    plate.run(20);
    assert.equal(plate.said.findLast((body) => body.startsWith("SET")).split(" ")[1], sent, `${wanted}`);
  }
});

test("the link fails for each reason of the protocol, with its message", () => {
  const hello = (...more) => (body) => (body.startsWith("HELLO") ? [facts, "AT +000.00 00000", ...more] : []);
  const silent = double(() => []);
  silent.run(5300);
  assert.equal(silent.link.failure, "The plate does not answer as a plate of protocol version 2 within 5 s; check port, cable and supply.");
  const cases = [[hello(), 700, /sent nothing for half a second/], [hello("STOPPED emergency"), 300, /emergency stop/],
                 [hello("STOPPED stuck"), 300, /servo is stuck/], [hello("BOOT"), 300, /has restarted/],
                 [hello("ERROR greeting"), 300, /has restarted/], [hello("ERROR session"), 300, /another program/],
                 [hello("STOPPED supply"), 300, /less than 4 V/], [hello("AT unknown 00000"), 300, /does not know its orientation/], [hello(facts), 300, /announced itself again/],
                 [hello("AT +095.00 00000"), 300, /95\.0°, outside its limits of -90° to 90°/],
                 [(body) => (body.startsWith("HELLO") ? [facts] : ["ERROR busy"]), 700, /has not reported its orientation since its greeting/]];
  for (const [answer, time, words] of cases) {
    const plate = double(answer);
    plate.run(time);
    assert.match(plate.link.failure, words);
    const { length } = plate.said;
    plate.run(500);
    assert.equal(plate.said.length, length, "nothing is sent to a plate that was given up");
  }
  const stuck = double((body) => (body.startsWith("HELLO") ? [facts] : [`AT +000.00 ${body.split(" ").at(-2)}`]));
  stuck.run(200);
  stuck.link.turnTo(60);
  stuck.run(1500);
  assert.match(stuck.link.failure, /stuck at 0\.0°; it was commanded to 60\.0°/);
});

test("garbage on the line changes nothing", () => {
  const plate = obedient();
  plate.run(100);
  let seed = 1;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 20_000; ++i) {
    const line = bytes(encodeLine(`AT ${random() < 0.5 ? "+" : "-"}0${String(Math.floor(90 * random())).padStart(2, "0")}.00 00001`));
    line[Math.floor(random() * (line.length - 1))] ^= 1 << Math.floor(8 * random());
    plate.link.receive(line, plate.now);
    plate.link.receive(Uint8Array.from({ length: 10 }, () => 256 * random()), plate.now);
    plate.link.receive(bytes("\n"), plate.now);
  }
  assert.deepEqual([plate.link.orientation_deg, plate.link.failure], [0, ""]);
});

/** Creates a test double of a Web Serial port, which fails in the way of `fails`. */
function port({ fails = "" } = {}) {
  let toHost, closed = false;
  const got = [];
  return { got, feed: (data) => toHost.enqueue(data), unplug: () => toHost.error(new Error("The device has been lost.")),
           get closed() { return closed; },
           open: async () => { if (fails) throw new Error(fails); },
           close: async () => { closed = true; },
           readable: new ReadableStream({ start(controller) { toHost = controller; } }),
           writable: new WritableStream({ write(chunk) { got.push(new TextDecoder().decode(chunk)); } }) };
}

test("a port is read, written and closed, and its loss is reported", async () => {
  const heard = [], ended = [], one = port();
  const line = await models.openPort(one, (data) => heard.push(...data), (why) => ended.push(why));
  one.feed(Uint8Array.of(1, 2));
  line.send("HELLO 2*0C18\n");
  await new Promise((done) => setTimeout(done, 20));
  assert.deepEqual([heard, one.got, ended], [[1, 2], ["HELLO 2*0C18\n"], []]);
  await line.close();
  assert.deepEqual([one.closed, ended], [true, []]);
  const other = port();
  await models.openPort(other, () => {}, (why) => ended.push(why));
  other.unplug();
  await new Promise((done) => setTimeout(done, 20));
  assert.deepEqual(ended, ["The device has been lost."]);
  await assert.rejects(models.openPort(port({ fails: "Failed to open serial port." }), () => {}, () => {}), /Failed to open/);
});
