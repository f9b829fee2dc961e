/*
 * Studies: a simulated person, recordings of a session and their replay, and the residuals of a calibration.
 *
 * The simulated person is a finger that slides over the plate, perceives its ridges and is deflected by them. It
 * replaces a tracked finger and the plate's servo in a first program, a demo or an engine's test. It is a model,
 * not a measurement of people: its parameters follow from a seed, and its illusion is linear in the plate angle.
 *
 * A recording is a CSV file with comments (#), which R, pandas and MATLAB open directly. It has a row for each
 * begin, update, retarget, touched, cancel and end of a reach, and for each update, finish and cancel of a
 * set-up, including refused calls, except those of a set-up whose structs cannot be read. Comments hold
 * configurations, targets, beginnings of set-ups and the plate orientation. Numbers have full precision. A thread
 * of the library writes the file: a slow or full disk never delays a call; rows are dropped and counted.
 */
#ifndef HAPTIC_RETARGETING_STUDY_H
#define HAPTIC_RETARGETING_STUDY_H

#include "setup.h"

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
  /** Tactile weight; 0: drawn from the seed between 0.12 and 0.3. @range 0 or 0.01 to 0.49 @unit 1 @default 0 */
  double tactile_weight;
  /** Direction in which the person sees a virtual target, minus its own. @range -45 to 45 @default 0 @ccw */
  double bias_deg;
  /** Duration of the motion; 0: 1.5 s. @range 0 or 0.3 to 20 @default 0 */
  double duration_s;
  /** SD of the tracker's white noise in each coordinate; 0: 1.2 mm. @range 0 to 0.1 @default 0 */
  double tracker_noise_m;
  /** Maximum speed of the plate's servo; 0: 400. @range 0 to 1e6 @default 0 */
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
  /** Plate orientation of the servo. @ccw */
  double plate_orientation_deg;
  /** Perceived direction minus that of the virtual target. @ccw */
  double felt_error_deg;
} hrt_person_state;

/** Creates a person. The same configuration and seed are the same person on every host, bit for bit.
 *
 *  @param config  Null: the defaults.
 *  @param seed    Any number.
 *  @return OUT_OF_RANGE naming the field; LIMIT_REACHED; OUT_OF_MEMORY.
 *  @threadsafety [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_create(const hrt_person_config* config, uint64_t seed,
                                                   hrt_person* out_person) HRT_NOEXCEPT;

/** Destroys the person.
 *
 *  @threadsafety [one-thread] */
HRT_API hrt_result hrt_person_destroy(hrt_person person) HRT_NOEXCEPT;

/** Puts the finger at rest at the session's start. After a rest of 0.6 s, the person intends to slide to the present
 *  position of a virtual target. Each call is a further reach, with its own noise.
 *
 *  @param session         Session of the target.
 *  @param virtual_target  Target of the person.
 *  @return INVALID_HANDLE; OUT_OF_RANGE naming the target.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_begin(hrt_person person, hrt_session session,
                                                  hrt_target virtual_target) HRT_NOEXCEPT;

/** Commands the servo, advances the simulation, and returns the report of tracker and servo: a sample with
 *  PLATE_POSITION and PLATE_ORIENTATION. The first call after hrt_person_begin() starts the rest and places the plate
 *  at the given orientation.
 *
 *  @param time_ns                Time to which the simulation advances.
 *  @param plate_orientation_deg  Command: this orientation, or the nearest one with the same ridges. @ccw
 *  @return OUT_OF_RANGE naming plate_orientation_deg; TIME_REVERSED; WRONG_STATE before hrt_person_begin().
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_move(hrt_person person, int64_t time_ns, double plate_orientation_deg,
                                                 hrt_sample* out_sample) HRT_NOEXCEPT;

/** Returns the state of the person.
 *
 *  @return WRONG_STATE before hrt_person_begin().
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_get_state(hrt_person person, hrt_person_state* out_state) HRT_NOEXCEPT;

/** @enumeration HRT_SLIDE hrt_setup_residual::verdict: use of a slide. */
#define HRT_SLIDE_USED UINT32_C(0)         /**< part of the fit */
#define HRT_SLIDE_OUTLYING UINT32_C(1)     /**< rejected as an outlier */
#define HRT_SLIDE_ALONG_RIDGES UINT32_C(2) /**< rejected: the illusion changes sign along the ridges */

/** One slide of a calibration, straight ahead. */
typedef struct hrt_setup_residual {
  uint32_t struct_size;
  /** Use of the slide. @values HRT_SLIDE */
  uint32_t verdict;
  /** Plate orientation. @ccw */
  double plate_deg;
  /** Measured direction of the second half of the path. @ccw */
  double direction_deg;
  /** Fitted direction of the second half of the path. @ccw */
  double fitted_deg;
  /** direction_deg minus fitted_deg. @ccw */
  double residual_deg;
} hrt_setup_residual;

/** Returns a slide of the session's last fit of a CALIBRATION or RETEST.
 *
 *  @param slide  Index of the slide in the order of execution.
 *  @return WRONG_STATE before the first fit; OUT_OF_RANGE beyond the last slide.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_get_residual(hrt_session session, uint32_t slide,
                                                        hrt_setup_residual* out_residual) HRT_NOEXCEPT;

/** State of a recording. */
typedef struct hrt_recording_status {
  uint32_t struct_size;
  /** errno of the first failed write, after which nothing is written; 0: no write failed. */
  int32_t system_error;
  /** Calls that the operating system has accepted for writing. */
  uint64_t rows_written;
  /** Calls dropped because the disk was too slow or failed. 0 after stopping: the file is complete. */
  uint64_t rows_lost;
} hrt_recording_status;

/** Starts recording the session into a file, which is created or replaced. In the child of a fork, which has the
 *  parent's sessions but not its recordings, calls of these sessions are not recorded, hrt_recording_get_status() and
 *  hrt_recording_stop() return WRONG_STATE, and this call may start a recording of the child.
 *
 *  @return SYSTEM if the file cannot be created, is not a regular file, or another recording is written to it, in
 *          this process or another; WRONG_STATE during a reach or a set-up, or while recording; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_start(hrt_session session, const char* path) HRT_NOEXCEPT;

/** Returns the state of the recording.
 *
 *  @return WRONG_STATE without a recording.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_get_status(hrt_session session,
                                                          hrt_recording_status* out_status) HRT_NOEXCEPT;

/** Writes the remaining rows, closes the file and returns the final state. The call may wait for the disk. Destroying
 *  the session also stops its recording.
 *
 *  @return WRONG_STATE without a recording.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_stop(hrt_session session, hrt_recording_status* out_status) HRT_NOEXCEPT;

/** @enumeration HRT_ENDING End of a recording. */
#define HRT_ENDING_COMPLETE 0  /**< an end line, and nothing was altered or lost */
#define HRT_ENDING_CUT 1       /**< no end line: cut off, or the process ended while recording */
#define HRT_ENDING_LOST_ROWS 2 /**< rows that a slow disk has lost: only the rows before them were replayed */
#define HRT_ENDING_ALTERED 3   /**< an end line whose checksum does not match the text before it */

/** The fields of hrt_command that hrt_replay_report::hash covers, in this order: WHOLE(name) for each whole number,
 *  NUMBER(name) for each double. A new field of hrt_command changes no hash. */
#define HRT_HASHED_FIELDS(WHOLE, NUMBER) \
  WHOLE(flags)                           \
  WHOLE(step)                            \
  NUMBER(plate_orientation_deg)          \
  NUMBER(finger_direction_deg)           \
  NUMBER(perceived_direction_deg)        \
  NUMBER(aimed_direction_deg)            \
  NUMBER(distance_to_go_m)               \
  NUMBER(tactile_weight)                 \
  NUMBER(tactile_weight_sd)              \
  NUMBER(time_to_go_s)                   \
  NUMBER(felt_error_deg)                 \
  NUMBER(predicted_miss_deg)             \
  NUMBER(misfit)                         \
  NUMBER(miss_sd_deg)

/** Result of a replay. */
typedef struct hrt_replay_report {
  uint32_t struct_size;
  /** 1 if `ending` is HRT_ENDING_COMPLETE. @bool */
  uint32_t complete;
  /** Rows replayed. */
  uint64_t rows;
  /** Line, from 1, of the first row whose result or any number differs from the recorded one; 0: all rows are equal,
   *  bit for bit. */
  uint64_t first_different_line;
  /** FNV-1a hash of the replayed commands, equal on every host: for each successful row "update", the fields of
   *  HRT_HASHED_FIELDS as 8 bytes each, least significant byte first. */
  uint64_t hash;
  /** End of the recording. @values HRT_ENDING */
  uint32_t ending;
  uint32_t reserved;
} hrt_replay_report;

/** Repeats the recorded calls and compares results, commands, summaries, steps and results of set-ups.
 *
 *  @param path    The file, of at most 1 GiB. Not read if `text` is given.
 *  @param text    Content of a recording, or null.
 *  @param length  Its bytes.
 *  @return BAD_FORMAT naming the line, or a version that is not supported; SYSTEM if the file cannot be read.
 *  @threadsafety [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_replay(const char* path, const char* text, uint64_t length,
                                            hrt_replay_report* out_report) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "study_init.h"

#endif
