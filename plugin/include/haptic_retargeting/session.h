/*
 * A session: one user, one plate, and what the controller assumes of both.
 *
 *   create -> add targets -> (begin -> update ... update -> end) as often as wanted -> destroy
 */
#ifndef HAPTIC_RETARGETING_SESSION_H
#define HAPTIC_RETARGETING_SESSION_H

#include "base.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A session's handle. Zero is never a session. A handle of a destroyed session is never valid again. */
typedef struct hrt_session {
  uint64_t value;
} hrt_session;

/** Sessions that can exist at the same time in a process. */
#define HRT_SESSIONS_MAX 64

/** What decides the plate's orientation. */
#define HRT_CONTROL_MPC 0         /**< the model-predictive controller */
#define HRT_CONTROL_FIXED_PLATE 1 /**< none, as a baseline: the plate stays where it is told to */

/** Where the finger is wanted. */
#define HRT_GUIDANCE_FIXED_DIRECTION 0 /**< in the real target's direction from the start */
/** In the direction from where the finger is to where the real target is, held once less than a fifth of
 *  the path remains. Takes effect when positions are streamed; with directions alone it is as above. */
#define HRT_GUIDANCE_LINE_OF_SIGHT 1

/** Whether the user's share of touch and motor variance are learnt. */
#define HRT_ADAPTATION_OFF 0 /**< no: they are taken as known */
/** The share of touch within each reach, from tactile_weight and its deviation. The reach's summary also
 *  tells the motor variance, from motor_variance_deg2 and its deviation. */
#define HRT_ADAPTATION_REACH 1
/** As REACH; and what a reach has learnt becomes the configuration's: tactile_weight and tactile_weight_sd,
 *  the latter no less than 0.01, and motor_variance_deg2 and motor_variance_sd_deg2, the latter no less than
 *  0.1, as people change. One reach changes the motor variance by a factor of two at most, in which
 *  case its deviation stays; it is kept within 0.05 to 5. */
#define HRT_ADAPTATION_CARRIED 2

/** Everything that a session is made from. hrt_session_config_default() fills every field. */
typedef struct hrt_session_config {
  uint32_t struct_size;
  /** Steps that the controller looks ahead, 1 to 50. Default 3. */
  uint32_t horizon;
  /** Time of one step of the participant's model and of the controller, 1 ms to 10 s. Default 100 ms. */
  int64_t step_period_ns;
  /** HRT_CONTROL_*. Default HRT_CONTROL_MPC. */
  uint32_t control;
  /** HRT_GUIDANCE_*. Default HRT_GUIDANCE_LINE_OF_SIGHT. */
  uint32_t guidance;
  /** HRT_ADAPTATION_*. Default HRT_ADAPTATION_OFF. */
  uint32_t adaptation;
  uint32_t reserved;
  /** Weight of the perceived error in the controller's cost, 1e-6 to 1e6. Default 1. */
  double perceived_weight;
  /** Weight of the actual error in the controller's cost, 0 to 1e6. Default 1. */
  double actual_weight;
  /** The plate stays within this of the direction that the user goes for, the virtual target's and bias_deg,
   *  or of what feels the same; 0.1 to 90. Default 84.5. */
  double plate_bound_deg;
  /** The plate's servo: its highest speed, 0 to 1e6 degrees a second; 0: no limit. Default 0. */
  double plate_max_speed_deg_s;
  /** Its highest acceleration, 0 to 1e8 degrees a second squared; 0: no limit. Default 0. */
  double plate_max_acceleration_deg_s2;
  /** The time from a command to the plate's first motion, 0 to 1 s and to 8 step periods. Default 0. */
  int64_t plate_latency_ns;
  /** The plate's stops, -3600 to 3600, the upper at least 180 above the lower; both 0: it turns freely.
   *  Default 0 and 0. */
  double plate_lower_stop_deg;
  double plate_upper_stop_deg;
  /** Where the plate stays under HRT_CONTROL_FIXED_PLATE, -180 to 180: there, or at what feels
   *  the same between the stops and is nearer to where it stands. Default 0. */
  double fixed_plate_orientation_deg;
  /** Share of touch in the direction that the user feels, 0.001 to 0.499. Default 0.15. */
  double tactile_weight;
  /** Standard deviation of that, for adaptation to start from, 0.001 to 0.49. Default 0.05. */
  double tactile_weight_sd;
  /** Variance of the user's motor command per step, 1e-9 to 1e4. Default 0.5. */
  double motor_variance_deg2;
  /** Variance of what the user feels per step, 1e-9 to 1e4. Default 0.1. */
  double sensory_variance_deg2;
  /** Variance of the user's perceived direction before the first step, 0 to 1e4. Default 0. */
  double initial_variance_deg2;
  /** White noise of each coordinate of a tracked position, standard deviation, 0 to 0.1; 0: learn it from the
   *  samples. Default 0. */
  double tracker_noise_m;
  /** Where reaches start, in plate coordinates; target directions are measured from here, in the plane of
   *  the plate. Each within 1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the user. */
  double start_position_m[3];
  /** Beyond this from the plate's centre a position is off the plate, 0.001 to 1000. Default 0.075. */
  double plate_radius_m;
  /** Higher than this above the plate a position is lifted, 0.0001 to 1000. Default 0.015. */
  double lift_height_m;
  /** The plate's centre in the engine's world, each within 1000. Default (0, 0, 0). */
  double plate_position_m[3];
  /** How the plate's mount is turned in the world, as the unit quaternion x, y, z, w that takes plate
   *  coordinates to the world's axes. It does not turn with the ridges. Default (0, 0, 0, 1). */
  double plate_rotation[4];
  /** The user's own bias: how much further to the left than it is they take a virtual target to lie, -45 to
   *  45. They go for its direction and this. Known from calibration.h, not learnt in reaches. Default 0.
   *  Since version 0.2. */
  double bias_deg;
  /** Standard deviation of motor_variance_deg2, for adaptation to start from, 0.001 to 10. Default 0.5. Since
   *  version 0.2. */
  double motor_variance_sd_deg2;
} hrt_session_config;

/** Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread] */
HRT_API hrt_result hrt_session_config_default(hrt_session_config* out_config,
                                              uint32_t struct_size) HRT_NOEXCEPT;

/** Makes a session. Errors: OUT_OF_RANGE naming the field, STRUCT_SIZE, LIMIT_REACHED, OUT_OF_MEMORY.
 *  [any-thread] */
HRT_API hrt_result hrt_session_create(const hrt_session_config* config,
                                      hrt_session* out_session) HRT_NOEXCEPT;

/** Ends the session, its targets and a reach that is under way. [one-thread] */
HRT_API hrt_result hrt_session_destroy(hrt_session session) HRT_NOEXCEPT;

/** The configuration in use. `out_config->struct_size` must be set. [one-thread] */
HRT_API hrt_result hrt_session_get_config(hrt_session session, hrt_session_config* out_config) HRT_NOEXCEPT;

/** Replaces the configuration, between reaches; targets stay, and so do fields that an older caller's struct
 *  does not have. Errors: as hrt_session_create(), and WRONG_STATE during a reach. [one-thread] */
HRT_API hrt_result hrt_session_set_config(hrt_session session, const hrt_session_config* config) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
