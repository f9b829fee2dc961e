/*
 * Gap: the angle between a real and a virtual target, seen from the start. hrt_gap_query() compares the gap with the
 * largest shift of the perceived direction that the plate can cause for this user; hrt_gap_assign() assigns real
 * targets to virtual ones.
 *
 * Example: can a real target 6 degrees to the right represent a virtual target 5 degrees to the left?
 *
 *   #include <haptic_retargeting/gap.h>
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session session;
 *     hrt_target real, virtual_cup;
 *     hrt_gap gap = hrt_gap_init();
 *     hrt_target_config config = hrt_target_config_init(); // a real target
 *     config.direction_deg = -6;
 *     int failed = hrt_session_create(HRT_VERSION, NULL, &session) || hrt_target_add(session, &config, &real);
 *     config.role = HRT_TARGET_VIRTUAL, config.direction_deg = 5;
 *     failed = failed || hrt_target_add(session, &config, &virtual_cup) ||
 *              hrt_gap_query(session, real, virtual_cup, &gap);
 *     if (failed) puts(hrt_last_error());
 *     else printf("The gap is %.1f degrees, the largest feasible gap %.1f.\n", gap.gap_deg, gap.max_gap_deg);
 *     return failed;
 *   }
 */
#ifndef HAPTIC_RETARGETING_GAP_H
#define HAPTIC_RETARGETING_GAP_H

#include "target.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Gap between a real and a virtual target. The user perceives the direction of the finger plus a shift that depends on
 *  the plate orientation, and steers until the sum is the virtual direction plus the user's bias. The largest feasible
 *  gap is therefore the largest shift for the allowed plate orientations.
 *
 *  GUIDANCE_ARRIVAL allows orientations within person.motion_bound_deg of the direction of the motion, and the shift
 *  follows the user's illusion curve (HRT_PERSON_WEIGHT): 11.25 degrees for a linear illusion of weight 0.15 and a
 *  bound of 75 degrees. FIXED_DIRECTION and HRT_CONTROL_FIXED_PLATE use the model of the paper, with orientations
 *  within paper.plate_bound_deg of the virtual direction plus the bias: 14.9 degrees for a weight of 0.15 and a bound
 *  of 84.5 degrees. */
typedef struct hrt_gap {
  uint32_t struct_size;
  /** 1 if the gap is feasible: the plate can keep the finger moving in the direction of the real target. @bool */
  uint32_t reachable;
  hrt_target real_target;    /**< the real target */
  hrt_target virtual_target; /**< the virtual target */
  /** Virtual direction plus the user's bias, minus the real direction; in [-180, 180). @ccw */
  double gap_deg;
  /** Largest feasible gap, to either side. */
  double max_gap_deg;
  /** max_gap_deg minus the absolute value of gap_deg. Negative: the gap is not feasible. */
  double margin_deg;
  /** Plate orientation that sustains the gap or, if the gap is not feasible, causes the largest shift. @ccw */
  double plate_orientation_deg;
  /** Direction in which the finger settles: that of the real target if the gap is feasible. @ccw */
  double settling_direction_deg;
  /** Largest gap in the model of the paper, from person.tactile_weight and paper.plate_bound_deg. */
  double paper_max_gap_deg;
  /** SD of the bearings at which reaches to the real target end, due to the apparatus alone: plate.covariance (after
   *  contacts, registration.contact_covariance) and tracker.bearing_sd_deg of hrt_session_config. */
  double bearing_sd_deg;
  /** Fraction of reaches that would end more than 1.5 degrees off the bearing of the real target because of
   *  bearing_sd_deg alone. If it is too large, register with more touches or use another tracker. @range 0 to 1
   *  @unit 1 */
  double miss_share;
} hrt_gap;

/** Returns the gap of a pair, for example before a reach.
 *
 *  @param real_target     Target to which the hand would be steered.
 *  @param virtual_target  Target that the user sees.
 *  @param out_gap         Gap of the pair.
 *  @return INVALID_HANDLE, or OUT_OF_RANGE for a target of the wrong role; both name the target.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_gap_query(hrt_session session, hrt_target real_target, hrt_target virtual_target,
                                               hrt_gap* out_gap) HRT_NOEXCEPT;

/** @flags HRT_ASSIGN Flags of hrt_gap_assign(). */
typedef uint32_t hrt_assign_flags;
/** Each real target is assigned to at most one virtual target. Without this flag, it may get several. */
#define HRT_ASSIGN_EXCLUSIVE UINT32_C(1)

/** Maximum number of virtual targets, and of real targets, in hrt_gap_assign(). */
#define HRT_ASSIGN_TARGETS_MAX 1000

/** Assigns real targets to as many virtual ones as possible, with feasible gaps only. Of these assignments, it chooses
 *  one whose largest ratio of |gap_deg| to max_gap_deg is minimal. With EXCLUSIVE, 1000 targets of each role take about
 *  a second.
 *
 *  @param virtual_targets  Targets that need a real one.
 *  @param real_targets     Targets to choose from.
 *  @param flags            HRT_ASSIGN_*.
 *  @param capacity         Number of elements of `out_gaps`.
 *  @param out_gaps         Gap of each virtual target. `out_gaps[0].struct_size` is the size of each element. A virtual
 *                          target without a real one has `reachable` 0 and real_target {0}; its other fields describe
 *                          its smallest gap.
 *  @return BUFFER_TOO_SMALL if `capacity` is below `virtual_count`; INVALID_HANDLE or OUT_OF_RANGE naming the wrong
 *          argument or target; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_gap_assign(hrt_session session, const hrt_target* virtual_targets,
                                                uint64_t virtual_count, const hrt_target* real_targets,
                                                uint64_t real_count, hrt_assign_flags flags, uint64_t capacity,
                                                hrt_gap* out_gaps) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "gap_init.h"

#endif
