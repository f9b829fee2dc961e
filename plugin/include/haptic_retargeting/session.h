/*
 * A session: one user, one plate, and what the controller assumes about both.
 *
 *   create -> add targets -> (begin -> update ... update -> end) for each reach -> destroy
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
#define HRT_SESSIONS_MAX 64

/** Source of the plate's commands. */
#define HRT_CONTROL_MPC 0         /**< the model-predictive controller */
#define HRT_CONTROL_FIXED_PLATE 1 /**< a plate that does not turn, as a baseline */

/** Direction to which the controller steers the finger. */
#define HRT_GUIDANCE_FIXED_DIRECTION 0 /**< the real target's, seen from the start */
/** From the finger to the real target; constant over the last fifth of the path. Needs positions: with
 *  directions alone this is FIXED_DIRECTION. */
#define HRT_GUIDANCE_LINE_OF_SIGHT 1

/** Learning of the tactile weight and the motor variance. */
#define HRT_ADAPTATION_OFF 0 /**< both are taken as known */
/** The tactile weight is learnt within each reach. The summary also has the motor variance of the reach. */
#define HRT_ADAPTATION_REACH 1
/** As REACH; the end of a reach also writes tactile_weight, motor_variance_deg2 and their deviations into
 *  the configuration. Deviations stay at or above 0.01 and 0.1, because people change. One reach changes
 *  the motor variance by a factor of 2 at most, within 0.05 to 5; if clamped to it, its deviation is
 *  unchanged. */
#define HRT_ADAPTATION_CARRIED 2

/** Configuration of a session. hrt_session_config_default() fills every field. */
typedef struct hrt_session_config {
  uint32_t struct_size;
  /** Steps that the controller plans ahead. With 1 most reaches miss; more than 3 changes little and costs
   *  time. 1 to 50. Default 3. */
  uint32_t horizon;
  /** Duration of one step of the model and of the controller. The variances below are per step: scale them
   *  with it. 1 ms to 10 s. Default 100 ms. */
  int64_t step_period_ns;
  /** HRT_CONTROL_*. Default HRT_CONTROL_MPC. */
  uint32_t control;
  /** HRT_GUIDANCE_*. Default HRT_GUIDANCE_LINE_OF_SIGHT. */
  uint32_t guidance;
  /** HRT_ADAPTATION_*. Default HRT_ADAPTATION_OFF. */
  uint32_t adaptation;
  uint32_t reserved;
  /** Cost of the error that the user feels. Raising it keeps the felt direction closer to the virtual one
   *  and steers more slowly. 1e-6 to 1e6. Default 1. */
  double perceived_weight;
  /** Cost of the finger's actual error. Raising it steers faster, with a larger felt error; 0 steers not
   *  at all. 0 to 1e6. Default 1. */
  double actual_weight;
  /** Maximum angle, modulo 180, between the plate orientation (base.h) and the virtual direction plus
   *  bias_deg. Raising it allows larger gaps; near 90 the ridges run along the motion and signal nothing.
   *  0.1 to 90. Default 84.5. */
  double plate_bound_deg;
  /** Maximum speed of the plate's servo, within which the controller plans. 0 to 1e6 degrees a second; 0:
   *  no limit. Default 0. */
  double plate_max_speed_deg_s;
  /** Maximum acceleration of the servo, within which the controller plans. 0 to 1e8 degrees a second
   *  squared; 0: no limit. Default 0. */
  double plate_max_acceleration_deg_s2;
  /** Time from a command to the plate's first motion. The controller plans from where the plate will be by
   *  then. 0 to 1 s, and at most 8 step periods. Default 0. */
  int64_t plate_latency_ns;
  /** Mechanical stops, as plate orientations (base.h): no command lies beyond them. -3600 to 3600, the
   *  upper at least 180 above the lower; both 0: no stops. Default 0 and 0. */
  double plate_lower_stop_deg;
  double plate_upper_stop_deg;
  /** Plate orientation (base.h) under HRT_CONTROL_FIXED_PLATE. With stops, the plate goes to the nearest
   *  orientation with the same ridges. -180 to 180. Default 0. */
  double fixed_plate_orientation_deg;
  /** Share of touch in the direction that the user feels. At a higher weight, the same turn of the plate
   *  steers the hand further. 0.001 to 0.499. Default 0.15. */
  double tactile_weight;
  /** Standard deviation of tactile_weight, from which adaptation starts. Raising it makes adaptation
   *  faster and less steady. 0.001 to 0.49. Default 0.05. */
  double tactile_weight_sd;
  /** Variance of the user's motor command per step. Raising it makes the estimator follow the samples more
   *  closely. 1e-9 to 1e4. Default 0.5. */
  double motor_variance_deg2;
  /** Variance of the felt direction per step. Raising it models a user who reacts to touch more slowly.
   *  1e-9 to 1e4. Default 0.1. */
  double sensory_variance_deg2;
  /** Variance of the user's felt direction before the first step. Raising it models a user who trusts
   *  touch more in the first steps. 0 to 1e4. Default 0. */
  double initial_variance_deg2;
  /** Standard deviation of white noise in each tracked coordinate. Raising it smooths positions more. 0 to
   *  0.1, less than 1e-9 as 1e-9; 0: learnt from the samples. Default 0. */
  double tracker_noise_m;
  /** Start of reaches in plate coordinates. Directions of targets are measured from here. Each within
   *  1000. Default (0, 0, 0.05): on the mid-line, 5 cm towards the user. */
  double start_position_m[3];
  /** Radius of the plate: positions beyond it get HRT_COMMAND_OFF_PLATE. 0.001 to 1000. Default 0.075. */
  double plate_radius_m;
  /** Height above the plate: positions above it count as lifted. 0.0001 to 1000. Default 0.015. */
  double lift_height_m;
  /** Centre of the plate in the engine's world. Each within 1000. Default (0, 0, 0). */
  double plate_position_m[3];
  /** Rotation of the plate's mount in the world: the unit quaternion x, y, z, w from plate coordinates to
   *  the world's axes. It does not turn with the ridges. Length 1 within 0.001. Default (0, 0, 0, 1). */
  double plate_rotation[4];
  /** Perceptual bias: perceived minus true direction of a virtual target. The user goes to the virtual
   *  direction plus this bias. Found by calibration.h, not learnt in reaches. -45 to 45. Default 0. Since
   *  version 0.2. */
  double bias_deg;
  /** Standard deviation of motor_variance_deg2, from which adaptation starts. Raising it makes adaptation
   *  faster and less steady. 0.001 to 10. Default 0.5. Since version 0.2. */
  double motor_variance_sd_deg2;
} hrt_session_config;

/** Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread] */
HRT_API hrt_result hrt_session_config_default(hrt_session_config* out_config,
                                              uint32_t struct_size) HRT_NOEXCEPT;

/** Creates a session. Errors: OUT_OF_RANGE naming the field, STRUCT_SIZE, LIMIT_REACHED, OUT_OF_MEMORY.
 *  [any-thread] */
HRT_API hrt_result hrt_session_create(const hrt_session_config* config,
                                      hrt_session* out_session) HRT_NOEXCEPT;

/** Destroys the session and its targets; ends its reach and its recording. [one-thread] */
HRT_API hrt_result hrt_session_destroy(hrt_session session) HRT_NOEXCEPT;

/** Returns the configuration. Set `out_config->struct_size` before the call. [one-thread] */
HRT_API hrt_result hrt_session_get_config(hrt_session session, hrt_session_config* out_config) HRT_NOEXCEPT;

/** Replaces the configuration. Targets stay, and so do fields that an older caller's struct lacks. Errors:
 *  as hrt_session_create(), and WRONG_STATE during a reach. [one-thread] */
HRT_API hrt_result hrt_session_set_config(hrt_session session, const hrt_session_config* config) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
