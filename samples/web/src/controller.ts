// The controllers that the page offers, and its default targets.
import * as hrt from "haptic-retargeting";
import { type Course, distance_m, start } from "./geometry";
import type { ControllerName, Settings } from "./settings";

/** Targets of the page: real and virtual target lie half the gap to either side of the mid-line. */
export function pageCourse(settings: Readonly<Settings>): Course {
  return {
    start,
    real_deg: -settings.gap_deg / 2,
    real_m: distance_m,
    virtual_deg: settings.gap_deg / 2,
    virtual_m: distance_m,
  };
}

/** Largest angle between the ridges' normal and the motion that the controller for people plans. */
export const motionBound_deg = 75;

/** Session configuration of each controller. */
export const sessions: Readonly<Record<ControllerName, Parameters<hrt.Library["createSession"]>[0]>> = {
  off: { control: hrt.HRT_CONTROL_FIXED_PLATE },
  paper: { guidance: hrt.HRT_GUIDANCE_FIXED_DIRECTION, adaptation: hrt.HRT_ADAPTATION_OFF, tactile_weight: 0.15 },
  ours: {
    guidance: hrt.HRT_GUIDANCE_ARRIVAL,
    adaptation: hrt.HRT_ADAPTATION_CARRIED,
    motion_bound_deg: motionBound_deg,
  },
};

/** Returns the warnings in a command's flags as text for people. */
export function warnings(flags: number): string[] {
  const said: string[] = [];
  if (flags & hrt.HRT_COMMAND_UNREACHABLE) said.push("the gap cannot be held");
  if (flags & hrt.HRT_COMMAND_OFF_TARGET) said.push("the finger ends off the target");
  if (flags & hrt.HRT_COMMAND_MISFIT) said.push("the motion does not fit the model");
  if (flags & hrt.HRT_COMMAND_NOT_AT_START) said.push("the finger is not at the start");
  return said;
}
