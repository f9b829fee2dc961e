/*
 * Registration: where the plate is in the engine's world, from touches of marks on it; whether that is still
 * true; the offset from a tracked joint to the skin that touches; and how late the tracker is. Tried on
 * simulated touches only.
 *
 * A frame that is turned by 1 degree about the start turns every reach by as much, 1.7 mm at 100 mm, and
 * nothing within a reach shows it.
 *
 *   fit -> apply -> (confirm by a touch of a mark -> reach) for each reach
 *
 * Marks are places on the plate whose plate coordinates (base.h) are known: the start dimple, the centre,
 * marks on the rim. Five touches or more let one bad touch be found; the same mark may be touched again. A
 * constant offset of the tracked joint becomes part of the pose, as it should, while the hand keeps its
 * orientation. For a hand that does not, find the offset first and place the skin by it in every touch and
 * sample: hrt_fingertip_fit(), hrt_fingertip_place().
 */
#ifndef HAPTIC_RETARGETING_REGISTRATION_H
#define HAPTIC_RETARGETING_REGISTRATION_H

#include "reach.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Maximum number of touches in one call. */
#define HRT_TOUCHES_MAX 1000

/** A touch of a mark. This struct never grows. */
typedef struct hrt_mark_touch {
  /** The mark in plate coordinates. Each within 1000. */
  double mark_m[3];
  /** Where the tracker saw the fingertip, in the engine's world. Each within 1000. */
  double touched_m[3];
} hrt_mark_touch;

/** hrt_registration_config::flags. */
/** The tracker's unit of length is fitted too: of use if it may be off by more than 1 in 100. */
#define HRT_REGISTER_SCALE UINT32_C(1)
/** `up` is given. Without it, touches of which left and right were confused pass for those of a plate that
 *  lies upside down. */
#define HRT_REGISTER_UP UINT32_C(2)

/** Configuration of a registration. hrt_registration_config_init() fills every field. */
typedef struct hrt_registration_config {
  uint32_t struct_size;
  /** HRT_REGISTER_*. Default 0. */
  uint32_t flags;
  /** Standard deviation of each coordinate of a touch, as expected; the residuals correct it. Raising it
   * accepts worse touches. 1e-5 to 0.1. Default 0.003. */
  double touch_sd_m;
  /** Up in the engine's world, of any length: the plate's face must look that way within 60 degrees. Each
   *  within 1000, not all 0. Default (0, 1, 0). */
  double up[3];
} hrt_registration_config;

/** Verdict on a set of touches. hrt_registration_advice() has what to do. */
#define HRT_REGISTRATION_HOLDS 1   /**< a pose explains the touches, or all of them but one */
#define HRT_REGISTRATION_TOO_FEW 2 /**< fewer than 3 touches */
#define HRT_REGISTRATION_DEGENERATE \
  3 /**< the marks lie within 1 cm of a line: the plate could turn about it */
#define HRT_REGISTRATION_INCONSISTENT 4 /**< no pose explains the touches, nor all of them but one */
#define HRT_REGISTRATION_UPSIDE_DOWN 5  /**< the face looks away from `up`: marks were confused */

/** Numbers in the lower triangle of hrt_registration::covariance. */
#define HRT_POSE_COVARIANCES 28

/** A registered pose. Set `struct_size` before the call. Its numbers mean something if it HOLDS; INCONSISTENT
 * and UPSIDE_DOWN have those of the fit to all touches, to look at. */
typedef struct hrt_registration {
  uint32_t struct_size;
  /** HRT_REGISTRATION_*. */
  uint32_t verdict;
  /** Touches that were given. */
  uint32_t touches;
  /** Index of the one touch that does not fit the others and was left out; -1: none. */
  int32_t left_out;
  /** Pose and scale, as hrt_session_config has them. The scale is 1 unless fitted. */
  double plate_position_m[3];
  double plate_rotation[4];
  double plate_scale;
  /** Covariance of the rotation about the plate's x, y and z (radians), the position in the world (metres)
   * and the scale: the lower triangle, row by row. 0 for a scale that was not fitted. */
  double covariance[HRT_POSE_COVARIANCES];
  /** Standard deviation of a touch's coordinate: as expected and as seen, weighted. */
  double touch_sd_m;
  /** Root mean square distance of the touches from their marks. */
  double residual_m;
  /** Standard deviation of the plate's turn about its normal, which turns every reach. */
  double turn_sd_deg;
} hrt_registration;

/** Fits the plate's pose to touches of its marks: least squares in closed form. `out_residuals_m` takes the
 *  distance of each touch from its mark under the pose, 0 if there is none; with `capacity` 0 it may be null.
 *  A verdict other than HOLDS is no error. With 5 touches or more one bad one is found and left out. `config`
 *  may be null: the defaults. Errors: OUT_OF_RANGE naming the field and the touch, or for a count above
 *  HRT_TOUCHES_MAX; BUFFER_TOO_SMALL if `capacity` is neither 0 nor at least `touch_count`. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_registration_fit(const hrt_registration_config* config,
                                                      const hrt_mark_touch* touches, uint64_t touch_count,
                                                      uint64_t capacity, double* out_residuals_m,
                                                      hrt_registration* out_registration) HRT_NOEXCEPT;

/** Returns what to do about a verdict, in one line for the user. Never null; valid as long as the library is
 *  loaded. [any-thread] */
HRT_API const char* hrt_registration_advice(uint32_t verdict) HRT_NOEXCEPT;

/** Copies pose, scale and uncertainty into the session's configuration (plate_position_m, plate_rotation,
 *  plate_scale, plate_covariance) with `time_ns`, when the touches were made on the clock of the samples, and
 * sets HRT_SESSION_REGISTERED. A profile holds none of it: it is of a place, not of a person. Errors:
 *  OUT_OF_RANGE naming the field, or unless the registration HOLDS; WRONG_STATE during a reach. [one-thread]
 */
HRT_NODISCARD HRT_API hrt_result hrt_registration_apply(hrt_session session,
                                                        const hrt_registration* registration,
                                                        int64_t time_ns) HRT_NOEXCEPT;

/** Result of hrt_registration_check(). Set `struct_size` before the call. */
typedef struct hrt_touch_check {
  uint32_t struct_size;
  /** 1 if the touch agrees with the registration; else 0: register again. */
  uint32_t holds;
  /** Distance of the touch from where its mark should be. */
  double distance_m;
  /** Distance within which 999 touches in 1000 are while the registration is true. A plate that has moved by
   *  less may pass. */
  double allowed_m;
} hrt_touch_check;

/** Checks a registration by a later touch of a mark, as before a reach. The start dimple shows that the plate
 *  has moved, a mark far from it that the plate has turned. Errors: OUT_OF_RANGE naming the field, or unless
 * the registration HOLDS. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_registration_check(const hrt_registration* registration,
                                                        const hrt_mark_touch* touch,
                                                        hrt_touch_check* out_check) HRT_NOEXCEPT;

/** Checks the session's registration by a touch of a mark, as before each reach, and writes the outcome into
 * the session's configuration. A touch that agrees sets registration_time_ns to `time_ns`, so
 * max_registration_age_ns counts from this touch. One that does not clears HRT_SESSION_REGISTERED: wherever a
 * limit of the registration is set, samples get HRT_COMMAND_REGISTRATION until the next
 * hrt_registration_apply(). A check that a host leaves out is flagged once the last one is older than
 * max_registration_age_ns. `registration` is the one that was applied. Errors: OUT_OF_RANGE naming the field,
 * or if the session's plate is not where `registration` has it; WRONG_STATE during a reach. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_registration_confirm(hrt_session session,
                                                          const hrt_registration* registration,
                                                          const hrt_mark_touch* touch, int64_t time_ns,
                                                          hrt_touch_check* out_check) HRT_NOEXCEPT;

/** A tracked joint, in touches while its fingertip is on a mark. This struct never grows. */
typedef struct hrt_joint_touch {
  /** Position of the joint in the engine's world. Each within 1000. */
  double position_m[3];
  /** Rotation of the joint: the unit quaternion x, y, z, w from its axes to the world's. Length 1 within
   *  0.001. */
  double rotation[4];
} hrt_joint_touch;

/** Where the skin that touches is, in the joint's axes: at position + rotation * offset_m in the world. Of
 * one hand. Set `struct_size` before the call. */
typedef struct hrt_fingertip {
  uint32_t struct_size;
  /** 1 if every deviation is below 5 mm; else 0: the joint was not turned enough, and the numbers are 0. */
  uint32_t known;
  double offset_m[3];
  /** Its standard deviations. */
  double sd_m[3];
} hrt_fingertip;

/** Fits the offset from a joint to the skin to touches of one and the same mark, wherever it is, with the
 * finger held differently each time: leant and turned about two axes at least. Each hand has its own.
 * `config` as in hrt_registration_fit(); only touch_sd_m is read. Errors: OUT_OF_RANGE naming the field and
 * the touch, or for a count above HRT_TOUCHES_MAX. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_fingertip_fit(const hrt_registration_config* config,
                                                   const hrt_joint_touch* touches, uint64_t touch_count,
                                                   hrt_fingertip* out_fingertip) HRT_NOEXCEPT;

/** Puts the skin that touches in place of the joint into a sample: finger_position_m becomes position +
 * rotation * offset_m, and HRT_SAMPLE_WORLD_POSITION replaces HRT_SAMPLE_DIRECTION and
 * HRT_SAMPLE_PLATE_POSITION. Other fields are unchanged. For every sample of that hand, and for the touches
 * of a registration that its reaches use. Errors: OUT_OF_RANGE naming the field, or if the offset is not
 * `known`. [any-thread] [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_fingertip_place(const hrt_fingertip* fingertip,
                                                     const hrt_joint_touch* joint,
                                                     hrt_sample* out_sample) HRT_NOEXCEPT;

/** Maximum number of samples in hrt_latency_fit(). */
#define HRT_LATENCY_SAMPLES_MAX 100000

/** Latency of a tracker. Set `struct_size` before the call. */
typedef struct hrt_latency {
  uint32_t struct_size;
  /** 1 if the 95 % interval is at most 40 ms wide; else 0, and the numbers are 0. */
  uint32_t known;
  /** For hrt_session_config::tracker_latency_ns: the best fit, or 0 if that is negative. */
  int64_t latency_ns;
  /** Ends of the 95 % interval; the lower one may be negative. */
  int64_t lower_ns;
  int64_t upper_ns;
  /** Standard deviation of a coordinate from the circle on which the finger was carried. */
  double residual_m;
  /** Radius of that circle. */
  double radius_m;
} hrt_latency;

/** Finds the tracker's latency from a finger that rests on a mark near the rim while the plate turns under it
 * to and fro by 10 to 40 degrees, at uneven times, for 5 to 10 s: the finger is carried. Samples need
 * PLATE_ORIENTATION, as the plate reports it, and PLATE_POSITION or WORLD_POSITION, all the same; others are
 * left out. The pose of the plate has no effect. The result is relative to the plate's report: if that is
 * late too, the difference. It cannot be found from a reach, where it adds to the person's own delay, nor
 * while the plate turns at constant speed or repeats its turns; not `known` then, nor if the finger slips,
 * nor within 2 s. A skin that yields counts as latency. `samples[0].struct_size` is the size of every
 * element. Takes about 0.1 s for 8 s at 1000 Hz. Errors: OUT_OF_RANGE naming the sample and the field, or for
 * a count above HRT_LATENCY_SAMPLES_MAX; TIME_REVERSED; OUT_OF_MEMORY. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_latency_fit(const hrt_sample* samples, uint64_t sample_count,
                                                 hrt_latency* out_latency) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
