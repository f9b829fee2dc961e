// The controllers that the page offers, and the targets of its reaches.
import * as hrt from "haptic-retargeting";
import { type Course, distance_m, start } from "./geometry";
import type { ControllerName, Settings } from "./settings";

/** Returns the page's targets: the cylinder lies half the gap to the right of the mid-line, the glass half the gap to the left. */
export function pageCourse(settings: Readonly<Settings>): Course {
  return {
    start,
    real_deg: -settings.gap_deg / 2,
    real_m: distance_m,
    virtual_deg: settings.gap_deg / 2,
    virtual_m: distance_m,
  };
}

/** Largest angle between the normal of the ridges and the motion for which the controller "ours" plans. */
export const motionBound_deg = 75;

/** Configuration of the plugin's session for each controller. */
export const sessions: Readonly<Record<ControllerName, Parameters<hrt.Library["createSession"]>[0]>> = {
  off: { control: hrt.HRT_CONTROL_FIXED_PLATE },
  paper: { guidance: hrt.HRT_GUIDANCE_FIXED_DIRECTION, adaptation: hrt.HRT_ADAPTATION_OFF, tactile_weight: 0.15 },
  ours: {
    guidance: hrt.HRT_GUIDANCE_ARRIVAL,
    adaptation: hrt.HRT_ADAPTATION_CARRIED,
    motion_bound_deg: motionBound_deg,
  },
};

/** Describes the warnings in the flags of a command. */
export function warnings(flags: number): string[] {
  const said: string[] = [];
  if (flags & hrt.HRT_COMMAND_UNREACHABLE) said.push("no plate orientation sustains the gap");
  if (flags & hrt.HRT_COMMAND_OFF_TARGET) said.push("the hand will miss the target");
  if (flags & hrt.HRT_COMMAND_MISFIT) said.push("the motion does not fit the model");
  if (flags & hrt.HRT_COMMAND_NOT_AT_START) said.push("the hand is not at the start");
  return said;
}
