// A session of the plugin, for one of the page's controllers.
import * as hrt from "haptic-retargeting";
import { distance_m, start, type Course } from "./geometry";
import type { ControllerName, Settings } from "./settings";

/** The page's own course: the gap, half to each side of the mid-line. */
export function pageCourse(settings: Readonly<Settings>): Course {
  return { start, real_deg: -settings.gap_deg / 2, real_m: distance_m, virtual_deg: settings.gap_deg / 2, virtual_m: distance_m };
}

/** The controller for people: what it plans within, of the motion. */
export const motionBound_deg = 75;

const controllers: Readonly<Record<ControllerName, Parameters<hrt.Library["createSession"]>[0]>> = {
  off: { control: hrt.HRT_CONTROL_FIXED_PLATE },
  paper: { guidance: hrt.HRT_GUIDANCE_FIXED_DIRECTION, adaptation: hrt.HRT_ADAPTATION_OFF, tactile_weight: 0.15 },
  ours: { guidance: hrt.HRT_GUIDANCE_ARRIVAL, adaptation: hrt.HRT_ADAPTATION_CARRIED, motion_bound_deg: motionBound_deg },
};

/** One controller with the two targets. Knows the course and what the plate can do; nothing of the person. */
export class Controller {
  readonly session: hrt.Session;
  readonly #real: hrt.TargetId;
  readonly #virtual: hrt.TargetId;

  constructor(library: hrt.Library, settings: Readonly<Settings>, course: Course, plateLatency_ms: number) {
    this.session = library.createSession({
      ...controllers[settings.controller],
      plate_max_speed_deg_s: settings.plate_deg_s,
      plate_latency_ns: Math.round(1e6 * plateLatency_ms),
    });
    this.#real = this.session.addTarget({ role: hrt.HRT_TARGET_REAL, name: "cylinder" });
    this.#virtual = this.session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, name: "ghost" });
    this.apply(settings, course);
  }

  /** Between reaches: other targets and another plate, with what has been learnt of the person. */
  apply(settings: Readonly<Settings>, course: Course): void {
    const { start: from, real_deg, real_m, virtual_deg, virtual_m } = course;
    this.session.configure({ plate_max_speed_deg_s: settings.plate_deg_s, start_position_m: [from.right_m, 0, -from.away_m] });
    this.session.setTarget(this.#real, { direction_deg: real_deg, distance_m: real_m });
    this.session.setTarget(this.#virtual, { direction_deg: virtual_deg, distance_m: virtual_m });
  }

  /** A reach begins, and is recorded. */
  begin(plate_deg: number): void {
    this.session.startRecording();
    this.session.beginReach(this.#real, this.#virtual, plate_deg);
  }

  /** The finger is seen there; returns the orientation that the plate is to turn to. */
  see(time_ms: number, right_m: number, away_m: number): number {
    const { sample, command } = this.session;
    sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
    sample.time_ns = Math.round(1e6 * time_ms);
    const position = sample.finger_position_m;
    position[0] = right_m;
    position[1] = 0;
    position[2] = -away_m;
    this.session.update();
    return command.plate_orientation_deg;
  }

  /** Ends the reach, and learns from it. */
  end(): ReturnType<hrt.Session["endReach"]> { return this.session.endReach(); }

  /** Ends a reach that is under way without learning from it. */
  cancel(): void {
    if (this.session.state & hrt.HRT_STATE_REACHING) this.session.cancelReach();
  }

  /** The recording of the reach that has ended; empty if none was recorded. */
  takeRecording(): string {
    return this.session.state & hrt.HRT_STATE_RECORDING ? this.session.stopRecording() : "";
  }

  destroy(): void {
    this.cancel();
    this.takeRecording();
    this.session.destroy();
  }
}

/** What the flags of a command say, for people. */
export function warnings(flags: number): string[] {
  const said: string[] = [];
  if (flags & hrt.HRT_COMMAND_UNREACHABLE) said.push("the gap cannot be held");
  if (flags & hrt.HRT_COMMAND_OFF_TARGET) said.push("the finger ends off the target");
  if (flags & hrt.HRT_COMMAND_MISFIT) said.push("the motion does not fit the model");
  return said;
}
