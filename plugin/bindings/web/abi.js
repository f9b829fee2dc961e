// Written by plugin/bindings/generate from the C headers.
export const HRT_ASSIGN_EXCLUSIVE = 1;
export const HRT_ASSIGN_TARGETS_MAX = 1000;
export const HRT_VERSION_MAJOR = 0;
export const HRT_VERSION_MINOR = 3;
export const HRT_VERSION_PATCH = 0;
export const HRT_OK = 0;
export const HRT_ERROR_NULL_ARGUMENT = -1;
export const HRT_ERROR_INVALID_HANDLE = -2;
export const HRT_ERROR_STRUCT_SIZE = -3;
export const HRT_ERROR_OUT_OF_RANGE = -4;
export const HRT_ERROR_WRONG_STATE = -5;
export const HRT_ERROR_BUSY = -6;
export const HRT_ERROR_TIME_REVERSED = -7;
export const HRT_ERROR_OUT_OF_MEMORY = -8;
export const HRT_ERROR_LIMIT_REACHED = -9;
export const HRT_ERROR_NOT_FOUND = -10;
export const HRT_ERROR_BUFFER_TOO_SMALL = -11;
export const HRT_ERROR_NAME_TAKEN = -12;
export const HRT_ERROR_SYSTEM = -13;
export const HRT_ERROR_BAD_FORMAT = -14;
export const HRT_ERROR_INSUFFICIENT_DATA = -15;
export const HRT_ERROR_INTERNAL = -99;
export const HRT_CALIBRATIONS_MAX = 16;
export const HRT_ILLUSION_LINEAR = 0;
export const HRT_ILLUSION_SATURATING = 1;
export const HRT_ILLUSION_SINE = 2;
export const HRT_ILLUSION_TANH = 3;
export const HRT_ILLUSION_DEAD_BAND = 4;
export const HRT_ILLUSION_UNEQUAL = 5;
export const HRT_ILLUSION_CUBIC = 6;
export const HRT_ILLUSION_NONE = 7;
export const HRT_LACK_OF_FIT_ANGLE = 1;
export const HRT_LACK_OF_FIT_ORDER = 2;
export const HRT_LACK_OF_FIT_PATH = 4;
export const HRT_SLIDE_USED = 0;
export const HRT_SLIDE_OUTLYING = 1;
export const HRT_SLIDE_ALONG_RIDGES = 2;
export const HRT_DIFFERS_TACTILE_WEIGHT = 1;
export const HRT_DIFFERS_MAX_GAP = 2;
export const HRT_DIFFERS_BIAS = 4;
export const HRT_DIFFERS_HABIT = 8;
export const HRT_DIFFERS_TRACKER_NOISE = 16;
export const HRT_DIFFERS_STEERING_RATE = 32;
export const HRT_DIFFERS_STEERING_DELAY = 64;
export const HRT_LOG_WARNING = 1;
export const HRT_LOG_ERROR = 2;
export const HRT_CONDITION_PLATE = 1;
export const HRT_CONDITION_TRACKER = 2;
export const HRT_REACH_PLATE_ORIENTATION = 1;
export const HRT_REACH_START_AT_FINGER = 2;
export const HRT_SAMPLE_DIRECTION = 1;
export const HRT_SAMPLE_PLATE_POSITION = 2;
export const HRT_SAMPLE_PLATE_ORIENTATION = 4;
export const HRT_SAMPLE_LIFTED = 8;
export const HRT_SAMPLE_WORLD_POSITION = 16;
export const HRT_SAMPLE_PLATE_POSE = 32;
export const HRT_COMMAND_HELD = 1;
export const HRT_COMMAND_PREDICTED = 2;
export const HRT_COMMAND_SATURATED = 4;
export const HRT_COMMAND_RATE_LIMITED = 8;
export const HRT_COMMAND_UNREACHABLE = 16;
export const HRT_COMMAND_LIFTED = 32;
export const HRT_COMMAND_OFF_PLATE = 64;
export const HRT_COMMAND_MISFIT = 128;
export const HRT_COMMAND_OFF_TARGET = 256;
export const HRT_COMMAND_RESTING = 512;
export const HRT_COMMAND_APPROXIMATE = 1024;
export const HRT_COMMAND_FAULT = 2048;
export const HRT_COMMAND_REGISTRATION = 4096;
export const HRT_ENDING_COMPLETE = 0;
export const HRT_ENDING_CUT = 1;
export const HRT_ENDING_LOST_ROWS = 2;
export const HRT_ENDING_ALTERED = 3;
export const HRT_TOUCHES_MAX = 1000;
export const HRT_REGISTER_SCALE = 1;
export const HRT_REGISTER_UP = 2;
export const HRT_REGISTRATION_HOLDS = 1;
export const HRT_REGISTRATION_TOO_FEW = 2;
export const HRT_REGISTRATION_DEGENERATE = 3;
export const HRT_REGISTRATION_INCONSISTENT = 4;
export const HRT_REGISTRATION_UPSIDE_DOWN = 5;
export const HRT_POSE_COVARIANCES = 28;
export const HRT_LATENCY_SAMPLES_MAX = 100000;
export const HRT_SCENES_MAX = 64;
export const HRT_SESSIONS_MAX = 1024;
export const HRT_CONTROL_MPC = 0;
export const HRT_CONTROL_FIXED_PLATE = 1;
export const HRT_GUIDANCE_FIXED_DIRECTION = 0;
export const HRT_GUIDANCE_ARRIVAL = 1;
export const HRT_GUIDANCE_LINE_OF_SIGHT = 1;
export const HRT_ADAPTATION_OFF = 0;
export const HRT_ADAPTATION_REACH = 1;
export const HRT_ADAPTATION_CARRIED = 2;
export const HRT_SESSION_PLATE_WAITS = 1;
export const HRT_SESSION_REGISTERED = 2;
export const HRT_PERSON_WEIGHT = 0;
export const HRT_PERSON_CURVE = 1;
export const HRT_PERSON_GAIN = 2;
export const HRT_PERSON_BIAS = 3;
export const HRT_PERSON_HABIT = 4;
export const HRT_PERSON_EVENNESS = 5;
export const HRT_PERSON_HEADING = 6;
export const HRT_PERSON_LOG_RATE = 7;
export const HRT_PERSON_FADING = 8;
export const HRT_PERSON_TRAITS = 9;
export const HRT_PERSON_COVARIANCES = 45;
export const HRT_STATE_READY = 1;
export const HRT_STATE_REACHING = 2;
export const HRT_STATE_CALIBRATING = 4;
export const HRT_STATE_RECORDING = 8;
export const HRT_TARGETS_MAX = 1000000;
export const HRT_NAME_SIZE = 64;
export const HRT_TARGET_REAL = 1;
export const HRT_TARGET_VIRTUAL = 2;
export const HRT_PLACE_DIRECTION = 1;
export const HRT_PLACE_PLATE_POSITION = 2;
export const HRT_PLACE_WORLD_POSITION = 3;

// Where each field of a struct is, in bytes; `length` of a fixed array. i64 and u64 are BigInt.
export const structs = Object.freeze({
  hrt_allocator: { size: 20, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    reserved: {"offset": 4, "type": "u32"},
    context: {"offset": 8, "type": "pointer"},
    allocate: {"offset": 12, "type": "pointer"},
    release: {"offset": 16, "type": "pointer"},
  } },
  hrt_session: { size: 8, fields: {
    value: {"offset": 0, "type": "u64"},
  } },
  hrt_session_config: { size: 832, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    horizon: {"offset": 4, "type": "u32"},
    step_period_ns: {"offset": 8, "type": "i64"},
    control: {"offset": 16, "type": "u32"},
    guidance: {"offset": 20, "type": "u32"},
    adaptation: {"offset": 24, "type": "u32"},
    flags: {"offset": 28, "type": "u32"},
    perceived_weight: {"offset": 32, "type": "f64"},
    actual_weight: {"offset": 40, "type": "f64"},
    plate_bound_deg: {"offset": 48, "type": "f64"},
    plate_max_speed_deg_s: {"offset": 56, "type": "f64"},
    plate_max_acceleration_deg_s2: {"offset": 64, "type": "f64"},
    plate_latency_ns: {"offset": 72, "type": "i64"},
    plate_lower_stop_deg: {"offset": 80, "type": "f64"},
    plate_upper_stop_deg: {"offset": 88, "type": "f64"},
    fixed_plate_orientation_deg: {"offset": 96, "type": "f64"},
    tactile_weight: {"offset": 104, "type": "f64"},
    tactile_weight_sd: {"offset": 112, "type": "f64"},
    motor_variance_deg2: {"offset": 120, "type": "f64"},
    sensory_variance_deg2: {"offset": 128, "type": "f64"},
    initial_variance_deg2: {"offset": 136, "type": "f64"},
    tracker_noise_m: {"offset": 144, "type": "f64"},
    start_position_m: {"offset": 152, "type": "f64", "length": 3},
    plate_radius_m: {"offset": 176, "type": "f64"},
    lift_height_m: {"offset": 184, "type": "f64"},
    plate_position_m: {"offset": 192, "type": "f64", "length": 3},
    plate_rotation: {"offset": 216, "type": "f64", "length": 4},
    bias_deg: {"offset": 248, "type": "f64"},
    motor_variance_sd_deg2: {"offset": 256, "type": "f64"},
    max_felt_error_deg: {"offset": 264, "type": "f64"},
    motion_bound_deg: {"offset": 272, "type": "f64"},
    tracker_latency_ns: {"offset": 280, "type": "i64"},
    person_mean: {"offset": 288, "type": "f64", "length": 9},
    person_covariance: {"offset": 360, "type": "f64", "length": 45},
    plate_scale: {"offset": 720, "type": "f64"},
    plate_covariance: {"offset": 728, "type": "f64", "length": 6},
    registration_time_ns: {"offset": 776, "type": "i64"},
    max_registration_age_ns: {"offset": 784, "type": "i64"},
    max_registration_sd_deg: {"offset": 792, "type": "f64"},
    tracker_correlated_noise_m: {"offset": 800, "type": "f64"},
    tracker_correlation_s: {"offset": 808, "type": "f64"},
    steering_rate_per_s: {"offset": 816, "type": "f64"},
    steering_delay_s: {"offset": 824, "type": "f64"},
  } },
  hrt_target: { size: 8, fields: {
    value: {"offset": 0, "type": "u64"},
  } },
  hrt_target_config: { size: 120, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    role: {"offset": 4, "type": "u32"},
    place: {"offset": 8, "type": "u32"},
    reserved: {"offset": 12, "type": "u32"},
    direction_deg: {"offset": 16, "type": "f64"},
    distance_m: {"offset": 24, "type": "f64"},
    position_m: {"offset": 32, "type": "f64", "length": 3},
    name: {"offset": 56, "type": "u8", "length": 64},
  } },
  hrt_authority: { size: 72, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    reachable: {"offset": 4, "type": "u32"},
    real_target: {"offset": 8, "type": "u64"},
    virtual_target: {"offset": 16, "type": "u64"},
    gap_deg: {"offset": 24, "type": "f64"},
    max_gap_deg: {"offset": 32, "type": "f64"},
    margin_deg: {"offset": 40, "type": "f64"},
    plate_orientation_deg: {"offset": 48, "type": "f64"},
    settling_direction_deg: {"offset": 56, "type": "f64"},
    paper_max_gap_deg: {"offset": 64, "type": "f64"},
  } },
  hrt_reach_config: { size: 40, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    flags: {"offset": 4, "type": "u32"},
    real_target: {"offset": 8, "type": "u64"},
    virtual_target: {"offset": 16, "type": "u64"},
    plate_orientation_deg: {"offset": 24, "type": "f64"},
    duration_s: {"offset": 32, "type": "f64"},
  } },
  hrt_sample: { size: 112, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    flags: {"offset": 4, "type": "u32"},
    time_ns: {"offset": 8, "type": "i64"},
    finger_direction_deg: {"offset": 16, "type": "f64"},
    finger_position_m: {"offset": 24, "type": "f64", "length": 3},
    plate_orientation_deg: {"offset": 48, "type": "f64"},
    plate_position_m: {"offset": 56, "type": "f64", "length": 3},
    plate_rotation: {"offset": 80, "type": "f64", "length": 4},
  } },
  hrt_command: { size: 112, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    flags: {"offset": 4, "type": "u32"},
    step: {"offset": 8, "type": "i64"},
    plate_orientation_deg: {"offset": 16, "type": "f64"},
    finger_direction_deg: {"offset": 24, "type": "f64"},
    perceived_direction_deg: {"offset": 32, "type": "f64"},
    aimed_direction_deg: {"offset": 40, "type": "f64"},
    distance_to_go_m: {"offset": 48, "type": "f64"},
    tactile_weight: {"offset": 56, "type": "f64"},
    tactile_weight_sd: {"offset": 64, "type": "f64"},
    time_to_go_s: {"offset": 72, "type": "f64"},
    felt_error_deg: {"offset": 80, "type": "f64"},
    predicted_miss_deg: {"offset": 88, "type": "f64"},
    normalised_innovation: {"offset": 96, "type": "f64"},
    bearing_error_sd_deg: {"offset": 104, "type": "f64"},
  } },
  hrt_reach_summary: { size: 248, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    flags: {"offset": 4, "type": "u32"},
    samples: {"offset": 8, "type": "i64"},
    dropped_samples: {"offset": 16, "type": "i64"},
    steps: {"offset": 24, "type": "i64"},
    predicted_steps: {"offset": 32, "type": "i64"},
    saturated_steps: {"offset": 40, "type": "i64"},
    rate_limited_steps: {"offset": 48, "type": "i64"},
    final_direction_deg: {"offset": 56, "type": "f64"},
    final_miss_deg: {"offset": 64, "type": "f64"},
    perceived_direction_deg: {"offset": 72, "type": "f64"},
    perceived_error_deg: {"offset": 80, "type": "f64"},
    distance_to_target_m: {"offset": 88, "type": "f64"},
    tactile_weight: {"offset": 96, "type": "f64"},
    tactile_weight_sd: {"offset": 104, "type": "f64"},
    tracker_noise_m: {"offset": 112, "type": "f64"},
    motor_variance_deg2: {"offset": 120, "type": "f64"},
    motor_variance_sd_deg2: {"offset": 128, "type": "f64"},
    bearing_error_deg: {"offset": 136, "type": "f64"},
    peak_felt_error_deg: {"offset": 144, "type": "f64"},
    rms_felt_error_deg: {"offset": 152, "type": "f64"},
    normalised_innovation: {"offset": 160, "type": "f64"},
    illusion_curve: {"offset": 168, "type": "f64"},
    illusion_curve_sd: {"offset": 176, "type": "f64"},
    gain_per_s: {"offset": 184, "type": "f64"},
    gain_sd_per_s: {"offset": 192, "type": "f64"},
    bias_deg: {"offset": 200, "type": "f64"},
    bias_sd_deg: {"offset": 208, "type": "f64"},
    habit_deg: {"offset": 216, "type": "f64"},
    habit_sd_deg: {"offset": 224, "type": "f64"},
    duration_s: {"offset": 232, "type": "f64"},
    bearing_error_sd_deg: {"offset": 240, "type": "f64"},
  } },
  hrt_calibration: { size: 8, fields: {
    value: {"offset": 0, "type": "u64"},
  } },
  hrt_calibration_config: { size: 48, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    max_trials: {"offset": 4, "type": "u32"},
    max_samples: {"offset": 8, "type": "u32"},
    reserved: {"offset": 12, "type": "u32"},
    goal_direction_deg: {"offset": 16, "type": "f64"},
    lower_plate_deg: {"offset": 24, "type": "f64"},
    upper_plate_deg: {"offset": 32, "type": "f64"},
    enough_weight_width: {"offset": 40, "type": "f64"},
  } },
  hrt_interval: { size: 32, fields: {
    value: {"offset": 0, "type": "f64"},
    lower: {"offset": 8, "type": "f64"},
    upper: {"offset": 16, "type": "f64"},
    known: {"offset": 24, "type": "u32"},
    reserved: {"offset": 28, "type": "u32"},
  } },
  hrt_calibration_result: { size: 504, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    slides_turning: {"offset": 4, "type": "u32"},
    trials: {"offset": 8, "type": "u32"},
    trials_used: {"offset": 12, "type": "u32"},
    tactile_weight: {"offset": 16, "type": "hrt_interval"},
    bias_deg: {"offset": 48, "type": "hrt_interval"},
    motor_variance_deg2: {"offset": 80, "type": "hrt_interval"},
    sensory_variance_deg2: {"offset": 112, "type": "hrt_interval"},
    tracker_noise_m: {"offset": 144, "type": "hrt_interval"},
    illusion: {"offset": 176, "type": "u32"},
    lack_of_fit: {"offset": 180, "type": "u32"},
    slides_outlying: {"offset": 184, "type": "u32"},
    slides_along_ridges: {"offset": 188, "type": "u32"},
    illusion_scale_deg: {"offset": 192, "type": "f64"},
    peak_offset_deg: {"offset": 200, "type": "f64"},
    person_weight: {"offset": 208, "type": "hrt_interval"},
    person_curve: {"offset": 240, "type": "hrt_interval"},
    weight_curve_correlation: {"offset": 272, "type": "f64"},
    max_gap_deg: {"offset": 280, "type": "hrt_interval"},
    habit_deg: {"offset": 312, "type": "hrt_interval"},
    correlated_noise_m: {"offset": 344, "type": "hrt_interval"},
    noise_correlation_s: {"offset": 376, "type": "hrt_interval"},
    angle_p: {"offset": 408, "type": "f64"},
    order_p: {"offset": 416, "type": "f64"},
    path_p: {"offset": 424, "type": "f64"},
    steering_rate_per_s: {"offset": 432, "type": "hrt_interval"},
    steering_delay_s: {"offset": 464, "type": "hrt_interval"},
    steering_p: {"offset": 496, "type": "f64"},
  } },
  hrt_calibration_slide: { size: 48, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    verdict: {"offset": 4, "type": "u32"},
    trial: {"offset": 8, "type": "u32"},
    reserved: {"offset": 12, "type": "u32"},
    plate_deg: {"offset": 16, "type": "f64"},
    direction_deg: {"offset": 24, "type": "f64"},
    fitted_deg: {"offset": 32, "type": "f64"},
    residual_deg: {"offset": 40, "type": "f64"},
  } },
  hrt_calibration_comparison: { size: 232, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    differing: {"offset": 4, "type": "u32"},
    tactile_weight: {"offset": 8, "type": "hrt_interval"},
    max_gap_deg: {"offset": 40, "type": "hrt_interval"},
    bias_deg: {"offset": 72, "type": "hrt_interval"},
    habit_deg: {"offset": 104, "type": "hrt_interval"},
    tracker_noise_m: {"offset": 136, "type": "hrt_interval"},
    steering_rate_per_s: {"offset": 168, "type": "hrt_interval"},
    steering_delay_s: {"offset": 200, "type": "hrt_interval"},
  } },
  hrt_conditions: { size: 144, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    differing: {"offset": 4, "type": "u32"},
    time_s: {"offset": 8, "type": "i64"},
    plate: {"offset": 16, "type": "u8", "length": 64},
    tracker: {"offset": 80, "type": "u8", "length": 64},
  } },
  hrt_recording_status: { size: 24, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    system_error: {"offset": 4, "type": "i32"},
    rows_written: {"offset": 8, "type": "u64"},
    rows_lost: {"offset": 16, "type": "u64"},
  } },
  hrt_replay_report: { size: 40, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    complete: {"offset": 4, "type": "u32"},
    rows: {"offset": 8, "type": "u64"},
    first_different_line: {"offset": 16, "type": "u64"},
    hash: {"offset": 24, "type": "u64"},
    ending: {"offset": 32, "type": "u32"},
    reserved: {"offset": 36, "type": "u32"},
  } },
  hrt_mark_touch: { size: 48, fields: {
    mark_m: {"offset": 0, "type": "f64", "length": 3},
    touched_m: {"offset": 24, "type": "f64", "length": 3},
  } },
  hrt_registration_config: { size: 40, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    flags: {"offset": 4, "type": "u32"},
    touch_sd_m: {"offset": 8, "type": "f64"},
    up: {"offset": 16, "type": "f64", "length": 3},
  } },
  hrt_registration: { size: 328, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    verdict: {"offset": 4, "type": "u32"},
    touches: {"offset": 8, "type": "u32"},
    left_out: {"offset": 12, "type": "i32"},
    plate_position_m: {"offset": 16, "type": "f64", "length": 3},
    plate_rotation: {"offset": 40, "type": "f64", "length": 4},
    plate_scale: {"offset": 72, "type": "f64"},
    covariance: {"offset": 80, "type": "f64", "length": 28},
    touch_sd_m: {"offset": 304, "type": "f64"},
    residual_m: {"offset": 312, "type": "f64"},
    turn_sd_deg: {"offset": 320, "type": "f64"},
  } },
  hrt_touch_check: { size: 24, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    holds: {"offset": 4, "type": "u32"},
    distance_m: {"offset": 8, "type": "f64"},
    allowed_m: {"offset": 16, "type": "f64"},
  } },
  hrt_joint_touch: { size: 56, fields: {
    position_m: {"offset": 0, "type": "f64", "length": 3},
    rotation: {"offset": 24, "type": "f64", "length": 4},
  } },
  hrt_fingertip: { size: 56, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    known: {"offset": 4, "type": "u32"},
    offset_m: {"offset": 8, "type": "f64", "length": 3},
    sd_m: {"offset": 32, "type": "f64", "length": 3},
  } },
  hrt_latency: { size: 48, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    known: {"offset": 4, "type": "u32"},
    latency_ns: {"offset": 8, "type": "i64"},
    lower_ns: {"offset": 16, "type": "i64"},
    upper_ns: {"offset": 24, "type": "i64"},
    residual_m: {"offset": 32, "type": "f64"},
    radius_m: {"offset": 40, "type": "f64"},
  } },
  hrt_scene: { size: 8, fields: {
    value: {"offset": 0, "type": "u64"},
  } },
  hrt_scene_info: { size: 104, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    target_count: {"offset": 4, "type": "u32"},
    plate_position_m: {"offset": 8, "type": "f64", "length": 3},
    plate_rotation: {"offset": 32, "type": "f64", "length": 4},
    plate_radius_m: {"offset": 64, "type": "f64"},
    plate_max_speed_deg_s: {"offset": 72, "type": "f64"},
    start_position_m: {"offset": 80, "type": "f64", "length": 3},
  } },
  hrt_scene_target: { size: 152, fields: {
    struct_size: {"offset": 0, "type": "u32"},
    role: {"offset": 4, "type": "u32"},
    served_by: {"offset": 8, "type": "i32"},
    reserved: {"offset": 12, "type": "u32"},
    position_m: {"offset": 16, "type": "f64", "length": 3},
    world_position_m: {"offset": 40, "type": "f64", "length": 3},
    direction_deg: {"offset": 64, "type": "f64"},
    distance_m: {"offset": 72, "type": "f64"},
    radius_m: {"offset": 80, "type": "f64"},
    name: {"offset": 88, "type": "u8", "length": 64},
  } },
});

// Every function that the module exports, with its parameters; i64 and u64 are BigInt.
export const functions = Object.freeze([
  "hrt_result_string",  // result: i32
  "hrt_last_error",
  "hrt_get_version",  // out_major: pointer, out_minor: pointer, out_patch: pointer
  "hrt_set_allocator",  // allocator: pointer
  "hrt_set_log_callback",  // callback: pointer, context: pointer
  "hrt_session_config_default",  // out_config: pointer, struct_size: u32
  "hrt_session_create",  // config: pointer, out_session: pointer
  "hrt_session_is_valid",  // session: u64
  "hrt_session_get_state",  // session: u64, out_state: pointer
  "hrt_session_destroy",  // session: u64
  "hrt_session_set_log_callback",  // session: u64, callback: pointer, context: pointer
  "hrt_session_get_config",  // session: u64, out_config: pointer
  "hrt_session_set_config",  // session: u64, config: pointer
  "hrt_target_config_default",  // out_config: pointer, struct_size: u32
  "hrt_target_add",  // session: u64, config: pointer, out_target: pointer
  "hrt_target_set",  // session: u64, target: u64, config: pointer
  "hrt_target_get",  // session: u64, target: u64, out_config: pointer
  "hrt_target_remove",  // session: u64, target: u64
  "hrt_target_find",  // session: u64, name: pointer, out_target: pointer
  "hrt_target_list",  // session: u64, role: u32, capacity: u64, out_targets: pointer, out_count: pointer
  "hrt_authority_query",  // session: u64, real_target: u64, virtual_target: u64, out_authority: pointer
  "hrt_authority_query_all",  // session: u64, capacity: u64, out_authorities: pointer, out_count: pointer
  "hrt_authority_query_best",  // session: u64, virtual_target: u64, out_authority: pointer
  "hrt_target_assign",  // session: u64, virtual_targets: pointer, virtual_count: u64, real_targets: pointer, real_count: u64, flags: u32, capacity: u64, out_authorities: pointer
  "hrt_reach_config_default",  // out_config: pointer, struct_size: u32
  "hrt_reach_begin",  // session: u64, config: pointer
  "hrt_reach_update",  // session: u64, sample: pointer, out_command: pointer
  "hrt_reach_retarget",  // session: u64, real_target: u64, virtual_target: u64
  "hrt_reach_cancel",  // session: u64
  "hrt_reach_end",  // session: u64, out_summary: pointer
  "hrt_calibration_config_default",  // out_config: pointer, struct_size: u32
  "hrt_calibration_create",  // session: u64, config: pointer, out_calibration: pointer
  "hrt_calibration_destroy",  // calibration: u64
  "hrt_calibration_begin_trial",  // calibration: u64, plate_orientation_deg: f64
  "hrt_calibration_add_sample",  // calibration: u64, sample: pointer
  "hrt_calibration_end_trial",  // calibration: u64
  "hrt_calibration_cancel_trial",  // calibration: u64
  "hrt_calibration_next_angle",  // calibration: u64, out_plate_orientation_deg: pointer, out_enough: pointer
  "hrt_calibration_solve",  // calibration: u64, out_result: pointer
  "hrt_calibration_get_residual",  // calibration: u64, slide: u32, out_slide: pointer
  "hrt_calibration_compare",  // first: pointer, second: pointer, out_comparison: pointer
  "hrt_calibration_apply",  // session: u64, result: pointer
  "hrt_profile_set_conditions",  // session: u64, conditions: pointer
  "hrt_profile_get_conditions",  // session: u64, out_conditions: pointer
  "hrt_profile_save",  // session: u64, capacity: u64, out_text: pointer, out_length: pointer
  "hrt_profile_load",  // session: u64, text: pointer, length: u64
  "hrt_recording_start",  // session: u64, path: pointer
  "hrt_recording_get_status",  // session: u64, out_status: pointer
  "hrt_recording_stop",  // session: u64, out_status: pointer
  "hrt_replay_text",  // text: pointer, length: u64, out_report: pointer
  "hrt_replay_file",  // path: pointer, out_report: pointer
  "hrt_registration_config_default",  // out_config: pointer, struct_size: u32
  "hrt_registration_fit",  // config: pointer, touches: pointer, touch_count: u64, capacity: u64, out_residuals_m: pointer, out_registration: pointer
  "hrt_registration_advice",  // verdict: u32
  "hrt_registration_apply",  // session: u64, registration: pointer, time_ns: i64
  "hrt_registration_check",  // registration: pointer, touch: pointer, out_check: pointer
  "hrt_registration_confirm",  // session: u64, registration: pointer, touch: pointer, time_ns: i64, out_check: pointer
  "hrt_fingertip_fit",  // config: pointer, touches: pointer, touch_count: u64, out_fingertip: pointer
  "hrt_fingertip_place",  // fingertip: pointer, joint: pointer, out_sample: pointer
  "hrt_latency_fit",  // samples: pointer, sample_count: u64, out_latency: pointer
  "hrt_scene_load_file",  // path: pointer, out_scene: pointer
  "hrt_scene_load_memory",  // bytes: pointer, length: u64, name: pointer, out_scene: pointer
  "hrt_scene_destroy",  // scene: u64
  "hrt_scene_get_info",  // scene: u64, out_info: pointer
  "hrt_scene_get_target",  // scene: u64, index: u32, out_target: pointer
  "hrt_scene_register",  // scene: u64, session: u64, capacity: u64, out_targets: pointer
]);
