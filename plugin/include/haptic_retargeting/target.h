/*
 * Targets: what the user sees (virtual) and what the hand is led to (real).
 */
#ifndef HAPTIC_RETARGETING_TARGET_H
#define HAPTIC_RETARGETING_TARGET_H

#include "session.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A target's id within its session. Zero is never a target. The id of a removed target is never valid
 *  again, in no session. */
typedef struct hrt_target {
  uint64_t value;
} hrt_target;

/** Targets that a session can hold. */
#define HRT_TARGETS_MAX 1000000
/** Bytes of a name, with its terminating zero. */
#define HRT_NAME_SIZE 64

/** What a target is. */
#define HRT_TARGET_REAL 1
#define HRT_TARGET_VIRTUAL 2

/** How a target's place is given. */
#define HRT_PLACE_DIRECTION 1      /**< by `direction_deg` and `distance_m` */
#define HRT_PLACE_PLATE_POSITION 2 /**< by `position_m` in plate coordinates */
/** By `position_m` in the engine's world; see hrt_session_config::plate_position_m. */
#define HRT_PLACE_WORLD_POSITION 3

/** A target. hrt_target_config_default() fills every field. Fields that `place` does not name are not
 *  read. */
typedef struct hrt_target_config {
  uint32_t struct_size;
  /** HRT_TARGET_*. Default HRT_TARGET_REAL. */
  uint32_t role;
  /** HRT_PLACE_*. Default HRT_PLACE_DIRECTION. */
  uint32_t place;
  uint32_t reserved;
  /** Direction from the start, -180 to 180. Default 0. */
  double direction_deg;
  /** Distance from the start along the plate, 0.001 to 1000. Default 0.1. */
  double distance_m;
  /** Place in plate coordinates or in the world, each within 1000; at least 1 mm from the start in the plane
   *  of the plate; the height y is kept and not used. Default (0, 0, 0). */
  double position_m[3];
  /** UTF-8, ended by a zero; unique within the session unless empty. Default empty. */
  char name[HRT_NAME_SIZE];
} hrt_target_config;

/** Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread] */
HRT_API hrt_result hrt_target_config_default(hrt_target_config* out_config,
                                             uint32_t struct_size) HRT_NOEXCEPT;

/** Adds a target. Errors: OUT_OF_RANGE naming the field, NAME_TAKEN, LIMIT_REACHED, OUT_OF_MEMORY.
 *  [one-thread] */
HRT_API hrt_result hrt_target_add(hrt_session session, const hrt_target_config* config,
                                  hrt_target* out_target) HRT_NOEXCEPT;

/** Changes a target; its id stays. A reach that is under way keeps the target as it was. Errors: as
 *  hrt_target_add(). [one-thread] */
HRT_API hrt_result hrt_target_set(hrt_session session, hrt_target target,
                                  const hrt_target_config* config) HRT_NOEXCEPT;

/** What a target was last set to. `out_config->struct_size` must be set. [one-thread] */
HRT_API hrt_result hrt_target_get(hrt_session session, hrt_target target,
                                  hrt_target_config* out_config) HRT_NOEXCEPT;

/** Removes a target. A reach that is under way goes on with it as it was. [one-thread] */
HRT_API hrt_result hrt_target_remove(hrt_session session, hrt_target target) HRT_NOEXCEPT;

/** Finds a target by its name. Errors: NOT_FOUND. [one-thread] */
HRT_API hrt_result hrt_target_find(hrt_session session, const char* name,
                                   hrt_target* out_target) HRT_NOEXCEPT;

/** Lists the targets of a role (0: of both) in the order in which they were added. With `capacity` 0 only
 *  counts them, and `out_targets` may be null. Errors: BUFFER_TOO_SMALL. [one-thread] */
HRT_API hrt_result hrt_target_list(hrt_session session, uint32_t role, uint32_t capacity,
                                   hrt_target* out_targets, uint32_t* out_count) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
