/*
 * Set-ups determine the pose of the plate, the offset of the fingertip and the parameters of the user.
 *
 * A set-up is a second frame loop: hrt_setup_update() replaces hrt_reach_update(). It instructs the user, detects when
 * each instruction is completed, and repeats failed attempts. In each frame, display step.text and step.place_m, and
 * turn the plate to step.plate_orientation_deg. Tested with simulated people only.
 *
 * Example: a simulated person follows the set-up. With a tracked finger, fill in `sample` instead of calling
 * hrt_person_move().
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <haptic_retargeting/person.h>
 *   #include <haptic_retargeting/setup.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session session;
 *     hrt_person person;
 *     hrt_target follow_setup = {0};
 *     hrt_sample sample = hrt_sample_init();
 *     hrt_setup_step step = hrt_setup_step_init();
 *     hrt_setup_result result = hrt_setup_result_init();
 *     int failed = hrt_session_create(HRT_VERSION, NULL, &session) ||
 *                  hrt_setup_begin(session, HRT_SETUP_ALL_MISSING, NULL) || hrt_person_create(NULL, 1, &person) ||
 *                  hrt_person_begin(person, session, follow_setup);
 *     for (int frame = 0; !failed && (step.instruction != HRT_STEP_FINISH || result.left); ++frame) {
 *       const int64_t time_ns = frame * INT64_C(11111111);
 *       failed = hrt_person_move(person, time_ns, step.plate_orientation_deg, &sample) ||
 *                hrt_setup_update(session, &sample, &step) ||
 *                (step.instruction == HRT_STEP_FINISH && hrt_setup_finish(session, &result));
 *     }
 *     if (failed) puts(hrt_last_error());
 *     else printf("Tactile weight: %.2f to %.2f.\n", result.tactile_weight.lower, result.tactile_weight.upper);
 *     return failed;
 *   }
 */
#ifndef HAPTIC_RETARGETING_SETUP_H
#define HAPTIC_RETARGETING_SETUP_H

#include "reach.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** @flags HRT_SETUP Parts of a set-up, in the order of execution: later parts use the results of earlier ones. */
typedef uint32_t hrt_setup_parts;
/** Measures hrt_session_config::fingertip_offset_m, the offset of the point of contact on the skin from the tracked
 *  joint, from six touches of one mark with different poses of the finger. Requires HRT_SAMPLE_JOINT_ROTATION. */
#define HRT_SETUP_FINGERTIP UINT32_C(1)
/** Measures the plate's pose in the world from touches of marks. Requires HRT_SAMPLE_WORLD_POSITION. An error of the
 *  rotation rotates every reach by the same angle, and the samples of a reach do not reveal it. */
#define HRT_SETUP_REGISTRATION UINT32_C(2)
/** Checks the registration by one touch, for example before each reach, and by a second touch if the first disagrees.
 *  If a touch agrees, sets registration.time_ns; otherwise, clears HRT_SESSION_REGISTERED. Requires
 *  HRT_SAMPLE_WORLD_POSITION and HRT_SESSION_REGISTERED. Cannot be combined with REGISTRATION. */
#define HRT_SETUP_CHECK UINT32_C(4)
/** Corrects the error that remains after registration. A guide is a strip on the plate from a dimple at the start to a
 *  real object. For each of the first 8 real targets, in the order of their addition, the user makes six slides along
 *  its guide, back and forth without lifting. Each slide ends with a rest of 1.4 s. With simulated trackers, guides
 *  halve the error of a registration by six marks. Sets registration.contact_correction and HRT_SESSION_START_FELT.
 *  Requires HRT_SESSION_REGISTERED and real targets whose near sides are at least 40 mm from the start. Cannot be
 *  combined with REGISTRATION. */
#define HRT_SETUP_GUIDES UINT32_C(8)
/** Measures the user's illusion curve, bias and habit, and the tracker's noise, from slides straight ahead while the
 *  plate does not turn. */
#define HRT_SETUP_CALIBRATION UINT32_C(16)
/** As CALIBRATION; in addition, hrt_setup_result::differing compares the result with the values before the set-up.
 *  Cannot be combined with CALIBRATION. */
#define HRT_SETUP_RETEST UINT32_C(32)
/** FINGERTIP if fingertip_offset_m is 0, REGISTRATION without HRT_SESSION_REGISTERED, and CALIBRATION if
 *  person.covariance is 0 and the plate leaves at least 50 mm for slides ahead of the start. Parts whose required
 *  fields the samples lack are skipped. Cannot be combined with other parts. */
#define HRT_SETUP_ALL_MISSING UINT32_C(64)

/** Maximum number of marks. */
#define HRT_MARKS_MAX 8
/** Number of elements of hrt_setup_config::marks_m. */
#define HRT_MARK_NUMBERS 24
/** Bytes of hrt_setup_step::text and hrt_setup_result::reason, including the terminating zero. */
#define HRT_TEXT_SIZE 256

/** Configuration of a set-up. */
typedef struct hrt_setup_config {
  uint32_t struct_size;
  /** Number of marks; 0: the start and five points on the rim. More marks give a better pose and take more touches.
   *  @range 0 or 3 to 8 @default 0 */
  uint32_t mark_count;
  /** Touches of each mark in REGISTRATION. Four touches halve the error of the pose, and take four times as long.
   *  @range 1 to 5 @default 1 */
  uint32_t touches_per_mark;
  /** Index of the mark that CHECK uses. A mark on the rim reveals a rotation of the plate best. @range 0 to 7
   *  @default 1 */
  uint32_t check_mark;
  /** 1: the registration also estimates plate.scale. Set it if the tracker's unit of length may be wrong by more than 1
   *  %; otherwise, the additional parameter makes the pose less accurate. @bool @default 0 */
  uint32_t fit_scale;
  /** Maximum number of slides of a calibration. After the first 16 slides, groups of 8 follow until the tactile weight
   *  is accurate enough (enough_weight_width). A lower maximum limits the duration, but the weight of a user with much
   *  variation remains less certain. @range 16 to 200 @default 40 */
  uint32_t max_slides;
  /** Marks in plate coordinates: x, y and z of each of mark_count marks. Set them to points that the user can find on
   *  the plate by touch or sight. @range -10 to 10 @default 0 */
  double marks_m[HRT_MARK_NUMBERS];
  /** Expected SD of each coordinate of a touch. A larger value accepts less accurate touches, but wrong touches too.
   *  @range 1e-5 to 0.1 @default 0.003 */
  double touch_sd_m;
  /** Upward direction in the engine's world, of any length: the plate's face must point within 60 degrees of it. All 0:
   *  not checked; if left and right marks are confused, the fit then accepts the pose of a plate that is upside down.
   *  @range -1000 to 1000 @unit 1 @default (0, 1, 0) */
  double up[3];
  /** Lower end of the range of plate orientations for slides, which use the middle 80 % of the range. With a narrower
   *  range, the illusion curve is less certain. @range -89 to 89 @default -75 @ccw */
  double lower_plate_deg;
  /** Upper end of the range that begins at lower_plate_deg; at least 40 above it. @range -89 to 89 @default 75 @ccw */
  double upper_plate_deg;
  /** Width of the 95 % interval of the tactile weight at which a calibration ends. A smaller value takes more slides.
   *  @range 0.001 to 0.5 @unit 1 @default 0.04 */
  double enough_weight_width;
} hrt_setup_config;

/** @enumeration HRT_STEP Instruction to the user or to the application, in hrt_setup_step::instruction. */
typedef uint32_t hrt_setup_instruction;
#define HRT_STEP_WAIT UINT32_C(0)          /**< lift the finger: the plate turns */
#define HRT_STEP_TOUCH_MARK UINT32_C(1)    /**< lift the finger, and touch the mark at place_m */
#define HRT_STEP_HOLD_STILL UINT32_C(2)    /**< hold the finger still on the mark */
#define HRT_STEP_REST_AT_START UINT32_C(3) /**< put the finger on the start, and let it rest */
#define HRT_STEP_SLIDE UINT32_C(4)         /**< slide towards place_m, and rest there */
#define HRT_STEP_FINISH UINT32_C(5)        /**< let the user wait, and call hrt_setup_finish() */

/** @enumeration HRT_PROBLEM Problem of the last attempt, which the user repeats. hrt_setup_step::text has the reason of
 *  DISAGREES, UPSIDE_DOWN and UNDETERMINED. */
typedef uint32_t hrt_setup_problem;
#define HRT_PROBLEM_NONE UINT32_C(0)          /**< no problem */
#define HRT_PROBLEM_TOO_FAST UINT32_C(1)      /**< the slide took less than about 0.4 s */
#define HRT_PROBLEM_TOO_SLOW UINT32_C(2)      /**< the slide took more than 8 s */
#define HRT_PROBLEM_STOPPED UINT32_C(3)       /**< the finger rested too early, or off the path */
#define HRT_PROBLEM_LEFT_PLATE UINT32_C(4)    /**< the finger was lifted, or moved over the rim */
#define HRT_PROBLEM_LOST UINT32_C(5)          /**< the tracker lost the finger */
#define HRT_PROBLEM_MOVED UINT32_C(6)         /**< the plate turned during the slide */
#define HRT_PROBLEM_PLATE UINT32_C(7)         /**< the plate has not followed its command for 5 s */
#define HRT_PROBLEM_DISAGREES UINT32_C(8)     /**< touches or guided slides do not fit the marks or each other */
#define HRT_PROBLEM_UPSIDE_DOWN UINT32_C(9)   /**< touches fit an upside-down or mirrored plate: check marks and axes */
#define HRT_PROBLEM_UNDETERMINED UINT32_C(10) /**< the data do not determine the result: more are needed */

/** @enumeration HRT_OBSERVED Likely mistake of the application. It is reported if no touch or slide is completed for
 *  20 s; TIME and WRONG_WAY are reported earlier. hrt_setup_step::text has the numbers. */
typedef uint32_t hrt_setup_observed;
#define HRT_OBSERVED_NONE UINT32_C(0)      /**< no mistake was detected */
#define HRT_OBSERVED_NO_FINGER UINT32_C(1) /**< every sample is a dropout: the tracker does not see the finger */
#define HRT_OBSERVED_LIFTED UINT32_C(2)    /**< the finger is above the plate in every sample */
#define HRT_OBSERVED_TIME UINT32_C(3)      /**< time_ns advances too slowly to be in nanoseconds */
#define HRT_OBSERVED_FAR UINT32_C(4)       /**< the finger is over 1 m from place_m: check unit of length and pose */
#define HRT_OBSERVED_PLATE UINT32_C(5)     /**< the plate reports another orientation than the commanded one */
#define HRT_OBSERVED_ELSEWHERE UINT32_C(6) /**< the finger is more than 25 mm from place_m */
#define HRT_OBSERVED_WRONG_WAY UINT32_C(7) /**< the last slide went backwards: check for swapped or mirrored axes */
#define HRT_OBSERVED_NO_REST UINT32_C(8)   /**< the finger has not moved to the requested position and rested */

/** Result of hrt_setup_update(): the next action of the user or of the application. */
typedef struct hrt_setup_step {
  uint32_t struct_size;
  /** Instruction to the user or to the application. */
  hrt_setup_instruction instruction;
  /** Part in progress, one of HRT_SETUP_*; 0: all parts are finished. */
  hrt_setup_parts part;
  /** Problem of the last attempt. */
  hrt_setup_problem problem;
  /** Number of touches or slides that are completed in this part. */
  uint32_t done;
  /** Number of touches or slides that this part needs. */
  uint32_t of;
  /** Index, from 0, of the mark; in FINGERTIP, of the pose of the finger; in GUIDES, of the guide. */
  uint32_t number;
  /** Likely mistake of the application. */
  hrt_setup_observed observed;
  /** Position to which the finger is to move, in plate coordinates. */
  double place_m[3];
  /** Plate orientation to turn to now. @ccw */
  double plate_orientation_deg;
  /** Problem and instruction in one line of UTF-8, to display or to speak. A text in brackets is for the supervisor. */
  char text[HRT_TEXT_SIZE];
} hrt_setup_step;

/** An estimate with its 95 % interval. The unit is that of the field that has this type. */
typedef struct hrt_interval {
  double value; /**< estimate @unit mixed */
  double lower; /**< lower end @unit mixed */
  double upper; /**< upper end @unit mixed */
  /** 1: the data determine the value. 0: they do not, and `value` is only the most likely point. @bool */
  uint32_t known;
  uint32_t reserved;
} hrt_interval;

/** @flags HRT_LACK_OF_FIT hrt_setup_result::lack_of_fit: patterns in the residuals of the fit. */
typedef uint32_t hrt_setup_lack_of_fit;
/** The residuals depend on the plate orientation: no illusion curve of the model fits the slides. Check the plate
 *  orientations and the direction of the slides. */
#define HRT_LACK_OF_FIT_ANGLE UINT32_C(1)
/** The residuals depend on the order of the slides: the user learns or gets tired. Allow practice or rest, and repeat
 *  the calibration. */
#define HRT_LACK_OF_FIT_ORDER UINT32_C(2)
/** The residuals depend on the position along the path: the paths are curved more than habit and steering explain. Ask
 *  for slower, longer and more even slides, and repeat the calibration. */
#define HRT_LACK_OF_FIT_PATH UINT32_C(4)

/** @flags HRT_RETEST hrt_setup_result::differing: differences of a retest. */
typedef uint32_t hrt_setup_difference;
#define HRT_RETEST_TACTILE_WEIGHT UINT32_C(1) /**< the tactile weight has changed */
#define HRT_RETEST_BIAS UINT32_C(2)           /**< the bias has changed */
#define HRT_RETEST_HABIT UINT32_C(4)          /**< the habit has changed */

/** Result of a set-up. The measured values are in the session's configuration. Fields of parts without a completed fit
 *  are 0. */
typedef struct hrt_setup_result {
  uint32_t struct_size;
  /** Parts that were determined and applied since the set-up began. */
  hrt_setup_parts done;
  /** Parts that are not finished: continue to call hrt_setup_update(). 0: the set-up is over. */
  hrt_setup_parts left;
  /** Values that a RETEST found to be different, by Holm's procedure. If nothing has changed, at most 5 % of retests
   *  report a difference. */
  hrt_setup_difference differing;
  /** Patterns that the model does not explain; the estimates of the user are then not applied. 0: no pattern. If the
   *  model fits, each pattern is reported for at most 1 % of users. */
  hrt_setup_lack_of_fit lack_of_fit;
  /** Number of completed slides in CALIBRATION or RETEST. */
  uint32_t slides;
  /** Number of slides that the fit uses. */
  uint32_t slides_used;
  /** Parts that ended without a result, for example after three rejected fits of touches, two touches that disagree
   *  (CHECK), or six unusable slides in succession. A calibration also ends without a result if the plate does not
   *  report the commanded orientation for a minute, or if max_slides does not suffice. Parts that depend on a dropped
   *  part are dropped too. */
  hrt_setup_parts dropped;
  /** Root mean square distance of the touches from their marks. */
  double registration_residual_m;
  /** SD of the estimated rotation of the plate about its normal. */
  double registration_turn_sd_deg;
  /** Distance between the touch of a CHECK and the expected position of its mark. */
  double check_distance_m;
  /** Largest SD of a coordinate of the fingertip's offset. */
  double fingertip_sd_m;
  /** Tactile weight: perceived shift divided by the angle between ridge normal and motion, at 60 degrees, for the speed
   *  of the slides. @unit 1 */
  hrt_interval tactile_weight;
  /** Bias: direction at which the user aims, minus the direction of the target. @ccw */
  hrt_interval bias_deg;
  /** Largest feasible gap with the plate within 75 degrees of the motion, on the side on which it is smaller. */
  hrt_interval max_gap_deg;
  /** Reason for which the last dropped part was dropped, in one line of UTF-8; empty if no part was dropped. */
  char reason[HRT_TEXT_SIZE];
} hrt_setup_result;

/** Begins a set-up. Until it is over, no reach can begin, and only the set-up can change the configuration. After
 *  hrt_setup_cancel(), ALL_MISSING repeats only the parts that were not completed. CALIBRATION and RETEST allocate 1.3
 *  MB with the default max_slides.
 *
 *  @param what    Parts, HRT_SETUP_*.
 *  @param config  Configuration, copied. Null: the defaults.
 *  @return OUT_OF_RANGE naming the field, for CALIBRATION and RETEST also if the plate leaves less than 50 mm for
 *          slides ahead of start_position_m, for GUIDES if a target is too near; WRONG_STATE during a reach or a
 *          set-up, or if a requirement of CHECK or GUIDES is not met; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_begin(hrt_session session, hrt_setup_parts what,
                                                 const hrt_setup_config* config) HRT_NOEXCEPT;

/** Processes one sample and returns the next action. Call it every frame, also while the finger is lifted or not
 *  tracked.
 *
 *  @param sample    Finger, and plate if its orientation is measured.
 *  @param out_step  Next action.
 *  @return WRONG_STATE without a set-up; OUT_OF_RANGE naming the field, or naming `flags` if HRT_SAMPLE_DIRECTION is
 *          set, which set-ups do not support, or if a part that was requested by name needs a field that is not set;
 *          TIME_REVERSED.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_update(hrt_session session, const hrt_sample* sample,
                                                  hrt_setup_step* out_step) HRT_NOEXCEPT;

/** Continues the fit of a part for less than 1 ms, or for up to 3 ms with more than 40 slides. Call it in each frame
 *  whose step has HRT_STEP_FINISH: a fit of touches takes one call, a fit of 16 slides 100 to 300. When the fit is
 *  complete, the call applies its result to the configuration, and the set-up continues with the remaining parts. If a
 *  fit is rejected, the user repeats the touches or guides, at most twice, or makes more slides of a calibration, up to
 *  max_slides; then the part is dropped (hrt_setup_result::dropped).
 *
 *  @param out_result  Result so far.  @return WRONG_STATE without a set-up, or before HRT_STEP_FINISH; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_finish(hrt_session session, hrt_setup_result* out_result) HRT_NOEXCEPT;

/** Ends the set-up. Results that hrt_setup_finish() has applied are kept.
 *
 *  @return WRONG_STATE without a set-up.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_cancel(hrt_session session) HRT_NOEXCEPT;

/** @enumeration HRT_SLIDE hrt_setup_residual::verdict: use of a slide. */
typedef uint32_t hrt_slide_verdict;
#define HRT_SLIDE_USED UINT32_C(0)         /**< part of the fit */
#define HRT_SLIDE_OUTLYING UINT32_C(1)     /**< rejected as an outlier */
#define HRT_SLIDE_ALONG_RIDGES UINT32_C(2) /**< rejected: nearly along the ridges, where the illusion changes sign */

/** One slide of a calibration. */
typedef struct hrt_setup_residual {
  uint32_t struct_size;
  /** Use of the slide. */
  hrt_slide_verdict verdict;
  /** Plate orientation. @ccw */
  double plate_deg;
  /** Direction of the second half of the path, as measured. @ccw */
  double direction_deg;
  /** Direction of the second half of the path, according to the fitted model. @ccw */
  double fitted_deg;
  /** direction_deg minus fitted_deg. @ccw */
  double residual_deg;
} hrt_setup_residual;

/** Returns one slide of the session's last CALIBRATION or RETEST with its residual, for a plot.
 *
 *  @param slide         Index of the slide in the order of execution.
 *  @param out_residual  Slide and its residual.
 *  @return WRONG_STATE before the first fit; OUT_OF_RANGE beyond the last slide.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_get_residual(hrt_session session, uint32_t slide,
                                                        hrt_setup_residual* out_residual) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "setup_init.h"

#endif
