/*
 * Targets: virtual targets, which the user sees, and real targets, to which the hand is steered.
 *
 * Example: a real object 100 mm from the start, and a virtual object that moves.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session session;
 *     hrt_target cylinder, cup;
 *     hrt_target_config config = hrt_target_config_init(); // a real target
 *     config.place = HRT_PLACE_PLATE_POSITION, config.position_m[2] = -0.05, config.radius_m = 0.02;
 *     int failed = hrt_session_create(HRT_VERSION, NULL, &session) || hrt_target_add(session, &config, &cylinder);
 *     config.role = HRT_TARGET_VIRTUAL;
 *     failed = failed || hrt_target_add(session, &config, &cup);
 *     config.position_m[0] = -0.01;
 *     failed = failed || hrt_target_set(session, cup, &config); // in a reach, hrt_reach_retarget() follows
 *     if (failed) puts(hrt_last_error());
 *     return failed;
 *   }
 */
#ifndef HAPTIC_RETARGETING_TARGET_H
#define HAPTIC_RETARGETING_TARGET_H

#include "session.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A target's id within its session. Zero is never a target. Ids are never reused, in any session. Ids are below 2^53:
 *  a double represents them exactly. */
typedef struct hrt_target {
  uint64_t value;
} hrt_target;

/** Maximum number of targets in a session. */
#define HRT_TARGETS_MAX 1000000
/** Bytes of a name, including the terminating zero. */
#define HRT_NAME_SIZE 64

/** @enumeration HRT_TARGET Role of a target. */
typedef uint32_t hrt_target_role;
#define HRT_TARGET_REAL 1    /**< the hand is steered to it */
#define HRT_TARGET_VIRTUAL 2 /**< the user sees it and reaches for it */

/** @enumeration HRT_PLACE Fields of hrt_target_config that give the position of a target. */
typedef uint32_t hrt_target_place;
#define HRT_PLACE_DIRECTION 1      /**< `direction_deg` and `distance_m` */
#define HRT_PLACE_PLATE_POSITION 2 /**< `position_m` in plate coordinates */
#define HRT_PLACE_WORLD_POSITION 3 /**< `position_m` in the engine's world */

/** A target. Of the fields for the position, only those that `place` names are read. */
typedef struct hrt_target_config {
  uint32_t struct_size;
  /** Role of the target. @default HRT_TARGET_REAL */
  hrt_target_role role;
  /** Fields that give the position. @default HRT_PLACE_DIRECTION */
  hrt_target_place place;
  uint32_t reserved;
  /** Direction from the start. If all targets have directions of at most 1.6 degrees, and at least two of these are not
   *  0, they are probably in radians: reaches get HRT_COMMAND_IMPLAUSIBLE. @range -180 to 180 @default 0 @ccw */
  double direction_deg;
  /** Distance from the start along the plate. @range 0.001 to 10 @default 0.1 */
  double distance_m;
  /** Position in the engine's world, or in plate coordinates at most 10 m from the plate's centre. In the plane of the
   *  plate, the position must be at least 1 mm from the start; its height has no effect. @range -1000 to 1000
   *  @default (0, 0, 0) */
  double position_m[3];
  /** Name, unique within the session or empty; error texts and recordings show it. UTF-8 without control characters,
   *  terminated by a zero. */
  char name[HRT_NAME_SIZE];
  /** Radius of the real object, for the position of contact in hrt_reach_touched() and HRT_SETUP_GUIDES. 0: unknown;
   *  contacts are then less accurate. @range 0 to 1 @default 0 */
  double radius_m;
  /** Real target that is assigned to this virtual target; null, the default: none. hrt_scene_register() sets it, for
   *  the host, which passes both targets to hrt_reach_begin(). It is not updated when the real target is removed. Must
   *  be null for a real target. */
  hrt_target served_by;
} hrt_target_config;

/** Adds a target to a session.
 *
 *  @param config      Target, copied.
 *  @param out_target  Id of the target.
 *  @return OUT_OF_RANGE naming the field; NAME_TAKEN; LIMIT_REACHED; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_add(hrt_session session, const hrt_target_config* config,
                                                hrt_target* out_target) HRT_NOEXCEPT;

/** Replaces a target and keeps its id. A reach in progress keeps the former target until hrt_reach_retarget().
 *  Allocates nothing if the name is unchanged.
 *
 *  @param target  Target to replace.
 *  @param config  Its new fields.
 *  @return OUT_OF_RANGE naming the field; NAME_TAKEN; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_set(hrt_session session, hrt_target target,
                                                const hrt_target_config* config) HRT_NOEXCEPT;

/** Removes a target from its session. A reach in progress continues with its copy of the target.
 *
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_remove(hrt_session session, hrt_target target) HRT_NOEXCEPT;

/** Returns the present fields of a target.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_get(hrt_session session, hrt_target target,
                                                hrt_target_config* out_config) HRT_NOEXCEPT;

/** Lists the targets of a role in the order of their addition.
 *
 *  @param role         Role of the targets; 0: both.
 *  @param capacity     Number of elements of `out_targets`. 0: the targets are only counted.
 *  @param out_targets  Ids of the targets. May be null if `capacity` is 0.
 *  @param out_count    Number of targets of the role.
 *  @return BUFFER_TOO_SMALL if `capacity` is neither 0 nor sufficient; OUT_OF_RANGE for another role.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_list(hrt_session session, hrt_target_role role, uint64_t capacity,
                                                 hrt_target* out_targets, uint64_t* out_count) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
