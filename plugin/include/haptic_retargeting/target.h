/*
 * Targets: virtual targets, which the user sees, and real targets, to which the hand is steered; and the gap
 * between two of them: the required shift and the largest shift that the plate can sustain.
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

/** @enumeration HRT_TARGET Role of a target. */
#define HRT_TARGET_REAL 1    /**< the hand is steered to it */
#define HRT_TARGET_VIRTUAL 2 /**< the user sees it and reaches for it */

/** @enumeration HRT_PLACE Fields that give the position of a target. */
#define HRT_PLACE_DIRECTION 1      /**< `direction_deg` and `distance_m` */
#define HRT_PLACE_PLATE_POSITION 2 /**< `position_m` in plate coordinates */
#define HRT_PLACE_WORLD_POSITION 3 /**< `position_m` in the engine's world */

/** A target. Only the fields that `place` names are read. */
typedef struct hrt_target_config {
  uint32_t struct_size;
  /** Role of the target. @values HRT_TARGET @default HRT_TARGET_REAL */
  uint32_t role;
  /** Fields that give the position. @values HRT_PLACE @default HRT_PLACE_DIRECTION */
  uint32_t place;
  uint32_t reserved;
  /** Direction from the start. @range -180 to 180 @default 0 @ccw */
  double direction_deg;
  /** Distance from the start along the plate. @range 0.001 to 10 @default 0.1 */
  double distance_m;
  /** Position in plate coordinates or in the world, at least 1 mm from the start in the plane of the plate; the
   *  height y has no effect. @range -1000 to 1000 @default (0, 0, 0) */
  double position_m[3];
  /** Name, unique within the session unless empty. UTF-8, terminated by a zero. */
  char name[HRT_NAME_SIZE];
  /** Radius of the real object that the finger meets, for hrt_reach_touched(); 0: unknown. @range 0 to 1 @default 0 */
  double radius_m;
  /** Real target that serves a virtual one; null, the default: unknown. hrt_scene_register() sets it; the host may
   *  read or change it. The library does not use it: each reach and hrt_gap_query() name both targets. The target may
   *  have been removed since. Must be null for a real target. */
  hrt_target served_by;
} hrt_target_config;

/** Adds a target.
 *
 *  @return OUT_OF_RANGE naming the field; NAME_TAKEN; LIMIT_REACHED; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_add(hrt_session session, const hrt_target_config* config,
                                                hrt_target* out_target) HRT_NOEXCEPT;

/** Replaces a target and keeps its id. A reach in progress keeps the former target until hrt_reach_retarget().
 *  Allocates nothing if the name is unchanged.
 *
 *  @param target  The target to replace.
 *  @param config  Its new fields.
 *  @return As hrt_target_add().
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_set(hrt_session session, hrt_target target,
                                                const hrt_target_config* config) HRT_NOEXCEPT;

/** Removes a target. A reach in progress keeps it.
 *
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_remove(hrt_session session, hrt_target target) HRT_NOEXCEPT;

/** The gap between a real and a virtual target. In the steady state, the user perceives the direction of the finger
 *  plus the perceived shift that the ridges cause, and this is the virtual direction. The largest gap is therefore
 *  the largest perceived shift within the bound of the plate. Under GUIDANCE_ARRIVAL, the bound is relative to the
 *  motion, and the shift follows the user's illusion curve: 11.25 degrees for a linear illusion of weight 0.15 within
 *  75 degrees. Under FIXED_DIRECTION, as in the paper, the bound is relative to the virtual direction: 14.9 degrees
 *  for the same weight within 84.5. Published human data cover plate angles up to 60. */
typedef struct hrt_gap {
  uint32_t struct_size;
  /** 1 if the plate can keep the finger on the direction of the real target. @bool */
  uint32_t reachable;
  hrt_target real_target;    /**< the real target */
  hrt_target virtual_target; /**< the virtual target */
  /** Virtual direction plus the user's bias, minus the real direction; in [-180, 180). @ccw */
  double gap_deg;
  /** Largest gap, to either side, that the plate can sustain for the user and the guidance of the session. */
  double max_gap_deg;
  /** max_gap_deg minus the absolute gap. Negative: unreachable. */
  double margin_deg;
  /** Plate orientation that sustains the gap; at the bound if the gap is unreachable. @ccw */
  double plate_orientation_deg;
  /** Direction in which the finger settles: that of the real target if the gap is reachable. @ccw */
  double settling_direction_deg;
  /** max_gap_deg of the paper's model, from tactile_weight and plate_bound_deg. */
  double paper_max_gap_deg;
  /** SD of the bearings at which reaches end, relative to the real target, due to the registration of the plate alone
   *  (hrt_session_config::plate.covariance) or, after contacts, to their covariance. */
  double registration_sd_deg;
  /** Fraction of reaches that end off the target (HRT_COMMAND_OFF_TARGET) for this reason alone, for any user.
   *  Register again if it is too large. @range 0 to 1 @unit 1 */
  double registration_miss_share;
} hrt_gap;

/** Returns the gap of a pair, before a reach.
 *
 *  @param real_target     Target of the hand.
 *  @param virtual_target  Target that the user sees.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_gap_query(hrt_session session, hrt_target real_target, hrt_target virtual_target,
                                               hrt_gap* out_gap) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
