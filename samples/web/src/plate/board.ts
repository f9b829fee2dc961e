// The plate's firmware (samples/plate/firmware) on an emulated ATmega328P at 16 MHz that drives a hobby servo.
// Simulation only: it has not run on a real board or servo.
import * as avr from "avr8js";
import firmware from "plate_firmware.hex";
import { crc16 } from "./line";

const cpu_hz = 16e6;
const flash_bytes = 32768;
const sram_bytes = 2048;
const sleepInstruction = 0x9588;
const servoPin = 1,
  emergencyPin = 2;
/** Zero, span, limits, speed, latency, the sensor's readings at the limits, emergency stop, supply, bend, serial number; times 100. */
const settings = [150000, 200000, -9000, 9000, 20000, 3000, 20500, 81800, 100, 100, ...new Array<number>(9).fill(0), 0];
/** Largest step of the emulated servo at each pulse, which is 400 degrees a second. */
const servoStep_deg = 8;

export class Board {
  /** Angle of the servo. */
  servo_deg = 0;
  /** Width of the last pulse; 0: no pulse since the start. */
  pulse_us = 0;
  /** Called with each byte that the board sends. */
  onByte: (byte: number) => void = () => {};

  readonly #cpu: avr.CPU;
  readonly #usart: avr.AVRUSART;
  readonly #adc: avr.AVRADC;
  readonly #portD: avr.AVRIOPort;
  readonly #toBoard: number[] = [];
  #roseAt = 0;
  #asleep = false;

  /** `hex`: firmware in Intel's hexadecimal format; default: the plate's firmware. Throws if it is damaged. */
  constructor(hex: string = firmware) {
    const cpu = new avr.CPU(readHex(hex), sram_bytes);
    this.#cpu = cpu;
    for (const timer of [avr.timer0Config, avr.timer1Config]) new avr.AVRTimer(cpu, timer);
    const eeprom = new avr.EEPROMMemoryBackend(1024);
    for (const [at, byte] of packed(settings).entries()) eeprom.writeMemory(at, byte);
    new avr.AVREEPROM(cpu, eeprom);
    this.#adc = new avr.AVRADC(cpu, avr.adcConfig);
    this.#adc.channelValues[1] = 2.5; // half of the servo's supply voltage
    this.#showSensor();
    this.#portD = new avr.AVRIOPort(cpu, avr.portDConfig);
    this.openEmergencyStop(false);
    this.#usart = new avr.AVRUSART(cpu, avr.usart0Config, cpu_hz);
    // "Data register empty" is level-triggered on a board; avr8js clears it when its interrupt is taken.
    (this.#usart as unknown as { UDRE: { constant: boolean } }).UDRE.constant = true;
    this.#usart.onByteTransmit = (byte) => this.onByte(byte);
    this.#usart.onRxComplete = () => this.#transmit();
    new avr.AVRIOPort(cpu, avr.portBConfig).addListener((value, before) => {
      if (!((value ^ before) & (1 << servoPin))) return;
      if (value & (1 << servoPin)) this.#roseAt = cpu.cycles;
      else this.#takePulse(((cpu.cycles - this.#roseAt) * 1e6) / cpu_hz);
    });
  }

  get time_ms(): number {
    return (this.#cpu.cycles * 1000) / cpu_hz;
  }

  /** Queues bytes, which arrive at the board at the speed of the line. */
  receive(text: string): void {
    for (let i = 0; i < text.length; ++i) this.#toBoard.push(text.charCodeAt(i) & 0xff);
    this.#transmit();
  }

  openEmergencyStop(open: boolean): void {
    this.#portD.setPin(emergencyPin, open);
  }

  /** Runs the board for this time. A sleeping board costs little. */
  run(milliseconds: number): void {
    const cpu = this.#cpu,
      end = cpu.cycles + (milliseconds * cpu_hz) / 1000;
    while (cpu.cycles < end) {
      if (!this.#asleep) {
        const sleeps = cpu.progMem[cpu.pc] === sleepInstruction,
          next = cpu.pc + 1;
        avr.avrInstruction(cpu); // does nothing for a sleep instruction
        cpu.tick();
        this.#asleep = sleeps && cpu.pc === next; // otherwise an interrupt was pending
      } else {
        this.#sleep(end);
      }
    }
    this.#transmit();
  }

  /** Skips from one event of the peripherals to the next, until an interrupt is pending. */
  #sleep(end: number): void {
    const cpu = this.#cpu as unknown as {
      pc: number;
      cycles: number;
      nextClockEvent: { cycles: number } | null;
      tick(): void;
    };
    const { pc } = cpu;
    while (cpu.pc === pc && cpu.cycles < end) {
      cpu.cycles = Math.max(cpu.cycles, Math.min(end, cpu.nextClockEvent?.cycles ?? end));
      cpu.tick();
    }
    this.#asleep = cpu.pc === pc;
  }

  #transmit(): void {
    while (this.#toBoard.length > 0 && !this.#usart.rxBusy) {
      const byte = this.#toBoard.shift();
      // A byte that arrives while the receiver is off is lost, as on a real line.
      if (byte !== undefined && this.#usart.writeByte(byte)) return;
    }
  }

  /** Sets the goal of the servo: 1500 us is 0, and 1000 us more or less is 90 degrees to either side. */
  #takePulse(width_us: number): void {
    this.pulse_us = width_us;
    const wanted_deg = ((width_us - 1500) * 90) / 1000;
    this.servo_deg += Math.max(-servoStep_deg, Math.min(servoStep_deg, wanted_deg - this.servo_deg));
    this.#showSensor();
  }

  /** Sets the voltage at the sensor's pin: 1 V at -90 degrees, 4 V at 90. */
  #showSensor(): void {
    this.#adc.channelValues[0] = 2.5 + this.servo_deg / 60;
  }
}

/** Encodes settings as the firmware stores them (samples/app/firmware/settings.c). */
function packed(values: readonly number[]): Uint8Array {
  const bytes = new Uint8Array(4 + 4 * values.length + 2),
    view = new DataView(bytes.buffer);
  bytes.set([0x48, 0x52, 0x50, 2]);
  for (const [i, value] of values.entries()) view.setInt32(4 + 4 * i, value, true);
  view.setUint16(bytes.length - 2, crc16(String.fromCharCode(...bytes.subarray(0, -2))), true);
  return bytes;
}

function readHex(text: string): Uint16Array {
  const memory = new Uint8Array(flash_bytes);
  for (const line of text.split(/\r?\n/)) {
    if (line === "") continue;
    const bytes = /^:([0-9A-Fa-f]{2})+$/.test(line)
      ? (line.slice(1).match(/../g) ?? []).map((pair) => parseInt(pair, 16))
      : [];
    const [count = 0, high = 0, low = 0, type] = bytes;
    const sum = bytes.reduce((total, byte) => (total + byte) & 0xff, 0);
    if (bytes.length !== count + 5 || sum !== 0)
      throw new Error(`the firmware's line "${line.slice(0, 20)}" is damaged`);
    if (type !== 0) continue;
    const at = 256 * high + low;
    if (at + count > flash_bytes) throw new Error("the firmware does not fit into 32 KB");
    memory.set(bytes.slice(4, -1), at);
  }
  return new Uint16Array(memory.buffer);
}
