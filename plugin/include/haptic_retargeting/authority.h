/*
 * Steering authority: the largest gap between two targets that the plate can sustain, computed before a
 * reach. Once settled, the user feels the finger's direction plus the felt shift of the ridges, and that is
 * the virtual direction: the largest gap is the largest felt shift within the plate's bound. Under
 * GUIDANCE_ARRIVAL the bound is about the motion and the shift that of the person's illusion: 11.25 degrees
 * for a linear one of weight 0.15 within 75. Under FIXED_DIRECTION, as in the paper, the bound is about the
 * virtual direction: 14.9 for the same weight within 84.5. Published human data cover angles of the plate up
 * to 60.
 */
#ifndef HAPTIC_RETARGETING_AUTHORITY_H
#define HAPTIC_RETARGETING_AUTHORITY_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Authority over one pair of targets. Set `struct_size` before the call. */
typedef struct hrt_authority {
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
} hrt_authority;

/** Computes the authority over a pair. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_authority_query(hrt_session session, hrt_target real_target,
                                                     hrt_target virtual_target,
                                                     hrt_authority* out_authority) HRT_NOEXCEPT;

/** Computes the authority over every pair, by virtual target and then by real one, in the order of
 *  addition. `out_authorities[0].struct_size` is the size of every element. With `capacity` 0 the call
 *  only counts the pairs, and `out_authorities` may be null. Errors: BUFFER_TOO_SMALL. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_authority_query_all(hrt_session session, uint64_t capacity,
                                                         hrt_authority* out_authorities,
                                                         uint64_t* out_count) HRT_NOEXCEPT;

/** Finds the real target with the greatest margin for a virtual one; the first added among equals. The
 *  margin may be negative. Errors: NOT_FOUND without a real target. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_authority_query_best(hrt_session session, hrt_target virtual_target,
                                                          hrt_authority* out_authority) HRT_NOEXCEPT;

/** Flags of hrt_target_assign(). */
/** A real target serves one virtual target at most. Otherwise it may serve any number. */
#define HRT_ASSIGN_EXCLUSIVE UINT32_C(1)

/** Maximum number of virtual targets, and of real ones, in hrt_target_assign(). */
#define HRT_ASSIGN_TARGETS_MAX 1000

/** Assigns a real target to each virtual one. As many virtual targets as possible are served, and of all such
 *  assignments the largest share of the authority that a pair needs, the size of gap_deg over
 *  max_gap_deg, is the smallest; exactly so. `out_authorities[i]` is the authority over
 * virtual_targets[i] and the real target that serves it; `out_authorities[0].struct_size` is the size of
 * every element. A virtual target that cannot be served has `reachable` 0 and a null real_target, and the
 * other numbers are those of the nearest real target, of the first among equals. Takes up to half a second
 * for 1000 of each with EXCLUSIVE. `flags` is HRT_ASSIGN_*. Errors: BUFFER_TOO_SMALL if `capacity` is below
 * `virtual_count`; INVALID_HANDLE or OUT_OF_RANGE naming the argument and the index of an id that is not of
 * its role or is there twice, also for a count of 0 or above HRT_ASSIGN_TARGETS_MAX; OUT_OF_MEMORY.
 * [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_assign(hrt_session session, const hrt_target* virtual_targets,
                                                   uint64_t virtual_count, const hrt_target* real_targets,
                                                   uint64_t real_count, uint32_t flags, uint64_t capacity,
                                                   hrt_authority* out_authorities) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
