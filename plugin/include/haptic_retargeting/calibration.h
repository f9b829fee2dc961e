/*
 * Calibration: who is this user? The share of touch, the user's own bias, the variances and the tracker's
 * noise, from slides over a plate that stands still. Tried on simulated people only.
 *
 * Have the user slide to one target, with the plate at rest at one of -60, -30, 0, 30 and 60 degrees, eight
 * to ten times at each, in random order; half a second at rest before each slide, which tells the tracker's
 * noise. The host turns the plate; this library does not, here.
 *
 *   create -> (begin_trial -> add_sample ... add_sample -> end_trial) for each slide -> solve -> apply
 */
#ifndef HAPTIC_RETARGETING_CALIBRATION_H
#define HAPTIC_RETARGETING_CALIBRATION_H

#include "reach.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A calibration's handle. Zero is never a calibration. A handle of a destroyed one is never valid again. */
typedef struct hrt_calibration {
  uint64_t value;
} hrt_calibration;

/** Calibrations that can exist at the same time in a process. */
#define HRT_CALIBRATIONS_MAX 16

/** What a calibration is. hrt_calibration_config_default() fills every field. */
typedef struct hrt_calibration_config {
  uint32_t struct_size;
  /** Trials that it can hold, 10 to 10000. Default 200. */
  uint32_t max_trials;
  /** Samples that all trials together can hold, 100 to 1000000; 24 bytes each, taken at creation. Default
   *  100000: 18 minutes at 90 Hz. */
  uint32_t max_samples;
  uint32_t reserved;
  /** Where the user is told to go, -180 to 180. Default 0: straight ahead. */
  double goal_direction_deg;
} hrt_calibration_config;

/** An estimate with the ends of its 95 % interval. This struct never grows. */
typedef struct hrt_interval {
  double value;
  double lower;
  double upper;
  /** 1, or 0: the data can't tell. Then the interval is what was searched, and the value no more than its
   *  likeliest point. */
  uint32_t known;
  uint32_t reserved;
} hrt_interval;

/** What the slides tell of the user. The fields are those of hrt_session_config. Set `struct_size` before the
 *  call. */
typedef struct hrt_calibration_result {
  uint32_t struct_size;
  uint32_t reserved;
  /** Trials that were ended, and of these the ones with a slide of 30 mm or more, which alone count. */
  uint32_t trials;
  uint32_t trials_used;
  /** Always known; otherwise hrt_calibration_solve() refuses. */
  hrt_interval tactile_weight;
  /** Always known. */
  hrt_interval bias_deg;
  /** Known if the tracker is good enough to show it; one with 1.2 mm of noise hardly is. */
  hrt_interval motor_variance_deg2;
  /** As motor_variance_deg2. */
  hrt_interval sensory_variance_deg2;
  /** Always known. */
  hrt_interval tracker_noise_m;
} hrt_calibration_result;

/** Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread] */
HRT_API hrt_result hrt_calibration_config_default(hrt_calibration_config* out_config,
                                                  uint32_t struct_size) HRT_NOEXCEPT;

/** Makes a calibration without trials. It takes the plate's place, the lift height and the step period from
 *  the session's configuration as it is now; the two then know nothing of each other. Errors: OUT_OF_RANGE
 *  naming the field, LIMIT_REACHED, OUT_OF_MEMORY. [one-thread] for the session */
HRT_API hrt_result hrt_calibration_create(hrt_session session, const hrt_calibration_config* config,
                                          hrt_calibration* out_calibration) HRT_NOEXCEPT;

/** Forgets the calibration and its trials. Errors of this and the calls below: INVALID_HANDLE, and BUSY if
 *  another thread is in a call on this calibration. [one-thread] */
HRT_API hrt_result hrt_calibration_destroy(hrt_calibration calibration) HRT_NOEXCEPT;

/** Begins a trial: the plate stands at `plate_orientation_deg`, -3600 to 3600, until the trial ends. Errors:
 *  OUT_OF_RANGE, WRONG_STATE during a trial, LIMIT_REACHED. [real-time] */
HRT_API hrt_result hrt_calibration_begin_trial(hrt_calibration calibration,
                                               double plate_orientation_deg) HRT_NOEXCEPT;

/** Takes one sample in: the finger at rest, then its slide. Positions are kept; dropouts, lifted fingers and
 *  a time that has been seen already are not, and are no error. HRT_SAMPLE_PLATE_ORIENTATION is not used.
 *  Errors: WRONG_STATE without a trial, OUT_OF_RANGE naming the field, or flags with HRT_SAMPLE_DIRECTION: a
 *  direction alone can't tell; TIME_REVERSED within a trial, LIMIT_REACHED if max_samples are held.
 *  [real-time] */
HRT_API hrt_result hrt_calibration_add_sample(hrt_calibration calibration,
                                              const hrt_sample* sample) HRT_NOEXCEPT;

/** Ends the trial, to be counted. Errors: WRONG_STATE without a trial. [real-time] */
HRT_API hrt_result hrt_calibration_end_trial(hrt_calibration calibration) HRT_NOEXCEPT;

/** Ends the trial and forgets it, as when the user has slipped. Errors: WRONG_STATE without a trial.
 *  [real-time] */
HRT_API hrt_result hrt_calibration_cancel_trial(hrt_calibration calibration) HRT_NOEXCEPT;

/** Fits the user to the trials, which stay: more can be added, and the fit repeated. Takes some 25
 *  microseconds a sample, half a second for 20000: not for a thread that draws frames. Errors:
 *  INSUFFICIENT_DATA if the trials can't tell, naming what is needed: at least 10 slides of 30 mm, at three
 *  plate orientations that span 40 degrees, a tactile weight whose interval is within 0.02 to 0.48;
 *  WRONG_STATE during a trial, OUT_OF_MEMORY. [one-thread] */
HRT_API hrt_result hrt_calibration_solve(hrt_calibration calibration,
                                         hrt_calibration_result* out_result) HRT_NOEXCEPT;

/** Takes what is known of the user into the session's configuration, and so into its profile: all five
 *  values, and of tactile_weight and motor_variance_deg2 the standard deviations, from the intervals and no
 *  less than adaptation carries. What is not known stays as it is. Errors: OUT_OF_RANGE naming the field,
 *  WRONG_STATE during a reach. [one-thread] */
HRT_API hrt_result hrt_calibration_apply(hrt_session session,
                                         const hrt_calibration_result* result) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
