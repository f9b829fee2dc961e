/*
 * Profiles: a user's parameters as JSON, to be stored and loaded later.
 *
 * Example: copies the user of one session to another.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <haptic_retargeting/profile.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session before, after;
 *     char text[4096];
 *     uint64_t length = 0;
 *     int failed = hrt_session_create(HRT_VERSION, NULL, &before) || hrt_session_create(HRT_VERSION, NULL, &after) ||
 *                  hrt_profile_save(before, sizeof text, text, &length) || hrt_profile_load(after, text, length);
 *     puts(failed ? hrt_last_error() : text);
 *     return failed;
 *   }
 *
 * The text is
 *
 *   {"format":"haptic retargeting profile","version":1,"tracker_noise_m":0,"tactile_weight":0.2,
 *    "tactile_weight_sd":0.05,"bias_deg":0,"motor_variance_deg2":0.5,"motor_variance_sd_deg2":0.5,
 *    "sensory_variance_deg2":0.1,"initial_variance_deg2":0}
 *
 * After a reach or a calibration has estimated the user's traits, the text also has "person_mean":[...] and
 * "person_covariance":[...]. If the host has named the conditions of the measurement, the text has them too:
 *
 *   "measured_at_s":1767225600,"plate":"desk 2","tracker":"Ultraleap"
 *
 * Fields and ranges are those of hrt_session_config with the tag @profile. If the session has contacts
 * (hrt_reach_touched()), they are stored with the pose of the plate. If the profile has contacts, hrt_profile_load()
 * discards those of the session. It uses the contacts of the profile only if their pose is that of the session, and
 * then adds 0.002 squared to the variances of registration.contact_correction, because trackers drift.
 */
#ifndef HAPTIC_RETARGETING_PROFILE_H
#define HAPTIC_RETARGETING_PROFILE_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** @flags HRT_CONDITION hrt_conditions::differing: conditions of the profile that differ from the present ones. */
typedef uint32_t hrt_condition_flags;
#define HRT_CONDITION_PLATE UINT32_C(1)   /**< the name of the plate */
#define HRT_CONDITION_TRACKER UINT32_C(2) /**< the name of the tracker */

/** Conditions under which a user was measured. The host sets them, because the library reads no clock and knows no
 *  devices. */
typedef struct hrt_conditions {
  uint32_t struct_size;
  /** Output: conditions that the profile and the host both name, and that differ. Not read as input. */
  hrt_condition_flags differing;
  /** Time of the measurement in seconds since 1970, UTC, until the end of the year 9999; 0: unknown.
   *  @range 0 to 253402300799 */
  int64_t time_s;
  /** Name of the plate, always the same for the same device; empty: unknown, and not compared. UTF-8 without control
   *  characters, terminated by a zero. */
  char plate[HRT_NAME_SIZE];
  /** Name of the tracker, always the same for the same device; empty: unknown, and not compared. UTF-8 without control
   *  characters, terminated by a zero. */
  char tracker[HRT_NAME_SIZE];
} hrt_conditions;

/** Sets the session's present conditions, which a calibration stores with its result. If the conditions of a loaded
 *  profile differ from the present ones, this call, or the one that loads the profile, logs a warning.
 *
 *  @param conditions  The present conditions.
 *  @return OUT_OF_RANGE naming the field; WRONG_STATE during a reach or a set-up.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_set_conditions(hrt_session session,
                                                            const hrt_conditions* conditions) HRT_NOEXCEPT;

/** Returns the conditions under which the user was measured: those of the last calibration in this session or of the
 *  last loaded profile, whichever is later. Without either, and after hrt_profile_reset(), all fields are 0 or empty.
 *
 *  @param out_conditions  Conditions of the measurement. `differing` compares them with the present ones.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_get_conditions(hrt_session session,
                                                            hrt_conditions* out_conditions) HRT_NOEXCEPT;

/** Writes the session's profile as UTF-8 with a terminating zero.
 *
 *  @param capacity    Bytes of `out_text`. 0: only the length is returned.
 *  @param out_text    Profile. May be null if `capacity` is 0.
 *  @param out_length  Length of the profile without the zero.
 *  @return BUFFER_TOO_SMALL for a `capacity` from 1 to the length.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_save(hrt_session session, uint64_t capacity, char* out_text,
                                                  uint64_t* out_length) HRT_NOEXCEPT;

/** Copies the user, the noise of the tracker and the contacts of a profile into the session's configuration. The pose
 *  of the plate is kept. Of the fields that the profile lacks, person.mean, person.covariance and those of correlated
 *  noise are reset to their defaults; the others keep their values. Unknown fields are an error.
 *
 *  @param text    Profile in UTF-8.
 *  @param length  Bytes of the profile.
 *  @return BAD_FORMAT naming the field, or the position of a mistake in the JSON; OUT_OF_RANGE naming the field;
 *          WRONG_STATE during a reach or a set-up; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_load(hrt_session session, const char* text, uint64_t length) HRT_NOEXCEPT;

/** Prepares the session for another user: resets fingertip_offset_m, all fields of hrt_session_person except
 *  max_felt_error_deg, the fields of hrt_session_paper that profiles contain, and the conditions under which the user
 *  was measured. Plate, tracker, registration, targets and the present conditions are kept. If the plate is registered,
 *  HRT_SETUP_ALL_MISSING then measures only fingertip and user.
 *
 *  @return WRONG_STATE during a reach or a set-up.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_profile_reset(hrt_session session) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "profile_init.h"

#endif
