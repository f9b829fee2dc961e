/*
 * Profiles: a participant's parameters as JSON, to be stored and loaded later:
 *
 *   {"format":"haptic retargeting profile","version":1,"tactile_weight":0.2,"tactile_weight_sd":0.05,
 *    "bias_deg":0,"motor_variance_deg2":0.5,"motor_variance_sd_deg2":0.5,"sensory_variance_deg2":0.1,
 *    "initial_variance_deg2":0,"tracker_noise_m":0,"person_mean":[...],"person_covariance":[...]}
 *
 * Fields and ranges are those of hrt_session_config. A library of version 0.1 refuses bias_deg,
 * motor_variance_sd_deg2 and tracker_noise_m; one of 0.2 refuses the last two, which are there once a reach
 * of the person was carried.
 */
#ifndef HAPTIC_RETARGETING_PROFILE_H
#define HAPTIC_RETARGETING_PROFILE_H

#include "session.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Writes the session's profile as UTF-8 with a terminating zero, and its length without the zero. With
 *  `capacity` 0 the call only returns the length, and `out_text` may be null. Errors: BUFFER_TOO_SMALL
 *  unless `capacity` exceeds the length. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_save(hrt_session session, uint64_t capacity, char* out_text,
                                                  uint64_t* out_length) HRT_NOEXCEPT;

/** Copies a profile of `length` bytes into the session's configuration. Fields missing in the profile keep
 *  their values; unknown fields are refused. Errors: BAD_FORMAT, OUT_OF_RANGE naming the field,
 *  WRONG_STATE during a reach. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_load(hrt_session session, const char* text,
                                                  uint64_t length) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
