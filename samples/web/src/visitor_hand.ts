// Base class of the reaches of the visitor's own hand. It simulates the servo, and the perceived fingertip: the
// illusion rotates each step of the motion, and the rotated steps are added.
import type { Library } from "haptic-retargeting";
import { ahead, direction_deg, feltDirection_deg, type Place, pageCourse, start } from "./geometry";
import { GuidedReach, plateLatency_ms } from "./guided_reach";
import type { Settings } from "./settings";

/** Time constant of the velocity filter, which smooths the coarse positions of trackers and pointers. */
const smoothing_ms = 60;
const minSpeed_m_s = 0.004;

/** Simulated servo: follows a command after plateLatency_ms, at most as fast as the caller allows. */
class Servo {
  orientation_deg = 0;
  #target_deg = 0;
  #pending: { readonly due_ms: number; readonly orientation_deg: number }[] = [];

  /** Sets the orientation without a motion. */
  put(orientation_deg: number): void {
    this.orientation_deg = this.#target_deg = orientation_deg;
    this.#pending = [];
  }

  command(orientation_deg: number, now_ms: number): void {
    this.#pending.push({ due_ms: now_ms + plateLatency_ms, orientation_deg });
  }

  advance(now_ms: number, maxMotion_deg: number): void {
    while (this.#pending[0] && this.#pending[0].due_ms <= now_ms)
      this.#target_deg = this.#pending.shift()!.orientation_deg;
    this.orientation_deg += Math.max(-maxMotion_deg, Math.min(maxMotion_deg, this.#target_deg - this.orientation_deg));
  }
}

export abstract class VisitorHand extends GuidedReach {
  readonly finger: Place = { ...start };
  readonly felt: Place = { ...start };
  /** True and perceived direction of the motion; NaN below minSpeed_m_s. */
  finger_deg = NaN;
  felt_deg = NaN;
  /** Time since the reach began. */
  protected time_ms = 0;
  readonly #servo = new Servo();
  #speedRight_m_s = 0;
  #speedAway_m_s = 0;

  constructor(library: Library, settings: Readonly<Settings>) {
    super(library, settings, pageCourse(settings.gap_deg));
  }

  get plate_deg(): number {
    return this.#servo.orientation_deg;
  }
  get speed_m_s(): number {
    return Math.hypot(this.#speedRight_m_s, this.#speedAway_m_s);
  }

  /** Cancels a running reach, and puts the hand at the start and the plate at 0°. */
  protected rest(): void {
    this.cancel();
    this.trace = [];
    this.time_ms = 0;
    this.#servo.put(0);
    Object.assign(this.finger, start);
    Object.assign(this.felt, start);
    this.#speedRight_m_s = this.#speedAway_m_s = 0;
    this.finger_deg = this.felt_deg = NaN;
  }

  protected turnPlate(): void {
    this.#servo.command(this.command.plate_orientation_deg, this.time_ms);
  }

  protected advancePlate(milliseconds: number): void {
    this.time_ms += milliseconds;
    this.#servo.advance(this.time_ms, (milliseconds / 1000) * this.settings.plate_deg_s);
    this.showConnectedPlate();
  }

  protected showConnectedPlate(): void {
    if (!Number.isNaN(this.plateConnected_deg)) this.#servo.put(this.plateConnected_deg);
  }

  /** Moves the fingertip. `milliseconds`: duration of the motion, above 0. */
  protected moveFinger({ right_m, away_m }: Readonly<Place>, milliseconds: number): void {
    const stepRight_m = right_m - this.finger.right_m,
      stepAway_m = away_m - this.finger.away_m,
      gain = 1 - Math.exp(-milliseconds / smoothing_ms);
    this.#speedRight_m_s += gain * ((1000 * stepRight_m) / milliseconds - this.#speedRight_m_s);
    this.#speedAway_m_s += gain * ((1000 * stepAway_m) / milliseconds - this.#speedAway_m_s);
    let added_deg = 0;
    if (this.speed_m_s < minSpeed_m_s) {
      this.finger_deg = this.felt_deg = NaN;
    } else {
      this.finger_deg = direction_deg(this.#speedRight_m_s, this.#speedAway_m_s);
      this.felt_deg = feltDirection_deg(this.settings.tactile_weight, this.plate_deg, this.finger_deg);
      added_deg = this.felt_deg - this.finger_deg;
    }
    const felt_deg = direction_deg(stepRight_m, stepAway_m) + added_deg;
    Object.assign(this.felt, ahead(this.felt, felt_deg, Math.hypot(stepRight_m, stepAway_m)));
    Object.assign(this.finger, { right_m, away_m });
  }

  protected recordHand(): void {
    const { time_ms, plate_deg, finger_deg, felt_deg, finger, felt } = this;
    this.record({ time_ms, plate_deg, finger_deg, felt_deg, finger: { ...finger }, felt: { ...felt } });
  }
}
