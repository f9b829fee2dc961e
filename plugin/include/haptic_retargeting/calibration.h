/*
 * Calibration: the curve of a user's illusion, their bias and habit, and the tracker's noise, from slides
 * over a plate at rest; and whether this account fits the slides. Tried on simulated people only.
 *
 * The user slides to one target straight ahead, with the plate at a different orientation (base.h) each time:
 * hrt_calibration_next_angle() chooses the next one. Half a second at rest before each slide measures the
 * tracker's noise. The host turns the plate. Published human data cover plate orientations of -60 to 60.
 *
 *   create -> (next_angle -> begin_trial -> add_sample ... add_sample -> end_trial) for each slide
 *          -> solve -> apply
 */
#ifndef HAPTIC_RETARGETING_CALIBRATION_H
#define HAPTIC_RETARGETING_CALIBRATION_H

#include "reach.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A calibration's handle. Zero is never a calibration. Handles are never reused. */
typedef struct hrt_calibration {
  uint64_t value;
} hrt_calibration;

/** Maximum number of calibrations in a process. */
#define HRT_CALIBRATIONS_MAX 16

/** Configuration of a calibration. hrt_calibration_config_init() fills every field. */
typedef struct hrt_calibration_config {
  uint32_t struct_size;
  /** Maximum number of trials. 10 to 10000. Default 200. */
  uint32_t max_trials;
  /** Maximum number of samples of all trials; each takes 32 bytes at creation. 100 to 1000000. Default
   *  100000: 18 minutes at 90 Hz. */
  uint32_t max_samples;
  uint32_t reserved;
  /** Direction of the user's target. -180 to 180. Default 0: straight ahead. */
  double goal_direction_deg;
  /** Range of the plate orientations that hrt_calibration_next_angle() chooses from, relative to the goal
   *  direction. -89 to 89, the upper at least 40 above the lower. Default -75 and 75. */
  double lower_plate_deg;
  double upper_plate_deg;
  /** Width of the 95 % interval of the tactile weight at which hrt_calibration_next_angle() reports enough
   *  slides. Lowering it asks for more. 0.001 to 0.5. Default 0.02. */
  double enough_weight_width;
} hrt_calibration_config;

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

/** Families of illusion curves: the felt shift over the offset t from the motion to the ridge normal. */
#define HRT_ILLUSION_LINEAR UINT32_C(0)     /**< w t */
#define HRT_ILLUSION_SATURATING UINT32_C(1) /**< w t within the scale, constant beyond */
#define HRT_ILLUSION_SINE UINT32_C(2)       /**< w 45 sin 2t */
#define HRT_ILLUSION_TANH UINT32_C(3)       /**< w scale tanh(t / scale) */
#define HRT_ILLUSION_DEAD_BAND UINT32_C(4)  /**< nothing within the scale, w (|t| - scale) beyond */
#define HRT_ILLUSION_UNEQUAL UINT32_C(5)    /**< different slopes to the left and to the right */
#define HRT_ILLUSION_CUBIC UINT32_C(6)      /**< w t - b t (t / 75)^2, the controller's model */
#define HRT_ILLUSION_NONE UINT32_C(7)       /**< no family fits the slides */

/** Patterns in what the fit leaves unexplained: hrt_calibration_result::lack_of_fit. */
/** Over the plate orientation: no curve fits. Check the plate's orientations and the goal direction. */
#define HRT_LACK_OF_FIT_ANGLE UINT32_C(1)
/** Over the order of the slides: the user learns or tires. Let them practise or rest, and repeat. */
#define HRT_LACK_OF_FIT_ORDER UINT32_C(2)
/** Along the paths: they bend as neither a habit nor the model's steering does. Ask for slower, longer and
 *  even slides, and repeat. */
#define HRT_LACK_OF_FIT_PATH UINT32_C(4)

/** Parameters of the user; the fields are those of hrt_session_config. Set `struct_size` before the call. */
typedef struct hrt_calibration_result {
  uint32_t struct_size;
  /** Trials with a slide within which the plate turned by more than 5 degrees: left out, not among
   *  trials_used. */
  uint32_t slides_turning;
  /** Ended trials, and those of them with a slide of at least 30 mm over a plate at rest. */
  uint32_t trials;
  uint32_t trials_used;
  /** Felt shift over the offset of the ridge normal from the motion, at 60 degrees, mean of both sides. Known
   *  unless lack_of_fit is set or the interval is wider than 0.1. Of the share of touch that is felt at the
   *  slides' speed: people who feel ridges only as they cross them feel more at a higher one. */
  hrt_interval tactile_weight;
  /** Goal at the middle of the path minus target direction, left positive. Known unless lack_of_fit is set or
   * the interval is wider than 10 degrees. */
  hrt_interval bias_deg;
  /** Of the white part of the tracker's noise. Known with enough samples of the finger at rest, unless the
   *  parts of the noise may decay within 1.5 samples, which cannot be separated. */
  hrt_interval tracker_noise_m;
  /** HRT_ILLUSION_*, the likeliest family; LINEAR without a test with fewer than 7 plate orientations. */
  uint32_t illusion;
  /** HRT_LACK_OF_FIT_*; 0: none was found, each at 1 % of people whom the model fits. */
  uint32_t lack_of_fit;
  /** Slides that were left out: unlike the others, or with the motion within 5 to 12 degrees of along the
   *  ridges. hrt_calibration_get_residual() names them. */
  uint32_t slides_outlying;
  uint32_t slides_along_ridges;
  /** Scale of the likeliest family, degrees; 0 if it has none. */
  double illusion_scale_deg;
  /** Smallest offset at which the illusion is largest, 1 to 75: the motion bound for this user. */
  double peak_offset_deg;
  /** w and b of the controller's curve (HRT_PERSON_WEIGHT, HRT_PERSON_CURVE), and their correlation. The
   *  curve is known with 7 plate orientations or more. */
  hrt_interval person_weight;
  hrt_interval person_curve;
  double weight_curve_correlation;
  /** Largest gap between real and virtual direction that can be held, on the weaker side, with the plate
   *  within 75 degrees of the motion. Known if the curve is, slides reach offsets of 60 to both
   *  sides, and the interval is at most 10 degrees wide. */
  hrt_interval max_gap_deg;
  /** How far the user's goal turns over a path, halved (HRT_PERSON_HABIT). Known as bias_deg. */
  hrt_interval habit_deg;
  /** Correlated part of the tracker's noise, and the time in which it decays to 1/e. */
  hrt_interval correlated_noise_m;
  hrt_interval noise_correlation_s;
  /** Probabilities of residuals as patterned as these if the model fits: over the plate orientation, the
   *  order of the slides, the path. */
  double angle_p;
  double order_p;
  double path_p;
} hrt_calibration_result;

/** What became of a slide: hrt_calibration_slide::verdict. */
#define HRT_SLIDE_USED UINT32_C(0)
#define HRT_SLIDE_OUTLYING UINT32_C(1)     /**< unlike the others: left out */
#define HRT_SLIDE_ALONG_RIDGES UINT32_C(2) /**< left out: the illusion flips along the ridges */

/** One slide of the last hrt_calibration_solve(). Angles are relative to the goal direction. Set
 *  `struct_size` before the call. */
typedef struct hrt_calibration_slide {
  uint32_t struct_size;
  /** HRT_SLIDE_*. */
  uint32_t verdict;
  /** Number of the trial, from 0; trials without a slide are left out. */
  uint32_t trial;
  uint32_t reserved;
  double plate_deg;
  /** Of the second half of the path, seen and fitted, and their difference. */
  double direction_deg;
  double fitted_deg;
  double residual_deg;
} hrt_calibration_slide;

/** Values of two calibrations that differ: hrt_calibration_comparison::differing. */
#define HRT_DIFFERS_TACTILE_WEIGHT UINT32_C(1)
#define HRT_DIFFERS_MAX_GAP UINT32_C(2)
#define HRT_DIFFERS_BIAS UINT32_C(4)
#define HRT_DIFFERS_HABIT UINT32_C(8)
#define HRT_DIFFERS_TRACKER_NOISE UINT32_C(16)

/** Test and retest: two calibrations of a user, or of two users. Each field is the second value less the
 *  first, with the 95 % interval of the difference; known if both values are. Set `struct_size` before the
 *  call. */
typedef struct hrt_calibration_comparison {
  uint32_t struct_size;
  /** HRT_DIFFERS_*, by Holm's procedure over the known values: if nothing has changed, any of them is set in
   *  5 % of comparisons. 0 is no proof that nothing has changed: see the intervals. */
  uint32_t differing;
  hrt_interval tactile_weight;
  hrt_interval max_gap_deg;
  hrt_interval bias_deg;
  hrt_interval habit_deg;
  hrt_interval tracker_noise_m;
} hrt_calibration_comparison;

/** Creates a calibration without trials. `config` may be null: the defaults. It copies the plate's pose and
 * the lift height from the session. Errors: OUT_OF_RANGE naming the field, LIMIT_REACHED, OUT_OF_MEMORY.
 * [one-thread] for the session */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_create(hrt_session session,
                                                        const hrt_calibration_config* config,
                                                        hrt_calibration* out_calibration) HRT_NOEXCEPT;

/** Destroys the calibration and its trials. Errors of this and the calls below: INVALID_HANDLE, and BUSY
 *  if another thread is in a call on this calibration. [one-thread] */
HRT_API hrt_result hrt_calibration_destroy(hrt_calibration calibration) HRT_NOEXCEPT;

/** Begins a trial, with the plate at `plate_orientation_deg` (base.h), -3600 to 3600. Errors: OUT_OF_RANGE,
 * WRONG_STATE during a trial, LIMIT_REACHED. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_begin_trial(hrt_calibration calibration,
                                                             double plate_orientation_deg) HRT_NOEXCEPT;

/** Adds one sample: of the finger at rest, then of its slide. Dropouts, lifted fingers and repeated times
 *  are ignored without an error. Without HRT_SAMPLE_PLATE_ORIENTATION the plate stands where it stood at the
 *  trial's last sample, first where the trial began. Errors: WRONG_STATE without a trial, OUT_OF_RANGE naming
 * the field, or flags with HRT_SAMPLE_DIRECTION: positions are needed; TIME_REVERSED within a trial,
 * LIMIT_REACHED after max_samples. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_add_sample(hrt_calibration calibration,
                                                            const hrt_sample* sample) HRT_NOEXCEPT;

/** Ends the trial. `keep` is 1, or 0 to discard it, for example after a slip. Errors: OUT_OF_RANGE naming
 * `keep`, WRONG_STATE without a trial. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_end_trial(hrt_calibration calibration,
                                                           uint32_t keep) HRT_NOEXCEPT;

/** Chooses the plate orientation of the next slide, in plate coordinates, by what it is expected to show
 *  given the trials so far; the first nine open the range. `*out_enough` is 1 if the trials so far determine
 *  the tactile weight within enough_weight_width and the model fits them, else 0. Takes as long as
 *  hrt_calibration_solve(). Errors: NULL_ARGUMENT, WRONG_STATE during a trial, OUT_OF_MEMORY. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_next_angle(hrt_calibration calibration,
                                                            double* out_plate_orientation_deg,
                                                            uint32_t* out_enough) HRT_NOEXCEPT;

/** Fits the user's parameters to the trials. The trials stay: more can be added, and the fit repeated.
 *  Takes about 25 microseconds a sample, half a second for 20000: too long for a thread that draws frames.
 *  Errors: INSUFFICIENT_DATA naming what is missing: at least 10 slides of 30 mm, three plate orientations
 *  that span 40 degrees, an interval of the tactile weight within 0.02 to 0.48; WRONG_STATE during a
 *  trial, OUT_OF_MEMORY. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_solve(hrt_calibration calibration,
                                                       hrt_calibration_result* out_result) HRT_NOEXCEPT;

/** Returns a slide of the last hrt_calibration_solve(), `slide` from 0 to trials_used minus 1. Errors:
 *  WRONG_STATE before a solve that succeeded, OUT_OF_RANGE. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_get_residual(hrt_calibration calibration, uint32_t slide,
                                                              hrt_calibration_slide* out_slide) HRT_NOEXCEPT;

/** Compares two results of hrt_calibration_solve(), which the host has kept. Errors: OUT_OF_RANGE naming the
 *  field, OUT_OF_MEMORY. [any-thread] */
HRT_NODISCARD HRT_API hrt_result
hrt_calibration_compare(const hrt_calibration_result* first, const hrt_calibration_result* second,
                        hrt_calibration_comparison* out_comparison) HRT_NOEXCEPT;

/** Copies the known values into the session's configuration, and so into its profile; unknown ones are
 *  unchanged. The deviation of tactile_weight comes from its interval, with the minimum of
 *  HRT_ADAPTATION_CARRIED. A known weight or bias replaces what reaches have learnt of the person
 *  (person_mean, person_covariance). If person_weight, person_curve, bias_deg and habit_deg are known, they
 *  become what is believed of the person, and peak_offset_deg becomes motion_bound_deg. A known
 *  correlated_noise_m above 0 goes in with noise_correlation_s if that is known; else tracker_noise_m becomes
 *  that of all noise. The conditions that hrt_profile_set_conditions() gave become those of the profile.
 * Errors: OUT_OF_RANGE naming the field, WRONG_STATE during a reach. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_apply(hrt_session session,
                                                       const hrt_calibration_result* result) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
