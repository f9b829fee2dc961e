/*
 * Targets: virtual ones, which the user sees, and real ones, to which the hand is steered; and the gap
 * between two of them: what is needed, and what the plate can hold.
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

/** A target. hrt_target_config_init() fills every field. Only the fields that `place` names are read. */
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
  /** Place in plate coordinates or in the world, at least 1 mm from the start in the plane of the plate; the
   * height y has no effect. Each within 1000. Default (0, 0, 0). */
  double position_m[3];
  /** Unique within the session unless empty. UTF-8, terminated by a zero. Default empty. */
  char name[HRT_NAME_SIZE];
  /** Radius of a real object that the finger meets, for hrt_reach_touched(). 0 to 1; 0: unknown. Default 0.
   */
  double radius_m;
  /** Real target that serves a virtual one. hrt_scene_register() sets it; the host may read or change it. The
   * library does not use it: each reach and hrt_gap_query() name both targets. The target may have been
   * removed since. Must be null for a real target. Default null: unknown. */
  hrt_target served_by;
} hrt_target_config;

/** Adds a target. Errors: OUT_OF_RANGE naming the field, NAME_TAKEN, LIMIT_REACHED, OUT_OF_MEMORY.
 * [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_add(hrt_session session, const hrt_target_config* config,
                                                hrt_target* out_target) HRT_NOEXCEPT;

/** Replaces a target and keeps its id. A running reach keeps the former target until hrt_reach_retarget().
 * Allocates nothing if the name stays. Errors: as hrt_target_add(). [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_set(hrt_session session, hrt_target target,
                                                const hrt_target_config* config) HRT_NOEXCEPT;

/** Removes a target. A running reach keeps it. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_remove(hrt_session session, hrt_target target) HRT_NOEXCEPT;

/** The gap between a real and a virtual target. Once settled, the user feels the finger's direction plus the
 * felt shift of the ridges, and that is the virtual direction: the largest gap is the largest felt shift
 * within the plate's bound. Under GUIDANCE_ARRIVAL the bound is about the motion and the shift that of the
 * person's illusion: 11.25 degrees for a linear one of weight 0.15 within 75. Under FIXED_DIRECTION, as in
 * the paper, the bound is about the virtual direction: 14.9 for the same weight within 84.5. Published human
 * data cover angles of the plate up to 60. Set `struct_size` before the call. */
typedef struct hrt_gap {
  uint32_t struct_size;
  /** 1 if the plate can keep the finger on the real target's direction, else 0. */
  uint32_t reachable;
  hrt_target real_target;
  hrt_target virtual_target;
  /** The virtual direction plus the person's bias, minus the real direction; in [-180, 180). */
  double gap_deg;
  /** Largest gap, to either side, that the plate can sustain for the session's person and guidance. */
  double max_gap_deg;
  /** max_gap_deg minus the size of the gap; negative: unreachable. */
  double margin_deg;
  /** Plate orientation (base.h) that sustains the gap; at the bound if unreachable. */
  double plate_orientation_deg;
  /** Direction in which the finger settles: the real target's, if reachable. */
  double settling_direction_deg;
  /** max_gap_deg as the paper has it, from tactile_weight and plate_bound_deg. */
  double paper_max_gap_deg;
  /** Standard deviation of where reaches end about the real target, degrees of bearing, by the plate's
   * registration alone (hrt_session_config::plate.covariance) or, once there were any, contacts. */
  double registration_sd_deg;
  /** Share of reaches that end off the target (HRT_COMMAND_OFF_TARGET) for that alone, of anybody:
   * if it is too large, register again. 0 to 1. */
  double registration_miss_share;
} hrt_gap;

/** Returns the gap of a pair, before a reach. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_gap_query(hrt_session session, hrt_target real_target, hrt_target virtual_target,
                                               hrt_gap* out_gap) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
