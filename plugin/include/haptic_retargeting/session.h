/*
 * A session: one user, one plate, and what the controller assumes about both.
 *
 *   create -> add targets -> (begin -> update ... update -> end or cancel) for each reach -> destroy
 *
 * Bindings, files and messages know no parts of the configuration: `plate.scale` is `plate_scale` there.
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

/** Source of the plate's commands. */
#define HRT_CONTROL_MPC 0         /**< the model-predictive controller */
#define HRT_CONTROL_FIXED_PLATE 1 /**< a plate that does not turn, as a baseline */

/** What the controller steers the finger to, and so which controller it is. */
/** The real target's direction, seen from the start: the controller of the paper, for the person of its
 * model. */
#define HRT_GUIDANCE_FIXED_DIRECTION 0
/** The real target's place, at arrival: the controller for people. It takes the pace of the motion, the whole
 * curve of the illusion, bias, habits and the tracker's noise as unknown, and learns them. Needs positions:
 * in a reach with directions alone this is FIXED_DIRECTION. Measured on simulated people only. */
#define HRT_GUIDANCE_ARRIVAL 1

/** Learning of the person: under GUIDANCE_ARRIVAL of all that person.mean holds, else of the tactile weight
 * and the motor variance. */
#define HRT_ADAPTATION_OFF                                                                  \
  0 /**< paper.tactile_weight and paper.bias_deg are taken as known, the illusion as linear \
     */
/** The person is learnt within each reach, which begins with what the configuration says of them. */
#define HRT_ADAPTATION_REACH 1
/** As REACH; the end of a reach also writes what it has learnt into the configuration, widened, because
 * people change: person.mean and person.covariance, paper.tactile_weight and its deviation. A reach that ends early
 * or that the model does not fit (HRT_COMMAND_MISFIT) writes nothing. Under FIXED_DIRECTION it writes
 * paper.tactile_weight and paper.motor_variance_deg2; one reach changes the latter by a factor of 2 at most. */
#define HRT_ADAPTATION_CARRIED 2

/** hrt_session_config::flags. */
/** The plate stays where it stands until the finger moves. Otherwise it turns to where the first moment of
 * the motion wants it as soon as a reach begins, which brings more fast reaches to the target. Set this if
 * the finger rests on the ridges before a reach: a plate that turns under a resting finger is felt. */
#define HRT_SESSION_PLATE_WAITS UINT32_C(1)
/** The plate's pose is from a registration made at registration.time_ns. A set-up sets this;
 * hrt_scene_register(), which writes the scene's pose, clears it. Either one forgets contacts. */
#define HRT_SESSION_REGISTERED UINT32_C(2)
/** The finger finds start_position_m by touch, as in a dimple: it is there when it rests before a reach,
 * wherever the tracker sees it, and places count from there. A skin that touches elsewhere and a shifted frame then
 * turn no reach. Read under GUIDANCE_ARRIVAL. HRT_SETUP_GUIDES sets this. */
#define HRT_SESSION_START_FELT UINT32_C(4)

/** Traits of a person, in this order, in hrt_session_config::person.mean. */
/** w: slope of the felt shift w t - b t (t / 75)^2 over the plate's angle t. 0.01 to 0.6. */
#define HRT_PERSON_WEIGHT 0
#define HRT_PERSON_CURVE 1 /**< b: 0 for a linear illusion. -0.1 to 0.5. */
#define HRT_PERSON_GAIN 2  /**< rate at which they correct the direction they feel. 3 to 20 1/s. */
#define HRT_PERSON_BIAS 3  /**< goal minus virtual direction, degrees. -90 to 90. */
/** Curving: the goal's turn at the start, minus that at the end, halved, degrees. -45 to 45. */
#define HRT_PERSON_HABIT 4
#define HRT_PERSON_EVENNESS 5 /**< of the pace: 0 minimum jerk, 1 even. 0 to 1. */
#define HRT_PERSON_HEADING 6  /**< share of the goal's direction in which they set out. -2 to 2. */
/** Natural logarithm of one over a reach's duration in seconds. -3 to 2.4. */
#define HRT_PERSON_LOG_RATE 7
/** Share of touch that fades from one ridge to the next: 0 if all of the ridges is always felt, 1 if a ridge
 * is felt as it is crossed and then fades. -0.2 to 1. */
#define HRT_PERSON_FADING 8
/** Standard deviation of the bias from reach to reach, degrees: how steadily they aim. 0 to 10. */
#define HRT_PERSON_SCATTER 9
/** Number of traits. */
#define HRT_PERSON_TRAITS 10
/** Numbers in the lower triangle of their covariance. */
#define HRT_PERSON_COVARIANCES 55

/** Part of hrt_session_config: what the plate and its servo can do, and where it is in the world. */
typedef struct hrt_session_plate {
  /** Maximum speed of the plate's servo, within which the controller plans. 0 to 1e6 degrees a second; 0: no
   * limit. Default 0. */
  double max_speed_deg_s;
  /** Maximum acceleration of the servo, within which the controller plans. 0 to 1e8 degrees a second squared;
   * 0: no limit. Default 0. */
  double max_acceleration_deg_s2;
  /** Time from a command to the plate's first motion. The controller plans from where the plate will be by
   * then. 0 to 1 s, and at most 8 step periods. Default 0. */
  int64_t latency_ns;
  /** Mechanical stops, as plate orientations (base.h): no command lies beyond them. -3600 to 3600, the upper
   * at least 180 above the lower; both 0: no stops. Default 0 and 0. */
  double lower_stop_deg;
  double upper_stop_deg;
  /** Radius of the plate: positions beyond it get HRT_COMMAND_OFF_PLATE. 0.001 to 1000. Default 0.075. */
  double radius_m;
  /** Centre of the plate in the engine's world. Each within 1000. Default (0, 0, 0). In profiles if
   * registration.contact_covariance is not 0. */
  double position_m[3];
  /** Rotation of the plate's mount in the world: the unit quaternion x, y, z, w from plate coordinates to the
   * world's axes. It does not turn with the ridges. Length 1 within 0.001. Default (0, 0, 0, 1). In profiles
   * if registration.contact_covariance is not 0. */
  double rotation[4];
  /** Length in the engine's world of 1 m on the plate: other than 1 if the tracker's unit is off. Divides
   * positions and targets in the world, as seen from the plate's centre. 0.5 to 2. Default 1. In profiles if
   * registration.contact_covariance is not 0. */
  double scale;
  /** Covariance of the plate's pose in its own plane, wherever the pose comes from: its turn about its normal
   * (radians, counter-clockwise) and its centre's place to the right and away (metres); the lower triangle,
   * row by row; positive semidefinite. All 0: the pose is exact. Under GUIDANCE_ARRIVAL it goes into
   * UNREACHABLE and miss_sd_deg; it does not change commands. Each within 1. Default 0. */
  double covariance[6];
} hrt_session_plate;

/** Part of hrt_session_config: what the tracker does to a motion. */
typedef struct hrt_session_tracker {
  /** Standard deviation of white noise in each tracked coordinate; under GUIDANCE_ARRIVAL of all noise,
   * unless tracker.correlated_noise_m says how much of it is correlated. Raising it smooths positions more. 0
   * to 0.1, less than 1e-9 as 1e-9; 0: learnt from the samples. Default 0. In profiles. */
  double noise_m;
  /** Standard deviation of the correlated part of the tracker's noise in each coordinate, under
   * GUIDANCE_ARRIVAL; tracker.noise_m is then the white part alone. Found by a set-up. 0 to 0.1; 0: not
   * known. Default 0. In profiles if tracker.correlated_noise_m is not 0. */
  double correlated_noise_m;
  /** Time in which that part decays to 1/e; read if it is not 0. 0.01 to 2 s. Default 0.1. In profiles if
   * tracker.correlated_noise_m is not 0. */
  double correlation_s;
  /** Time from a motion to the time_ns of its sample, under GUIDANCE_ARRIVAL. SETUP.md has that of devices. 0 to
   *  0.5 s. Default 0. */
  int64_t latency_ns;
} hrt_session_tracker;

/** Part of hrt_session_config: what GUIDANCE_ARRIVAL believes of the person, and learns. */
typedef struct hrt_session_person {
  /** What is believed of the person under GUIDANCE_ARRIVAL: HRT_PERSON_*, which have the ranges. Read if
   * person.covariance is not 0. Each within 100. Default 0. In profiles if person.covariance is not 0. */
  double mean[HRT_PERSON_TRAITS];
  /** Covariance of person.mean: the lower triangle, row by row; positive definite. All 0: an unknown person,
   * of whom only paper.tactile_weight, paper.tactile_weight_sd and paper.bias_deg are read. Each within 1e4. Default 0.
   * In profiles if person.covariance is not 0. */
  double covariance[HRT_PERSON_COVARIANCES];
} hrt_session_person;

/** Part of hrt_session_config: how fresh and how sure the plate's pose is, and what contacts have shown of it. */
typedef struct hrt_session_registration {
  /** When the plate was registered, on the clock of the samples; read if HRT_SESSION_REGISTERED. Any. Default
   * 0. */
  int64_t time_ns;
  /** Largest age of a registration at a sample. Older ones, and a session without HRT_SESSION_REGISTERED, get
   * HRT_COMMAND_REGISTRATION. 0 or more; 0: not checked. Default 0. */
  int64_t max_age_ns;
  /** Largest standard deviation that plate.covariance, or contacts, may give the bearing of the real target.
   * Worse ones, and a session without HRT_SESSION_REGISTERED, get HRT_COMMAND_REGISTRATION. 0 to 180; 0: not
   * checked. Default 0. */
  double max_sd_deg;
  /** What contacts have shown of the registration: a finger seen at r from the start, to the right and away,
   * is at r + D r. D row by row; read if registration.contact_covariance is not 0 and HRT_SESSION_REGISTERED is set.
   * hrt_reach_touched() writes it, and with another pose of the plate it is 0 unless it changes too. Each
   * within 0.5. Default 0. In profiles if registration.contact_covariance is not 0. */
  double contact_correction[4];
  /** Covariance of registration.contact_correction: the lower triangle, row by row; positive definite. All 0: there was
   * no contact. Each within 1e4. Default 0. In profiles if registration.contact_covariance is not 0. */
  double contact_covariance[10];
} hrt_session_registration;

/** Part of hrt_session_config: the controller and the user of the paper's model. Of these GUIDANCE_ARRIVAL reads
 * the step, the tactile weight and the bias alone. */
typedef struct hrt_session_paper {
  /** Steps that the controller plans ahead. With 1 most reaches miss; more than 3 changes little and costs
   * time. 1 to 50. Default 3. */
  uint32_t horizon;
  /** Duration of one step of the model and of the controller. The variances below are per step: scale them
   * with it. 1 ms to 10 s. Default 100 ms. */
  int64_t step_period_ns;
  /** Cost of the error that the user feels. Raising it keeps the felt direction closer to the virtual one and
   * steers more slowly. 1e-6 to 1e6. Default 1. */
  double perceived_weight;
  /** Cost of the finger's actual error. Raising it steers faster, with a larger felt error; 0 steers not at
   * all. 0 to 1e6. Default 1. */
  double actual_weight;
  /** Maximum angle, modulo 180, between the plate orientation (base.h) and the virtual direction plus
   * paper.bias_deg. Raising it allows larger gaps; near 90 the ridges run along the motion and signal nothing. 0.1
   * to 90. Default 84.5. */
  double plate_bound_deg;
  /** Share of touch in the direction that the user feels. At a higher weight, the same turn of the plate
   * steers the hand further. Under GUIDANCE_ARRIVAL it is that of an illusion taken as linear, at 60 degrees;
   * person.mean overrides it. 0.001 to 0.499. Default 0.2. In profiles. */
  double tactile_weight;
  /** Standard deviation of paper.tactile_weight, from which adaptation starts. Raising it makes adaptation faster
   * and less steady; under GUIDANCE_ARRIVAL it also makes the illusion's curve as uncertain in proportion.
   * 0.001 to 0.49. Default 0.05. In profiles. */
  double tactile_weight_sd;
  /** Variance of the user's motor command per step. Raising it makes the estimator follow the samples more
   * closely. 1e-9 to 1e4. Default 0.5. In profiles. */
  double motor_variance_deg2;
  /** Standard deviation of paper.motor_variance_deg2, from which adaptation starts. Raising it makes adaptation
   * faster and less steady. 0.001 to 10. Default 0.5. In profiles. */
  double motor_variance_sd_deg2;
  /** Variance of the felt direction per step. Raising it models a user who reacts to touch more slowly. 1e-9
   * to 1e4. Default 0.1. In profiles. */
  double sensory_variance_deg2;
  /** Variance of the user's felt direction before the first step. Raising it models a user who trusts touch
   * more in the first steps. 0 to 1e4. Default 0. In profiles. */
  double initial_variance_deg2;
  /** Perceptual bias: perceived minus true direction of a virtual target. The user goes to the virtual
   * direction plus this bias. Found by a set-up; GUIDANCE_ARRIVAL learns the rest. -45 to 45. Default 0.
   * In profiles. */
  double bias_deg;
} hrt_session_paper;

/** Configuration of a session. hrt_session_config_init() fills every field. */
typedef struct hrt_session_config {
  uint32_t struct_size;
  /** HRT_CONTROL_*. Default HRT_CONTROL_MPC. */
  uint32_t control;
  /** HRT_GUIDANCE_*. Default HRT_GUIDANCE_ARRIVAL. */
  uint32_t guidance;
  /** HRT_ADAPTATION_*. Default HRT_ADAPTATION_CARRIED. */
  uint32_t adaptation;
  /** HRT_SESSION_*. Default 0. */
  uint32_t flags;
  /** Largest felt error that GUIDANCE_ARRIVAL asks the plate for: felt minus intended direction, as
   * predicted. Lowering it keeps the illusion less noticeable and reaches somewhat fewer targets: of
   * simulated people, 3.5 costs about 2 reaches in 100. What the person adds, by noise or by being other than
   * estimated, comes on top. 0.1 to 45. Default 5. */
  double max_felt_error_deg;
  /** Largest angle between the plate orientation and the finger's direction under GUIDANCE_ARRIVAL. Raising
   * it allows larger gaps for people whose illusion still grows there; published data cover 60. Never beyond
   * the peak of the person's illusion. 1 to 89. Default 75. */
  double motion_bound_deg;
  /** Plate orientation (base.h) under HRT_CONTROL_FIXED_PLATE. With stops, the plate goes to the nearest
   * orientation with the same ridges. -180 to 180. Default 0. */
  double fixed_plate_orientation_deg;
  /** Start of reaches in plate coordinates. Directions of targets are measured from here. Each within 1000.
   * Default (0, 0, 0.05): on the mid-line, 5 cm towards the user. */
  double start_position_m[3];
  /** Height above the plate: positions above it count as lifted. 0.0001 to 1000. Default 0.015. */
  double lift_height_m;
  /** From the tracked joint to the skin that touches, in the joint's axes; of samples with
   * HRT_SAMPLE_JOINT_ROTATION. Found by a set-up; each hand has its own. Each within 1. Default 0. */
  double fingertip_offset_m[3];
  /** The parts. */
  hrt_session_plate plate;
  hrt_session_tracker tracker;
  hrt_session_person person;
  hrt_session_registration registration;
  hrt_session_paper paper;
} hrt_session_config;

/** Creates a session. `version` is HRT_VERSION: a program that was built with the headers of another version
 * is refused. `config` may be null: the defaults. Errors: OUT_OF_RANGE naming the field or `version`,
 * STRUCT_SIZE, LIMIT_REACHED, OUT_OF_MEMORY. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_session_create(uint32_t version, const hrt_session_config* config,
                                                    hrt_session* out_session) HRT_NOEXCEPT;

/** What a session is about: bits of hrt_session_get(). 0: idle, no reach can begin. */
#define HRT_STATE_READY UINT32_C(1)      /**< a real and a virtual target are there, and no reach is under way */
#define HRT_STATE_REACHING UINT32_C(2)   /**< a reach is under way */
#define HRT_STATE_SETTING_UP UINT32_C(4) /**< a set-up is under way: no reach can begin */
#define HRT_STATE_RECORDING UINT32_C(8)  /**< the calls of the session are recorded */

/** Returns the configuration and what the session is about: HRT_STATE_*; later versions may set further bits.
 * A null output is skipped. Set `out_config->struct_size` before the call. INVALID_HANDLE: there is no such
 * session; BUSY: there is. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_session_get(hrt_session session, hrt_session_config* out_config,
                                                 uint32_t* out_state) HRT_NOEXCEPT;

/** Replaces the configuration; null: by the defaults. Targets stay. Errors: as hrt_session_create(), and
 * WRONG_STATE during a reach or a set-up. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_session_set(hrt_session session, const hrt_session_config* config) HRT_NOEXCEPT;

/** Destroys the session and its targets; ends its reach and its recording. [one-thread] */
HRT_API hrt_result hrt_session_destroy(hrt_session session) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
