// Written by plugin/bindings/generate from the C headers.
import { writeF64s, writeI64, writeU32, readI64 } from "./numbers.mjs";

export class Sample {
  flags = 0;
  time_ns = 0;
  finger_direction_deg = 0;
  finger_position_m = new Float64Array(3);
  plate_orientation_deg = 0;
  plate_position_m = new Float64Array(3);
  plate_rotation = new Float64Array(4);
  constructor() { Object.preventExtensions(this); }
  toJSON() { return { ...this, finger_position_m: [...this.finger_position_m], plate_position_m: [...this.plate_position_m], plate_rotation: [...this.plate_rotation] }; }
}

export function writeSample(view, at, { flags, time_ns, finger_direction_deg, finger_position_m, plate_orientation_deg, plate_position_m, plate_rotation }) {
  writeU32(view, at + 4, "flags", flags);
  writeI64(view, at + 8, "time_ns", time_ns);
  view.setFloat64(at + 16, finger_direction_deg, true);
  writeF64s(view, at + 24, "finger_position_m", finger_position_m, 3);
  view.setFloat64(at + 48, plate_orientation_deg, true);
  writeF64s(view, at + 56, "plate_position_m", plate_position_m, 3);
  writeF64s(view, at + 80, "plate_rotation", plate_rotation, 4);
}

export class Command {
  flags = 0;
  step = 0;
  plate_orientation_deg = 0;
  finger_direction_deg = 0;
  perceived_direction_deg = 0;
  aimed_direction_deg = 0;
  distance_to_go_m = 0;
  tactile_weight = 0;
  tactile_weight_sd = 0;
  time_to_go_s = 0;
  felt_error_deg = 0;
  predicted_miss_deg = 0;
  normalised_innovation = 0;
  bearing_error_sd_deg = 0;
  constructor() { Object.preventExtensions(this); }
}

export function readCommand(view, at, into) {
  into.flags = view.getUint32(at + 4, true);
  into.step = readI64(view, at + 8);
  into.plate_orientation_deg = view.getFloat64(at + 16, true);
  into.finger_direction_deg = view.getFloat64(at + 24, true);
  into.perceived_direction_deg = view.getFloat64(at + 32, true);
  into.aimed_direction_deg = view.getFloat64(at + 40, true);
  into.distance_to_go_m = view.getFloat64(at + 48, true);
  into.tactile_weight = view.getFloat64(at + 56, true);
  into.tactile_weight_sd = view.getFloat64(at + 64, true);
  into.time_to_go_s = view.getFloat64(at + 72, true);
  into.felt_error_deg = view.getFloat64(at + 80, true);
  into.predicted_miss_deg = view.getFloat64(at + 88, true);
  into.normalised_innovation = view.getFloat64(at + 96, true);
  into.bearing_error_sd_deg = view.getFloat64(at + 104, true);
}
