/*
 * Setting up, before any frame: scenes from files, the plate's place, who the user is, their profile; and
 * which targets a session has, and which real one serves which virtual one.
 *
 * A set-up is a frame loop with another call in it. It says what the user is to do, sees it done, and repeats
 * what failed:
 *
 *   hrt_setup_begin(session, HRT_SETUP_ALL_MISSING, NULL);
 *   do {
 *     do { hrt_setup_update(session, &sample, &step); } while (step.instruction != HRT_STEP_FINISH);
 *     hrt_setup_finish(session, &result);
 *   } while (result.left);
 *
 * where each frame shows step.text and step.place_m and sends step.plate_orientation_deg to the plate. Tried
 * on simulated people only.
 */
#ifndef HAPTIC_RETARGETING_SETUP_H
#define HAPTIC_RETARGETING_SETUP_H

#include "profile.h"
#include "reach.h"
#include "scene.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Parts of a set-up, in the order in which they are done: each uses the results of those before it. */
/** The skin that touches, beside the tracked joint, from six touches of one mark with the finger held
 *  differently: hrt_session_config::fingertip_offset_m. Needs HRT_SAMPLE_JOINT_ROTATION. */
#define HRT_SETUP_FINGERTIP UINT32_C(1)
/** The plate's pose in the world, from touches of marks. Needs HRT_SAMPLE_WORLD_POSITION. A frame that is
 *  turned by 1 degree about the start turns every reach by as much, and nothing within a reach shows it. */
#define HRT_SETUP_REGISTRATION UINT32_C(2)
/** Whether the plate is still where it was registered, by one touch, as before each reach; by a second one if
 *  the first disagrees. Sets registration.time_ns, or clears HRT_SESSION_REGISTERED. Not with REGISTRATION.
 */
#define HRT_SETUP_CHECK UINT32_C(4)
/** What is left of the registration's error at the real targets, from slides to and fro along a guide from the
 * start to each of them, the first 8 in the order of their addition: a strip with an end at the object, and a
 * dimple at the start. Six slides a target, with a rest of 1.4 s at each end and without a lift. Sets
 * registration.contact_correction and HRT_SESSION_START_FELT. Halves the error of six marks, and more where the
 * tracker's frame is not rigid. Needs HRT_SESSION_REGISTERED, and real targets whose nearer sides are at least 40 mm
 * from the start. Not with REGISTRATION. */
#define HRT_SETUP_GUIDES UINT32_C(8)
/** The user: curve of the illusion, bias and habit, and the tracker's noise, from slides straight ahead over
 * a plate at rest. */
#define HRT_SETUP_CALIBRATION UINT32_C(16)
/** As CALIBRATION, and hrt_setup_result::differing compares it with what was believed before. Not with it. */
#define HRT_SETUP_RETEST UINT32_C(32)
/** Those of FINGERTIP, REGISTRATION and CALIBRATION of which the session has no result, and which
 * the samples can show. Alone. */
#define HRT_SETUP_ALL_MISSING UINT32_C(64)

/** Maximum number of marks. */
#define HRT_MARKS_MAX 8
/** Numbers in hrt_setup_config::marks_m. */
#define HRT_MARK_NUMBERS 24
/** Bytes of a sentence, including the terminating zero. */
#define HRT_TEXT_SIZE 256

/** Configuration of a set-up. hrt_setup_config_init() fills every field. */
typedef struct hrt_setup_config {
  uint32_t struct_size;
  /** Number of marks. 3 to 8; 0: the start and five places on the rim. Default 0. */
  uint32_t mark_count;
  /** Touches of each mark: four halve the error of the pose. 1 to 5. Default 1. */
  uint32_t touches_per_mark;
  /** Number of the mark that CHECK asks for, from 0. One far from the start shows best that the plate has
   *  turned. 0 to 7. Default 1. */
  uint32_t check_mark;
  /** 1: the tracker's unit of length is fitted too, of use if it may be off by more than 1 in 100. 0 to 1.
   *  Default 0. */
  uint32_t fit_scale;
  /** Maximum number of slides. The first 16 are followed by 8 more, again and again, until the weight is
   *  known well enough. 16 to 200. Default 40. */
  uint32_t max_slides;
  /** The marks in plate coordinates, x, y and z of each. Each within 1000. Default 0. */
  double marks_m[HRT_MARK_NUMBERS];
  /** Standard deviation of each coordinate of a touch, as expected. Raising it accepts worse touches. 1e-5 to
   *  0.1. Default 0.003. */
  double touch_sd_m;
  /** Up in the engine's world, of any length: the plate's face must look that way within 60 degrees. All 0:
   *  not checked, and touches of which left and right were confused pass for those of a plate upside down.
   *  Each within 1000. Default (0, 1, 0). */
  double up[3];
  /** Range of the plate orientations (base.h) in slides. -89 to 89, the upper at least 40 above the lower.
   *  Default -75 and 75. */
  double lower_plate_deg;
  double upper_plate_deg;
  /** Width of the 95 % interval of the tactile weight at which slides are enough. Lowering it asks for more
   *  slides, of use for a study of people: no reach relies on a narrower one than the default. 0.001 to 0.5.
   *  Default 0.04. */
  double enough_weight_width;
} hrt_setup_config;

/** What is asked of the user, or of the host. */
#define HRT_STEP_WAIT UINT32_C(0)          /**< lift the finger: the plate turns */
#define HRT_STEP_TOUCH_MARK UINT32_C(1)    /**< lift the finger, and touch the mark at place_m */
#define HRT_STEP_HOLD_STILL UINT32_C(2)    /**< there */
#define HRT_STEP_REST_AT_START UINT32_C(3) /**< put the finger to the start, and let it rest */
#define HRT_STEP_SLIDE UINT32_C(4)         /**< slide towards place_m, and rest there */
#define HRT_STEP_FINISH UINT32_C(5)        /**< nothing: hrt_setup_finish() is to be called */

/** What was wrong with the last try, which is repeated. */
#define HRT_PROBLEM_NONE UINT32_C(0)
#define HRT_PROBLEM_TOO_FAST UINT32_C(1)      /**< the slide took less than some 0.4 s */
#define HRT_PROBLEM_TOO_SLOW UINT32_C(2)      /**< the slide took more than 8 s */
#define HRT_PROBLEM_STOPPED UINT32_C(3)       /**< the finger rested before it was half way, or elsewhere */
#define HRT_PROBLEM_LEFT_PLATE UINT32_C(4)    /**< the finger was lifted, or went over the rim */
#define HRT_PROBLEM_LOST UINT32_C(5)          /**< the tracker lost the finger */
#define HRT_PROBLEM_MOVED UINT32_C(6)         /**< the plate turned during the slide */
#define HRT_PROBLEM_PLATE UINT32_C(7)         /**< the plate has not turned as it was asked, for 5 s */
#define HRT_PROBLEM_DISAGREES UINT32_C(8)     /**< touches, or guided slides, do not fit the marks or each other */
#define HRT_PROBLEM_UPSIDE_DOWN UINT32_C(9)   /**< by the touches the plate lies upside down: marks were confused */
#define HRT_PROBLEM_UNDETERMINED UINT32_C(10) /**< what was done does not determine the result: more is needed */

/** What to do now. Set `struct_size` before the call. */
typedef struct hrt_setup_step {
  uint32_t struct_size;
  /** HRT_STEP_*. */
  uint32_t instruction;
  /** HRT_SETUP_*: the part that is under way; 0: none is left. */
  uint32_t part;
  /** HRT_PROBLEM_*. */
  uint32_t problem;
  /** Touches or slides that are done, and the number that this part needs. */
  uint32_t done;
  uint32_t of;
  /** Number of the mark, of the way to hold the finger, or of the guide, from 0. */
  uint32_t number;
  uint32_t reserved;
  /** Where the finger is to go, in plate coordinates. */
  double place_m[3];
  /** Plate orientation (base.h) to turn to now. */
  double plate_orientation_deg;
  /** Problem and instruction in one line of UTF-8, for a label or a voice. */
  char text[HRT_TEXT_SIZE];
} hrt_setup_step;

/** An estimate with the ends of its 95 % interval. This struct never grows. */
typedef struct hrt_interval {
  double value;
  double lower;
  double upper;
  /** 1; or 0: the data cannot determine the value. Then the interval is the range that was searched, and
   *  the value its likeliest point. */
  uint32_t known;
  uint32_t reserved;
} hrt_interval;

/** Patterns in what the fit leaves unexplained: hrt_setup_result::lack_of_fit. */
/** Over the plate orientation: no curve fits. Check the plate's orientations and the goal direction. */
#define HRT_LACK_OF_FIT_ANGLE UINT32_C(1)
/** Over the order of the slides: the user learns or tires. Let them practise or rest, and repeat. */
#define HRT_LACK_OF_FIT_ORDER UINT32_C(2)
/** Along the paths: they bend as neither a habit nor the model's steering does. Ask for slower, longer and
 *  even slides, and repeat. */
#define HRT_LACK_OF_FIT_PATH UINT32_C(4)

/** Differences of a retest: hrt_setup_result::differing. */
#define HRT_RETEST_TACTILE_WEIGHT UINT32_C(1)
#define HRT_RETEST_BIAS UINT32_C(2)
#define HRT_RETEST_HABIT UINT32_C(4)

/** What a set-up has found. The session's configuration has the values themselves. Values of parts that are
 *  not `done` are 0. Set `struct_size` before the call. */
typedef struct hrt_setup_result {
  uint32_t struct_size;
  /** Parts that were found and applied, since the set-up began: HRT_SETUP_*. */
  uint32_t done;
  /** HRT_SETUP_*: parts that are to be done yet, so updates continue. 0: the set-up is over. */
  uint32_t left;
  /** HRT_RETEST_*, by Holm's procedure: if nothing has changed, any of them is set in 5 % of retests. */
  uint32_t differing;
  /** HRT_LACK_OF_FIT_*: the user is not like the model, and nothing of them is known. 0: none was found, each
   * at 1 % of people whom the model fits. */
  uint32_t lack_of_fit;
  /** Slides that were made, and those of them that count. */
  uint32_t slides;
  uint32_t slides_used;
  uint32_t reserved;
  /** Root mean square distance of the touches from their marks, and the standard deviation of the plate's
   *  turn about its normal, which turns every reach. */
  double registration_residual_m;
  double registration_turn_sd_deg;
  /** Distance of a CHECK's touch from where its mark should be. */
  double check_distance_m;
  /** Largest standard deviation of a coordinate of the fingertip's offset. */
  double fingertip_sd_m;
  /** Felt shift over the offset of the ridge normal from the motion, at 60 degrees, at the pace of the slides. */
  hrt_interval tactile_weight;
  /** Goal minus target direction, left positive. */
  hrt_interval bias_deg;
  /** Largest gap between real and virtual direction that can be held, on the weaker side. */
  hrt_interval max_gap_deg;
} hrt_setup_result;

/** Begins a set-up of `what`, HRT_SETUP_*. Until it is
 * over no reach can begin, and the configuration does not change but by the set-up. Takes 1.4 MB for slides.
 * After a cancel, ALL_MISSING continues with the part that was under way: parts that are done are not
 * missing. `config` may be null: the defaults. Errors: OUT_OF_RANGE naming the field, for CALIBRATION also if
 * the plate has less than 50 mm ahead of start_position_m, for GUIDES if a target is too near; WRONG_STATE during
 * a reach or a set-up, for CHECK and GUIDES without what they need; OUT_OF_MEMORY. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_begin(hrt_session session, uint32_t what,
                                                 const hrt_setup_config* config) HRT_NOEXCEPT;

/** Takes one sample, also of a finger that is lost or lifted, and returns what to do now. Errors: WRONG_STATE
 * without a set-up; OUT_OF_RANGE naming the field, or flags: HRT_SAMPLE_DIRECTION, which shows nothing here,
 * or a sample without what a part needs that was asked for by name; TIME_REVERSED. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_update(hrt_session session, const hrt_sample* sample,
                                                  hrt_setup_step* out_step) HRT_NOEXCEPT;

/** Fits what was done, once a step says HRT_STEP_FINISH, and applies the result to the configuration; then
 * the set-up continues with what is left. A part that its fit refuses is left, and repeated; a calibration
 * that max_slides do not determine, or that has lack of fit, is neither `done` nor left. Takes some 25
 * microseconds a sample of slides, up to a second: too long for a thread that draws frames. Errors:
 * WRONG_STATE without a set-up, or before HRT_STEP_FINISH; OUT_OF_MEMORY. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_finish(hrt_session session, hrt_setup_result* out_result) HRT_NOEXCEPT;

/** Ends the set-up. What hrt_setup_finish() has applied stays. Errors: WRONG_STATE without a set-up.
 * [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_cancel(hrt_session session) HRT_NOEXCEPT;

/** Another user comes: what is known of the last one is the default again, which is the part person, what profiles
 * hold of the part paper, motion_bound_deg and fingertip_offset_m. Plate, tracker, registration and targets stay,
 * so that HRT_SETUP_ALL_MISSING asks for the user alone. Errors: WRONG_STATE during a reach or a set-up.
 * [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_session_new_person(hrt_session session) HRT_NOEXCEPT;

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

/** Assigns a real target to each virtual one: as many as possible are served, and of all such assignments the
 * largest share, gap_deg over max_gap_deg, is the smallest; exactly so. `out_gaps[i]` is that of
 * virtual_targets[i]; `out_gaps[0].struct_size` is the size of each. One that cannot be served has
 * `reachable` 0, a null real_target, and the numbers of the nearest real target. Takes up to a second
 * for 1000 of each with EXCLUSIVE. `flags` is HRT_ASSIGN_*. Errors: BUFFER_TOO_SMALL if `capacity` is below
 * `virtual_count`; INVALID_HANDLE or OUT_OF_RANGE naming the argument and the index of a wrong or repeated
 * id; OUT_OF_MEMORY. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_target_assign(hrt_session session, const hrt_target* virtual_targets,
                                                   uint64_t virtual_count, const hrt_target* real_targets,
                                                   uint64_t real_count, uint32_t flags, uint64_t capacity,
                                                   hrt_gap* out_gaps) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "setup_init.h"

#endif
