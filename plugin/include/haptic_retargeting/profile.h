/*
 * Profiles: what is known of a participant, as JSON that can be kept and loaded tomorrow:
 *
 *   {"format":"haptic retargeting profile","version":1,"tactile_weight":0.15,"tactile_weight_sd":0.05,
 *    "bias_deg":0,"motor_variance_deg2":0.5,"motor_variance_sd_deg2":0.5,"sensory_variance_deg2":0.1,
 *    "initial_variance_deg2":0,"tracker_noise_m":0}
 *
 * The fields mean what those of hrt_session_config do, and have their ranges. A library of version 0.1
 * refuses bias_deg, motor_variance_sd_deg2 and tracker_noise_m.
 */
#ifndef HAPTIC_RETARGETING_PROFILE_H
#define HAPTIC_RETARGETING_PROFILE_H

#include "session.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Writes the profile of the session's participant, UTF-8, and a zero after it, into `out_text`; its length
 *  without the zero into `*out_length`. With `capacity` 0 only tells the length, and `out_text` may be null.
 *  Errors: BUFFER_TOO_SMALL unless capacity is above the length. [one-thread] */
HRT_API hrt_result hrt_profile_save(hrt_session session, uint64_t capacity, char* out_text,
                                    uint64_t* out_length) HRT_NOEXCEPT;

/** Takes a profile of `length` bytes into the session's configuration, between reaches. Fields that it lacks
 *  stay as they are; unknown ones are refused. Errors: BAD_FORMAT, OUT_OF_RANGE naming the field,
 *  WRONG_STATE during a reach. [one-thread] */
HRT_API hrt_result hrt_profile_load(hrt_session session, const char* text, uint64_t length) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
