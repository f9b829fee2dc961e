/*
 * Profiles: a participant's parameters as JSON, to be stored and loaded later:
 *
 *   {"format":"haptic retargeting profile","version":1,"tracker_noise_m":0,"tactile_weight":0.2,
 *    "tactile_weight_sd":0.05,"motor_variance_deg2":0.5,"motor_variance_sd_deg2":0.5,"sensory_variance_deg2":0.1,
 *    "initial_variance_deg2":0,"bias_deg":0}
 *
 * and "person_mean":[...],"person_covariance":[...] once a reach has learnt of the person.
 *
 * If the host names them, it also has the conditions under which the person was measured:
 *
 *    "measured_at_s":1767225600,"plate":"desk 2","tracker":"Ultraleap"
 *
 * Fields and ranges are those of hrt_session_config whose comments say "In profiles". Contacts stand with the
 * pose of the plate under which they were made. A session with another pose leaves them out; in one with the
 * same pose their covariance is wider by 0.2 %, since trackers drift.
 */
#ifndef HAPTIC_RETARGETING_PROFILE_H
#define HAPTIC_RETARGETING_PROFILE_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** How the conditions of the profile differ from those of now: hrt_conditions::differing. */
#define HRT_CONDITION_PLATE UINT32_C(1)
#define HRT_CONDITION_TRACKER UINT32_C(2)

/** Conditions of a measurement. The plugin reads no clock and knows no devices: the host names them. */
typedef struct hrt_conditions {
  uint32_t struct_size;
  /** Output: of what both the profile and the host name, and not alike. Input: not read. HRT_CONDITION_*. */
  uint32_t differing;
  /** Seconds since 1970, UTC. 0 to 253402300799, the end of the year 9999; 0: unknown. */
  int64_t time_s;
  /** Name of the plate; empty: unknown. UTF-8 without control characters, ended by a zero. */
  char plate[HRT_NAME_SIZE];
  /** Name of the tracker; empty: unknown. UTF-8 without control characters, ended by a zero. */
  char tracker[HRT_NAME_SIZE];
} hrt_conditions;

/** Sets the session's conditions of now: what a set-up's calibration measures under, and what profiles are
 * compared with. If those of the profile differ, the log has a warning, here or when the profile is loaded.
 * Errors: OUT_OF_RANGE naming the field, WRONG_STATE during a reach or a set-up. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_set_conditions(hrt_session session,
                                                            const hrt_conditions* conditions) HRT_NOEXCEPT;

/** Returns the conditions under which the person was measured: of the loaded profile, or of now if a
 * set-up has calibrated since; unknown without both. `differing` compares them with those of now. Set
 * `struct_size` before the call. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_get_conditions(hrt_session session,
                                                            hrt_conditions* out_conditions) HRT_NOEXCEPT;

/** Writes the session's profile as UTF-8 with a terminating zero, and its length without the zero. With
 * `capacity` 0 the call only returns the length, and `out_text` may be null. Errors: BUFFER_TOO_SMALL unless
 * `capacity` exceeds the length. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_save(hrt_session session, uint64_t capacity, char* out_text,
                                                  uint64_t* out_length) HRT_NOEXCEPT;

/** Copies a profile of `length` bytes into the session's configuration. Of the person and of correlated noise,
 * fields missing in the profile are the default again; other fields that are missing keep their values. Unknown
 * fields are refused. Errors: BAD_FORMAT, OUT_OF_RANGE naming the field, WRONG_STATE during a reach or a set-up.
 * [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_load(hrt_session session, const char* text, uint64_t length) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
