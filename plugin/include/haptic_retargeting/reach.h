/*
 * A reach: the finger goes from the start to a real target while the user feels that it goes to a virtual
 * one. Samples of the finger in, commands for the plate out, in one call.
 */
#ifndef HAPTIC_RETARGETING_REACH_H
#define HAPTIC_RETARGETING_REACH_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** hrt_reach_config::flags. */
/** `plate_orientation_deg` is given; without this the plate is where the session's last command left it
 *  (at first 0). */
#define HRT_REACH_PLATE_ORIENTATION UINT32_C(1)

/** What a reach is. hrt_reach_config_default() fills every field. */
typedef struct hrt_reach_config {
  uint32_t struct_size;
  /** HRT_REACH_*. Default 0. */
  uint32_t flags;
  /** Its direction and the one that the user goes for, the virtual target's and
   *  hrt_session_config::bias_deg, are less than 90 degrees apart. Default null: to be set. */
  hrt_target real_target;
  hrt_target virtual_target;
  /** Where the plate stands before the reach, -3600 to 3600; beyond a stop means at the stop. Default 0. */
  double plate_orientation_deg;
} hrt_reach_config;

/** hrt_sample::flags: which fields hold something. Of DIRECTION, PLATE_POSITION and WORLD_POSITION at most
 *  one may be given. With none of them, nor LIFTED, the sample is a dropout: the plate is held, and the model
 *  predicts until the finger is seen again. */
#define HRT_SAMPLE_DIRECTION UINT32_C(1)         /**< finger_direction_deg */
#define HRT_SAMPLE_PLATE_POSITION UINT32_C(2)    /**< finger_position_m, in plate coordinates */
#define HRT_SAMPLE_PLATE_ORIENTATION UINT32_C(4) /**< plate_orientation_deg, measured by the device */
/** The finger is off the plate, and so feels nothing: the model waits. */
#define HRT_SAMPLE_LIFTED UINT32_C(8)
#define HRT_SAMPLE_WORLD_POSITION UINT32_C(16) /**< finger_position_m, in the engine's world */
/** plate_position_m and plate_rotation: the plate has moved in the world; else it is where the session's
 *  configuration has it. Goes with WORLD_POSITION. */
#define HRT_SAMPLE_PLATE_POSE UINT32_C(32)

/** One sample of the tracked finger. Set it to zero, then `struct_size` and what is known. Fields that
 *  `flags` does not name are not read, whatever is in them. */
typedef struct hrt_sample {
  uint32_t struct_size;
  /** HRT_SAMPLE_*. */
  uint32_t flags;
  /** The caller's monotonic clock; any origin. Not before the last sample's; the same time again is taken. */
  int64_t time_ns;
  /** The direction in which the finger moves, -180 to 180; taken as exact. */
  double finger_direction_deg;
  /** The fingertip, each within 1000. Of a tracked pose this is the position; how the finger is turned is not
   *  asked for. */
  double finger_position_m[3];
  /** Where the plate stands, -3600 to 3600. A plate without stops may count its turns as it likes: of the
   *  orientations that feel the same, the one nearest to where it is expected is taken. With stops it is
   *  taken as it is. */
  double plate_orientation_deg;
  /** The plate in the world, as in hrt_session_config. */
  double plate_position_m[3];
  double plate_rotation[4];
} hrt_sample;

/** hrt_command::flags. */
#define HRT_COMMAND_HELD UINT32_C(1)         /**< between steps: nothing new was decided in this call */
#define HRT_COMMAND_PREDICTED UINT32_C(2)    /**< the last step had no direction and was predicted */
#define HRT_COMMAND_SATURATED UINT32_C(4)    /**< the plate's bound or a stop holds the command */
#define HRT_COMMAND_RATE_LIMITED UINT32_C(8) /**< the plate's speed holds the command */
#define HRT_COMMAND_UNREACHABLE UINT32_C(16) /**< the real direction cannot be held: see authority.h */
#define HRT_COMMAND_LIFTED UINT32_C(32)      /**< the finger is above the plate: the model waits */
#define HRT_COMMAND_OFF_PLATE UINT32_C(64)   /**< the finger is beyond the plate's edge */

/** What the plate is to do now, and why. Set `struct_size` before the call. */
typedef struct hrt_command {
  uint32_t struct_size;
  /** HRT_COMMAND_*. */
  uint32_t flags;
  /** The model step, from 0; -1 before the finger moves. */
  int64_t step;
  /** Turn the plate here. Ridges repeat every 180 degrees. If the session's configuration gives
   *  the plate no highest speed or acceleration, this is the nearest of the orientations that feel the same
   *  and lie between the stops. If it does, the plate keeps to one half turn for a whole reach, so that it
   *  swings round at the start or not at all; a command beyond a stop is held at the stop. */
  double plate_orientation_deg;
  /** The finger's direction in the last step, observed or predicted. */
  double finger_direction_deg;
  /** The direction that the user feels, as the model predicts it under this command. */
  double perceived_direction_deg;
  /** Where the finger is wanted; see hrt_session_config::guidance. */
  double aimed_direction_deg;
  /** Along the plate to the real target; from the start until a position is streamed. */
  double distance_to_go_m;
  /** The share of touch that the controller assumes. */
  double tactile_weight;
  /** Its standard deviation; 0: it is taken as known. */
  double tactile_weight_sd;
} hrt_command;

/** What became of a reach. Set `struct_size` before the call. */
typedef struct hrt_reach_summary {
  uint32_t struct_size;
  uint32_t reserved;
  /** Samples taken in, and of these the dropouts and what was left out as an outlier. */
  int64_t samples;
  int64_t dropped_samples;
  /** Model steps with samples, and steps without, which were predicted. */
  int64_t steps;
  int64_t predicted_steps;
  /** Of the steps with samples, those whose command the plate's bound, a stop, or its speed held. */
  int64_t saturated_steps;
  int64_t rate_limited_steps;
  /** The finger's direction in the last step, and that less the real target's. */
  double final_direction_deg;
  double final_miss_deg;
  /** What the user felt in the last step, and that less where they went: the virtual target's direction and
   *  hrt_session_config::bias_deg. */
  double perceived_direction_deg;
  double perceived_error_deg;
  /** From the last position along the plate to the real target; from the start if none was streamed. */
  double distance_to_target_m;
  /** What the controller assumed at the end; see hrt_command. */
  double tactile_weight;
  double tactile_weight_sd;
  /** White noise of each coordinate of the tracked positions, standard deviation, as learnt or configured. */
  double tracker_noise_m;
  /** The user's motor variance as this reach corrects what the configuration assumes. Since version 0.2. */
  double motor_variance_deg2;
  /** Its standard deviation; close to hrt_session_config::motor_variance_sd_deg2 if the reach could not tell;
   *  0: it is taken as known. Since version 0.2. */
  double motor_variance_sd_deg2;
} hrt_reach_summary;

/** Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread] */
HRT_API hrt_result hrt_reach_config_default(hrt_reach_config* out_config, uint32_t struct_size) HRT_NOEXCEPT;

/** Starts a reach. Errors: INVALID_HANDLE or OUT_OF_RANGE naming the target, WRONG_STATE during a reach.
 *  [real-time] */
HRT_API hrt_result hrt_reach_begin(hrt_session session, const hrt_reach_config* config) HRT_NOEXCEPT;

/** Takes one sample in and tells what the plate is to do now. Samples may come at any rate. Directions
 *  move the controller once in a step period, positions at each sample, as they tell ever more of the step;
 *  in between the command is held. Steps that pass without samples are predicted, at most 64 in one call.
 *  Errors: WRONG_STATE without a reach, OUT_OF_RANGE naming the field, TIME_REVERSED. [real-time] */
HRT_API hrt_result hrt_reach_update(hrt_session session, const hrt_sample* sample,
                                    hrt_command* out_command) HRT_NOEXCEPT;

/** Ends the reach. Errors: WRONG_STATE without a reach. [real-time] */
HRT_API hrt_result hrt_reach_end(hrt_session session, hrt_reach_summary* out_summary) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
