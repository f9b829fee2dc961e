/*
 * Studies: a simulated person, recordings of a session and their replay, and what a calibration is made of.
 *
 * The simulated person is a finger that slides over the plate, feels its ridges and is bent by them. It takes
 * the place of a tracked finger and of the plate's servo in a first program, a demo or an engine's test. It
 * is a model, and no measurement of people: who it is follows from a seed, with an illusion that is linear in
 * the plate's angle.
 *
 * A recording is a CSV file with comments (#), which R, pandas and MATLAB open directly. Each begin, update,
 * retarget, touched, cancel and end of a reach, and each update, finish and cancel of a set-up, is a row,
 * refused calls too, but those of a set-up whose structs cannot be read. Comments hold configurations, targets,
 * beginnings of set-ups and the plate orientation (base.h). Numbers have full precision. A thread of the library writes
 * the file: a slow or full disk never delays a call; rows are dropped and counted.
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

/** Configuration of a simulated person. All zero with `struct_size` is the default. */
typedef struct hrt_person_config {
  uint32_t struct_size;
  uint32_t reserved;
  /** Share of touch in the direction that they feel; drawn from the seed between 0.12 and 0.3. 0.01 to 0.49;
   * 0: drawn. Default 0. */
  double tactile_weight;
  /** Direction in which they see a virtual target minus its own. -45 to 45. Default 0. */
  double bias_deg;
  /** Duration of the motion, by default 1.5 s. 0.3 to 20 s; 0: the default. Default 0. */
  double duration_s;
  /** Standard deviation of the tracker's white noise in each coordinate, by default 1.2 mm. 0 to 0.1; 0: the
   * default. Default 0. */
  double tracker_noise_m;
  /** Maximum speed of the plate's servo, by default 400. 0 to 1e6 degrees a second; 0: the default. Default
   * 0. */
  double plate_max_speed_deg_s;
  /** Time from a command to the servo's first motion, by default 30 ms. 0 to 1 s; 0: the default. Default
   * 0. */
  int64_t plate_latency_ns;
} hrt_person_config;

/** Where a simulated person is. Positions are in plate coordinates, without the tracker's noise. Set
 * `struct_size` before the call. */
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
 * `config`: the defaults. Errors: OUT_OF_RANGE naming the field, STRUCT_SIZE, LIMIT_REACHED, OUT_OF_MEMORY.
 * [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_create(const hrt_person_config* config, uint64_t seed,
                                                   hrt_person* out_person) HRT_NOEXCEPT;

/** Destroys the person. [one-thread] */
HRT_API hrt_result hrt_person_destroy(hrt_person person) HRT_NOEXCEPT;

/** Puts the finger at rest at the session's start. The person means to slide to where the session's virtual
 * target is now, after a rest of 0.6 s. Each call is a further reach, with noise of its own. Errors:
 * INVALID_HANDLE, OUT_OF_RANGE naming the target. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_begin(hrt_person person, hrt_session session,
                                                  hrt_target virtual_target) HRT_NOEXCEPT;

/** Commands the servo to the plate orientation (base.h), or the nearest that feels the same, lets time pass until
 * `time_ns`, and returns what tracker and servo then report: a sample with PLATE_POSITION and PLATE_ORIENTATION. Set
 * `out_sample->struct_size` before the call. The first call after hrt_person_begin() has the rest begin, and
 * the plate stand where it says. Errors: OUT_OF_RANGE naming plate_orientation_deg, TIME_REVERSED,
 * WRONG_STATE before hrt_person_begin(). [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_move(hrt_person person, int64_t time_ns, double plate_orientation_deg,
                                                 hrt_sample* out_sample) HRT_NOEXCEPT;

/** Returns where the person is. Errors: WRONG_STATE before hrt_person_begin(). [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_person_get_state(hrt_person person, hrt_person_state* out_state) HRT_NOEXCEPT;

/** What became of a slide: hrt_setup_residual::verdict. */
#define HRT_SLIDE_USED UINT32_C(0)
#define HRT_SLIDE_OUTLYING UINT32_C(1)     /**< unlike the others: left out */
#define HRT_SLIDE_ALONG_RIDGES UINT32_C(2) /**< left out: the illusion flips along the ridges */

/** One slide of a calibration, straight ahead. Set `struct_size` before the call. */
typedef struct hrt_setup_residual {
  uint32_t struct_size;
  /** HRT_SLIDE_*. */
  uint32_t verdict;
  /** Plate orientation (base.h). */
  double plate_deg;
  /** Of the second half of the path, seen and fitted, and their difference. */
  double direction_deg;
  double fitted_deg;
  double residual_deg;
} hrt_setup_residual;

/** Returns a slide of the session's last fit of a CALIBRATION or RETEST, in the order in which they were
 * made, from 0. Errors: WRONG_STATE before the first fit; OUT_OF_RANGE beyond the last slide. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_setup_get_residual(hrt_session session, uint32_t slide,
                                                        hrt_setup_residual* out_residual) HRT_NOEXCEPT;

/** State of a recording. Set `struct_size` before the call. */
typedef struct hrt_recording_status {
  uint32_t struct_size;
  /** errno of the first failed write, after which nothing is written; 0: none. */
  int32_t system_error;
  /** Calls that the operating system has accepted for writing. */
  uint64_t rows_written;
  /** Calls dropped because the disk was too slow or failed. 0 after stopping: the file is complete. */
  uint64_t rows_lost;
} hrt_recording_status;

/** Starts recording the session into a file, which is created or replaced. Errors: SYSTEM if the file cannot
 * be created, is not a regular file, or another recording is written to it, in this process or another;
 * WRONG_STATE during a reach or a set-up, or while recording; OUT_OF_MEMORY. In the child of a fork, which has the
 * parent's sessions but not its recordings, calls of these sessions are not recorded, the two calls below
 * return WRONG_STATE, and this one may start a recording of the child. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_start(hrt_session session, const char* path) HRT_NOEXCEPT;

/** Returns the state of the recording. Errors: WRONG_STATE without a recording. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_get_status(hrt_session session,
                                                          hrt_recording_status* out_status) HRT_NOEXCEPT;

/** Writes the remaining rows, closes the file and returns the final state. The call may wait for the disk.
 * Destroying the session also stops its recording. Errors: WRONG_STATE without a recording. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_stop(hrt_session session, hrt_recording_status* out_status) HRT_NOEXCEPT;

/** How a recording ends. */
#define HRT_ENDING_COMPLETE 0  /**< with its end line, and nothing was altered or lost */
#define HRT_ENDING_CUT 1       /**< without an end line: cut off, or the process ended while recording */
#define HRT_ENDING_LOST_ROWS 2 /**< at rows that a slow disk has lost: only those before were replayed */
#define HRT_ENDING_ALTERED 3   /**< with an end line whose checksum is not that of the text before it */

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

/** Result of a replay. Set `struct_size` before the call. */
typedef struct hrt_replay_report {
  uint32_t struct_size;
  /** 1 if `ending` is HRT_ENDING_COMPLETE, else 0. */
  uint32_t complete;
  /** Rows replayed. */
  uint64_t rows;
  /** Line, from 1, of the first row whose result or any number differs from the recorded one; 0: all rows are
   * equal, bit for bit. */
  uint64_t first_different_line;
  /** FNV-1a hash of the replayed commands, equal on every host: for each successful row "update", the fields of
   *  HRT_HASHED_FIELDS as 8 bytes each, least significant byte first. */
  uint64_t hash;
  /** HRT_ENDING_*. */
  uint32_t ending;
  uint32_t reserved;
} hrt_replay_report;

/** Repeats the recorded calls and compares results, commands, summaries, steps and results of set-ups: of the
 * file `path`, of at most 1 GiB; or, unless `text` is null, of a text, and `path` is not read. Errors:
 * BAD_FORMAT naming the line, or a version that is not supported; SYSTEM if the file cannot be read.
 * [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_replay(const char* path, const char* text, uint64_t length,
                                            hrt_replay_report* out_report) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "study_init.h"

#endif
