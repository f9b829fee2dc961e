// Reaches of the plugin's simulated person, who also simulates the tracker and the servo, controlled by the plugin.
import type { Library, Person } from "haptic-retargeting";
import { bearing_deg, type Course, length_m, type Place, pageCourse, type SlideEnd, slideEnd } from "./geometry";
import { GuidedReach, plateLatency_ms, type Step, type Trace } from "./guided_reach";
import type { ControllerName, Settings } from "./settings";

const period_ms = 1000 / 90; // of the tracker
/** Duration of the tracked rest after the motion. */
const tail_ms = 300;
/** At a lower speed, the perceived-direction error does not count for its peak. */
const minSpeed_m_s = 0.01;

/** Result of a reach: the ground truth of the simulation and the controller's estimates. */
export interface ReachResult extends SlideEnd {
  /** Number of the reach since the controller had no estimates, from 1. */
  readonly number: number;
  readonly controller: ControllerName;
  readonly gap_deg: number;
  /** Direction of the end of the reach minus that of the cylinder, both seen from the start. */
  readonly bearingError_deg: number;
  readonly peakFeltError_deg: number;
  /** Estimate of the tactile weight, and its SD; 0: the controller assumes that the weight is exact. */
  readonly weight: number;
  readonly weightSd: number;
  readonly flags: number;
}

export class SimulatedReach extends GuidedReach {
  phase: "waiting" | "sliding" | "arrived" = "waiting";
  result: ReachResult | null = null;
  course: Course;
  number = 1;
  #person: Person | null = null;
  #personConfig = "";
  #sampleCount = 0;
  /** Time until which the reach is shown. */
  #shown_ms = 0;
  #stoppedAt_ms = NaN;
  #peakFeltError_deg = 0;
  /** Orientation of the plate at the beginning, which the controller "off" keeps. */
  #still_deg = 0;

  constructor(
    library: Library,
    settings: Readonly<Settings>,
    private readonly courseOf: (settings: Readonly<Settings>) => Course = ({ gap_deg }) => pageCourse(gap_deg),
  ) {
    super(library, settings, courseOf(settings));
    this.course = courseOf(settings);
    this.begin();
  }

  get controller(): ControllerName {
    return this.settings.controller;
  }
  /** Estimates of the person, as the plugin's profile in JSON. */
  get profile(): string {
    return this.session.profile;
  }

  /** Begins a reach. If the person or the controller has changed, discards the estimates and returns true. */
  apply(settings: Readonly<Settings>): boolean {
    const before = this.settings,
      unknown = (["person", "tactile_weight", "pace_s", "controller"] as const).some(
        (name) => before[name] !== settings[name],
      );
    this.settings = { ...settings };
    this.course = this.courseOf(settings);
    this.cancel();
    if (unknown) {
      this.restartSession(this.course);
      this.#personConfig = ""; // so that begin() creates the person, who starts with the first reach
      this.number = 1;
      this.phase = "waiting";
    } else {
      this.setTargets(this.course);
    }
    this.begin();
    return unknown;
  }

  /** Begins the next reach over a plate at `plate_deg`. A reach without a motion is not counted in `number`. */
  begin(plate_deg = 0): void {
    if (this.phase !== "waiting") ++this.number;
    this.beginReach(plate_deg);
    this.#choosePerson().begin(this.session, this.virtual);
    this.phase = "waiting";
    this.result = null;
    this.#sampleCount = this.#shown_ms = this.#peakFeltError_deg = 0;
    this.#stoppedAt_ms = NaN;
    this.#still_deg = plate_deg;
    this.#sample();
  }

  /** Returns the person of the settings, whose simulated servo is immediate if a plate is connected. */
  #choosePerson(): Person {
    const { person: seed, tactile_weight, pace_s, noise_mm, plate_deg_s } = this.settings,
      connected = !Number.isNaN(this.plateConnected_deg);
    const config = {
      tactile_weight,
      duration_s: pace_s,
      tracker_noise_m: Math.max(1e-9, noise_mm / 1000), // 0 selects the default of the plugin
      plate_max_speed_deg_s: connected ? 1e6 : plate_deg_s,
      plate_latency_ns: connected ? 1 : 1e6 * plateLatency_ms,
    };
    const text = JSON.stringify([seed, config]);
    if (this.#person && text === this.#personConfig) return this.#person;
    this.#person?.destroy();
    this.#personConfig = text;
    this.#person = this.library.createPerson(seed, config);
    return this.#person;
  }

  advance(milliseconds: number): void {
    this.#shown_ms += milliseconds;
    while (this.phase !== "arrived" && this.#sampleTime_ms < this.#shown_ms) this.#sample();
  }

  finish(): void {
    while (this.phase !== "arrived") this.advance(period_ms);
  }

  /** State of the reach; positions and plate orientation are interpolated between its last two samples. */
  get shown(): Step & { readonly trace: Trace } {
    const { trace } = this,
      after = trace.at(-1)!,
      before = trace.at(-2) ?? after,
      part = Math.min(1, 1 - (this.#sampleTime_ms - this.#shown_ms) / period_ms);
    const mix = (from: Readonly<Place>, to: Readonly<Place>) => ({
      right_m: from.right_m + part * (to.right_m - from.right_m),
      away_m: from.away_m + part * (to.away_m - from.away_m),
    });
    const plate_deg = before.plate_deg + part * (after.plate_deg - before.plate_deg);
    return { ...after, plate_deg, finger: mix(before.finger, after.finger), felt: mix(before.felt, after.felt), trace };
  }

  get #sampleTime_ms(): number {
    return (this.#sampleCount - 1) * period_ms;
  }

  /** Advances the person over the commanded or connected plate, and passes a sample of the tracker to the plugin. */
  #sample(): void {
    const still = this.#sampleCount === 0 || this.controller === "off",
      command_deg = still ? this.#still_deg : this.command.plate_orientation_deg;
    const plate_deg = Number.isNaN(this.plateConnected_deg) ? command_deg : this.plateConnected_deg;
    ++this.#sampleCount;
    const person = this.#person!,
      time_ms = this.#sampleTime_ms,
      before = this.trace.at(-1)?.finger;
    person.move(this.session.sample, 1e6 * time_ms, plate_deg);
    this.session.update();
    const { done, position_m, felt_position_m, plate_orientation_deg, felt_error_deg } = person.state;
    const onPlate = ([x = 0, , z = 0]: readonly number[]): Place => ({ right_m: x, away_m: -z }),
      finger = onPlate(position_m),
      step_m = before ? length_m(before, finger) : 0,
      moves = !done && before && step_m > 0;
    if (moves) this.phase = "sliding";
    if ((1000 * step_m) / period_ms > minSpeed_m_s)
      this.#peakFeltError_deg = Math.max(this.#peakFeltError_deg, Math.abs(felt_error_deg));
    this.record({
      time_ms,
      plate_deg: plate_orientation_deg,
      finger_deg: moves ? bearing_deg(before, finger) : NaN,
      felt_deg: moves ? this.course.virtual_deg + felt_error_deg : NaN,
      finger,
      felt: onPlate(felt_position_m),
    });
    if (done && Number.isNaN(this.#stoppedAt_ms)) this.#stoppedAt_ms = time_ms;
    if (time_ms > this.#stoppedAt_ms + tail_ms) this.#end();
  }

  #end(): void {
    const { finger, felt } = this.trace.at(-1)!,
      { course, number } = this,
      { tactile_weight, tactile_weight_sd } = this.command;
    const { flags } = this.session.endReach();
    this.recording = this.cancel();
    this.phase = "arrived";
    this.result = {
      number,
      controller: this.settings.controller,
      gap_deg: course.virtual_deg - course.real_deg,
      bearingError_deg: bearing_deg(course.start, finger) - course.real_deg,
      ...slideEnd(finger, felt, course),
      peakFeltError_deg: this.#peakFeltError_deg,
      weight: tactile_weight,
      weightSd: tactile_weight_sd,
      flags,
    };
  }
}
