/*
 * Calibration: a user's tactile weight, bias and variances, and the tracker's noise, from slides over a plate
 * at rest. Tried on simulated people only.
 *
 * The user slides to one target straight ahead, eight to ten times at each plate orientation (base.h) of -60,
 * -30, 0, 30 and 60 degrees, in random order. Half a second at rest before each slide measures the tracker's
 * noise. The host turns the plate.
 *
 *   create -> (begin_trial -> add_sample ... add_sample -> end_trial) for each slide -> solve -> apply
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

/** Configuration of a calibration. hrt_calibration_config_default() fills every field. */
typedef struct hrt_calibration_config {
  uint32_t struct_size;
  /** Maximum number of trials. 10 to 10000. Default 200. */
  uint32_t max_trials;
  /** Maximum number of samples of all trials; each takes 24 bytes at creation. 100 to 1000000. Default
   *  100000: 18 minutes at 90 Hz. */
  uint32_t max_samples;
  uint32_t reserved;
  /** Direction of the user's target. -180 to 180. Default 0: straight ahead, where the motor variance is
   *  accurate. */
  double goal_direction_deg;
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

/** Parameters of the user; the fields are those of hrt_session_config. Set `struct_size` before the call. */
typedef struct hrt_calibration_result {
  uint32_t struct_size;
  uint32_t reserved;
  /** Ended trials, and those of them with a slide of at least 30 mm. Only the latter count. */
  uint32_t trials;
  uint32_t trials_used;
  /** Always known: otherwise hrt_calibration_solve() fails. */
  hrt_interval tactile_weight;
  /** Always known. */
  hrt_interval bias_deg;
  /** Known with an accurate tracker; rarely at 1.2 mm of noise. */
  hrt_interval motor_variance_deg2;
  /** As motor_variance_deg2. */
  hrt_interval sensory_variance_deg2;
  /** Always known. */
  hrt_interval tracker_noise_m;
} hrt_calibration_result;

/** Fills `*out_config` with the defaults. `struct_size` is sizeof *out_config. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_config_default(hrt_calibration_config* out_config,
                                                                uint32_t struct_size) HRT_NOEXCEPT;

/** Creates a calibration without trials. It copies the plate's pose, the lift height and the step period
 *  from the session. Errors: OUT_OF_RANGE naming the field, LIMIT_REACHED, OUT_OF_MEMORY. [one-thread] for
 *  the session */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_create(hrt_session session,
                                                        const hrt_calibration_config* config,
                                                        hrt_calibration* out_calibration) HRT_NOEXCEPT;

/** Destroys the calibration and its trials. Errors of this and the calls below: INVALID_HANDLE, and BUSY
 *  if another thread is in a call on this calibration. [one-thread] */
HRT_API hrt_result hrt_calibration_destroy(hrt_calibration calibration) HRT_NOEXCEPT;

/** Begins a trial, during which the plate stays at `plate_orientation_deg` (base.h), -3600 to 3600.
 *  Errors: OUT_OF_RANGE, WRONG_STATE during a trial, LIMIT_REACHED. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_begin_trial(hrt_calibration calibration,
                                                             double plate_orientation_deg) HRT_NOEXCEPT;

/** Adds one sample: of the finger at rest, then of its slide. Dropouts, lifted fingers and repeated times
 *  are ignored without an error; so is HRT_SAMPLE_PLATE_ORIENTATION. Errors: WRONG_STATE without a trial,
 *  OUT_OF_RANGE naming the field, or flags with HRT_SAMPLE_DIRECTION: positions are needed; TIME_REVERSED
 *  within a trial, LIMIT_REACHED after max_samples. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_add_sample(hrt_calibration calibration,
                                                            const hrt_sample* sample) HRT_NOEXCEPT;

/** Ends the trial and keeps it. Errors: WRONG_STATE without a trial. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_end_trial(hrt_calibration calibration) HRT_NOEXCEPT;

/** Ends the trial and discards it, for example after a slip. Errors: WRONG_STATE without a trial.
 *  [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_cancel_trial(hrt_calibration calibration) HRT_NOEXCEPT;

/** Fits the user's parameters to the trials. The trials stay: more can be added, and the fit repeated.
 *  Takes about 25 microseconds a sample, half a second for 20000: too long for a thread that draws frames.
 *  Errors: INSUFFICIENT_DATA naming what is missing: at least 10 slides of 30 mm, three plate orientations
 *  that span 40 degrees, an interval of the tactile weight within 0.02 to 0.48; WRONG_STATE during a
 *  trial, OUT_OF_MEMORY. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_solve(hrt_calibration calibration,
                                                       hrt_calibration_result* out_result) HRT_NOEXCEPT;

/** Copies the known values into the session's configuration, and so into its profile; unknown ones are
 *  unchanged. The deviations of tactile_weight and motor_variance_deg2 come from their intervals, with the
 *  minimum of HRT_ADAPTATION_CARRIED. A known weight or bias replaces what reaches have learnt of the person
 *  (person_mean, person_covariance). Errors: OUT_OF_RANGE naming the field, WRONG_STATE during a reach.
 *  [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_calibration_apply(hrt_session session,
                                                       const hrt_calibration_result* result) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
