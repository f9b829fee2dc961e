/*
 * Set-ups: they determine the pose of the plate, the offset of the fingertip and the parameters of the user, before the
 * first reach.
 *
 * A set-up is a frame loop with another call. It instructs the user, detects when each instruction is completed, and
 * repeats failed attempts. Each frame displays step.text and step.place_m, and turns the plate to
 * step.plate_orientation_deg. No call of the loop takes more than 1 ms. Tested with simulated people only.
 *
 * Example: a simulated person follows the set-up. With a tracked finger, fill `sample` instead of hrt_person_move().
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

/** @flags HRT_SETUP Parts of a set-up, in the order of execution: each uses the results of the parts before it. */
typedef uint32_t hrt_setup_parts;
/** Offset of the point of contact on the skin from the tracked joint, from six touches of one mark with the finger held
 *  in different ways: hrt_session_config::fingertip_offset_m. Requires HRT_SAMPLE_JOINT_ROTATION. */
#define HRT_SETUP_FINGERTIP UINT32_C(1)
/** The plate's pose in the world, from touches of marks. Requires HRT_SAMPLE_WORLD_POSITION. A frame that is rotated by
 *  1 degree about the start rotates every reach by 1 degree, and nothing within a reach reveals it. */
#define HRT_SETUP_REGISTRATION UINT32_C(2)
/** Check of the registration by one touch, for example before each reach; by a second touch if the first disagrees.
 *  Sets registration.time_ns, or clears HRT_SESSION_REGISTERED. Not together with REGISTRATION. */
#define HRT_SETUP_CHECK UINT32_C(4)
/** Remaining error of the registration at the real targets, from slides back and forth along a guide from the start to
 *  each of the first 8 targets in the order of their addition. A guide is a strip that ends at the object, with a
 *  dimple at the start. It halves the error of six marks, more if the tracker's frame is distorted, and takes six
 *  slides for each target without lifting, with a rest of 1.4 s at each end. Sets registration.contact_correction and
 *  HRT_SESSION_START_FELT. Requires HRT_SESSION_REGISTERED and real targets whose near sides are at least 40 mm from
 *  the start. Not together with REGISTRATION. */
#define HRT_SETUP_GUIDES UINT32_C(8)
/** The user's illusion curve, bias and habit, and the tracker's noise, from slides straight ahead over a plate at
 *  rest. */
#define HRT_SETUP_CALIBRATION UINT32_C(16)
/** As CALIBRATION; in addition, hrt_setup_result::differing compares the result with the values before it. Not together
 *  with CALIBRATION. */
#define HRT_SETUP_RETEST UINT32_C(32)
/** All of FINGERTIP, REGISTRATION and CALIBRATION for which the session has no result and the samples have the data.
 *  Not together with other parts. */
#define HRT_SETUP_ALL_MISSING UINT32_C(64)

/** Maximum number of marks. */
#define HRT_MARKS_MAX 8
/** Numbers in hrt_setup_config::marks_m. */
#define HRT_MARK_NUMBERS 24
/** Bytes of a sentence, including the terminating zero. */
#define HRT_TEXT_SIZE 256

/** Configuration of a set-up. */
typedef struct hrt_setup_config {
  uint32_t struct_size;
  /** Number of marks; 0: the start and five points on the rim. More marks give a better pose and take more touches.
   *  @range 0 or 3 to 8 @default 0 */
  uint32_t mark_count;
  /** Touches of each mark. Four halve the error of the pose and take four times as long. @range 1 to 5 @default 1 */
  uint32_t touches_per_mark;
  /** Index of the mark that CHECK asks for. A mark far from the start shows a rotation of the plate best. @range 0 to 7
   *  @default 1 */
  uint32_t check_mark;
  /** 1: also fit the tracker's unit of length. Set it if the unit may be wrong by more than 1 %; otherwise, the fit
   *  adds noise. @bool @default 0 */
  uint32_t fit_scale;
  /** Maximum number of slides. The first 16 are followed by groups of 8 until the weight is accurate enough. Lowering
   *  it limits the time of an unsteady user, whose weight then remains less certain. @range 16 to 200 @default 40 */
  uint32_t max_slides;
  /** Marks in plate coordinates: x, y and z of each. Set them to points that the user can find on the plate by touch or
   *  sight. @range -10 to 10 @default 0 */
  double marks_m[HRT_MARK_NUMBERS];
  /** Expected SD of each coordinate of a touch. Raising it accepts less accurate touches, and wrong ones too.
   *  @range 1e-5 to 0.1 @default 0.003 */
  double touch_sd_m;
  /** Upward direction in the engine's world, of any length: the plate's face must point within 60 degrees of it. All 0:
   *  not checked; touches with left and right confused are then accepted as those of a plate that is upside down.
   *  @range -1000 to 1000 @unit 1 @default (0, 1, 0) */
  double up[3];
  /** Lower end of the plate orientations in slides. A narrower range leaves the curve of the illusion less certain.
   *  @range -89 to 89 @default -75 @ccw */
  double lower_plate_deg;
  /** Upper end of the plate orientations in slides, at least 40 above the lower end. @range -89 to 89 @default 75
   *  @ccw */
  double upper_plate_deg;
  /** Width of the 95 % interval of the tactile weight at which no more slides are needed. Lowering it takes more
   *  slides: only studies of people need a narrower interval than the default. @range 0.001 to 0.5 @unit 1
   *  @default 0.04 */
  double enough_weight_width;
} hrt_setup_config;

/** @enumeration HRT_STEP Instruction to the user or to the host, in hrt_setup_step::instruction. */
typedef uint32_t hrt_setup_instruction;
#define HRT_STEP_WAIT UINT32_C(0)          /**< lift the finger: the plate turns */
#define HRT_STEP_TOUCH_MARK UINT32_C(1)    /**< lift the finger, and touch the mark at place_m */
#define HRT_STEP_HOLD_STILL UINT32_C(2)    /**< hold the finger still on the mark */
#define HRT_STEP_REST_AT_START UINT32_C(3) /**< put the finger on the start, and let it rest */
#define HRT_STEP_SLIDE UINT32_C(4)         /**< slide towards place_m, and rest there */
#define HRT_STEP_FINISH UINT32_C(5)        /**< nothing for the user: call hrt_setup_finish() */

/** @enumeration HRT_PROBLEM Problem of the last attempt, which is repeated. hrt_setup_step::text has the reason of
 *  DISAGREES, UPSIDE_DOWN and UNDETERMINED. */
typedef uint32_t hrt_setup_problem;
#define HRT_PROBLEM_NONE UINT32_C(0)          /**< no problem */
#define HRT_PROBLEM_TOO_FAST UINT32_C(1)      /**< the slide took less than about 0.4 s */
#define HRT_PROBLEM_TOO_SLOW UINT32_C(2)      /**< the slide took more than 8 s */
#define HRT_PROBLEM_STOPPED UINT32_C(3)       /**< the finger rested in the first half of the path, or elsewhere */
#define HRT_PROBLEM_LEFT_PLATE UINT32_C(4)    /**< the finger was lifted, or moved over the rim */
#define HRT_PROBLEM_LOST UINT32_C(5)          /**< the tracker lost the finger */
#define HRT_PROBLEM_MOVED UINT32_C(6)         /**< the plate turned during the slide */
#define HRT_PROBLEM_PLATE UINT32_C(7)         /**< the plate has not followed its command for 5 s */
#define HRT_PROBLEM_DISAGREES UINT32_C(8)     /**< touches or guided slides do not fit the marks or each other */
#define HRT_PROBLEM_UPSIDE_DOWN UINT32_C(9)   /**< the touches fit a plate upside down or mirrored: marks or axes */
#define HRT_PROBLEM_UNDETERMINED UINT32_C(10) /**< the data do not determine the result: more are needed */

/** @enumeration HRT_OBSERVED Likely mistake of the application if no instruction is completed for 20 s; TIME and
 *  WRONG_WAY earlier. hrt_setup_step::text has the numbers. */
typedef uint32_t hrt_setup_observed;
#define HRT_OBSERVED_NONE UINT32_C(0)      /**< progress, or too little time */
#define HRT_OBSERVED_NO_FINGER UINT32_C(1) /**< no sample has the finger */
#define HRT_OBSERVED_LIFTED UINT32_C(2)    /**< the finger is above the plate in every sample */
#define HRT_OBSERVED_TIME UINT32_C(3)      /**< time_ns advances too slowly to be in nanoseconds */
#define HRT_OBSERVED_FAR UINT32_C(4)       /**< the finger is more than 1 m from place_m: unit of length, or pose */
#define HRT_OBSERVED_PLATE UINT32_C(5)     /**< the plate reports another orientation than the commanded one */
#define HRT_OBSERVED_ELSEWHERE UINT32_C(6) /**< the finger is not at place_m */
#define HRT_OBSERVED_WRONG_WAY UINT32_C(7) /**< the last slide went backwards: axes are swapped or mirrored */
#define HRT_OBSERVED_NO_REST UINT32_C(8)   /**< the finger has not moved to the requested position and rested */

/** Result of hrt_setup_update(): the next action of the user or of the host. */
typedef struct hrt_setup_step {
  uint32_t struct_size;
  /** Instruction to the user or to the host. */
  hrt_setup_instruction instruction;
  /** Part in progress, one of HRT_SETUP_*; 0: all parts are finished. */
  hrt_setup_parts part;
  /** Problem of the last attempt. */
  hrt_setup_problem problem;
  /** Number of touches or slides that are completed in this part. */
  uint32_t done;
  /** Number of touches or slides that this part needs. */
  uint32_t of;
  /** Index of the mark, of the way to hold the finger, or of the guide. */
  uint32_t number;
  /** Likely mistake of the application. */
  hrt_setup_observed observed;
  /** Position to which the finger is to move, in plate coordinates. */
  double place_m[3];
  /** Plate orientation to turn to now. @ccw */
  double plate_orientation_deg;
  /** Problem and instruction in one line of UTF-8, to display or to speak. */
  char text[HRT_TEXT_SIZE];
} hrt_setup_step;

/** An estimate with its 95 % interval. */
typedef struct hrt_interval {
  double value; /**< estimate @unit mixed */
  double lower; /**< lower end @unit mixed */
  double upper; /**< upper end @unit mixed */
  /** 0 if the data cannot determine the value. The interval is then the range of the search, and the value its most
   *  likely point. @bool */
  uint32_t known;
  uint32_t reserved;
} hrt_interval;

/** @flags HRT_LACK_OF_FIT hrt_setup_result::lack_of_fit: patterns in the residuals of the fit. */
typedef uint32_t hrt_setup_lack_of_fit;
/** Pattern over the plate orientation: no curve fits. Check the plate orientations and the direction of the slides. */
#define HRT_LACK_OF_FIT_ANGLE UINT32_C(1)
/** Pattern over the order of the slides: the user learns or gets tired. Allow practice or rest, and repeat. */
#define HRT_LACK_OF_FIT_ORDER UINT32_C(2)
/** Pattern along the paths: their curvature exceeds that of a habit and of the model's steering. Ask for slower, longer
 *  and more even slides, and repeat. */
#define HRT_LACK_OF_FIT_PATH UINT32_C(4)

/** @flags HRT_RETEST hrt_setup_result::differing: differences of a retest. */
typedef uint32_t hrt_setup_difference;
#define HRT_RETEST_TACTILE_WEIGHT UINT32_C(1) /**< the tactile weight has changed */
#define HRT_RETEST_BIAS UINT32_C(2)           /**< the bias has changed */
#define HRT_RETEST_HABIT UINT32_C(4)          /**< the habit has changed */

/** Result of a set-up. The values themselves are in the session's configuration. Values of parts that are not `done`
 *  are 0. */
typedef struct hrt_setup_result {
  uint32_t struct_size;
  /** Parts that were determined and applied since the set-up began. */
  hrt_setup_parts done;
  /** Parts that remain: continue to update. 0: the set-up is over. */
  hrt_setup_parts left;
  /** Differences of a RETEST, by Holm's procedure: if nothing has changed, 5 % of retests have any. */
  hrt_setup_difference differing;
  /** Patterns that the model does not explain; the user's traits then remain unknown. 0: no pattern. If the model fits,
   *  each pattern is reported for 1 % of users. */
  hrt_setup_lack_of_fit lack_of_fit;
  /** Number of slides that were made. */
  uint32_t slides;
  /** Number of slides that the fit uses. */
  uint32_t slides_used;
  /** Parts that ended without a result: after three rejected fits, six unusable slides in succession, a plate that does
   *  not turn for a minute, or max_slides. The parts that depend on a dropped part are dropped too. */
  hrt_setup_parts dropped;
  /** Root mean square distance of the touches from their marks. */
  double registration_residual_m;
  /** SD of the plate's rotation about its normal. An error of this rotation rotates every reach. */
  double registration_turn_sd_deg;
  /** Distance of the touch of a CHECK from the expected position of its mark. */
  double check_distance_m;
  /** Largest SD of a coordinate of the fingertip's offset. */
  double fingertip_sd_m;
  /** Tactile weight: perceived shift divided by the angle between ridge normal and motion, at 60 degrees and at the
   *  pace of the slides. @unit 1 */
  hrt_interval tactile_weight;
  /** Bias: aimed minus target direction. @ccw */
  hrt_interval bias_deg;
  /** Largest gap between real and virtual direction that the plate can sustain, on the weaker side. */
  hrt_interval max_gap_deg;
  /** Why the last dropped part was dropped, in one line of UTF-8; empty if none was. */
  char reason[HRT_TEXT_SIZE];
} hrt_setup_result;

/** Begins a set-up. Until it is over, no reach can begin, and only the set-up changes the configuration. Slides take
 *  1.4 MB of memory. After hrt_setup_cancel(), ALL_MISSING repeats only the parts that were not completed.
 *
 *  @param what    Parts, HRT_SETUP_*.
 *  @param config  Configuration, copied. Null: the defaults.
 *  @return OUT_OF_RANGE naming the field, for CALIBRATION also if the plate extends less than 50 mm ahead of
 *          start_position_m, for GUIDES if a target is too near; WRONG_STATE during a reach or a set-up, or if a
 *          requirement of CHECK or GUIDES is not met; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_begin(hrt_session session, hrt_setup_parts what,
                                                 const hrt_setup_config* config) HRT_NOEXCEPT;

/** Processes one sample and returns the next action. Call it every frame, also while the finger is lifted or lost.
 *
 *  @param sample    Finger, and plate if its orientation is measured.
 *  @param out_step  Next action.
 *  @return WRONG_STATE without a set-up; OUT_OF_RANGE naming the field, or naming flags: with HRT_SAMPLE_DIRECTION,
 *          which set-ups do not use, or if a part that was requested by name needs a field that the sample does not
 *          have; TIME_REVERSED.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_update(hrt_session session, const hrt_sample* sample,
                                                  hrt_setup_step* out_step) HRT_NOEXCEPT;

/** Continues the fit of a part for less than 1 ms. Call it in each frame whose step has HRT_STEP_FINISH: touches take
 *  one call, 16 slides about 300. More than 40 slides take up to 3 ms in a call. When the fit is complete, the call
 *  applies its result to the configuration, and the set-up continues with the remaining parts. A part whose fit is
 *  rejected is repeated at most twice; see hrt_setup_result::dropped.
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
#define HRT_SLIDE_ALONG_RIDGES UINT32_C(2) /**< rejected: the illusion changes sign along the ridges */

/** One slide of a calibration, straight ahead. */
typedef struct hrt_setup_residual {
  uint32_t struct_size;
  /** Use of the slide. */
  hrt_slide_verdict verdict;
  /** Plate orientation. @ccw */
  double plate_deg;
  /** Measured direction of the second half of the path. @ccw */
  double direction_deg;
  /** Fitted direction of the second half of the path. @ccw */
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
