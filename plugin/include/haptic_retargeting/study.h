/*
 * A simulated person: a finger that slides over the plate, feels its ridges and is bent by them. It takes the
 * place of a tracked finger and of the plate's servo in a first program, a demo or an engine's test.
 *
 * It is a model, and no measurement of people: who it is follows from a seed, with an illusion that is linear
 * in the plate's angle.
 */
#ifndef HAPTIC_RETARGETING_STUDY_H
#define HAPTIC_RETARGETING_STUDY_H

#include "reach.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** A simulated person's handle. Zero is never a person. Handles are never reused. */
typedef struct hrt_person {
  uint64_t value;
} hrt_person;

/** Maximum number of simulated people in a process. */
#define HRT_PEOPLE_MAX 64

/** Configuration of a simulated person. All zero with `struct_size` is the default. */
typedef struct hrt_person_config {
  uint32_t struct_size;
  uint32_t reserved;
  /** Share of touch in the direction that they feel; drawn from the seed between 0.12 and 0.3. 0.01 to 0.49;
   *  0: drawn. Default 0. */
  double tactile_weight;
  /** Direction in which they see a virtual target minus its own. -45 to 45. Default 0. */
  double bias_deg;
  /** Duration of the motion, by default 1.5 s. 0.3 to 20 s; 0: the default. Default 0. */
  double duration_s;
  /** Standard deviation of the tracker's white noise in each coordinate, by default 1.2 mm. 0 to 0.1; 0: the
   *  default. Default 0. */
  double tracker_noise_m;
  /** Maximum speed of the plate's servo, by default 400. 0 to 1e6 degrees a second; 0: the default. Default
   * 0. */
  double plate_max_speed_deg_s;
  /** Time from a command to the servo's first motion, by default 30 ms. 0 to 1 s; 0: the default. Default 0.
   */
  int64_t plate_latency_ns;
} hrt_person_config;

/** Where a simulated person is. Positions are in plate coordinates, without the tracker's noise. Set
 *  `struct_size` before the call. */
typedef struct hrt_person_state {
  uint32_t struct_size;
  /** 1 if the motion is over, else 0. */
  uint32_t done;
  /** Where the fingertip is. */
  double position_m[3];
  /** Where the person feels that the fingertip is. */
  double felt_position_m[3];
  /** Plate orientation (base.h) at which the servo has the plate. */
  double plate_orientation_deg;
  /** Felt direction minus the virtual target's. */
  double felt_error_deg;
} hrt_person_state;

/** Creates a person. The same configuration and seed are the same person on every host, bit for bit. Null
 *  `config`: the defaults. Errors: OUT_OF_RANGE naming the field, STRUCT_SIZE, LIMIT_REACHED, OUT_OF_MEMORY.
 *  [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_create(const hrt_person_config* config, uint64_t seed,
                                                   hrt_person* out_person) HRT_NOEXCEPT;

/** Destroys the person. [one-thread] */
HRT_API hrt_result hrt_person_destroy(hrt_person person) HRT_NOEXCEPT;

/** Puts the finger at rest at the session's start. The person means to slide to where the session's virtual
 *  target is now, after a rest of 0.6 s. Each call is a further reach, with noise of its own. Errors:
 *  INVALID_HANDLE, OUT_OF_RANGE naming the target. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_begin(hrt_person person, hrt_session session,
                                                  hrt_target virtual_target) HRT_NOEXCEPT;

/** Commands the servo to the plate orientation (base.h), lets time pass until `time_ns`, and returns what
 *  tracker and servo then report: a sample with PLATE_POSITION and PLATE_ORIENTATION. Set
 *  `out_sample->struct_size` before the call. The first call after hrt_person_begin() has the rest begin, and
 *  the plate stand where it says. Errors: OUT_OF_RANGE naming plate_orientation_deg, TIME_REVERSED,
 *  WRONG_STATE before hrt_person_begin(). [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_move(hrt_person person, int64_t time_ns,
                                                 double plate_orientation_deg,
                                                 hrt_sample* out_sample) HRT_NOEXCEPT;

/** Returns where the person is. Errors: WRONG_STATE before hrt_person_begin(). [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_get_state(hrt_person person,
                                                      hrt_person_state* out_state) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
