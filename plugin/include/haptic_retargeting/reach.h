/*
 * A reach: the finger moves from the start to a real target while the user perceives a motion to a virtual target. Each
 * hrt_reach_update() takes a sample of the finger and returns a command for the plate.
 *
 * Example: one frame of an engine whose tracker reports positions in the world. haptic_retargeting.h has a complete
 * reach.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *
 *   // `finger_m` is null while the tracker has lost the finger. Returns HRT_COMMAND_ARRIVED at the end, 0 before.
 *   hrt_command_flags frame(hrt_session session, int64_t now_ns, const double* finger_m, double* plate_deg) {
 *     hrt_sample sample = hrt_sample_init();
 *     hrt_command command = hrt_command_init();
 *     sample.time_ns = now_ns;
 *     for (int i = 0; finger_m && i < 3; ++i) {
 *       sample.flags = HRT_SAMPLE_WORLD_POSITION;
 *       sample.finger_position_m[i] = finger_m[i];
 *     }
 *     if (hrt_reach_update(session, &sample, &command) != HRT_OK) return 0; // hrt_last_error() has the reason
 *     *plate_deg = command.plate_orientation_deg;
 *     return command.flags & HRT_COMMAND_ARRIVED;
 *   }
 */
#ifndef HAPTIC_RETARGETING_REACH_H
#define HAPTIC_RETARGETING_REACH_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** @flags HRT_REACH Options of a reach: hrt_reach_config::flags. */
typedef uint32_t hrt_reach_flags;
/** hrt_reach_config::plate_orientation_deg is set. Without this flag, the plate is assumed to be at the last command of
 *  a reach or set-up of this session, and at 0 before the first command. */
#define HRT_REACH_PLATE_ORIENTATION UINT32_C(1)
/** The reach starts at the first position of the finger instead of hrt_session_config::start_position_m; directions and
 *  distances are measured from this position. Until the first position, the controller uses the configured start, and
 *  samples are not counted. Has no effect if samples have directions only. */
#define HRT_REACH_START_AT_FINGER UINT32_C(2)

/** Configuration of a reach. */
typedef struct hrt_reach_config {
  uint32_t struct_size;
  /** Options. @default 0 */
  hrt_reach_flags flags;
  /** Target to which the hand is steered, less than 90 degrees from the virtual direction plus
   *  hrt_session_config::person.bias_deg. Null by default: must be set. */
  hrt_target real_target;
  /** Target that the user reaches for. Null by default: must be set. */
  hrt_target virtual_target;
  /** Plate orientation before the reach, clamped to the stops. Set it, with HRT_REACH_PLATE_ORIENTATION, if something
   *  other than this session has turned the plate: the controller plans from this orientation. @range -1e6 to 1e6
   *  @default 0 @ccw */
  double plate_orientation_deg;
  /** Expected duration of the motion, if the task dictates it. Used under GUIDANCE_ARRIVAL only. A correct value
   *  improves the first corrections, a wrong one impairs them. 0: estimated from the progress of the finger.
   *  @range 0 or 0.1 to 20 @default 0 */
  double duration_s;
} hrt_reach_config;

/** @flags HRT_SAMPLE hrt_sample::flags: the fields that are set. At most one of DIRECTION, PLATE_POSITION and
 *  WORLD_POSITION is allowed. A sample with none of these three and without LIFTED is a dropout: the last command is
 *  repeated, and the model predicts the position of the finger. */
typedef uint32_t hrt_sample_flags;
#define HRT_SAMPLE_DIRECTION UINT32_C(1)         /**< finger_direction_deg */
#define HRT_SAMPLE_PLATE_POSITION UINT32_C(2)    /**< finger_position_m, in plate coordinates */
#define HRT_SAMPLE_PLATE_ORIENTATION UINT32_C(4) /**< plate_orientation_deg, as measured */
#define HRT_SAMPLE_LIFTED UINT32_C(8)            /**< the finger does not touch the plate; its position is ignored */
#define HRT_SAMPLE_WORLD_POSITION UINT32_C(16)   /**< finger_position_m, in the engine's world */
/** plate_position_m and plate_rotation, with WORLD_POSITION, if the plate is tracked too. Otherwise, the pose in the
 *  session's configuration is used. */
#define HRT_SAMPLE_PLATE_POSE UINT32_C(32)
/** joint_rotation, with WORLD_POSITION: finger_position_m is the position of a joint, and the point of contact on the
 *  skin is hrt_session_config::fingertip_offset_m from it. */
#define HRT_SAMPLE_JOINT_ROTATION UINT32_C(64)

/** One sample of the tracked finger. Initialise it by hrt_sample_init(), then set the known fields and their flags.
 *  Besides time_ns, only the fields that `flags` names are read. */
typedef struct hrt_sample {
  uint32_t struct_size;
  /** Fields that are set. */
  hrt_sample_flags flags;
  /** Time of the sample on the caller's monotonic clock, with any origin. Must not decrease within a reach or set-up.
   *  @range any */
  int64_t time_ns;
  /** Direction of the finger's motion, assumed to be exact. If the position is known, set finger_position_m instead:
   *  GUIDANCE_ARRIVAL needs positions. @range -180 to 180 @ccw */
  double finger_direction_deg;
  /** Position of the fingertip or, with HRT_SAMPLE_JOINT_ROTATION, of the tracked joint. @range -1000 to 1000 */
  double finger_position_m[3];
  /** Measured plate orientation, from which the model corrects the orientation that it expects from the commands. If
   *  the plate has no stops, multiples of 180 degrees are ignored: the model uses the equivalent orientation that is
   *  nearest to the expected one. @range -1e6 to 1e6 @ccw */
  double plate_orientation_deg;
  /** Position of the plate in the world, as in hrt_session_plate::position_m. @range -1000 to 1000 */
  double plate_position_m[3];
  /** Rotation of the plate's mount in the world, as in hrt_session_plate::rotation. @norm 0.999 to 1.001 @unit 1 */
  double plate_rotation[4];
  /** Rotation of the tracked joint: the unit quaternion x, y, z, w from its axes to those of the world.
   *  @norm 0.999 to 1.001 @unit 1 */
  double joint_rotation[4];
} hrt_sample;

/** @flags HRT_COMMAND Reasons of a command, and warnings: hrt_command::flags. */
typedef uint32_t hrt_command_flags;
#define HRT_COMMAND_HELD UINT32_C(1) /**< the controller computed no new command: the last one is repeated */
/** The model predicts the finger: the motion has begun, and the sample is a dropout or, under FIXED_DIRECTION, all
 *  samples of the present and the last step are dropouts. */
#define HRT_COMMAND_PREDICTED UINT32_C(2)
#define HRT_COMMAND_SATURATED UINT32_C(4)    /**< a bound of the plate orientation or a stop limits the command */
#define HRT_COMMAND_RATE_LIMITED UINT32_C(8) /**< the plate's speed limits the command; FIXED_DIRECTION only */
#define HRT_COMMAND_UNREACHABLE UINT32_C(16) /**< the gap is clearly too large for the plate and the user (hrt_gap) */
#define HRT_COMMAND_LIFTED UINT32_C(32)      /**< the finger does not touch the plate: the last command is repeated */
#define HRT_COMMAND_OFF_PLATE UINT32_C(64)   /**< the finger is beyond the plate's edge */
/** Under ARRIVAL: the motion differs from the model by more than noise explains; estimates and UNREACHABLE are
 *  unreliable. */
#define HRT_COMMAND_MISFIT UINT32_C(128)
/** Under ARRIVAL: the bearing of the end of the motion, predicted or actual, probably differs by more than 1.5 degrees
 *  from that of the real target. Under either guidance: after three tenths of the path, the finger is more than 60
 *  degrees off the bearing of the target, or the motion has ended, but not near the target (HRT_COMMAND_ARRIVED). */
#define HRT_COMMAND_OFF_TARGET UINT32_C(256)
/** Under ARRIVAL: the finger has stopped or was lifted after the onset of the motion; the last command is repeated. */
#define HRT_COMMAND_RESTING UINT32_C(512)
/** Under FIXED_DIRECTION: the solver stopped before it found the optimum; the command is within its limits. */
#define HRT_COMMAND_APPROXIMATE UINT32_C(1024)
/** A defect in this library: a value was not a finite number. A plate orientation is replaced by that of the last
 *  command, any other value by 0. The log reports the first defect of a session, in the calls that
 *  HRT_COMMAND_REGISTRATION lists. */
#define HRT_COMMAND_FAULT UINT32_C(2048)
/** The plate's registration is older than registration.max_age_ns, less accurate than registration.max_sd_deg, or
 *  missing although one of these limits is set. Set up again (setup.h). The log reports this in the next call of
 *  hrt_host_set_log(), hrt_session_set(), hrt_session_destroy(), hrt_setup_begin(), hrt_profile_load(),
 *  hrt_profile_reset() or hrt_scene_register(), once for each configuration. */
#define HRT_COMMAND_REGISTRATION UINT32_C(4096)
/** The motion has ended; hrt_reach_retarget() may continue the reach. A finger that was at the start, or has moved, has
 *  then rested: for 0.4 s near the real target, after nine tenths of the path; or for 2 s within 60 degrees of the
 *  target's bearing, after three tenths of the path. OFF_TARGET is set if the finger is not near the target. "Near" is
 *  within a quarter of the target's distance from the start, or within 15 mm if this is more. A lift, a dropout of more
 *  than 0.2 s, or a move of the real target by 2 mm or more restarts the time. Not set in a reach with directions only:
 *  use a time limit there. */
#define HRT_COMMAND_ARRIVED UINT32_C(8192)
/** Contacts (hrt_reach_touched()) contradict the registration: they shift the real target further than 99.9 % of
 *  correct registrations would require. The plate or the tracker's coordinate system has moved, or another object was
 *  touched. Set up again (setup.h). */
#define HRT_COMMAND_CONTACTS UINT32_C(16384)
/** The finger rests more than 15 mm from the start, and was not at the start in this reach: ask the user to move there.
 *  The motion begins when the finger has rested at the start, or moves from its present position. */
#define HRT_COMMAND_NOT_AT_START UINT32_C(32768)
/** The miss is unknown: no sample shows a motion; or, in a command under FIXED_DIRECTION, it is not predicted.
 *  predicted_miss_deg and miss_deg are 0, miss_sd_deg is 180. */
#define HRT_COMMAND_MISS_UNKNOWN UINT32_C(65536)
/** Times, units or axes are probably wrong: times do not advance in nanoseconds; the finger is faster than 5 m/s,
 *  further than three plate radii from the plate's centre, or moving away from the virtual target; the start or the
 *  real target is further than two radii from the centre; the directions of all targets are probably in radians; or the
 *  finger ends beyond the virtual target, on the side away from the real target. The log names the cause, in the
 *  calls that HRT_COMMAND_REGISTRATION lists. The reach does not change the estimates of the user. */
#define HRT_COMMAND_IMPLAUSIBLE UINT32_C(131072)

/** Value of hrt_command::time_to_go_s before the motion and in a pause; under FIXED_DIRECTION, in every command. */
#define HRT_NOT_MOVING (-1)
/** Value of hrt_command::time_to_go_s once the motion has ended, or should have ended according to the model. */
#define HRT_ARRIVED 0

/** Writes flags of a command or summary as words, such as "unreachable, off target"; an empty text for 0.
 *
 *  @param flags       Flags of hrt_command or hrt_reach_summary.
 *  @param capacity    Bytes of `out_text`. 0: only the length is returned.
 *  @param out_text    Words in UTF-8 with a terminating zero. May be null if `capacity` is 0.
 *  @param out_length  Length of the words without the zero.
 *  @return OUT_OF_RANGE for unknown flags; BUFFER_TOO_SMALL for a `capacity` from 1 to the length.
 *  @threadsafety [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_flags_text(hrt_command_flags flags, uint64_t capacity, char* out_text,
                                                uint64_t* out_length) HRT_NOEXCEPT;

/** Part of hrt_command: values of the controller of the paper. Under GUIDANCE_ARRIVAL, `step` is -1 and the directions
 *  are 0. */
typedef struct hrt_command_paper {
  /** Index of the model's step, from 0; -1 before the finger moves. */
  int64_t step;
  /** Direction of the finger's motion in the last step, observed or predicted. @ccw */
  double finger_direction_deg;
  /** Direction to which the finger is steered: that of the real target, or the nearest direction that the plate can
   *  sustain. @ccw */
  double aimed_direction_deg;
} hrt_command_paper;

/** Command for the plate, and its reasons. */
typedef struct hrt_command {
  uint32_t struct_size;
  /** Reasons and warnings, HRT_COMMAND_*. */
  hrt_command_flags flags;
  /** Plate orientation to turn to now, within the stops. Orientations 180 degrees apart have the same ridges. Under
   *  ARRIVAL without stops, and under FIXED_DIRECTION without limits of speed and acceleration, the nearest of them is
   *  commanded; otherwise, the plate stays within one half turn during a reach. Without stops, successive reaches may
   *  turn the plate further and further in one direction: the device must count turns, or remove whole ones. @ccw */
  double plate_orientation_deg;
  /** Bearing of the finger, seen from the start of the reach; 0 until the finger moves. In a reach with directions
   *  only, the direction of the last step. @ccw */
  double bearing_deg;
  /** Direction of motion that the user perceives according to the model: at the present plate orientation or, under
   *  FIXED_DIRECTION, at the end of the step. @ccw */
  double perceived_direction_deg;
  /** Estimated present perceived-direction error (perceived minus intended direction), which the user could notice. 0
   *  before the motion and under FIXED_DIRECTION. @ccw */
  double felt_error_deg;
  /** Bearing of the predicted position of arrival or, while the finger rests, of the finger, minus that of the real
   *  target; 0 with HRT_COMMAND_MISS_UNKNOWN. @ccw */
  double predicted_miss_deg;
  /** SD of the bearing of the finger's true position, from the uncertainty of the estimator, plate.covariance (after
   *  contacts, registration.contact_covariance) and tracker.bearing_sd_deg. 180 with HRT_COMMAND_MISS_UNKNOWN. */
  double miss_sd_deg;
  /** Distance along the plate to the real target, from the finger or, until its first position, from the start. */
  double distance_to_go_m;
  /** Predicted time until the motion ends, or HRT_NOT_MOVING, or HRT_ARRIVED. */
  double time_to_go_s;
  /** Present estimate of the tactile weight, as defined at hrt_session_person::tactile_weight. @unit 1 */
  double tactile_weight;
  /** SD of tactile_weight; 0: assumed to be exact. @unit 1 */
  double tactile_weight_sd;
  /** Normalised innovation squared (NIS), averaged over about the last twenty positions: how much the positions deviate
   *  from the model. About 2 if the model fits. MISFIT is set from 6 on, and below 6 if successive deviations have the
   *  same direction. 0 under FIXED_DIRECTION. @unit 1 */
  double misfit;
  hrt_command_paper paper; /**< values of the controller of the paper @flatten paper_* */
} hrt_command;

/** Part of hrt_reach_summary: numbers of samples and steps. A step lasts 0.1 s; under FIXED_DIRECTION,
 *  paper.step_period_ns. */
typedef struct hrt_reach_counts {
  int64_t samples;         /**< samples of the reach */
  int64_t dropped_samples; /**< samples that were dropouts or rejected as outliers */
  int64_t steps;           /**< steps with samples */
  int64_t saturated_steps; /**< steps with samples whose command had HRT_COMMAND_SATURATED */
} hrt_reach_counts;

/** Part of hrt_reach_summary: estimates of the user and the tracker at the end of the reach. HRT_ADAPTATION_CARRIED
 *  writes slightly different estimates into hrt_session_config::person, from a second pass of the filter over the
 *  motion. Under FIXED_DIRECTION, curve, bias and their SDs are 0.
 *
 *  Under ARRIVAL, the SDs of weight and bias are too small after many reaches with gaps on the same side, where a
 *  weight and a bias have the same effect. To measure a user, alternate the sides of the gaps. */
typedef struct hrt_reach_learnt {
  double tactile_weight;    /**< value of hrt_command::tactile_weight at the end @unit 1 */
  double tactile_weight_sd; /**< value of hrt_command::tactile_weight_sd at the end @unit 1 */
  /** Curvature of the illusion: HRT_PERSON_CURVE. If its absolute value exceeds twice illusion_curve_sd, the illusion
   *  is probably not linear, and tactile_weight is valid at 60 degrees only. @unit 1 */
  double illusion_curve;
  double illusion_curve_sd; /**< SD of illusion_curve @unit 1 */
  double bias_deg;          /**< bias: HRT_PERSON_BIAS @ccw */
  double bias_sd_deg;       /**< SD of bias_deg */
  /** SD of the noise in each tracked coordinate, estimated or configured: all noise under ARRIVAL, white noise under
   *  FIXED_DIRECTION. */
  double tracker_noise_m;
} hrt_reach_learnt;

/** Part of hrt_reach_summary: results of the controller of the paper; all 0 under GUIDANCE_ARRIVAL. */
typedef struct hrt_reach_paper {
  /** Direction of the finger's motion in the last step. @ccw */
  double final_direction_deg;
  /** final_direction_deg minus the direction of the real target: the error measure of the paper. @ccw */
  double miss_deg;
  /** Perceived direction in the last step. @ccw */
  double perceived_direction_deg;
  /** perceived_direction_deg minus the intended direction: virtual direction plus the user's bias as configured before
   *  the reach. @ccw */
  double perceived_error_deg;
  /** Estimate of paper.motor_variance_deg2; the configured value without adaptation. @flatten motor_variance_deg2 */
  double motor_variance_deg2;
  /** SD of motor_variance_deg2; close to the configured one if the reach had too little data; 0: assumed to be exact.
   *  @flatten motor_variance_sd_deg2 */
  double motor_variance_sd_deg2;
  int64_t predicted_steps;    /**< steps without samples */
  int64_t rate_limited_steps; /**< steps with samples whose command had HRT_COMMAND_RATE_LIMITED */
} hrt_reach_paper;

/** Result of a reach. */
typedef struct hrt_reach_summary {
  uint32_t struct_size;
  /** Warnings. UNREACHABLE, NOT_AT_START and IMPLAUSIBLE are those of the last command; MISFIT and REGISTRATION are set
   *  if any command had them; CONTACTS includes a contact during this reach; OFF_TARGET and MISS_UNKNOWN refer to the
   *  end of the motion; FAULT to this summary. */
  hrt_command_flags flags;
  /** Bearing of the last position; 0 with HRT_COMMAND_MISS_UNKNOWN. If samples have directions only, the direction of
   *  the last step. @ccw */
  double bearing_deg;
  /** bearing_deg minus the bearing of the real target; 0 with HRT_COMMAND_MISS_UNKNOWN. @ccw */
  double miss_deg;
  /** SD of miss_deg: the last hrt_command::miss_sd_deg. 180 under FIXED_DIRECTION. */
  double miss_sd_deg;
  /** Distance along the plate to the real target, from the last position or, without positions, from the start. */
  double distance_to_target_m;
  /** Largest absolute hrt_command::felt_error_deg while the finger moved. */
  double peak_felt_error_deg;
  /** Root mean square of hrt_command::felt_error_deg while the finger moved. */
  double rms_felt_error_deg;
  /** Largest hrt_command::misfit after the onset of the motion. @unit 1 */
  double misfit;
  /** Estimated duration of the motion; 0 under FIXED_DIRECTION. */
  double duration_s;
  hrt_reach_counts counts; /**< numbers of samples and steps @flatten * */
  hrt_reach_learnt learnt; /**< estimates of the user and the tracker @flatten * */
  hrt_reach_paper paper;   /**< results of the controller of the paper @flatten paper_* */
} hrt_reach_summary;

/** @flags HRT_CONTACT hrt_contact::flags: coordinates of the position; at most one. Without a flag, the finger is
 *  assumed to be at the near side of the reach's real target, one radius before its centre. */
typedef uint32_t hrt_contact_flags;
#define HRT_CONTACT_PLATE_POSITION UINT32_C(1) /**< position_m, in plate coordinates */
#define HRT_CONTACT_WORLD_POSITION UINT32_C(2) /**< position_m, in the engine's world; the plate's pose converts it */

/** Position of the finger while it touches a real object. The default is all zero except `struct_size`. */
typedef struct hrt_contact {
  uint32_t struct_size;
  /** Coordinates of the position. @default 0 */
  hrt_contact_flags flags;
  /** Position of the fingertip; the height above the plate has no effect. @range -1000 to 1000 @default 0 */
  double position_m[3];
  /** SD of the position in each coordinate. The smaller the SD, the more the contact corrects. 0: the radius of the
   *  real target, or 10 mm if the radius is unknown. @range 0 or 0.0001 to 1 @default 0 */
  double sd_m;
} hrt_contact;

/** Begins a reach. The targets are copied. Directions are measured from hrt_session_config::start_position_m, even if
 *  the finger is elsewhere, unless HRT_REACH_START_AT_FINGER is set.
 *
 *  @param config  Targets and options.
 *  @return INVALID_HANDLE naming the target; OUT_OF_RANGE naming the target or field; WRONG_STATE during a reach or a
 *          set-up.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_begin(hrt_session session, const hrt_reach_config* config) HRT_NOEXCEPT;

/** Processes one sample and returns the command for the plate. Call it every frame, at any frame rate, also before the
 *  motion: GUIDANCE_ARRIVAL estimates the start and the noise of the tracker from these samples. During the motion, a
 *  command is computed for each position or, if samples have directions only, once in a step period. A position that
 *  equals the last one is a dropout for 50 ms, since a tracker may be slower than the application. Steps without
 *  samples are predicted, under FIXED_DIRECTION at most 64 in a call.
 *
 *  @param sample       Finger, and plate if its orientation is measured.
 *  @param out_command  Command for the plate.
 *  @return WRONG_STATE without a reach; OUT_OF_RANGE naming the field, or naming the target if, with
 *          HRT_REACH_START_AT_FINGER, a target is within 1 mm of the finger or the targets are 90 degrees or more
 *          apart; TIME_REVERSED.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_update(hrt_session session, const hrt_sample* sample,
                                                  hrt_command* out_command) HRT_NOEXCEPT;

/** Redirects the reach to other targets, or to moved targets (hrt_target_set()); call it every frame while targets
 *  move. After this call, the direction of the real target is measured from the finger, that of the virtual target from
 *  the position that the user perceives. Before the motion, and if samples have directions only, both are measured from
 *  the start. The next command has UNREACHABLE if the plate cannot sustain the remaining gap, OFF_TARGET if the
 *  remaining path is too short. If the real target has moved by 2 mm or more, the rest that HRT_COMMAND_ARRIVED
 *  requires starts again.
 *
 *  @param real_target     Target to which the hand is steered.
 *  @param virtual_target  Target that the user reaches for.
 *  @return INVALID_HANDLE or OUT_OF_RANGE naming the target, also for targets 90 degrees or more apart; WRONG_STATE
 *          without a reach.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_retarget(hrt_session session, hrt_target real_target,
                                                    hrt_target virtual_target) HRT_NOEXCEPT;

/** Reports that the finger has touched the real object, during a reach or after hrt_reach_end(), at most once for each
 *  reach. The contact reveals an error of the tracker's coordinate system: from the next reach on,
 *  hrt_session_config::registration.contact_correction corrects the finger's positions, and HRT_PERSON_BIAS, if it was
 *  estimated, changes by the angle of this correction.
 *
 *  @param contact  Position of contact. Null: the default.
 *  @return OUT_OF_RANGE naming the field, or the position if it is within 10 mm of start_position_m or too far from the
 *          tracked finger; WRONG_STATE if no reach is in progress and none has ended since the last cancel, set-up or
 *          change of the configuration, without HRT_SESSION_REGISTERED, or after a contact of the same reach;
 *          INSUFFICIENT_DATA if the finger did not move.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_touched(hrt_session session, const hrt_contact* contact) HRT_NOEXCEPT;

/** Ends the reach without a summary, and discards its estimates and its contact. The plate is assumed to remain at the
 *  last command.
 *
 *  @return WRONG_STATE without a reach.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_cancel(hrt_session session) HRT_NOEXCEPT;

/** Ends the reach and returns its result. With HRT_ADAPTATION_CARRIED, updates the estimates in the configuration.
 *
 *  @param out_summary  Result of the reach.
 *  @return WRONG_STATE without a reach; INSUFFICIENT_DATA if the reach has had no sample. The reach then remains in
 *          progress; hrt_reach_cancel() ends it.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_end(hrt_session session, hrt_reach_summary* out_summary) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
