// Written by plugin/bindings/generate from the C headers.
/** Version of these headers; hrt_get_version() tells that of the library. */
export declare const HRT_VERSION_MAJOR = 0;
export declare const HRT_VERSION_MINOR = 2;
export declare const HRT_VERSION_PATCH = 0;
export declare const HRT_OK = 0;
/** A pointer that must not be null was null. */
export declare const HRT_ERROR_NULL_ARGUMENT = -1;
/** The handle or id is null, was never given out, is of another session, or of something destroyed. */
export declare const HRT_ERROR_INVALID_HANDLE = -2;
/** `struct_size` is below the first version's, or bytes beyond what this library knows are not zero. */
export declare const HRT_ERROR_STRUCT_SIZE = -3;
/** A value is outside its documented range, not a number, or infinite. */
export declare const HRT_ERROR_OUT_OF_RANGE = -4;
/** Not now: for example an update without a reach, or a new configuration during one. */
export declare const HRT_ERROR_WRONG_STATE = -5;
/** Another thread is in a call on this session. */
export declare const HRT_ERROR_BUSY = -6;
/** The sample's time is before that of the sample before it. */
export declare const HRT_ERROR_TIME_REVERSED = -7;
export declare const HRT_ERROR_OUT_OF_MEMORY = -8;
/** There are as many of these as there can be. */
export declare const HRT_ERROR_LIMIT_REACHED = -9;
/** Nothing has this name. */
export declare const HRT_ERROR_NOT_FOUND = -10;
/** The caller's buffer cannot hold the answer. */
export declare const HRT_ERROR_BUFFER_TOO_SMALL = -11;
/** Another target of this session has this name. */
export declare const HRT_ERROR_NAME_TAKEN = -12;
/** The operating system refused: a file, a thread. */
export declare const HRT_ERROR_SYSTEM = -13;
/** A text is not what it should be; hrt_last_error() tells where. */
export declare const HRT_ERROR_BAD_FORMAT = -14;
/** The data do not tell what was asked of them; hrt_last_error() tells what is missing. */
export declare const HRT_ERROR_INSUFFICIENT_DATA = -15;
/** A defect in this library; please report it with the text of hrt_last_error(). */
export declare const HRT_ERROR_INTERNAL = -99;
/** Calibrations that can exist at the same time in a process. */
export declare const HRT_CALIBRATIONS_MAX = 16;
/** hrt_log_callback: how bad it is. */
export declare const HRT_LOG_WARNING = 1;
export declare const HRT_LOG_ERROR = 2;

/** hrt_reach_config::flags. */
/** `plate_orientation_deg` is given; without this the plate is where the session's last command left it (at first 0). */
export declare const HRT_REACH_PLATE_ORIENTATION = 1;

/** hrt_sample::flags: which fields hold something. Of DIRECTION, PLATE_POSITION and WORLD_POSITION at most one may be given. With none of them, nor LIFTED, the sample is a dropout: the plate is held, and the model predicts until the finger is seen again. */
/** finger_direction_deg */
export declare const HRT_SAMPLE_DIRECTION = 1;
/** finger_position_m, in plate coordinates */
export declare const HRT_SAMPLE_PLATE_POSITION = 2;
/** plate_orientation_deg, measured by the device */
export declare const HRT_SAMPLE_PLATE_ORIENTATION = 4;
/** The finger is off the plate, and so feels nothing: the model waits. */
export declare const HRT_SAMPLE_LIFTED = 8;
/** finger_position_m, in the engine's world */
export declare const HRT_SAMPLE_WORLD_POSITION = 16;
/** plate_position_m and plate_rotation: the plate has moved in the world; else it is where the session's configuration has it. Goes with WORLD_POSITION. */
export declare const HRT_SAMPLE_PLATE_POSE = 32;

/** hrt_command::flags. */
/** between steps: nothing new was decided in this call */
export declare const HRT_COMMAND_HELD = 1;
/** the last step had no direction and was predicted */
export declare const HRT_COMMAND_PREDICTED = 2;
/** the plate's bound or a stop holds the command */
export declare const HRT_COMMAND_SATURATED = 4;
/** the plate's speed holds the command */
export declare const HRT_COMMAND_RATE_LIMITED = 8;
/** the real direction cannot be held: see authority.h */
export declare const HRT_COMMAND_UNREACHABLE = 16;
/** the finger is above the plate: the model waits */
export declare const HRT_COMMAND_LIFTED = 32;
/** the finger is beyond the plate's edge */
export declare const HRT_COMMAND_OFF_PLATE = 64;
/** Scenes that can be loaded at the same time in a process. */
export declare const HRT_SCENES_MAX = 64;
/** Sessions that can exist at the same time in a process. */
export declare const HRT_SESSIONS_MAX = 64;

/** What decides the plate's orientation. */
/** the model-predictive controller */
export declare const HRT_CONTROL_MPC = 0;
/** none, as a baseline: the plate stays where it is told to */
export declare const HRT_CONTROL_FIXED_PLATE = 1;

/** Where the finger is wanted. */
/** in the real target's direction from the start */
export declare const HRT_GUIDANCE_FIXED_DIRECTION = 0;
/** In the direction from where the finger is to where the real target is, held once less than a fifth of the path remains. Takes effect when positions are streamed; with directions alone it is as above. */
export declare const HRT_GUIDANCE_LINE_OF_SIGHT = 1;

/** Whether the user's share of touch and motor variance are learnt. */
/** no: they are taken as known */
export declare const HRT_ADAPTATION_OFF = 0;
/** The share of touch within each reach, from tactile_weight and its deviation. The reach's summary also tells the motor variance, from motor_variance_deg2 and its deviation. */
export declare const HRT_ADAPTATION_REACH = 1;
/** As REACH; and what a reach has learnt becomes the configuration's: tactile_weight and tactile_weight_sd, the latter no less than 0.01, and motor_variance_deg2 and motor_variance_sd_deg2, the latter no less than 0.1, as people change. One reach changes the motor variance by a factor of two at most, in which case its deviation stays; it is kept within 0.05 to 5. */
export declare const HRT_ADAPTATION_CARRIED = 2;
/** Targets that a session can hold. */
export declare const HRT_TARGETS_MAX = 1000000;
/** Bytes of a name, with its terminating zero. */
export declare const HRT_NAME_SIZE = 64;
/** What a target is. */
export declare const HRT_TARGET_REAL = 1;
export declare const HRT_TARGET_VIRTUAL = 2;

/** How a target's place is given. */
/** by `direction_deg` and `distance_m` */
export declare const HRT_PLACE_DIRECTION = 1;
/** by `position_m` in plate coordinates */
export declare const HRT_PLACE_PLATE_POSITION = 2;
/** By `position_m` in the engine's world; see hrt_session_config::plate_position_m. */
export declare const HRT_PLACE_WORLD_POSITION = 3;

export interface FieldPlace {
  readonly offset: number;
  /** Or the name of a struct. A handle is its u64. */
  readonly type: "u8" | "i32" | "u32" | "i64" | "u64" | "f64" | "pointer" | string;
  readonly length?: number;
}

export interface StructLayout<Field extends string> {
  readonly size: number;
  readonly fields: Readonly<Record<Field, FieldPlace>>;
}

export declare const structs: {
  readonly hrt_session: StructLayout<"value">;
  readonly hrt_session_config: StructLayout<"struct_size" | "horizon" | "step_period_ns" | "control" | "guidance" | "adaptation" | "reserved" | "perceived_weight" | "actual_weight" | "plate_bound_deg" | "plate_max_speed_deg_s" | "plate_max_acceleration_deg_s2" | "plate_latency_ns" | "plate_lower_stop_deg" | "plate_upper_stop_deg" | "fixed_plate_orientation_deg" | "tactile_weight" | "tactile_weight_sd" | "motor_variance_deg2" | "sensory_variance_deg2" | "initial_variance_deg2" | "tracker_noise_m" | "start_position_m" | "plate_radius_m" | "lift_height_m" | "plate_position_m" | "plate_rotation" | "bias_deg" | "motor_variance_sd_deg2">;
  readonly hrt_target: StructLayout<"value">;
  readonly hrt_target_config: StructLayout<"struct_size" | "role" | "place" | "reserved" | "direction_deg" | "distance_m" | "position_m" | "name">;
  readonly hrt_authority: StructLayout<"struct_size" | "reachable" | "real_target" | "virtual_target" | "gap_deg" | "largest_gap_deg" | "margin_deg" | "plate_orientation_deg" | "settling_direction_deg">;
  readonly hrt_reach_config: StructLayout<"struct_size" | "flags" | "real_target" | "virtual_target" | "plate_orientation_deg">;
  readonly hrt_sample: StructLayout<"struct_size" | "flags" | "time_ns" | "finger_direction_deg" | "finger_position_m" | "plate_orientation_deg" | "plate_position_m" | "plate_rotation">;
  readonly hrt_command: StructLayout<"struct_size" | "flags" | "step" | "plate_orientation_deg" | "finger_direction_deg" | "perceived_direction_deg" | "aimed_direction_deg" | "distance_to_go_m" | "tactile_weight" | "tactile_weight_sd">;
  readonly hrt_reach_summary: StructLayout<"struct_size" | "reserved" | "samples" | "dropped_samples" | "steps" | "predicted_steps" | "saturated_steps" | "rate_limited_steps" | "final_direction_deg" | "final_miss_deg" | "perceived_direction_deg" | "perceived_error_deg" | "distance_to_target_m" | "tactile_weight" | "tactile_weight_sd" | "tracker_noise_m" | "motor_variance_deg2" | "motor_variance_sd_deg2">;
  readonly hrt_calibration: StructLayout<"value">;
  readonly hrt_calibration_config: StructLayout<"struct_size" | "max_trials" | "max_samples" | "reserved" | "goal_direction_deg">;
  readonly hrt_interval: StructLayout<"value" | "lower" | "upper" | "known" | "reserved">;
  readonly hrt_calibration_result: StructLayout<"struct_size" | "reserved" | "trials" | "trials_used" | "tactile_weight" | "bias_deg" | "motor_variance_deg2" | "sensory_variance_deg2" | "tracker_noise_m">;
  readonly hrt_allocator: StructLayout<"struct_size" | "reserved" | "context" | "allocate" | "release">;
  readonly hrt_recording_status: StructLayout<"struct_size" | "system_error" | "rows_written" | "rows_lost">;
  readonly hrt_replay_report: StructLayout<"struct_size" | "complete" | "rows" | "first_different_line" | "hash">;
  readonly hrt_scene: StructLayout<"value">;
  readonly hrt_scene_info: StructLayout<"struct_size" | "target_count" | "plate_position_m" | "plate_rotation" | "plate_radius_m" | "plate_max_speed_deg_s" | "start_position_m">;
  readonly hrt_scene_target: StructLayout<"struct_size" | "role" | "served_by" | "reserved" | "position_m" | "world_position_m" | "direction_deg" | "distance_m" | "radius_m" | "name">;
};

export declare const functions: readonly string[];

/** A session's handle. Zero is never a session. A handle of a destroyed session is never valid again. */
export interface hrt_session {
  value: bigint;
}

/** Everything that a session is made from. hrt_session_config_default() fills every field. */
export interface hrt_session_config {
  struct_size: number;
  /** Steps that the controller looks ahead, 1 to 50. Default 3. */
  horizon: number;
  /** Time of one step of the participant's model and of the controller, 1 ms to 10 s. Default 100 ms. */
  step_period_ns: bigint;
  /** HRT_CONTROL_*. Default HRT_CONTROL_MPC. */
  control: number;
  /** HRT_GUIDANCE_*. Default HRT_GUIDANCE_LINE_OF_SIGHT. */
  guidance: number;
  /** HRT_ADAPTATION_*. Default HRT_ADAPTATION_OFF. */
  adaptation: number;
  reserved: number;
  /** Weight of the perceived error in the controller's cost, 1e-6 to 1e6. Default 1. */
  perceived_weight: number;
  /** Weight of the actual error in the controller's cost, 0 to 1e6. Default 1. */
  actual_weight: number;
  /** The plate stays within this of the direction that the user goes for, the virtual target's and bias_deg, or of what feels the same; 0.1 to 90. Default 84.5. */
  plate_bound_deg: number;
  /** The plate's servo: its highest speed, 0 to 1e6 degrees a second; 0: no limit. Default 0. */
  plate_max_speed_deg_s: number;
  /** Its highest acceleration, 0 to 1e8 degrees a second squared; 0: no limit. Default 0. */
  plate_max_acceleration_deg_s2: number;
  /** The time from a command to the plate's first motion, 0 to 1 s and to 8 step periods. Default 0. */
  plate_latency_ns: bigint;
  /** The plate's stops, -3600 to 3600, the upper at least 180 above the lower; both 0: it turns freely. Default 0 and 0. */
  plate_lower_stop_deg: number;
  plate_upper_stop_deg: number;
  /** Where the plate stays under HRT_CONTROL_FIXED_PLATE, -180 to 180: there, or at what feels the same between the stops and is nearer to where it stands. Default 0. */
  fixed_plate_orientation_deg: number;
  /** Share of touch in the direction that the user feels, 0.001 to 0.499. Default 0.15. */
  tactile_weight: number;
  /** Standard deviation of that, for adaptation to start from, 0.001 to 0.49. Default 0.05. */
  tactile_weight_sd: number;
  /** Variance of the user's motor command per step, 1e-9 to 1e4. Default 0.5. */
  motor_variance_deg2: number;
  /** Variance of what the user feels per step, 1e-9 to 1e4. Default 0.1. */
  sensory_variance_deg2: number;
  /** Variance of the user's perceived direction before the first step, 0 to 1e4. Default 0. */
  initial_variance_deg2: number;
  /** White noise of each coordinate of a tracked position, standard deviation, 0 to 0.1; 0: learn it from the samples. Default 0. */
  tracker_noise_m: number;
  /** Where reaches start, in plate coordinates; target directions are measured from here, in the plane of the plate. Each within 1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the user. */
  start_position_m: number[];
  /** Beyond this from the plate's centre a position is off the plate, 0.001 to 1000. Default 0.075. */
  plate_radius_m: number;
  /** Higher than this above the plate a position is lifted, 0.0001 to 1000. Default 0.015. */
  lift_height_m: number;
  /** The plate's centre in the engine's world, each within 1000. Default (0, 0, 0). */
  plate_position_m: number[];
  /** How the plate's mount is turned in the world, as the unit quaternion x, y, z, w that takes plate coordinates to the world's axes. It does not turn with the ridges. Default (0, 0, 0, 1). */
  plate_rotation: number[];
  /** The user's own bias: how much further to the left than it is they take a virtual target to lie, -45 to 45. They go for its direction and this. Known from calibration.h, not learnt in reaches. Default 0. Since version 0.2. */
  bias_deg: number;
  /** Standard deviation of motor_variance_deg2, for adaptation to start from, 0.001 to 10. Default 0.5. Since version 0.2. */
  motor_variance_sd_deg2: number;
}

/** A target's id within its session. Zero is never a target. The id of a removed target is never valid again, in no session. */
export interface hrt_target {
  value: bigint;
}

/** A target. hrt_target_config_default() fills every field. Fields that `place` does not name are not read. */
export interface hrt_target_config {
  struct_size: number;
  /** HRT_TARGET_*. Default HRT_TARGET_REAL. */
  role: number;
  /** HRT_PLACE_*. Default HRT_PLACE_DIRECTION. */
  place: number;
  reserved: number;
  /** Direction from the start, -180 to 180. Default 0. */
  direction_deg: number;
  /** Distance from the start along the plate, 0.001 to 1000. Default 0.1. */
  distance_m: number;
  /** Place in plate coordinates or in the world, each within 1000; at least 1 mm from the start in the plane of the plate; the height y is kept and not used. Default (0, 0, 0). */
  position_m: number[];
  /** UTF-8, ended by a zero; unique within the session unless empty. Default empty. */
  name: string;
}

/** What can be held for one pair. Set `struct_size` before the call. */
export interface hrt_authority {
  struct_size: number;
  /** 1 if the finger can be held on the real target's direction, else 0. */
  reachable: number;
  real_target: bigint;
  virtual_target: bigint;
  /** Where the user goes, the virtual target's direction and hrt_session_config::bias_deg, less the real target's direction; in [-180, 180). */
  gap_deg: number;
  /** The largest gap, either way, that can be held with the session's tactile weight and plate bound. */
  largest_gap_deg: number;
  /** largest_gap_deg less the size of the gap; negative if out of reach. */
  margin_deg: number;
  /** Where the plate must stand to hold it; on its bound if out of reach. */
  plate_orientation_deg: number;
  /** Where the finger settles: the real target's direction if it can be held. */
  settling_direction_deg: number;
}

/** What a reach is. hrt_reach_config_default() fills every field. */
export interface hrt_reach_config {
  struct_size: number;
  /** HRT_REACH_*. Default 0. */
  flags: number;
  /** Its direction and the one that the user goes for, the virtual target's and hrt_session_config::bias_deg, are less than 90 degrees apart. Default null: to be set. */
  real_target: bigint;
  virtual_target: bigint;
  /** Where the plate stands before the reach, -3600 to 3600; beyond a stop means at the stop. Default 0. */
  plate_orientation_deg: number;
}

/** One sample of the tracked finger. Set it to zero, then `struct_size` and what is known. Fields that `flags` does not name are not read, whatever is in them. */
export interface hrt_sample {
  struct_size: number;
  /** HRT_SAMPLE_*. */
  flags: number;
  /** The caller's monotonic clock; any origin. Not before the last sample's; the same time again is taken. */
  time_ns: bigint;
  /** The direction in which the finger moves, -180 to 180; taken as exact. */
  finger_direction_deg: number;
  /** The fingertip, each within 1000. Of a tracked pose this is the position; how the finger is turned is not asked for. */
  finger_position_m: number[];
  /** Where the plate stands, -3600 to 3600. A plate without stops may count its turns as it likes: of the orientations that feel the same, the one nearest to where it is expected is taken. With stops it is taken as it is. */
  plate_orientation_deg: number;
  /** The plate in the world, as in hrt_session_config. */
  plate_position_m: number[];
  plate_rotation: number[];
}

/** What the plate is to do now, and why. Set `struct_size` before the call. */
export interface hrt_command {
  struct_size: number;
  /** HRT_COMMAND_*. */
  flags: number;
  /** The model step, from 0; -1 before the finger moves. */
  step: bigint;
  /** Turn the plate here. Ridges repeat every 180 degrees. If the session's configuration gives the plate no highest speed or acceleration, this is the nearest of the orientations that feel the same and lie between the stops. If it does, the plate keeps to one half turn for a whole reach, so that it swings round at the start or not at all; a command beyond a stop is held at the stop. */
  plate_orientation_deg: number;
  /** The finger's direction in the last step, observed or predicted. */
  finger_direction_deg: number;
  /** The direction that the user feels, as the model predicts it under this command. */
  perceived_direction_deg: number;
  /** Where the finger is wanted; see hrt_session_config::guidance. */
  aimed_direction_deg: number;
  /** Along the plate to the real target; from the start until a position is streamed. */
  distance_to_go_m: number;
  /** The share of touch that the controller assumes. */
  tactile_weight: number;
  /** Its standard deviation; 0: it is taken as known. */
  tactile_weight_sd: number;
}

/** What became of a reach. Set `struct_size` before the call. */
export interface hrt_reach_summary {
  struct_size: number;
  reserved: number;
  /** Samples taken in, and of these the dropouts and what was left out as an outlier. */
  samples: bigint;
  dropped_samples: bigint;
  /** Model steps with samples, and steps without, which were predicted. */
  steps: bigint;
  predicted_steps: bigint;
  /** Of the steps with samples, those whose command the plate's bound, a stop, or its speed held. */
  saturated_steps: bigint;
  rate_limited_steps: bigint;
  /** The finger's direction in the last step, and that less the real target's. */
  final_direction_deg: number;
  final_miss_deg: number;
  /** What the user felt in the last step, and that less where they went: the virtual target's direction and hrt_session_config::bias_deg. */
  perceived_direction_deg: number;
  perceived_error_deg: number;
  /** From the last position along the plate to the real target; from the start if none was streamed. */
  distance_to_target_m: number;
  /** What the controller assumed at the end; see hrt_command. */
  tactile_weight: number;
  tactile_weight_sd: number;
  /** White noise of each coordinate of the tracked positions, standard deviation, as learnt or configured. */
  tracker_noise_m: number;
  /** The user's motor variance as this reach corrects what the configuration assumes. Since version 0.2. */
  motor_variance_deg2: number;
  /** Its standard deviation; close to hrt_session_config::motor_variance_sd_deg2 if the reach could not tell; 0: it is taken as known. Since version 0.2. */
  motor_variance_sd_deg2: number;
}

/** A calibration's handle. Zero is never a calibration. A handle of a destroyed one is never valid again. */
export interface hrt_calibration {
  value: bigint;
}

/** What a calibration is. hrt_calibration_config_default() fills every field. */
export interface hrt_calibration_config {
  struct_size: number;
  /** Trials that it can hold, 10 to 10000. Default 200. */
  max_trials: number;
  /** Samples that all trials together can hold, 100 to 1000000; 24 bytes each, taken at creation. Default 100000: 18 minutes at 90 Hz. */
  max_samples: number;
  reserved: number;
  /** Where the user is told to go, -180 to 180. Default 0: straight ahead. */
  goal_direction_deg: number;
}

/** An estimate with the ends of its 95 % interval. This struct never grows. */
export interface hrt_interval {
  value: number;
  lower: number;
  upper: number;
  /** 1, or 0: the data can't tell. Then the interval is what was searched, and the value no more than its likeliest point. */
  known: number;
  reserved: number;
}

/** What the slides tell of the user. The fields are those of hrt_session_config. Set `struct_size` before the call. */
export interface hrt_calibration_result {
  struct_size: number;
  reserved: number;
  /** Trials that were ended, and of these the ones with a slide of 30 mm or more, which alone count. */
  trials: number;
  trials_used: number;
  /** Always known; otherwise hrt_calibration_solve() refuses. */
  tactile_weight: hrt_interval;
  /** Always known. */
  bias_deg: hrt_interval;
  /** Known if the tracker is good enough to show it; one with 1.2 mm of noise hardly is. */
  motor_variance_deg2: hrt_interval;
  /** As motor_variance_deg2. */
  sensory_variance_deg2: hrt_interval;
  /** Always known. */
  tracker_noise_m: hrt_interval;
}

/** Where the library's memory comes from. The functions may be called from any thread, at the same time; they must not call this library, and must not throw. */
export interface hrt_allocator {
  struct_size: number;
  reserved: number;
  /** Passed to both functions; never read. */
  context: number;
  /** Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null if it can't. */
  allocate: number;
  /** Takes back what allocate() returned. */
  release: number;
}

/** How a recording does. Set `struct_size` before the call. */
export interface hrt_recording_status {
  struct_size: number;
  /** The errno of the first write that failed, after which nothing more is written; 0: none did. */
  system_error: number;
  /** Calls recorded, as far as the operating system has taken them. */
  rows_written: bigint;
  /** Calls that are not in the file, because the disk was too slow or failed. 0 at the end: it is complete. */
  rows_lost: bigint;
}

/** What a replay found. Set `struct_size` before the call. */
export interface hrt_replay_report {
  struct_size: number;
  /** 1 if the recording is whole: it has its end, and no rows were lost; else 0, and what precedes the gap was replayed. */
  complete: number;
  /** Rows replayed. */
  rows: bigint;
  /** The line of the file, from 1, of the first row that came out otherwise than recorded, in its result or any number; 0: all came out the same, bit for bit. */
  first_different_line: bigint;
  /** FNV-1a of the commands as replayed, which is the same on every host: of each row "update" without error, flags as 8 bytes, step, and the seven numbers after them, least significant byte first. */
  hash: bigint;
}

/** A scene's handle. Zero is never a scene. A handle of a destroyed scene is never valid again. */
export interface hrt_scene {
  value: bigint;
}

/** The plate of a scene. Set `struct_size` before the call. */
export interface hrt_scene_info {
  struct_size: number;
  /** How many targets the scene has, real and virtual. */
  target_count: number;
  /** The plate in the world, as in hrt_session_config. */
  plate_position_m: number[];
  plate_rotation: number[];
  plate_radius_m: number;
  /** Of the plate's servo; 0 if the file does not tell. */
  plate_max_speed_deg_s: number;
  /** In plate coordinates. */
  start_position_m: number[];
}

/** A target of a scene. Set `struct_size` before the call. */
export interface hrt_scene_target {
  struct_size: number;
  /** HRT_TARGET_*. */
  role: number;
  /** Of a virtual target: the index of the real one that serves it; of a real one -1. */
  served_by: number;
  reserved: number;
  /** In plate coordinates; y is the height above the plate. */
  position_m: number[];
  world_position_m: number[];
  /** Seen from the start, along the plate. */
  direction_deg: number;
  distance_m: number;
  /** 0 if the file does not tell. */
  radius_m: number;
  name: string;
}
