/*
 * A session: one user, one plate, and the assumptions of the controller about both. "The paper" is "Controlling Hand
 * Movements relying on Tactile Illusions: A Model Predictive Control Framework". Order of calls:
 *
 *   create -> add targets -> (begin -> update ... update -> end or cancel) for each reach -> destroy
 *
 * Example: a session for a plate whose servo and stops were measured.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session session;
 *     hrt_session_config config = hrt_session_config_init(); // the defaults suit a plate of 75 mm radius
 *     config.plate.max_speed_deg_s = 300;
 *     config.plate.latency_ns = 30000000;
 *     config.plate.lower_stop_deg = -135, config.plate.upper_stop_deg = 135;
 *     config.flags = HRT_SESSION_PLATE_WAITS; // the finger rests on the ridges before a reach
 *     if (hrt_session_create(HRT_VERSION, &config, &session)) return puts(hrt_last_error()), 1;
 *     return hrt_session_destroy(session);
 *   }
 *
 * Structs are not nested in other languages, profiles and recordings: there, `plate.scale` is `plate_scale`.
 */
#ifndef HAPTIC_RETARGETING_SESSION_H
#define HAPTIC_RETARGETING_SESSION_H

#include "base.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A session's handle. Zero is never a session. Handles are never reused. */
typedef struct hrt_session {
  uint64_t value;
} hrt_session;

/** Maximum number of sessions in a process. */
#define HRT_SESSIONS_MAX 1024

/** @enumeration HRT_CONTROL Source of the plate's commands. */
typedef uint32_t hrt_control;
#define HRT_CONTROL_MPC 0 /**< a model-predictive controller, which `guidance` selects */
/** A constant plate orientation, as a baseline of studies. Estimates and outputs are as under FIXED_DIRECTION. */
#define HRT_CONTROL_FIXED_PLATE 1

/** @enumeration HRT_GUIDANCE Goal of the controller under HRT_CONTROL_MPC; each goal has its own controller. */
typedef uint32_t hrt_guidance;
/** Steers the finger along the direction of the real target, seen from the start: the controller of the paper. It
 *  assumes that the illusion is linear. Choose it to reproduce the paper, or if only directions are tracked. */
#define HRT_GUIDANCE_FIXED_DIRECTION 0
/** Steers the finger so that it arrives at the position of the real target. Estimates the duration of the motion, the
 *  nonlinear illusion, bias, habits and tracker noise. Requires positions: if samples have directions only,
 *  FIXED_DIRECTION is used. Tested with simulated people only. */
#define HRT_GUIDANCE_ARRIVAL 1

/** @enumeration HRT_ADAPTATION Estimation of the user's parameters: under GUIDANCE_ARRIVAL of all traits in
 *  person.mean, otherwise of the tactile weight and the motor variance. */
typedef uint32_t hrt_adaptation;
/** person.tactile_weight and person.bias_deg are assumed to be exact, and the illusion to be linear; under
 *  GUIDANCE_ARRIVAL, only while person.covariance is 0. */
#define HRT_ADAPTATION_OFF 0
/** The parameters are estimated within each reach. Each reach starts from the configured values, so that reaches of a
 *  study do not depend on earlier reaches. */
#define HRT_ADAPTATION_REACH 1
/** As REACH; in addition, hrt_reach_end() writes the estimates into the configuration: person.mean, person.covariance,
 *  person.tactile_weight and person.tactile_weight_sd, with increased uncertainty, because people change. A reach that
 *  ends early, does not fit the model (HRT_COMMAND_MISFIT) or is implausible writes nothing. Under FIXED_DIRECTION, a
 *  reach writes person.tactile_weight, paper.motor_variance_deg2 and their SDs, if it is not implausible; it changes
 *  the variance by a factor of 2 at most. */
#define HRT_ADAPTATION_CARRIED 2

/** @flags HRT_SESSION Options of a session: hrt_session_config::flags. */
typedef uint32_t hrt_session_flags;
/** Under GUIDANCE_ARRIVAL, the plate does not move until the finger moves. Set this flag if the finger rests on the
 *  ridges before a reach, because the user feels a plate that turns under a resting finger. Without the flag, the first
 *  command already turns the plate to the orientation that the start of the motion requires, and more fast reaches end
 *  at the target. Under FIXED_DIRECTION, the plate waits in any case. */
#define HRT_SESSION_PLATE_WAITS UINT32_C(1)
/** The plate's pose is from a registration made or checked at registration.time_ns. HRT_SETUP_REGISTRATION sets this
 *  flag; a failed HRT_SETUP_CHECK and hrt_scene_register() clear it. All three discard contacts
 *  (hrt_reach_touched()). */
#define HRT_SESSION_REGISTERED UINT32_C(2)
/** The user finds start_position_m by touch, for example by a dimple. A finger that rests before a reach is then
 *  assumed to be at the start, even if the tracker reports another position, and positions are measured relative to
 *  this rest: a shift of the tracker's coordinate system does not rotate a reach. The controller of FIXED_DIRECTION
 *  ignores the flag. HRT_SETUP_GUIDES sets it. */
#define HRT_SESSION_START_FELT UINT32_C(4)

/* Indices of the user's parameters (traits) in hrt_session_config::person.mean. */
/** Slope w of the illusion curve: the perceived direction is shifted by w t - b t (t / 75)^2 degrees, where t is the
 *  angle between the normal of the ridges and the motion, in degrees. A positive HRT_PERSON_FADING reduces the shift.
 *  @range 0.01 to 0.6 @unit 1 */
#define HRT_PERSON_WEIGHT 0
/** Curvature b of the illusion curve, in the formula of HRT_PERSON_WEIGHT; 0: linear. @range -0.1 to 0.5 @unit 1 */
#define HRT_PERSON_CURVE 1
/** Rate at which the user corrects the perceived-direction error. @range 3 to 20 @unit 1/s */
#define HRT_PERSON_GAIN 2
/** Bias: direction that the user aims at, minus the virtual direction. @range -90 to 90 @unit deg @ccw */
#define HRT_PERSON_BIAS 3
/** Habit, a curvature of the path: aimed direction at the start minus that at the end, divided by 2; mean over reaches.
 *  @range -45 to 45 @unit deg @ccw */
#define HRT_PERSON_HABIT 4
/** Speed profile of the motion, from 0: minimum jerk, to 1: constant speed. @range 0 to 1 @unit 1 */
#define HRT_PERSON_EVENNESS 5
/** Natural logarithm of the reciprocal of a reach's duration in seconds. @range -3 to 2.4 @unit 1 */
#define HRT_PERSON_LOG_RATE 6
/** Fraction of the tactile sensation that fades between two ridges. 0: the user always feels all of the ridges; 1: a
 *  ridge is felt when the finger crosses it, and then fades. @range -0.2 to 1 @unit 1 */
#define HRT_PERSON_FADING 7
/** SD of the bias from reach to reach: how steadily the user aims. @range 0 to 10 @unit deg */
#define HRT_PERSON_SCATTER 8
/** Natural logarithm of the SD, in degrees, of the random deviation of the motion from the direction in which the user
 *  steers. @range -1.5 to 3 @unit 1 */
#define HRT_PERSON_LOG_WANDER 9
/** Number of traits. */
#define HRT_PERSON_TRAITS 10
/** Number of elements in the lower triangle of the covariance of all traits. */
#define HRT_PERSON_COVARIANCES 55

/** Part of hrt_session_config: limits of the plate and its servo, and the plate's pose in the world. */
typedef struct hrt_session_plate {
  /** Maximum speed of the plate's servo, which the controller expects; 0: no limit. Set the measured speed: if the
   *  value is too high, the plate lags behind the model; if it is too low, the controller turns the plate earlier or
   *  more slowly than necessary. @range 0 to 1e6 @default 0 */
  double max_speed_deg_s;
  /** Maximum acceleration of the servo, which the controller expects; 0: no limit. A wrong value has the same effects
   *  as a wrong max_speed_deg_s. @range 0 to 1e8 @default 0 */
  double max_acceleration_deg_s2;
  /** Time from a command to the plate's first motion. The controller plans from the orientation that the plate will
   *  have after this time. Set the measured time: a value that is too small makes every correction late. At most 8
   *  times paper.step_period_ns. @range 0 to 1 s @default 0 */
  int64_t latency_ns;
  /** Lower mechanical stop, as a plate orientation. If both stops are 0, the plate turns freely. If a stop limits a
   *  command, HRT_COMMAND_SATURATED is set, and the plate may not sustain the gap. @range -3600 to 3600 @default 0
   *  @ccw */
  double lower_stop_deg;
  /** Upper mechanical stop, at least 180 degrees above the lower one. @range -3600 to 3600 @default 0 @ccw */
  double upper_stop_deg;
  /** Radius of the plate. Positions beyond it get HRT_COMMAND_OFF_PLATE. Set-ups derive their default marks and the
   *  length of slides from it. @range 0.02 to 1 @default 0.075 */
  double radius_m;
  /** Centre of the plate in the engine's world. A set-up writes position and rotation; for a fixed plate, the host may
   *  set both. @range -1000 to 1000 @default (0, 0, 0) @profile registration.contact_covariance */
  double position_m[3];
  /** Rotation of the plate's mount, which does not turn with the ridges: the unit quaternion x, y, z, w from plate
   *  coordinates to the axes of the world. @norm 0.999 to 1.001 @unit 1 @default (0, 0, 0, 1)
   *  @profile registration.contact_covariance */
  double rotation[4];
  /** Length in the engine's world of 1 m on the plate; differs from 1 if the tracker's unit of length is wrong. World
   *  positions relative to the plate's centre are divided by the scale. @range 0.5 to 2 @unit 1 @default 1
   *  @profile registration.contact_covariance */
  double scale;
  /** Covariance of the plate's pose in its plane: rotation about the normal (radians, counter-clockwise) and position
   *  of the centre to the right and away (metres). Lower triangle, row by row; positive semidefinite. All 0: the pose
   *  is exact. A set-up writes it. Under GUIDANCE_ARRIVAL, it contributes to UNREACHABLE, OFF_TARGET and miss_sd_deg,
   *  but not to the plate orientation. @unit mixed @range -1 to 1 @default 0 */
  double covariance[6];
} hrt_session_plate;

/** Part of hrt_session_config: errors of the tracker. */
typedef struct hrt_session_tracker {
  /** SD of the white noise in each tracked coordinate. Under GUIDANCE_ARRIVAL, if tracker.correlated_noise_m is 0: SD
   *  of all noise. A larger value smooths positions more and delays corrections. 0: estimated from the samples; other
   *  values below 1e-9 count as 1e-9. @range 0 to 0.1 @default 0 @profile */
  double noise_m;
  /** SD of the correlated part of the noise in each coordinate, under GUIDANCE_ARRIVAL; tracker.noise_m is then the
   *  white part only. 0: unknown. A calibration measures it. If it is too small, slow drifts of the tracker are taken
   *  for motions of the finger. @range 0 to 0.1 @default 0 @profile tracker.correlated_noise_m */
  double correlated_noise_m;
  /** Time in which the correlated part decays to 1/e. Read if tracker.correlated_noise_m is not 0. @range 0.01 to 2
   *  @default 0.1 @profile tracker.correlated_noise_m */
  double correlation_s;
  /** Age of a position at the time_ns of its sample. Used under GUIDANCE_ARRIVAL only. Set the value of the device
   *  (SETUP.md): latency that is not configured makes fast reaches miss. @range 0 to 0.5 s @default 0 */
  int64_t latency_ns;
  /** SD of the tracker's error in the bearing of a reach. The error is constant within a reach, so the samples do not
   *  show it, and differs from reach to reach. The SD contributes to hrt_gap::miss_share and, under GUIDANCE_ARRIVAL,
   *  to miss_sd_deg and OFF_TARGET. SETUP.md describes how to measure it. @range 0 to 45 @default 0 */
  double bearing_sd_deg;
} hrt_session_tracker;

/** Part of hrt_session_config: the user. Calibrations, profiles and, with HRT_ADAPTATION_CARRIED, reaches write
 *  estimates into these fields. */
typedef struct hrt_session_person {
  /** Tactile weight w_T: weight of touch in the perceived direction; the arm's own sense has the weight 1 - w_T. The
   *  higher the user's weight, the further a rotation of the plate steers the hand. If this value is above the user's
   *  weight, the controller steers too little. Under GUIDANCE_ARRIVAL, w_T is the perceived shift divided by the angle
   *  between motion and ridge normal, at 60 degrees; it is not read if person.covariance is not 0.
   *  @range 0.001 to 0.499 @unit 1 @default 0.2 @profile @flatten tactile_weight */
  double tactile_weight;
  /** SD of person.tactile_weight, from which adaptation starts. A larger value makes adaptation faster and noisier;
   *  under GUIDANCE_ARRIVAL, it also raises the uncertainty of the illusion curve in proportion. @range 0.001 to 0.49
   *  @unit 1 @default 0.05 @profile @flatten tactile_weight_sd */
  double tactile_weight_sd;
  /** Perceptual bias: perceived minus true direction of a virtual target. The user aims at the virtual direction plus
   *  this bias. A calibration measures it. Under GUIDANCE_ARRIVAL, reaches estimate the bias too, as HRT_PERSON_BIAS of
   *  person.mean. @range -45 to 45 @default 0 @profile @ccw @flatten bias_deg */
  double bias_deg;
  /** Maximum predicted perceived-direction error (perceived minus intended direction) that the plate may cause under
   *  GUIDANCE_ARRIVAL. Lowering it makes the illusion less noticeable, but fewer reaches end at the target: with
   *  simulated users, 2 in 100 fewer at 3.5 degrees. The actual error may be larger, because of noise and of errors of
   *  the estimates. @range 0.1 to 45 @default 5 @flatten max_felt_error_deg */
  double max_felt_error_deg;
  /** Maximum angle between the plate orientation and the direction of the motion under GUIDANCE_ARRIVAL. Raising it
   *  allows larger gaps for users whose illusion still increases at that angle; published data cover angles up to 60
   *  degrees. The controller does not plan beyond the estimated peak of the illusion. A calibration may write this
   *  field. @range 1 to 89 @default 75 @flatten motion_bound_deg */
  double motion_bound_deg;
  /** Mean of the traits HRT_PERSON_*, whose comments have the ranges. Used if person.covariance is not 0.
   *  @elements HRT_PERSON @unit mixed @range -100 to 100 @default 0 @profile person.covariance */
  double mean[HRT_PERSON_TRAITS];
  /** Covariance of person.mean: lower triangle, row by row; positive definite. All 0: the user is unknown, and
   *  person.tactile_weight, person.tactile_weight_sd and person.bias_deg are used instead of person.mean. @unit mixed
   *  @range -1e4 to 1e4 @default 0 @profile person.covariance */
  double covariance[HRT_PERSON_COVARIANCES];
} hrt_session_person;

/** Part of hrt_session_config: age and accuracy of the registration, and its correction by contacts with real objects
 *  (hrt_reach_touched()). */
typedef struct hrt_session_registration {
  /** Time of the registration or of its last check, on the clock of the samples. Used with max_age_ns. @range any
   *  @default 0 */
  int64_t time_ns;
  /** Maximum age of the registration at a sample. HRT_COMMAND_REGISTRATION is set if the registration is older, or if
   *  HRT_SESSION_REGISTERED is not set. A lower value detects a moved plate earlier and requires more set-ups. 0: not
   *  checked. @range 0 or more @default 0 */
  int64_t max_age_ns;
  /** Maximum SD of the bearing of the real target that follows from plate.covariance or from contacts.
   *  HRT_COMMAND_REGISTRATION is set if the SD is larger, or if HRT_SESSION_REGISTERED is not set. A lower value
   *  requires more touches in a set-up. 0: not checked. @range 0 to 180 @default 0 */
  double max_sd_deg;
  /** Matrix D, row by row, that corrects the registration by contacts: a finger that is tracked at the vector r from
   *  the start (to the right, away from the user) is in fact at r + D r. Used if registration.contact_covariance is not
   *  0 and HRT_SESSION_REGISTERED is set. hrt_reach_touched() and HRT_SETUP_GUIDES write it. A call of
   *  hrt_session_set() that changes the plate's pose, but neither this field nor contact_covariance, resets both to 0.
   *  @unit 1 @range -0.5 to 0.5 @default 0 @flatten contact_correction @profile registration.contact_covariance */
  double contact_correction[4];
  /** Covariance of registration.contact_correction: lower triangle, row by row; positive definite. All 0: no contact
   *  yet. @unit 1 @range -1e4 to 1e4 @default 0 @flatten contact_covariance @profile registration.contact_covariance */
  double contact_covariance[10];
} hrt_session_registration;

/** Part of hrt_session_config: the controller of the paper, and the noise of the user in its model. Without effect on
 *  commands under GUIDANCE_ARRIVAL, unless samples have directions only. */
typedef struct hrt_session_paper {
  /** Steps that the controller plans ahead. With a horizon of 1, most reaches miss; a horizon above 3 changes little
   *  and takes more computing time. @range 1 to 20 @default 3 */
  uint32_t horizon;
  /** Duration of one step of the model and of the controller. Shorter steps correct more often. If you change it, scale
   *  the variances below, which are per step. @range 1 ms to 10 s @default 100 ms */
  int64_t step_period_ns;
  /** Cost of the perceived-direction error. Raising it makes the controller steer more slowly, with a smaller
   *  perceived-direction error. @range 1e-6 to 1e6 @unit 1 @default 1 */
  double perceived_weight;
  /** Cost of the angle between the finger's direction and that of the real target. Raising it makes the controller
   *  steer faster, with a larger perceived-direction error; 0: no steering. @range 0 to 1e6 @unit 1 @default 1 */
  double actual_weight;
  /** Maximum angle, modulo 180, between the plate orientation and the virtual direction plus person.bias_deg. Raising
   *  it allows larger gaps; near 90, the ridges run along the motion and provide no cue. @range 0.1 to 90
   *  @default 84.5 */
  double plate_bound_deg;
  /** Variance of the user's motor command per step. Raising it makes the estimator follow the samples more closely.
   *  @range 1e-9 to 1e4 @default 0.5 @profile */
  double motor_variance_deg2;
  /** SD of paper.motor_variance_deg2, from which adaptation starts. Raising it makes adaptation faster and less steady.
   *  @range 0.001 to 10 @default 0.5 @profile */
  double motor_variance_sd_deg2;
  /** Variance of the perceived direction per step. Raising it models a user who reacts to touch more slowly.
   *  @range 1e-9 to 1e4 @default 0.1 @profile */
  double sensory_variance_deg2;
  /** Variance of the perceived direction before the first step. Raising it models a user who relies more on touch in
   *  the first steps. @range 0 to 1e4 @default 0 @profile */
  double initial_variance_deg2;
} hrt_session_paper;

/** Configuration of a session. */
typedef struct hrt_session_config {
  uint32_t struct_size;
  /** Source of the plate's commands. @default HRT_CONTROL_MPC */
  hrt_control control;
  /** Goal of the controller under HRT_CONTROL_MPC. @default HRT_GUIDANCE_ARRIVAL */
  hrt_guidance guidance;
  /** Estimation of the user's parameters from reaches. @default HRT_ADAPTATION_CARRIED */
  hrt_adaptation adaptation;
  /** Options. @default 0 */
  hrt_session_flags flags;
  /** Plate orientation under HRT_CONTROL_FIXED_PLATE. Of the orientations within the stops that differ from it by
   *  multiples of 180 degrees, the plate turns to the one nearest to its present orientation. @range -180 to 180
   *  @default 0 @ccw */
  double fixed_plate_orientation_deg;
  /** Start of reaches in plate coordinates. Directions of targets are measured from here: moving it changes the gaps of
   *  targets that are given by positions. The default is on the mid-line, 5 cm towards the user. @range -10 to 10
   *  @default (0, 0, 0.05) */
  double start_position_m[3];
  /** A finger that is tracked higher than this above the plate is assumed to be lifted. If the value is too low, noise
   *  of the tracker interrupts reaches; if it is too high, a hovering finger is assumed to touch the plate.
   *  @range 0.0001 to 1 @default 0.015 */
  double lift_height_m;
  /** Vector from the tracked joint to the point of contact on the skin, in the axes of the joint. Applied to samples
   *  with HRT_SAMPLE_JOINT_ROTATION. HRT_SETUP_FINGERTIP measures it; measure it again for another hand. @range -1 to 1
   *  @default 0 */
  double fingertip_offset_m[3];
  hrt_session_plate plate;               /**< limits and pose of the plate @flatten plate_* */
  hrt_session_tracker tracker;           /**< errors of the tracker @flatten tracker_* */
  hrt_session_person person;             /**< the user @flatten person_* */
  hrt_session_registration registration; /**< age and accuracy of the pose @flatten registration_* */
  hrt_session_paper paper;               /**< the controller of the paper @flatten * */
} hrt_session_config;

/** Creates a session.
 *
 *  @param version      HRT_VERSION, so that the library can reject a program that was built with incompatible headers.
 *  @param config       Configuration, copied. Null: the defaults.
 *  @param out_session  Handle of the session.
 *  @return OUT_OF_RANGE naming the field or `version`; LIMIT_REACHED for more than HRT_SESSIONS_MAX sessions;
 *          OUT_OF_MEMORY.
 *  @threadsafety [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_session_create(uint32_t version, const hrt_session_config* config,
                                                    hrt_session* out_session) HRT_NOEXCEPT;

/** @flags HRT_STATE State of a session, from hrt_session_get(). Without READY, REACHING and SETTING_UP: no reach can
 *  begin, because the session has no real or no virtual target. */
typedef uint32_t hrt_session_state;
#define HRT_STATE_READY UINT32_C(1)      /**< a reach can begin: there is a real and a virtual target */
#define HRT_STATE_REACHING UINT32_C(2)   /**< a reach is in progress */
#define HRT_STATE_SETTING_UP UINT32_C(4) /**< a set-up is in progress: no reach can begin */
#define HRT_STATE_RECORDING UINT32_C(8)  /**< the calls of the session are recorded */

/** Returns the configuration and the state of a session.
 *
 *  @param session     Session to query; INVALID_HANDLE is returned if it does not exist.
 *  @param out_config  Receives the configuration. May be null.
 *  @param out_state   Receives the state. May be null. Later versions may set further bits.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_session_get(hrt_session session, hrt_session_config* out_config,
                                                 hrt_session_state* out_state) HRT_NOEXCEPT;

/** Replaces the configuration of a session. Targets are kept.
 *
 *  @param config  Configuration, copied. Null: the defaults.
 *  @return WRONG_STATE during a reach or a set-up; otherwise as hrt_session_create().
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_session_set(hrt_session session, const hrt_session_config* config) HRT_NOEXCEPT;

/** Destroys a session with its targets, its reach and its set-up, and stops its recording.
 *
 *  @threadsafety [one-thread] */
HRT_API hrt_result hrt_session_destroy(hrt_session session) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
