/*
 * A reach: the finger goes from the start to a real target while the user feels that it goes to a virtual
 * one. Each call takes a sample of the finger and returns a command for the plate.
 */
#ifndef HAPTIC_RETARGETING_REACH_H
#define HAPTIC_RETARGETING_REACH_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** hrt_reach_config::flags. */
/** `plate_orientation_deg` is given. Otherwise the plate is at the session's last command, at first 0. */
#define HRT_REACH_PLATE_ORIENTATION UINT32_C(1)
/** The reach starts where the finger is first seen, instead of at hrt_session_config::start_position_m:
 * directions and distances are measured from there. The plate stands ready for the configured start until
 * then, and samples before it are not counted. In a reach of directions alone this has no effect. */
#define HRT_REACH_START_AT_FINGER UINT32_C(2)

/** Configuration of a reach. hrt_reach_config_init() fills every field. */
typedef struct hrt_reach_config {
  uint32_t struct_size;
  /** HRT_REACH_*. Default 0. */
  uint32_t flags;
  /** Target of the hand, less than 90 degrees from the virtual direction plus hrt_session_config::paper.bias_deg.
   * Default null: to be set. */
  hrt_target real_target;
  /** Target that the user goes to. Default null: to be set. */
  hrt_target virtual_target;
  /** Plate orientation (base.h) before the reach, clamped to the stops. -1e6 to 1e6. Default 0. */
  double plate_orientation_deg;
  /** Expected duration of the motion under GUIDANCE_ARRIVAL, if the host knows it; it is learnt from the
   * finger's progress otherwise. 0.1 to 20 s; 0: unknown. Default 0. */
  double duration_s;
} hrt_reach_config;

/** hrt_sample::flags: the fields that are set. At most one of DIRECTION, PLATE_POSITION and WORLD_POSITION.
 * With none of these and without LIFTED the sample is a dropout: the plate is held, and the model
 * predicts. */
#define HRT_SAMPLE_DIRECTION UINT32_C(1)         /**< finger_direction_deg */
#define HRT_SAMPLE_PLATE_POSITION UINT32_C(2)    /**< finger_position_m, in plate coordinates */
#define HRT_SAMPLE_PLATE_ORIENTATION UINT32_C(4) /**< plate_orientation_deg, as measured */
#define HRT_SAMPLE_LIFTED UINT32_C(8)            /**< the finger does not touch the plate: the model waits */
#define HRT_SAMPLE_WORLD_POSITION UINT32_C(16)   /**< finger_position_m, in the engine's world */
/** plate_position_m and plate_rotation, for WORLD_POSITION. Otherwise the session's configuration has
 * them. */
#define HRT_SAMPLE_PLATE_POSE UINT32_C(32)
/** joint_rotation, with WORLD_POSITION: finger_position_m is that of a joint, and the skin is
 * hrt_session_config::fingertip_offset_m from it. */
#define HRT_SAMPLE_JOINT_ROTATION UINT32_C(64)

/** One sample of the tracked finger. Set it to zero, then set `struct_size` and the known fields. Only the
 * fields that `flags` names are read. */
typedef struct hrt_sample {
  uint32_t struct_size;
  /** HRT_SAMPLE_*. */
  uint32_t flags;
  /** The caller's monotonic clock, with any origin; never less than the last sample's. Any. */
  int64_t time_ns;
  /** Direction in which the finger moves, taken as exact. -180 to 180. */
  double finger_direction_deg;
  /** Position of the fingertip. Each within 1000. */
  double finger_position_m[3];
  /** Measured plate orientation (base.h). With stops it is taken as measured. Without stops half turns do not
   * count: the model takes the orientation with the same ridges that is nearest to the expected one. -1e6 to
   * 1e6. */
  double plate_orientation_deg;
  /** Pose of the plate in the world; see hrt_session_config. Each within 1000. */
  double plate_position_m[3];
  /** Length 1 within 0.001. */
  double plate_rotation[4];
  /** Rotation of the tracked joint: the unit quaternion x, y, z, w from its axes to the world's. Length 1
   *  within 0.001. */
  double joint_rotation[4];
} hrt_sample;

/** hrt_command::flags. */
#define HRT_COMMAND_HELD UINT32_C(1)         /**< no new decision: the former command is repeated */
#define HRT_COMMAND_PREDICTED UINT32_C(2)    /**< no sample in the last step; under ARRIVAL, none now */
#define HRT_COMMAND_SATURATED UINT32_C(4)    /**< the plate's bound or a stop limits the command */
#define HRT_COMMAND_RATE_LIMITED UINT32_C(8) /**< the plate's speed limits the command */
#define HRT_COMMAND_UNREACHABLE UINT32_C(16) /**< the plate cannot sustain the gap: see hrt_gap */
#define HRT_COMMAND_LIFTED UINT32_C(32)      /**< the finger does not touch the plate: the model waits */
#define HRT_COMMAND_OFF_PLATE UINT32_C(64)   /**< the finger is beyond the plate's edge */
/** The motion departs from the model more than its noise allows: the estimates, and UNREACHABLE, are not to
 * be trusted. */
#define HRT_COMMAND_MISFIT UINT32_C(128)
/** The finger is going to end, or has ended, more than 1.5 degrees of bearing from the real target. */
#define HRT_COMMAND_OFF_TARGET UINT32_C(256)
#define HRT_COMMAND_RESTING UINT32_C(512) /**< the finger rests within the reach: the plate is held */
/** The solver's work was cut short; the command keeps its bounds. */
#define HRT_COMMAND_APPROXIMATE UINT32_C(1024)
/** A defect in this library: a value was not a finite number. The plate is held, and that value is 0. The log
 * says so once a session, when the session is next configured or destroyed. */
#define HRT_COMMAND_FAULT UINT32_C(2048)
/** The plate's registration is older or worse than the configuration allows, or there is none:
 * registration.max_age_ns, registration.max_sd_deg. Set up again: setup.h. The log has it at the next call of
 * hrt_session_set(), hrt_session_destroy(), hrt_setup_begin(), hrt_profile_load() or hrt_scene_register(). */
#define HRT_COMMAND_REGISTRATION UINT32_C(4096)
/** The reach is over, and stays so until hrt_reach_retarget(): the finger has come nine tenths of the way
 * from the start to the real target and has rested for 0.4 s, or three tenths of the way and for 2 s. It
 * rests while means of its positions over 0.1 s stay within 4 mm, root mean square, and drift by less than
 * 8.6 mm/s, in 2 s by less than 2 mm/s. A lift or a gap of 0.3 s starts the time anew. Never in a reach of
 * directions alone: keep a time limit. */
#define HRT_COMMAND_ARRIVED UINT32_C(8192)
/** Contacts (hrt_reach_touched()) move the real target by more than the registration allows in 99.9 %: the
 * plate or the tracker's frame has moved, or what was touched is another object. Set up again: setup.h. */
#define HRT_COMMAND_CONTACTS UINT32_C(16384)

/** hrt_command::time_to_go_s: the finger rests before the motion or within it; or, under FIXED_DIRECTION, the
 * time is not known. */
#define HRT_NOT_MOVING (-1)
/** hrt_command::time_to_go_s: the motion has ended, or should have by now. */
#define HRT_ARRIVED 0

/** Command for the plate, and its reasons. Set `struct_size` before the call. */
typedef struct hrt_command {
  uint32_t struct_size;
  /** HRT_COMMAND_*. */
  uint32_t flags;
  /** Model step, from 0; -1 before the finger moves. */
  int64_t step;
  /** Plate orientation (base.h) to turn to now. Of the orientations with the same ridges between the stops it
   * is the nearest one, if the configured speed and acceleration are unlimited. Otherwise the plate stays in
   * one half turn for the whole reach, limited by the stops. Without stops one reach after another may wind it
   * up: it is the device's to count turns, or to leave whole ones out. */
  double plate_orientation_deg;
  /** Direction of the finger in the last step, observed or predicted. */
  double finger_direction_deg;
  /** Direction that the user feels under this command, as the model predicts it. */
  double perceived_direction_deg;
  /** Direction to which the finger is steered; see hrt_session_config::guidance. */
  double aimed_direction_deg;
  /** Distance along the plate to the real target; from the start until the first position. */
  double distance_to_go_m;
  /** Tactile weight that the controller assumes. */
  double tactile_weight;
  /** Standard deviation of tactile_weight; 0: taken as known. */
  double tactile_weight_sd;
  /** Predicted time until the motion ends, or HRT_NOT_MOVING, or HRT_ARRIVED. */
  double time_to_go_s;
  /** Felt minus intended direction now, as estimated: what the person could notice. For visual redirection
   * about 4.5 is noticed; no threshold is published for touch. 0 under FIXED_DIRECTION. */
  double felt_error_deg;
  /** Predicted bearing of the place of arrival, seen from the start, minus the real target's; 0 under
   * FIXED_DIRECTION. */
  double predicted_miss_deg;
  /** How far the last positions depart from the model: their normalised innovation squared, mean over about
   * twenty. About 2 if the model fits, MISFIT from 4.5. 0 under FIXED_DIRECTION. */
  double misfit;
  /** Standard deviation of the finger's true place across the line to the real target, as a bearing from the
   * start: by what the estimator knows of the place, and by plate.covariance or, once there were any,
   * contacts. At the end, of hrt_reach_summary::miss_deg. 0 under FIXED_DIRECTION. */
  double miss_sd_deg;
} hrt_command;

/** Part of hrt_reach_summary: what the reach was made of. */
typedef struct hrt_reach_counts {
  /** Samples, and those of them that were dropouts or rejected as outliers. */
  int64_t samples;
  int64_t dropped_samples;
  /** Model steps with samples, and predicted steps without. Under ARRIVAL the steps before the motion was
   * seen count as predicted. */
  int64_t steps;
  int64_t predicted_steps;
  /** Steps with samples in which the plate's bound or a stop, or its speed, limited the command; its speed
   * under FIXED_DIRECTION alone. */
  int64_t saturated_steps;
  int64_t rate_limited_steps;
} hrt_reach_counts;

/** Part of hrt_reach_summary: what it says of the person, HRT_PERSON_*, and of tracker and model; each with its
 * standard deviation. */
typedef struct hrt_reach_learnt {
  /** Tactile weight and deviation at the end; see hrt_command. */
  double tactile_weight;
  double tactile_weight_sd;
  /** What the reach says of the person (HRT_PERSON_*), each with its standard deviation. An illusion_curve of
   * more than 2 deviations says that the illusion is not linear, and tactile_weight holds at 60 degrees
   * only. */
  double illusion_curve;
  double illusion_curve_sd;
  double gain_per_s;
  double gain_sd_per_s;
  double bias_deg;
  double bias_sd_deg;
  double habit_deg;
  double habit_sd_deg;
  /** Standard deviation of noise in each tracked coordinate, learnt or configured: of white noise, and under
   * ARRIVAL of all noise. */
  double tracker_noise_m;
  /** Motor variance: the configured one, corrected by this reach. */
  double motor_variance_deg2;
  /** Standard deviation of motor_variance_deg2; close to the configured one if the reach had too little data;
   * 0: taken as known. */
  double motor_variance_sd_deg2;
} hrt_reach_learnt;

/** Result of a reach. Set `struct_size` before the call. */
typedef struct hrt_reach_summary {
  uint32_t struct_size;
  /** HRT_COMMAND_*: UNREACHABLE and CONTACTS at the end, MISFIT and REGISTRATION at any time, OFF_TARGET of
   * where the finger ended, FAULT. */
  uint32_t flags;
  /** Direction of the finger in the last step, and that direction minus the real target's: what the paper's
   * results are tested by. */
  double final_direction_deg;
  double paper_miss_deg;
  /** Direction that the user felt in the last step, and that direction minus the virtual target's and the
   * user's bias as it was known before the reach. */
  double perceived_direction_deg;
  double perceived_error_deg;
  /** Distance along the plate from the last position to the real target; from the start without positions. */
  double distance_to_target_m;
  /** Where the finger ended beside the real target: the bearing of the last position, seen from the start,
   * minus the target's. 0 if the finger never moved, which distance_to_target_m shows. Under FIXED_DIRECTION
   * paper_miss_deg; the fields below and what ARRIVAL learns are 0 then. */
  double miss_deg;
  /** The last hrt_command::miss_sd_deg: standard deviation of miss_deg. */
  double miss_sd_deg;
  /** Largest size of hrt_command::felt_error_deg, and its root mean square while the finger moved. */
  double peak_felt_error_deg;
  double rms_felt_error_deg;
  /** Largest hrt_command::misfit. */
  double misfit;
  /** Duration of the motion, as estimated. */
  double duration_s;
  /** The parts. */
  hrt_reach_counts counts;
  hrt_reach_learnt learnt;
} hrt_reach_summary;

/** hrt_contact::flags: how the place is given, at most one. With neither, the finger is at the near side of
 * the reach's real target: its place, less its radius towards the start. */
#define HRT_CONTACT_PLATE_POSITION UINT32_C(1) /**< position_m, in plate coordinates */
#define HRT_CONTACT_WORLD_POSITION UINT32_C(2) /**< position_m, in the engine's world: by the session's pose */

/** Where the finger is, since it touches a real object. All zero with `struct_size` is the default. */
typedef struct hrt_contact {
  uint32_t struct_size;
  /** HRT_CONTACT_*. Default 0. */
  uint32_t flags;
  /** Place of the fingertip; the height above the plate has no effect. Each within 1000. Default 0. */
  double position_m[3];
  /** Standard deviation of that place in each coordinate. 0.0001 to 1; 0: the real target's radius, or 10 mm
   * if that is unknown. Default 0. */
  double sd_m;
} hrt_contact;

/** Begins a reach. The targets are copied. Its directions are measured from
 * hrt_session_config::start_position_m, wherever the finger is, unless HRT_REACH_START_AT_FINGER is set.
 * Errors: INVALID_HANDLE or OUT_OF_RANGE naming the target, WRONG_STATE during a reach. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_begin(hrt_session session, const hrt_reach_config* config) HRT_NOEXCEPT;

/** Processes one sample and returns the command. Samples may come at any rate. A direction changes the
 * command once in a step period, a position at every sample: each one refines the estimate. Under
 * GUIDANCE_ARRIVAL the samples before the motion matter: they give the start, and the tracker's noise. Steps
 * without samples are predicted, under FIXED_DIRECTION at most 64 in a call. Errors: WRONG_STATE without a
 * reach, OUT_OF_RANGE naming the field, or the target if HRT_REACH_START_AT_FINGER finds it within 1 mm of
 * the finger or the pair 90 degrees apart; TIME_REVERSED. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_update(hrt_session session, const hrt_sample* sample,
                                                  hrt_command* out_command) HRT_NOEXCEPT;

/** Leads the reach to other targets, or to the same ones after hrt_target_set() has moved them: every frame,
 * if they move. The plan continues from where the finger is. Directions are then
 * seen from the finger, the virtual target's from where the person feels it; in a reach of directions alone,
 * from the start. The next command has UNREACHABLE if the plate cannot sustain the gap left, OFF_TARGET if the path
 * left is too short. Errors leave the reach as it was: INVALID_HANDLE, OUT_OF_RANGE naming the target, also of a pair
 * 90 degrees apart; WRONG_STATE. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_retarget(hrt_session session, hrt_target real_target,
                                                    hrt_target virtual_target) HRT_NOEXCEPT;

/** The finger has met the real object: once a reach, up to the next one; null `contact`: the default. It shows how far
 * the tracker's frame is off: from the next reach on hrt_session_config::registration.contact_correction corrects the
 * finger's positions, and the bias learnt of the person is less by as much. Errors: OUT_OF_RANGE naming the field, or
 * the place if it is within 10 mm of the start or too far from where the finger was seen; WRONG_STATE without a reach,
 * without HRT_SESSION_REGISTERED, or after a contact; INSUFFICIENT_DATA if the finger did not move. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_touched(hrt_session session, const hrt_contact* contact) HRT_NOEXCEPT;

/** Ends the reach without a summary and learns nothing from it, nor from its contact. The plate is where the
 * last command left it. Errors: WRONG_STATE without a reach. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_cancel(hrt_session session) HRT_NOEXCEPT;

/** Ends the reach. Errors: WRONG_STATE without a reach; INSUFFICIENT_DATA if it has had no sample: it stays
 * under way, and hrt_reach_cancel() ends it. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_reach_end(hrt_session session, hrt_reach_summary* out_summary) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
