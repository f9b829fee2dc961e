/*
 * Setting up, before any frame: scenes from files, the plate's place, who the user is, their profile; and
 * which targets a session has, and which real one serves which virtual one.
 */
#ifndef HAPTIC_RETARGETING_SETUP_H
#define HAPTIC_RETARGETING_SETUP_H

#include "calibration.h"
#include "profile.h"
#include "registration.h"
#include "scene.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Returns a target. Set `out_config->struct_size` before the call. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_get(hrt_session session, hrt_target target,
                                                hrt_target_config* out_config) HRT_NOEXCEPT;

/** Lists the targets of a role (0: both) in the order of addition. With `capacity` 0 the call only counts
 *  them, and `out_targets` may be null. Errors: BUFFER_TOO_SMALL. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_list(hrt_session session, uint32_t role, uint64_t capacity,
                                                 hrt_target* out_targets, uint64_t* out_count) HRT_NOEXCEPT;

/** Flags of hrt_target_assign(). */
/** A real target serves one virtual target at most. Otherwise it may serve any number. */
#define HRT_ASSIGN_EXCLUSIVE UINT32_C(1)

/** Maximum number of virtual targets, and of real ones, in hrt_target_assign(). */
#define HRT_ASSIGN_TARGETS_MAX 1000

/** Assigns a real target to each virtual one. As many virtual targets as possible are served, and of all such
 *  assignments the largest share of what can be held that a pair needs, the size of gap_deg over
 *  max_gap_deg, is the smallest; exactly so. `out_gaps[i]` is the gap of
 * virtual_targets[i] and the real target that serves it; `out_gaps[0].struct_size` is the size of
 * every element. A virtual target that cannot be served has `reachable` 0 and a null real_target, and the
 * other numbers are those of the nearest real target, of the first among equals. Takes up to half a second
 * for 1000 of each with EXCLUSIVE. `flags` is HRT_ASSIGN_*. Errors: BUFFER_TOO_SMALL if `capacity` is below
 * `virtual_count`; INVALID_HANDLE or OUT_OF_RANGE naming the argument and the index of an id that is not of
 * its role or is there twice, also for a count of 0 or above HRT_ASSIGN_TARGETS_MAX; OUT_OF_MEMORY.
 * [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_assign(hrt_session session, const hrt_target* virtual_targets,
                                                   uint64_t virtual_count, const hrt_target* real_targets,
                                                   uint64_t real_count, uint32_t flags, uint64_t capacity,
                                                   hrt_gap* out_gaps) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "setup_init.h"

#endif
