/*
 * A simulated person slides a finger over the plate, perceives the ridges and is deflected by them. The simulation
 * replaces a tracked finger and the plate's servo in a first program, a demo or an engine's test. The person is a
 * model: parameters are drawn from a seed, and the illusion is linear in the angle between motion and ridge normal.
 *
 * Example: a plate that is held at 45 degrees deflects the finger. haptic_retargeting.h has a controlled reach.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <haptic_retargeting/person.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session session;
 *     hrt_person person;
 *     hrt_target cup;
 *     hrt_target_config config = hrt_target_config_init();
 *     hrt_sample sample = hrt_sample_init();
 *     hrt_person_state state = hrt_person_state_init();
 *     config.role = HRT_TARGET_VIRTUAL; // straight ahead, at 100 mm
 *     int failed = hrt_session_create(HRT_VERSION, NULL, &session) || hrt_target_add(session, &config, &cup) ||
 *                  hrt_person_create(NULL, 1, &person) || hrt_person_begin(person, session, cup);
 *     for (int64_t time_ns = 0; !failed && !state.done; time_ns += 10000000)
 *       failed = hrt_person_move(person, time_ns, 45, &sample) || hrt_person_get_state(person, &state);
 *     if (failed) puts(hrt_last_error());
 *     else printf("The finger is %.0f mm to the right.\n", 1000 * state.position_m[0]);
 *     return failed;
 *   }
 */
#ifndef HAPTIC_RETARGETING_PERSON_H
#define HAPTIC_RETARGETING_PERSON_H

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

/** Configuration of a simulated person. The default is all zero except `struct_size`. */
typedef struct hrt_person_config {
  uint32_t struct_size;
  uint32_t reserved;
  /** Tactile weight: a higher weight deflects the finger further. 0: drawn from the seed between 0.12 and 0.3.
   *  @range 0 or 0.01 to 0.49 @unit 1 @default 0 */
  double tactile_weight;
  /** Perceptual bias: direction in which the person sees a virtual target minus its true direction.
   *  @range -45 to 45 @default 0 @ccw */
  double bias_deg;
  /** Duration of the motion. A shorter motion leaves the controller less time to correct. 0: 1.5 s.
   *  @range 0 or 0.3 to 20 @default 0 */
  double duration_s;
  /** SD of the tracker's white noise in each coordinate. Raise it to test an application with a poor tracker. 0: 1.2
   *  mm. @range 0 to 0.1 @default 0 */
  double tracker_noise_m;
  /** Maximum speed of the simulated servo; 0: 400 degrees per second. Set it and plate_latency_ns to the values of your
   *  device. @range 0 to 1e6 @default 0 */
  double plate_max_speed_deg_s;
  /** Time from a command to the servo's first motion; 0: 30 ms. @range 0 to 1 s @default 0 */
  int64_t plate_latency_ns;
} hrt_person_config;

/** State of a simulated person. Positions are in plate coordinates, without the tracker's noise. */
typedef struct hrt_person_state {
  uint32_t struct_size;
  /** 1 if the motion is over. @bool */
  uint32_t done;
  /** Position of the fingertip. */
  double position_m[3];
  /** Position of the fingertip as the person perceives it. */
  double felt_position_m[3];
  /** Orientation to which the simulated servo has turned the plate. @ccw */
  double plate_orientation_deg;
  /** Perceived direction minus direction of the virtual target, without a correction for the person's bias. @ccw */
  double felt_error_deg;
} hrt_person_state;

/** Creates a simulated person. The same configuration, seed and calls give the same motions on every host, bit for bit.
 *
 *  @param config      Configuration, copied. Null: the defaults.
 *  @param seed        Seed of parameters and noise; any number.
 *  @param out_person  Handle of the person.
 *  @return OUT_OF_RANGE naming the field; LIMIT_REACHED for more than HRT_PEOPLE_MAX people; OUT_OF_MEMORY.
 *  @threadsafety [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_create(const hrt_person_config* config, uint64_t seed,
                                                   hrt_person* out_person) HRT_NOEXCEPT;

/** Destroys a simulated person.
 *
 *  @threadsafety [one-thread] */
HRT_API hrt_result hrt_person_destroy(hrt_person person) HRT_NOEXCEPT;

/** Starts a reach with new noise: the finger rests at the session's start for 0.6 s, and then slides towards the
 *  position that the virtual target has at this call.
 *
 *  With virtual_target {0}, the person follows the session's set-up. The plate is then at (0.3, 0.75, -0.4) m in the
 *  world, rotated by 20 degrees about the world's y axis. The skin is at (2, -8, -12) mm from the tracked joint, in the
 *  joint's axes. Samples have WORLD_POSITION and JOINT_ROTATION in the parts FINGERTIP, REGISTRATION and CHECK, and in
 *  all parts once the session is registered.
 *
 *  @param session         Session of the target or of the set-up.
 *  @param virtual_target  Target that the person reaches for; {0}: follow the set-up in progress.
 *  @return INVALID_HANDLE; OUT_OF_RANGE naming the target; WRONG_STATE for {0} if no set-up is in progress.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_begin(hrt_person person, hrt_session session,
                                                  hrt_target virtual_target) HRT_NOEXCEPT;

/** Commands the simulated servo, advances the simulation, and returns the sample of tracker and servo. The sample has
 *  the flags PLATE_ORIENTATION and PLATE_POSITION; hrt_person_begin() describes the exceptions in a set-up. The first
 *  call after hrt_person_begin() puts the plate at the given orientation and starts the finger's rest.
 *
 *  @param time_ns                Time to which the simulation advances; must not decrease.
 *  @param plate_orientation_deg  Command to the servo, which turns to the nearest equivalent orientation. @ccw
 *  @param out_sample             Sample for hrt_reach_update() or hrt_setup_update().
 *  @return OUT_OF_RANGE naming plate_orientation_deg; TIME_REVERSED; WRONG_STATE before hrt_person_begin();
 *          INVALID_HANDLE if the session of the set-up was destroyed.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_move(hrt_person person, int64_t time_ns, double plate_orientation_deg,
                                                 hrt_sample* out_sample) HRT_NOEXCEPT;

/** Returns the true state of the person, without errors of the tracker.
 *  @return WRONG_STATE before hrt_person_begin(), and in a set-up.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_get_state(hrt_person person, hrt_person_state* out_state) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "person_init.h"

#endif
