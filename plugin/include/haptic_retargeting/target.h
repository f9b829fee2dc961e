/*
 * Targets: virtual ones, which the user sees, and real ones, to which the hand is steered.
 */
#ifndef HAPTIC_RETARGETING_TARGET_H
#define HAPTIC_RETARGETING_TARGET_H

#include "session.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A target's id within its session. Zero is never a target. Ids are never reused, in any session. */
typedef struct hrt_target {
  uint64_t value;
} hrt_target;

/** Maximum number of targets in a session. */
#define HRT_TARGETS_MAX 1000000
/** Bytes of a name, including the terminating zero. */
#define HRT_NAME_SIZE 64

/** Role of a target. */
#define HRT_TARGET_REAL 1    /**< the hand is steered to it */
#define HRT_TARGET_VIRTUAL 2 /**< the user sees it and goes to it */

/** How a target's place is given. */
#define HRT_PLACE_DIRECTION 1      /**< by `direction_deg` and `distance_m` */
#define HRT_PLACE_PLATE_POSITION 2 /**< by `position_m` in plate coordinates */
#define HRT_PLACE_WORLD_POSITION 3 /**< by `position_m` in the engine's world */

/** A target. hrt_target_config_default() fills every field. Only the fields that `place` names are read. */
typedef struct hrt_target_config {
  uint32_t struct_size;
  /** HRT_TARGET_*. Default HRT_TARGET_REAL. */
  uint32_t role;
  /** HRT_PLACE_*. Default HRT_PLACE_DIRECTION. */
  uint32_t place;
  uint32_t reserved;
  /** Direction from the start (base.h). -180 to 180. Default 0. */
  double direction_deg;
  /** Distance from the start along the plate. 0.001 to 1000. Default 0.1. */
  double distance_m;
  /** Place in plate coordinates or in the world, at least 1 mm from the start in the plane of the plate;
   *  the height y has no effect. Each within 1000. Default (0, 0, 0). */
  double position_m[3];
  /** Unique within the session unless empty. UTF-8, terminated by a zero. Default empty. */
  char name[HRT_NAME_SIZE];
} hrt_target_config;

/** Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_config_default(hrt_target_config* out_config,
                                                           uint32_t struct_size) HRT_NOEXCEPT;

/** Adds a target. Errors: OUT_OF_RANGE naming the field, NAME_TAKEN, LIMIT_REACHED, OUT_OF_MEMORY.
 *  [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_add(hrt_session session, const hrt_target_config* config,
                                                hrt_target* out_target) HRT_NOEXCEPT;

/** Replaces a target and keeps its id. A running reach keeps the former target until hrt_reach_retarget().
 *  Allocates nothing if the name stays. Errors: as hrt_target_add(). [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_set(hrt_session session, hrt_target target,
                                                const hrt_target_config* config) HRT_NOEXCEPT;

/** Returns a target. Set `out_config->struct_size` before the call. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_get(hrt_session session, hrt_target target,
                                                hrt_target_config* out_config) HRT_NOEXCEPT;

/** Removes a target. A running reach keeps it. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_remove(hrt_session session, hrt_target target) HRT_NOEXCEPT;

/** Finds a target by name. Errors: NOT_FOUND. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_find(hrt_session session, const char* name,
                                                 hrt_target* out_target) HRT_NOEXCEPT;

/** Lists the targets of a role (0: both) in the order of addition. With `capacity` 0 the call only counts
 *  them, and `out_targets` may be null. Errors: BUFFER_TOO_SMALL. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_list(hrt_session session, uint32_t role, uint64_t capacity,
                                                 hrt_target* out_targets, uint64_t* out_count) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
