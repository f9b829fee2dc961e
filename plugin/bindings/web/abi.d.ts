// Written by plugin/bindings/generate from the C headers.

/** Flags of hrt_target_assign(). */
/** A real target serves one virtual target at most. Otherwise it may serve any number. */
export declare const HRT_ASSIGN_EXCLUSIVE = 1;
/** Maximum number of virtual targets, and of real ones, in hrt_target_assign(). */
export declare const HRT_ASSIGN_TARGETS_MAX = 1000;

/** Version of these headers. hrt_get_version() returns the library's. */
export declare const HRT_VERSION_MAJOR = 0;
export declare const HRT_VERSION_MINOR = 3;
export declare const HRT_VERSION_PATCH = 0;
export declare const HRT_OK = 0;
/** A pointer that must not be null was null. */
export declare const HRT_ERROR_NULL_ARGUMENT = -1;
/** The handle or id is null, stale, of another session, or was never given out. */
export declare const HRT_ERROR_INVALID_HANDLE = -2;
/** `struct_size` is below the first version's, or bytes that this library does not know are not zero. */
export declare const HRT_ERROR_STRUCT_SIZE = -3;
/** A value is outside its documented range, not a number, or infinite. */
export declare const HRT_ERROR_OUT_OF_RANGE = -4;
/** The call is not allowed now: for example an update without a reach. */
export declare const HRT_ERROR_WRONG_STATE = -5;
/** Another thread is in a call on this session. */
export declare const HRT_ERROR_BUSY = -6;
/** The sample is older than the one before it. */
export declare const HRT_ERROR_TIME_REVERSED = -7;
/** An allocation failed. */
export declare const HRT_ERROR_OUT_OF_MEMORY = -8;
/** The number of objects or samples is at its limit. */
export declare const HRT_ERROR_LIMIT_REACHED = -9;
/** Nothing has this name. */
export declare const HRT_ERROR_NOT_FOUND = -10;
/** The caller's buffer is too small for the output. */
export declare const HRT_ERROR_BUFFER_TOO_SMALL = -11;
/** Another target of this session has this name. */
export declare const HRT_ERROR_NAME_TAKEN = -12;
/** The operating system refused a file or a thread. */
export declare const HRT_ERROR_SYSTEM = -13;
/** A file or text is malformed. hrt_last_error() names the place. */
export declare const HRT_ERROR_BAD_FORMAT = -14;
/** The data cannot determine the requested value. hrt_last_error() names what is missing. */
export declare const HRT_ERROR_INSUFFICIENT_DATA = -15;
/** A defect in this library. Please report it with the text of hrt_last_error(). */
export declare const HRT_ERROR_INTERNAL = -99;
/** Maximum number of calibrations in a process. */
export declare const HRT_CALIBRATIONS_MAX = 16;

/** Families of illusion curves: the felt shift over the offset t from the motion to the ridge normal. */
/** w t */
export declare const HRT_ILLUSION_LINEAR = 0;
/** w t within the scale, constant beyond */
export declare const HRT_ILLUSION_SATURATING = 1;
/** w 45 sin 2t */
export declare const HRT_ILLUSION_SINE = 2;
/** w scale tanh(t / scale) */
export declare const HRT_ILLUSION_TANH = 3;
/** nothing within the scale, w (|t| - scale) beyond */
export declare const HRT_ILLUSION_DEAD_BAND = 4;
/** different slopes to the left and to the right */
export declare const HRT_ILLUSION_UNEQUAL = 5;
/** w t - b t (t / 75)^2, the controller's model */
export declare const HRT_ILLUSION_CUBIC = 6;
/** no family fits the slides */
export declare const HRT_ILLUSION_NONE = 7;

/** Patterns in what the fit leaves unexplained: hrt_calibration_result::lack_of_fit. */
/** Over the plate orientation: no curve fits. Check the plate's orientations and the goal direction. */
export declare const HRT_LACK_OF_FIT_ANGLE = 1;
/** Over the order of the slides: the user learns or tires. Let them practise or rest, and repeat. */
export declare const HRT_LACK_OF_FIT_ORDER = 2;
/** Along the paths: they bend as neither a habit nor the model's steering does. Ask for slower, longer and even slides, and repeat. */
export declare const HRT_LACK_OF_FIT_PATH = 4;

/** What became of a slide: hrt_calibration_slide::verdict. */
export declare const HRT_SLIDE_USED = 0;
/** unlike the others: left out */
export declare const HRT_SLIDE_OUTLYING = 1;
/** left out: the illusion flips along the ridges */
export declare const HRT_SLIDE_ALONG_RIDGES = 2;

/** Values of two calibrations that differ: hrt_calibration_comparison::differing. */
export declare const HRT_DIFFERS_TACTILE_WEIGHT = 1;
export declare const HRT_DIFFERS_MAX_GAP = 2;
export declare const HRT_DIFFERS_BIAS = 4;
export declare const HRT_DIFFERS_HABIT = 8;
export declare const HRT_DIFFERS_TRACKER_NOISE = 16;
export declare const HRT_DIFFERS_STEERING_RATE = 32;
export declare const HRT_DIFFERS_STEERING_DELAY = 64;

/** Level of a log message. */
export declare const HRT_LOG_WARNING = 1;
export declare const HRT_LOG_ERROR = 2;

/** How the conditions of the profile differ from those of now: hrt_conditions::differing. */
export declare const HRT_CONDITION_PLATE = 1;
export declare const HRT_CONDITION_TRACKER = 2;

/** hrt_reach_config::flags. */
/** `plate_orientation_deg` is given. Otherwise the plate is at the session's last command, at first 0. */
export declare const HRT_REACH_PLATE_ORIENTATION = 1;
/** The reach starts where the finger is first seen, instead of at hrt_session_config::start_position_m: directions and distances are measured from there. The plate stands ready for the configured start until then, and samples before it are not counted. In a reach of directions alone this has no effect. Since version 0.3. */
export declare const HRT_REACH_START_AT_FINGER = 2;

/** hrt_sample::flags: the fields that are set. At most one of DIRECTION, PLATE_POSITION and WORLD_POSITION. With none of these and without LIFTED the sample is a dropout: the plate is held, and the model predicts. */
/** finger_direction_deg */
export declare const HRT_SAMPLE_DIRECTION = 1;
/** finger_position_m, in plate coordinates */
export declare const HRT_SAMPLE_PLATE_POSITION = 2;
/** plate_orientation_deg, as measured */
export declare const HRT_SAMPLE_PLATE_ORIENTATION = 4;
/** the finger does not touch the plate: the model waits */
export declare const HRT_SAMPLE_LIFTED = 8;
/** finger_position_m, in the engine's world */
export declare const HRT_SAMPLE_WORLD_POSITION = 16;
/** plate_position_m and plate_rotation, for WORLD_POSITION. Otherwise the session's configuration has them. */
export declare const HRT_SAMPLE_PLATE_POSE = 32;

/** hrt_command::flags. */
/** no new decision: the former command is repeated */
export declare const HRT_COMMAND_HELD = 1;
/** no sample in the last step; under ARRIVAL, none now */
export declare const HRT_COMMAND_PREDICTED = 2;
/** the plate's bound or a stop limits the command */
export declare const HRT_COMMAND_SATURATED = 4;
/** the plate's speed limits the command */
export declare const HRT_COMMAND_RATE_LIMITED = 8;
/** the plate cannot sustain the gap: see authority.h */
export declare const HRT_COMMAND_UNREACHABLE = 16;
/** the finger does not touch the plate: the model waits */
export declare const HRT_COMMAND_LIFTED = 32;
/** the finger is beyond the plate's edge */
export declare const HRT_COMMAND_OFF_PLATE = 64;
/** The motion departs from the model more than its noise allows: the estimates, and UNREACHABLE, are not to be trusted. */
export declare const HRT_COMMAND_MISFIT = 128;
/** The finger is going to end, or has ended, more than 1.5 degrees of bearing from the real target. */
export declare const HRT_COMMAND_OFF_TARGET = 256;
/** the finger rests within the reach: the plate is held */
export declare const HRT_COMMAND_RESTING = 512;
/** The solver's work was cut short; the command keeps its bounds. */
export declare const HRT_COMMAND_APPROXIMATE = 1024;
/** A defect in this library: a value was not a finite number. The plate is held, and that value is 0. The log says so once a session, when the session is next configured or destroyed. */
export declare const HRT_COMMAND_FAULT = 2048;
/** The plate's registration is older or worse than the configuration allows, or there is none: max_registration_age_ns, max_registration_sd_deg. Touch the marks again (registration.h). The log has it at the next call of hrt_session_set_config(), _destroy() or hrt_registration_apply(). */
export declare const HRT_COMMAND_REGISTRATION = 4096;

/** How a recording ends. */
/** with its end line, and nothing was altered or lost */
export declare const HRT_ENDING_COMPLETE = 0;
/** without an end line: cut off, or the process ended while recording */
export declare const HRT_ENDING_CUT = 1;
/** at rows that a slow disk has lost: only those before were replayed */
export declare const HRT_ENDING_LOST_ROWS = 2;
/** with an end line whose checksum is not that of the text before it */
export declare const HRT_ENDING_ALTERED = 3;
/** Maximum number of touches in one call. */
export declare const HRT_TOUCHES_MAX = 1000;

/** hrt_registration_config::flags. */
/** The tracker's unit of length is fitted too: of use if it may be off by more than 1 in 100. */
export declare const HRT_REGISTER_SCALE = 1;
/** `up` is given. Without it, touches of which left and right were confused pass for those of a plate that lies upside down. */
export declare const HRT_REGISTER_UP = 2;

/** Verdict on a set of touches. hrt_registration_advice() has what to do. */
/** a pose explains the touches, or all of them but one */
export declare const HRT_REGISTRATION_HOLDS = 1;
/** fewer than 3 touches */
export declare const HRT_REGISTRATION_TOO_FEW = 2;
/** the marks lie within 1 cm of a line: the plate could turn about it */
export declare const HRT_REGISTRATION_DEGENERATE = 3;
/** no pose explains the touches, nor all of them but one */
export declare const HRT_REGISTRATION_INCONSISTENT = 4;
/** the face looks away from `up`: marks were confused */
export declare const HRT_REGISTRATION_UPSIDE_DOWN = 5;
/** Numbers in the lower triangle of hrt_registration::covariance. */
export declare const HRT_POSE_COVARIANCES = 28;
/** Maximum number of samples in hrt_latency_fit(). */
export declare const HRT_LATENCY_SAMPLES_MAX = 100000;
/** Maximum number of scenes in a process. */
export declare const HRT_SCENES_MAX = 64;
/** Maximum number of sessions in a process. */
export declare const HRT_SESSIONS_MAX = 1024;

/** Source of the plate's commands. */
/** the model-predictive controller */
export declare const HRT_CONTROL_MPC = 0;
/** a plate that does not turn, as a baseline */
export declare const HRT_CONTROL_FIXED_PLATE = 1;

/** What the controller steers the finger to, and so which controller it is. */
/** The real target's direction, seen from the start: the controller of the paper, for the person of its model. */
export declare const HRT_GUIDANCE_FIXED_DIRECTION = 0;
/** The real target's place, at arrival: the controller for people. It takes the pace of the motion, the whole curve of the illusion, bias, habits and the tracker's noise as unknown, and learns them. Needs positions: in a reach with directions alone this is FIXED_DIRECTION. Measured on simulated people only. */
export declare const HRT_GUIDANCE_ARRIVAL = 1;
/** Name of ARRIVAL in version 0.2, whose line of sight it replaces. */
export declare const HRT_GUIDANCE_LINE_OF_SIGHT = 1;

/** Learning of the person: under GUIDANCE_ARRIVAL of all that person_mean holds, else of the tactile weight and the motor variance. */
/** tactile_weight and bias_deg are taken as known, the illusion as linear */
export declare const HRT_ADAPTATION_OFF = 0;
/** The person is learnt within each reach, which begins with what the configuration says of them. */
export declare const HRT_ADAPTATION_REACH = 1;
/** As REACH; the end of a reach also writes what it has learnt into the configuration, widened, because people change: person_mean and person_covariance, tactile_weight and its deviation. A reach that ends early or that the model does not fit (HRT_COMMAND_MISFIT) writes nothing. Under FIXED_DIRECTION it writes tactile_weight and motor_variance_deg2; one reach changes the latter by a factor of 2 at most. */
export declare const HRT_ADAPTATION_CARRIED = 2;

/** hrt_session_config::flags. */
/** The plate stays where it stands until the finger moves. Otherwise it turns to where the first moment of the motion wants it as soon as a reach begins, which brings more fast reaches to the target. Set this if the finger rests on the ridges before a reach: a plate that turns under a resting finger is felt. */
export declare const HRT_SESSION_PLATE_WAITS = 1;
/** The plate's pose is from a registration made at registration_time_ns. hrt_registration_apply() sets this; hrt_scene_register(), which writes the scene's pose, clears it. */
export declare const HRT_SESSION_REGISTERED = 2;

/** Traits of a person, in this order, in hrt_session_config::person_mean. */
/** w: slope of the felt shift w t - b t (t / 75)^2 over the plate's angle t */
export declare const HRT_PERSON_WEIGHT = 0;
/** b: 0 for a linear illusion */
export declare const HRT_PERSON_CURVE = 1;
/** rate at which they correct the direction they feel, 1/s */
export declare const HRT_PERSON_GAIN = 2;
/** goal minus virtual direction, degrees */
export declare const HRT_PERSON_BIAS = 3;
/** Curving: the goal's turn at the start, minus that at the end, halved, degrees. */
export declare const HRT_PERSON_HABIT = 4;
/** of the pace: 0 minimum jerk, 1 even */
export declare const HRT_PERSON_EVENNESS = 5;
/** share of the goal's direction in which they set out */
export declare const HRT_PERSON_HEADING = 6;
/** natural logarithm of one over a reach's duration in seconds */
export declare const HRT_PERSON_LOG_RATE = 7;
/** Share of touch that fades from one ridge to the next: 0 if all of the ridges is always felt, 1 if a ridge is felt as it is crossed and then fades. */
export declare const HRT_PERSON_FADING = 8;
/** Number of traits. */
export declare const HRT_PERSON_TRAITS = 9;
/** Numbers in the lower triangle of their covariance. */
export declare const HRT_PERSON_COVARIANCES = 45;

/** What a session is about: bits of hrt_session_get_state(). 0: idle, no reach can begin. */
/** a real and a virtual target are there, and no reach is under way */
export declare const HRT_STATE_READY = 1;
/** a reach is under way */
export declare const HRT_STATE_REACHING = 2;
/** A trial of a calibration that was created from this session is under way. */
export declare const HRT_STATE_CALIBRATING = 4;
/** the calls of the session are recorded */
export declare const HRT_STATE_RECORDING = 8;
/** Maximum number of targets in a session. */
export declare const HRT_TARGETS_MAX = 1000000;
/** Bytes of a name, including the terminating zero. */
export declare const HRT_NAME_SIZE = 64;

/** Role of a target. */
/** the hand is steered to it */
export declare const HRT_TARGET_REAL = 1;
/** the user sees it and goes to it */
export declare const HRT_TARGET_VIRTUAL = 2;

/** How a target's place is given. */
/** by `direction_deg` and `distance_m` */
export declare const HRT_PLACE_DIRECTION = 1;
/** by `position_m` in plate coordinates */
export declare const HRT_PLACE_PLATE_POSITION = 2;
/** by `position_m` in the engine's world */
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
  readonly hrt_allocator: StructLayout<keyof hrt_allocator>;
  readonly hrt_session: StructLayout<keyof hrt_session>;
  readonly hrt_session_config: StructLayout<keyof hrt_session_config>;
  readonly hrt_target: StructLayout<keyof hrt_target>;
  readonly hrt_target_config: StructLayout<keyof hrt_target_config>;
  readonly hrt_authority: StructLayout<keyof hrt_authority>;
  readonly hrt_reach_config: StructLayout<keyof hrt_reach_config>;
  readonly hrt_sample: StructLayout<keyof hrt_sample>;
  readonly hrt_command: StructLayout<keyof hrt_command>;
  readonly hrt_reach_summary: StructLayout<keyof hrt_reach_summary>;
  readonly hrt_calibration: StructLayout<keyof hrt_calibration>;
  readonly hrt_calibration_config: StructLayout<keyof hrt_calibration_config>;
  readonly hrt_interval: StructLayout<keyof hrt_interval>;
  readonly hrt_calibration_result: StructLayout<keyof hrt_calibration_result>;
  readonly hrt_calibration_slide: StructLayout<keyof hrt_calibration_slide>;
  readonly hrt_calibration_comparison: StructLayout<keyof hrt_calibration_comparison>;
  readonly hrt_conditions: StructLayout<keyof hrt_conditions>;
  readonly hrt_recording_status: StructLayout<keyof hrt_recording_status>;
  readonly hrt_replay_report: StructLayout<keyof hrt_replay_report>;
  readonly hrt_mark_touch: StructLayout<keyof hrt_mark_touch>;
  readonly hrt_registration_config: StructLayout<keyof hrt_registration_config>;
  readonly hrt_registration: StructLayout<keyof hrt_registration>;
  readonly hrt_touch_check: StructLayout<keyof hrt_touch_check>;
  readonly hrt_joint_touch: StructLayout<keyof hrt_joint_touch>;
  readonly hrt_fingertip: StructLayout<keyof hrt_fingertip>;
  readonly hrt_latency: StructLayout<keyof hrt_latency>;
  readonly hrt_scene: StructLayout<keyof hrt_scene>;
  readonly hrt_scene_info: StructLayout<keyof hrt_scene_info>;
  readonly hrt_scene_target: StructLayout<keyof hrt_scene_target>;
};

export declare const functions: readonly string[];

/** Source of the library's memory. Both functions are called from any thread, concurrently. Neither may call this library or throw. */
export interface hrt_allocator {
  struct_size: number;
  reserved: number;
  /** Passed to both functions. The library does not read it. */
  context: number;
  /** Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null on failure. */
  allocate: number;
  /** Releases memory that allocate() returned. As of free(), it gets no size: an allocator that needs it keeps it beside the memory. */
  release: number;
}

/** A session's handle. Zero is never a session. Handles are never reused. */
export interface hrt_session {
  value: bigint;
}

/** Configuration of a session. hrt_session_config_default() fills every field. */
export interface hrt_session_config {
  struct_size: number;
  /** Steps that the controller plans ahead. With 1 most reaches miss; more than 3 changes little and costs time. 1 to 50. Default 3. */
  horizon: number;
  /** Duration of one step of the model and of the controller. The variances below are per step: scale them with it. 1 ms to 10 s. Default 100 ms. */
  step_period_ns: bigint;
  /** HRT_CONTROL_*. Default HRT_CONTROL_MPC. */
  control: number;
  /** HRT_GUIDANCE_*. Default HRT_GUIDANCE_ARRIVAL. */
  guidance: number;
  /** HRT_ADAPTATION_*. Default HRT_ADAPTATION_CARRIED. */
  adaptation: number;
  /** HRT_SESSION_*. Default 0. Named `reserved` before version 0.3. */
  flags: number;
  /** Cost of the error that the user feels. Raising it keeps the felt direction closer to the virtual one and steers more slowly. 1e-6 to 1e6. Default 1. */
  perceived_weight: number;
  /** Cost of the finger's actual error. Raising it steers faster, with a larger felt error; 0 steers not at all. 0 to 1e6. Default 1. */
  actual_weight: number;
  /** Maximum angle, modulo 180, between the plate orientation (base.h) and the virtual direction plus bias_deg. Raising it allows larger gaps; near 90 the ridges run along the motion and signal nothing. 0.1 to 90. Default 84.5. */
  plate_bound_deg: number;
  /** Maximum speed of the plate's servo, within which the controller plans. 0 to 1e6 degrees a second; 0: no limit. Default 0. */
  plate_max_speed_deg_s: number;
  /** Maximum acceleration of the servo, within which the controller plans. 0 to 1e8 degrees a second squared; 0: no limit. Default 0. */
  plate_max_acceleration_deg_s2: number;
  /** Time from a command to the plate's first motion. The controller plans from where the plate will be by then. 0 to 1 s, and at most 8 step periods. Default 0. */
  plate_latency_ns: bigint;
  /** Mechanical stops, as plate orientations (base.h): no command lies beyond them. -3600 to 3600, the upper at least 180 above the lower; both 0: no stops. Default 0 and 0. */
  plate_lower_stop_deg: number;
  plate_upper_stop_deg: number;
  /** Plate orientation (base.h) under HRT_CONTROL_FIXED_PLATE. With stops, the plate goes to the nearest orientation with the same ridges. -180 to 180. Default 0. */
  fixed_plate_orientation_deg: number;
  /** Share of touch in the direction that the user feels. At a higher weight, the same turn of the plate steers the hand further. Under GUIDANCE_ARRIVAL it is that of an illusion taken as linear, at 60 degrees; person_mean overrides it. 0.001 to 0.499. Default 0.2. */
  tactile_weight: number;
  /** Standard deviation of tactile_weight, from which adaptation starts. Raising it makes adaptation faster and less steady; under GUIDANCE_ARRIVAL it also makes the illusion's curve as uncertain in proportion. 0.001 to 0.49. Default 0.05. */
  tactile_weight_sd: number;
  /** Variance of the user's motor command per step. Raising it makes the estimator follow the samples more closely. 1e-9 to 1e4. Default 0.5. */
  motor_variance_deg2: number;
  /** Variance of the felt direction per step. Raising it models a user who reacts to touch more slowly. 1e-9 to 1e4. Default 0.1. */
  sensory_variance_deg2: number;
  /** Variance of the user's felt direction before the first step. Raising it models a user who trusts touch more in the first steps. 0 to 1e4. Default 0. */
  initial_variance_deg2: number;
  /** Standard deviation of white noise in each tracked coordinate; under GUIDANCE_ARRIVAL of all noise, unless tracker_correlated_noise_m says how much of it is correlated. Raising it smooths positions more. 0 to 0.1, less than 1e-9 as 1e-9; 0: learnt from the samples. Default 0. */
  tracker_noise_m: number;
  /** Start of reaches in plate coordinates. Directions of targets are measured from here. Each within 1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the user. */
  start_position_m: number[];
  /** Radius of the plate: positions beyond it get HRT_COMMAND_OFF_PLATE. 0.001 to 1000. Default 0.075. */
  plate_radius_m: number;
  /** Height above the plate: positions above it count as lifted. 0.0001 to 1000. Default 0.015. */
  lift_height_m: number;
  /** Centre of the plate in the engine's world. Each within 1000. Default (0, 0, 0). */
  plate_position_m: number[];
  /** Rotation of the plate's mount in the world: the unit quaternion x, y, z, w from plate coordinates to the world's axes. It does not turn with the ridges. Length 1 within 0.001. Default (0, 0, 0, 1). */
  plate_rotation: number[];
  /** Perceptual bias: perceived minus true direction of a virtual target. The user goes to the virtual direction plus this bias. Found by calibration.h; GUIDANCE_ARRIVAL learns the rest. -45 to 45. Default 0. Since version 0.2. */
  bias_deg: number;
  /** Standard deviation of motor_variance_deg2, from which adaptation starts. Raising it makes adaptation faster and less steady. 0.001 to 10. Default 0.5. Since version 0.2. */
  motor_variance_sd_deg2: number;
  /** Largest felt error that GUIDANCE_ARRIVAL asks the plate for: felt minus intended direction, as predicted. Lowering it keeps the illusion less noticeable and reaches somewhat fewer targets: of simulated people, 3.5 costs about 2 reaches in 100. What the person adds, by noise or by being other than estimated, comes on top. 0.1 to 45. Default 5. Since version 0.3. */
  max_felt_error_deg: number;
  /** Largest angle between the plate orientation and the finger's direction under GUIDANCE_ARRIVAL. Raising it allows larger gaps for people whose illusion still grows there; published data cover 60. Never beyond the peak of the person's illusion. 1 to 89. Default 75. Since version 0.3. */
  motion_bound_deg: number;
  /** Time from a motion to the time_ns of its sample, under GUIDANCE_ARRIVAL. 0 to 0.5 s. Default 0. Since version 0.3. */
  tracker_latency_ns: bigint;
  /** What is believed of the person under GUIDANCE_ARRIVAL: HRT_PERSON_*. Read if person_covariance is not 0: then the weight in 0.01 to 0.6, the curve -0.1 to 0.5, the gain 3 to 20, the bias -90 to 90, the habit -45 to 45, the evenness 0 to 1, the heading -2 to 2, the logarithm of the rate -3 to 2.4, the fading -0.2 to 1. Default 0. Since version 0.3. */
  person_mean: number[];
  /** Covariance of person_mean: the lower triangle, row by row; positive definite, up to 1e4. All 0: an unknown person, of whom only tactile_weight, tactile_weight_sd and bias_deg are read. Default 0. Since version 0.3. */
  person_covariance: number[];
  /** Length in the engine's world of 1 m on the plate: other than 1 if the tracker's unit is off. Divides positions and targets in the world, as seen from the plate's centre. 0.5 to 2. Default 1. This and the following: since version 0.3. */
  plate_scale: number;
  /** Covariance of the plate's pose in its own plane, wherever the pose comes from: its turn about its normal (radians, counter-clockwise) and its centre's place to the right and away (metres); the lower triangle, row by row. Variances 0 to 1. All 0: the pose is exact. Under GUIDANCE_ARRIVAL it goes into UNREACHABLE and bearing_error_sd_deg; where the plate leads does not depend on it. Default 0. */
  plate_covariance: number[];
  /** When the plate was registered, on the clock of the samples; read if HRT_SESSION_REGISTERED. Default 0. */
  registration_time_ns: bigint;
  /** Largest age of a registration at a sample. Older ones, and a session without HRT_SESSION_REGISTERED, get HRT_COMMAND_REGISTRATION. 0: not checked. Default 0. */
  max_registration_age_ns: bigint;
  /** Largest standard deviation that plate_covariance may give the bearing of the real target. Worse ones, and a session without HRT_SESSION_REGISTERED, get HRT_COMMAND_REGISTRATION. 0 to 180; 0: not checked. Default 0. */
  max_registration_sd_deg: number;
  /** Standard deviation of the correlated part of the tracker's noise in each coordinate, under GUIDANCE_ARRIVAL; tracker_noise_m is then the white part alone. Found by calibration.h. 0 to 0.1; 0: not known. Default 0. */
  tracker_correlated_noise_m: number;
  /** Time in which that part decays to 1/e; read if it is not 0. 0.01 to 2 s. Default 0.1. */
  tracker_correlation_s: number;
  /** Rate at which the person corrects an error that they feel. Found by calibration.h, kept in the profile; the controller does not read it, as it gains nothing by it. 0 to 50 1/s; 0: not known. Default 0. */
  steering_rate_per_s: number;
  /** Time from what the person feels to their answer, kept likewise. 0 to 0.5 s; 0: not known. Default 0. */
  steering_delay_s: number;
}

/** A target's id within its session. Zero is never a target. Ids are never reused, in any session. */
export interface hrt_target {
  value: bigint;
}

/** A target. hrt_target_config_default() fills every field. Only the fields that `place` names are read. */
export interface hrt_target_config {
  struct_size: number;
  /** HRT_TARGET_*. Default HRT_TARGET_REAL. */
  role: number;
  /** HRT_PLACE_*. Default HRT_PLACE_DIRECTION. */
  place: number;
  reserved: number;
  /** Direction from the start (base.h), -180 to 180. Default 0. */
  direction_deg: number;
  /** Distance from the start along the plate, 0.001 to 1000. Default 0.1. */
  distance_m: number;
  /** Place in plate coordinates or in the world, at least 1 mm from the start in the plane of the plate; the height y has no effect. Each within 1000. Default (0, 0, 0). */
  position_m: number[];
  /** UTF-8, terminated by a zero; unique within the session unless empty. Default empty. */
  name: string;
}

/** Authority over one pair of targets. Set `struct_size` before the call. */
export interface hrt_authority {
  struct_size: number;
  /** 1 if the plate can keep the finger on the real target's direction, else 0. */
  reachable: number;
  real_target: bigint;
  virtual_target: bigint;
  /** The virtual direction plus the person's bias, minus the real direction; in [-180, 180). */
  gap_deg: number;
  /** Largest gap, to either side, that the plate can sustain for the session's person and guidance. */
  max_gap_deg: number;
  /** max_gap_deg minus the size of the gap; negative: unreachable. */
  margin_deg: number;
  /** Plate orientation (base.h) that sustains the gap; at the bound if unreachable. */
  plate_orientation_deg: number;
  /** Direction in which the finger settles: the real target's, if reachable. */
  settling_direction_deg: number;
  /** max_gap_deg as the paper has it, from tactile_weight and plate_bound_deg. Since version 0.3. */
  paper_max_gap_deg: number;
}

/** Configuration of a reach. hrt_reach_config_default() fills every field. */
export interface hrt_reach_config {
  struct_size: number;
  /** HRT_REACH_*. Default 0. */
  flags: number;
  /** Target of the hand, less than 90 degrees from the virtual direction plus hrt_session_config::bias_deg. Default null: to be set. */
  real_target: bigint;
  /** Target that the user goes to. Default null: to be set. */
  virtual_target: bigint;
  /** Plate orientation (base.h) before the reach, clamped to the stops. -3600 to 3600. Default 0. */
  plate_orientation_deg: number;
  /** Expected duration of the motion under GUIDANCE_ARRIVAL, if the host knows it; it is learnt from the finger's progress otherwise. 0.1 to 20 s; 0: unknown. Default 0. Since version 0.3. */
  duration_s: number;
}

/** One sample of the tracked finger. Set it to zero, then set `struct_size` and the known fields. Only the fields that `flags` names are read. */
export interface hrt_sample {
  struct_size: number;
  /** HRT_SAMPLE_*. */
  flags: number;
  /** The caller's monotonic clock, with any origin; never less than the last sample's. */
  time_ns: bigint;
  /** Direction in which the finger moves, taken as exact. -180 to 180. */
  finger_direction_deg: number;
  /** Position of the fingertip. Each within 1000. */
  finger_position_m: number[];
  /** Measured plate orientation (base.h). With stops it is taken as measured. Without stops half turns do not count: the model takes the orientation with the same ridges that is nearest to the expected one. -3600 to 3600. */
  plate_orientation_deg: number;
  /** Pose of the plate in the world; see hrt_session_config. */
  plate_position_m: number[];
  plate_rotation: number[];
}

/** Command for the plate, and its reasons. Set `struct_size` before the call. */
export interface hrt_command {
  struct_size: number;
  /** HRT_COMMAND_*. */
  flags: number;
  /** Model step, from 0; -1 before the finger moves. */
  step: bigint;
  /** Plate orientation (base.h) to turn to now. Of the orientations with the same ridges between the stops it is the nearest one, if the configured speed and acceleration are unlimited. Otherwise the plate stays in one half turn for the whole reach, limited by the stops. */
  plate_orientation_deg: number;
  /** Direction of the finger in the last step, observed or predicted. */
  finger_direction_deg: number;
  /** Direction that the user feels under this command, as the model predicts it. */
  perceived_direction_deg: number;
  /** Direction to which the finger is steered; see hrt_session_config::guidance. */
  aimed_direction_deg: number;
  /** Distance along the plate to the real target; from the start until the first position. */
  distance_to_go_m: number;
  /** Tactile weight that the controller assumes. */
  tactile_weight: number;
  /** Standard deviation of tactile_weight; 0: taken as known. */
  tactile_weight_sd: number;
  /** Predicted time until the motion ends; 0 before it begins, and under FIXED_DIRECTION. Since version 0.3. */
  time_to_go_s: number;
  /** Felt minus intended direction now, as estimated: what the person could notice. For visual redirection about 4.5 is noticed; no threshold is published for touch. 0 under FIXED_DIRECTION. Since version 0.3. */
  felt_error_deg: number;
  /** Predicted bearing of the place of arrival, seen from the start, minus the real target's; 0 under FIXED_DIRECTION. Since version 0.3. */
  predicted_miss_deg: number;
  /** Normalised innovation squared of the last positions, mean over about twenty: about 2 if the model fits, MISFIT from 4.5. 0 under FIXED_DIRECTION. Since version 0.3. */
  normalised_innovation: number;
  /** Standard deviation of the finger's true place across the line to the real target, as a bearing from the start: by what the estimator knows of the place and by plate_covariance. At the end, of bearing_error_deg. 0 under FIXED_DIRECTION. Since version 0.3. */
  bearing_error_sd_deg: number;
}

/** Result of a reach. Set `struct_size` before the call. */
export interface hrt_reach_summary {
  struct_size: number;
  /** HRT_COMMAND_*: UNREACHABLE at the end, MISFIT and REGISTRATION at any time, OFF_TARGET of where the finger ended, FAULT. Named `reserved` before version 0.3. */
  flags: number;
  /** Samples, and those of them that were dropouts or rejected as outliers. */
  samples: bigint;
  dropped_samples: bigint;
  /** Model steps with samples, and predicted steps without. Under ARRIVAL the steps before the motion was seen count as predicted. */
  steps: bigint;
  predicted_steps: bigint;
  /** Steps with samples in which the plate's bound or a stop, or its speed, limited the command; its speed under FIXED_DIRECTION alone. */
  saturated_steps: bigint;
  rate_limited_steps: bigint;
  /** Direction of the finger in the last step, and that direction minus the real target's. */
  final_direction_deg: number;
  final_miss_deg: number;
  /** Direction that the user felt in the last step, and that direction minus the virtual target's and the user's bias as it was known before the reach. */
  perceived_direction_deg: number;
  perceived_error_deg: number;
  /** Distance along the plate from the last position to the real target; from the start without positions. */
  distance_to_target_m: number;
  /** Tactile weight and deviation at the end; see hrt_command. */
  tactile_weight: number;
  tactile_weight_sd: number;
  /** Standard deviation of noise in each tracked coordinate, learnt or configured: of white noise, and under ARRIVAL of all noise. */
  tracker_noise_m: number;
  /** Motor variance: the configured one, corrected by this reach. Since version 0.2. */
  motor_variance_deg2: number;
  /** Standard deviation of motor_variance_deg2; close to the configured one if the reach had too little data; 0: taken as known. Since version 0.2. */
  motor_variance_sd_deg2: number;
  /** Bearing of the last position, seen from the start, minus the real target's; 0 without positions, or if the finger never moved, which distance_to_target_m shows. This and the following: 0 under FIXED_DIRECTION, since version 0.3. */
  bearing_error_deg: number;
  /** Largest size of hrt_command::felt_error_deg, and its root mean square while the finger moved. */
  peak_felt_error_deg: number;
  rms_felt_error_deg: number;
  /** Largest hrt_command::normalised_innovation. */
  normalised_innovation: number;
  /** What the reach says of the person (HRT_PERSON_*), each with its standard deviation. An illusion_curve of more than 2 deviations says that the illusion is not linear, and tactile_weight holds at 60 degrees only. */
  illusion_curve: number;
  illusion_curve_sd: number;
  gain_per_s: number;
  gain_sd_per_s: number;
  bias_deg: number;
  bias_sd_deg: number;
  habit_deg: number;
  habit_sd_deg: number;
  /** Duration of the motion, as estimated. */
  duration_s: number;
  /** The last hrt_command::bearing_error_sd_deg: standard deviation of bearing_error_deg. */
  bearing_error_sd_deg: number;
}

/** A calibration's handle. Zero is never a calibration. Handles are never reused. */
export interface hrt_calibration {
  value: bigint;
}

/** Configuration of a calibration. hrt_calibration_config_default() fills every field. */
export interface hrt_calibration_config {
  struct_size: number;
  /** Maximum number of trials. 10 to 10000. Default 200. */
  max_trials: number;
  /** Maximum number of samples of all trials; each takes 32 bytes at creation. 100 to 1000000. Default 100000: 18 minutes at 90 Hz. */
  max_samples: number;
  reserved: number;
  /** Direction of the user's target. -180 to 180. Default 0: straight ahead, where the motor variance is accurate. */
  goal_direction_deg: number;
  /** Range of the plate orientations that hrt_calibration_next_angle() chooses from, relative to the goal direction. -89 to 89, the upper at least 40 above the lower. Default -75 and 75. Since version 0.3. */
  lower_plate_deg: number;
  upper_plate_deg: number;
  /** Width of the 95 % interval of the tactile weight at which hrt_calibration_next_angle() reports enough slides. Lowering it asks for more. 0.001 to 0.5. Default 0.02. Since version 0.3. */
  enough_weight_width: number;
}

/** An estimate with the ends of its 95 % interval. This struct never grows. */
export interface hrt_interval {
  value: number;
  lower: number;
  upper: number;
  /** 1; or 0: the data cannot determine the value. Then the interval is the range that was searched, and the value its likeliest point. */
  known: number;
  reserved: number;
}

/** Parameters of the user; the fields are those of hrt_session_config. Set `struct_size` before the call. */
export interface hrt_calibration_result {
  struct_size: number;
  /** Trials with a slide within which the plate turned by more than 5 degrees: they show the steering alone, and are not among trials_used. Named `reserved` before version 0.3. */
  slides_turning: number;
  /** Ended trials, and those of them with a slide of at least 30 mm over a plate at rest. */
  trials: number;
  trials_used: number;
  /** Felt shift over the offset of the ridge normal from the motion, at 60 degrees, mean of both sides. Known unless lack_of_fit is set or the interval is wider than 0.1. Of the share of touch that is felt at the slides' speed: people who feel ridges only as they cross them feel more at a higher one. */
  tactile_weight: hrt_interval;
  /** Goal at the middle of the path minus target direction, left positive. Known unless lack_of_fit is set or the interval is wider than 10 degrees. */
  bias_deg: hrt_interval;
  /** Never known since version 0.3: slides of people who steer continuously look as those of the paper's person with other variances. The value is the likeliest of the paper's person. */
  motor_variance_deg2: hrt_interval;
  /** As motor_variance_deg2. */
  sensory_variance_deg2: hrt_interval;
  /** Of the white part of the tracker's noise. Known with enough samples of the finger at rest, unless the parts of the noise may decay within 1.5 samples, which cannot be separated. */
  tracker_noise_m: hrt_interval;
  /** HRT_ILLUSION_*, the likeliest family; LINEAR without a test with fewer than 7 plate orientations. Since version 0.3, as all fields below. */
  illusion: number;
  /** HRT_LACK_OF_FIT_*; 0: none was found, each at 1 % of people whom the model fits. */
  lack_of_fit: number;
  /** Slides that were left out: unlike the others, or with the motion within 5 to 12 degrees of along the ridges. hrt_calibration_get_residual() names them. */
  slides_outlying: number;
  slides_along_ridges: number;
  /** Scale of the likeliest family, degrees; 0 if it has none. */
  illusion_scale_deg: number;
  /** Smallest offset at which the illusion is largest, 1 to 75: the motion bound for this user. */
  peak_offset_deg: number;
  /** w and b of the controller's curve (HRT_PERSON_WEIGHT, HRT_PERSON_CURVE), and their correlation. The curve is known with 7 plate orientations or more. */
  person_weight: hrt_interval;
  person_curve: hrt_interval;
  weight_curve_correlation: number;
  /** Largest gap between real and virtual direction that can be held, on the weaker side, with the plate within 75 degrees of the motion. Known if the curve is, slides reach offsets of 60 to both sides, and the interval is at most 10 degrees wide. */
  max_gap_deg: hrt_interval;
  /** How far the user's goal turns over a path, halved (HRT_PERSON_HABIT). Known as bias_deg. */
  habit_deg: hrt_interval;
  /** Correlated part of the tracker's noise, and the time in which it decays to 1/e. */
  correlated_noise_m: hrt_interval;
  noise_correlation_s: hrt_interval;
  /** Probabilities of residuals as patterned as these if the model fits: over the plate orientation, the order of the slides, the path. */
  angle_p: number;
  order_p: number;
  path_p: number;
  /** Rate at which the user corrects an error that they feel, 1/s, and the time from feeling to answer, with the tracker's latency and the arm's lag. Known with 6 turning slides or more unless lack_of_fit is set, steering_p is below 0.01, the rate's interval spans a factor above 2.5, or the delay's is wider than 0.1 s. */
  steering_rate_per_s: hrt_interval;
  steering_delay_s: hrt_interval;
  /** As path_p, of the turning slides under the likeliest law of steering; 1 without such slides. */
  steering_p: number;
}

/** One slide of the last hrt_calibration_solve(). Angles are relative to the goal direction. Set `struct_size` before the call. Since version 0.3. */
export interface hrt_calibration_slide {
  struct_size: number;
  /** HRT_SLIDE_*. */
  verdict: number;
  /** Number of the trial, from 0; trials without a slide are left out. */
  trial: number;
  reserved: number;
  plate_deg: number;
  /** Of the second half of the path, seen and fitted, and their difference. */
  direction_deg: number;
  fitted_deg: number;
  residual_deg: number;
}

/** Test and retest: two calibrations of a user, or of two users. Each field is the second value less the first, with the 95 % interval of the difference; known if both values are. Set `struct_size` before the call. Since version 0.3. */
export interface hrt_calibration_comparison {
  struct_size: number;
  /** HRT_DIFFERS_*, by Holm's procedure over the known values: if nothing has changed, any of them is set in 5 % of comparisons. 0 is no proof that nothing has changed: see the intervals. */
  differing: number;
  tactile_weight: hrt_interval;
  max_gap_deg: hrt_interval;
  bias_deg: hrt_interval;
  habit_deg: hrt_interval;
  tracker_noise_m: hrt_interval;
  steering_rate_per_s: hrt_interval;
  steering_delay_s: hrt_interval;
}

/** Conditions of a measurement. The plugin reads no clock and knows no devices: the host names them. Since version 0.3. */
export interface hrt_conditions {
  struct_size: number;
  /** Output: HRT_CONDITION_*, of what both the profile and the host name, and not alike. Input: not read. */
  differing: number;
  /** Seconds since 1970, UTC. 0 to 253402300799, the end of the year 9999. 0: unknown. */
  time_s: bigint;
  /** Names of plate and tracker: UTF-8 without control characters, ended by a zero. Empty: unknown. */
  plate: string;
  tracker: string;
}

/** State of a recording. Set `struct_size` before the call. */
export interface hrt_recording_status {
  struct_size: number;
  /** errno of the first failed write, after which nothing is written; 0: none. */
  system_error: number;
  /** Calls that the operating system has accepted for writing. */
  rows_written: bigint;
  /** Calls dropped because the disk was too slow or failed. 0 after stopping: the file is complete. */
  rows_lost: bigint;
}

/** Result of a replay. Set `struct_size` before the call. */
export interface hrt_replay_report {
  struct_size: number;
  /** 1 if `ending` is HRT_ENDING_COMPLETE, else 0. */
  complete: number;
  /** Rows replayed. */
  rows: bigint;
  /** Line, from 1, of the first row whose result or any number differs from the recorded one; 0: all rows are equal, bit for bit. */
  first_different_line: bigint;
  /** FNV-1a hash of the replayed commands, equal on every host: for each successful row "update", flags as 8 bytes, step and the eleven numbers after it, least significant byte first. */
  hash: bigint;
  /** HRT_ENDING_*. Since version 0.3. */
  ending: number;
  reserved: number;
}

/** A touch of a mark. This struct never grows. */
export interface hrt_mark_touch {
  /** The mark in plate coordinates. Each within 1000. */
  mark_m: number[];
  /** Where the tracker saw the fingertip, in the engine's world. Each within 1000. */
  touched_m: number[];
}

/** Configuration of a registration. hrt_registration_config_default() fills every field. */
export interface hrt_registration_config {
  struct_size: number;
  /** HRT_REGISTER_*. Default 0. */
  flags: number;
  /** Standard deviation of each coordinate of a touch, as expected; the residuals correct it. Raising it accepts worse touches. 1e-5 to 0.1. Default 0.003. */
  touch_sd_m: number;
  /** Up in the engine's world, of any length: the plate's face must look that way within 60 degrees. Each within 1000, and not all 0. Default (0, 1, 0). */
  up: number[];
}

/** A registered pose. Set `struct_size` before the call. Its numbers mean something if it HOLDS; INCONSISTENT and UPSIDE_DOWN have those of the fit to all touches, to look at. */
export interface hrt_registration {
  struct_size: number;
  /** HRT_REGISTRATION_*. */
  verdict: number;
  /** Touches that were given. */
  touches: number;
  /** Index of the one touch that does not fit the others and was left out; -1: none. */
  left_out: number;
  /** Pose and scale, as hrt_session_config has them. The scale is 1 unless fitted. */
  plate_position_m: number[];
  plate_rotation: number[];
  plate_scale: number;
  /** Covariance of the rotation about the plate's x, y and z (radians), the position in the world (metres) and the scale: the lower triangle, row by row. 0 for a scale that was not fitted. */
  covariance: number[];
  /** Standard deviation of a touch's coordinate: as expected and as seen, weighted. */
  touch_sd_m: number;
  /** Root mean square distance of the touches from their marks. */
  residual_m: number;
  /** Standard deviation of the plate's turn about its normal, which turns every reach. */
  turn_sd_deg: number;
}

/** Result of hrt_registration_check(). Set `struct_size` before the call. */
export interface hrt_touch_check {
  struct_size: number;
  /** 1 if the touch agrees with the registration; else 0: register again. */
  holds: number;
  /** Distance of the touch from where its mark should be. */
  distance_m: number;
  /** Distance within which 999 touches in 1000 are while the registration is true. A plate that has moved by less may pass. */
  allowed_m: number;
}

/** A tracked joint, in touches while its fingertip is on a mark. This struct never grows. */
export interface hrt_joint_touch {
  /** Position of the joint in the engine's world. Each within 1000. */
  position_m: number[];
  /** Rotation of the joint: the unit quaternion x, y, z, w from its axes to the world's. Length 1 within 0.001. */
  rotation: number[];
}

/** Where the skin that touches is, in the joint's axes: at position + rotation * offset_m in the world. Of one hand. Set `struct_size` before the call. */
export interface hrt_fingertip {
  struct_size: number;
  /** 1 if every deviation is below 5 mm; else 0: the joint was not turned enough, and the numbers are 0. */
  known: number;
  offset_m: number[];
  /** Its standard deviations. */
  sd_m: number[];
}

/** Latency of a tracker. Set `struct_size` before the call. */
export interface hrt_latency {
  struct_size: number;
  /** 1 if the 95 % interval is at most 40 ms wide; else 0, and the numbers are 0. */
  known: number;
  /** For hrt_session_config::tracker_latency_ns: the best fit, or 0 if that is negative. */
  latency_ns: bigint;
  /** Ends of the 95 % interval; the lower one may be negative. */
  lower_ns: bigint;
  upper_ns: bigint;
  /** Standard deviation of a coordinate from the circle on which the finger was carried. */
  residual_m: number;
  /** Radius of that circle. */
  radius_m: number;
}

/** A scene's handle. Zero is never a scene. Handles are never reused. */
export interface hrt_scene {
  value: bigint;
}

/** The plate of a scene. Set `struct_size` before the call. */
export interface hrt_scene_info {
  struct_size: number;
  /** Number of targets, real and virtual. */
  target_count: number;
  /** Pose of the plate in the world; see hrt_session_config. */
  plate_position_m: number[];
  plate_rotation: number[];
  plate_radius_m: number;
  /** Maximum speed of the servo, degrees per second; 0: not in the file. */
  plate_max_speed_deg_s: number;
  /** Start of reaches, in plate coordinates. */
  start_position_m: number[];
}

/** A target of a scene. Set `struct_size` before the call. */
export interface hrt_scene_target {
  struct_size: number;
  /** HRT_TARGET_*. */
  role: number;
  /** Index of the real target that serves this virtual one: the one that the file names, or else the nearest in direction, the first among equals; -1 for a real target. */
  served_by: number;
  reserved: number;
  /** In plate coordinates; y is the height above the plate. */
  position_m: number[];
  world_position_m: number[];
  /** From the start, along the plate. */
  direction_deg: number;
  distance_m: number;
  /** 0: not in the file. */
  radius_m: number;
  name: string;
}
