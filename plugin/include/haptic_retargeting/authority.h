/*
 * Steering authority: what can be held, told before anyone moves. At rest the user feels the virtual
 * direction, a mixture of the plate's orientation and the finger's direction with tactile_weight and
 * 1 - tactile_weight; the plate's bound therefore limits how far the two targets may be apart.
 */
#ifndef HAPTIC_RETARGETING_AUTHORITY_H
#define HAPTIC_RETARGETING_AUTHORITY_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** What can be held for one pair. Set `struct_size` before the call. */
typedef struct hrt_authority {
  uint32_t struct_size;
  /** 1 if the finger can be held on the real target's direction, else 0. */
  uint32_t reachable;
  hrt_target real_target;
  hrt_target virtual_target;
  /** Where the user goes, the virtual target's direction and hrt_session_config::bias_deg, less the real
   *  target's direction; in [-180, 180). */
  double gap_deg;
  /** The largest gap, either way, that can be held with the session's tactile weight and plate bound. */
  double largest_gap_deg;
  /** largest_gap_deg less the size of the gap; negative if out of reach. */
  double margin_deg;
  /** Where the plate must stand to hold it; on its bound if out of reach. */
  double plate_orientation_deg;
  /** Where the finger settles: the real target's direction if it can be held. */
  double settling_direction_deg;
} hrt_authority;

/** What can be held for a pair. [one-thread] */
HRT_API hrt_result hrt_authority_query(hrt_session session, hrt_target real_target, hrt_target virtual_target,
                                       hrt_authority* out_authority) HRT_NOEXCEPT;

/** What can be held for every pair, by virtual target and then by real one, in the order in which they were
 *  added. `out_authorities[0].struct_size` must be set and is the size of every element. With `capacity` 0
 *  only counts the pairs, and `out_authorities` may be null. Errors: BUFFER_TOO_SMALL. [one-thread] */
HRT_API hrt_result hrt_authority_query_all(hrt_session session, uint64_t capacity,
                                           hrt_authority* out_authorities, uint64_t* out_count) HRT_NOEXCEPT;

/** The real target that serves a virtual one with the greatest margin; of equals the one added first. It
 *  may still be out of reach. Errors: NOT_FOUND if there is no real target. [one-thread] */
HRT_API hrt_result hrt_authority_query_best(hrt_session session, hrt_target virtual_target,
                                            hrt_authority* out_authority) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
