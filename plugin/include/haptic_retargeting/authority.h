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
  double largest_gap_deg;
  /** largest_gap_deg minus the size of the gap; negative: unreachable. */
  double margin_deg;
  /** Plate orientation (base.h) that sustains the gap; at the bound if unreachable. */
  double plate_orientation_deg;
  /** Direction in which the finger settles: the real target's, if reachable. */
  double settling_direction_deg;
  /** largest_gap_deg as the paper has it, from tactile_weight and plate_bound_deg. Since version 0.3. */
  double paper_largest_gap_deg;
} hrt_authority;

/** Computes the authority over a pair. [one-thread] */
HRT_API hrt_result hrt_authority_query(hrt_session session, hrt_target real_target, hrt_target virtual_target,
                                       hrt_authority* out_authority) HRT_NOEXCEPT;

/** Computes the authority over every pair, by virtual target and then by real one, in the order of
 *  addition. `out_authorities[0].struct_size` is the size of every element. With `capacity` 0 the call
 *  only counts the pairs, and `out_authorities` may be null. Errors: BUFFER_TOO_SMALL. [one-thread] */
HRT_API hrt_result hrt_authority_query_all(hrt_session session, uint64_t capacity,
                                           hrt_authority* out_authorities, uint64_t* out_count) HRT_NOEXCEPT;

/** Finds the real target with the greatest margin for a virtual one; the first added among equals. The
 *  margin may be negative. Errors: NOT_FOUND without a real target. [one-thread] */
HRT_API hrt_result hrt_authority_query_best(hrt_session session, hrt_target virtual_target,
                                            hrt_authority* out_authority) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
