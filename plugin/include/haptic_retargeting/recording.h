/*
 * Recordings of a session, and their replay.
 *
 * A recording is a CSV file with comments (#), which R, pandas and MATLAB open directly. Each begin, update,
 * retarget, cancel and end of a reach is a row, refused calls too; so is each trial, sample, next angle and
 * solution of a calibration that was created while the recording ran. Comments hold configurations, targets
 * and the plate orientation (base.h). Numbers have full precision. A thread of the library writes the file: a
 * slow or full disk never delays a call; rows are dropped and counted.
 */
#ifndef HAPTIC_RETARGETING_RECORDING_H
#define HAPTIC_RETARGETING_RECORDING_H

#include "session.h"

#if defined(__cplusplus)
extern "C" {
#endif

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

/** Starts recording the session into a file, which is created or replaced. Errors: SYSTEM if the file
 *  cannot be created, is not a regular file, or another recording is written to it, in this process or
 *  another; WRONG_STATE during a reach or while recording; OUT_OF_MEMORY. In the child of a fork, which has
 * the parent's sessions but not its recordings, calls of these sessions are not recorded, the two calls below
 *  return WRONG_STATE, and this one may start a recording of the child. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_start(hrt_session session, const char* path) HRT_NOEXCEPT;

/** Returns the state of the recording. Errors: WRONG_STATE without a recording. [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_get_status(hrt_session session,
                                                          hrt_recording_status* out_status) HRT_NOEXCEPT;

/** Writes the remaining rows, closes the file and returns the final state. The call may wait for the disk.
 *  Destroying the session also stops its recording. Errors: WRONG_STATE without a recording. [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_stop(hrt_session session,
                                                    hrt_recording_status* out_status) HRT_NOEXCEPT;

/** How a recording ends. */
#define HRT_ENDING_COMPLETE 0  /**< with its end line, and nothing was altered or lost */
#define HRT_ENDING_CUT 1       /**< without an end line: cut off, or the process ended while recording */
#define HRT_ENDING_LOST_ROWS 2 /**< at rows that a slow disk has lost: only those before were replayed */
#define HRT_ENDING_ALTERED 3   /**< with an end line whose checksum is not that of the text before it */

/** Result of a replay. Set `struct_size` before the call. */
typedef struct hrt_replay_report {
  uint32_t struct_size;
  /** 1 if `ending` is HRT_ENDING_COMPLETE, else 0. */
  uint32_t complete;
  /** Rows replayed. */
  uint64_t rows;
  /** Line, from 1, of the first row whose result or any number differs from the recorded one; 0: all rows
   *  are equal, bit for bit. */
  uint64_t first_different_line;
  /** FNV-1a hash of the replayed commands, equal on every host: for each successful row "update", flags as
   *  8 bytes, step and the eleven numbers after it, least significant byte first. */
  uint64_t hash;
  /** HRT_ENDING_*. */
  uint32_t ending;
  uint32_t reserved;
} hrt_replay_report;

/** Repeats the recorded calls and compares results, commands, summaries, angles and solutions. Errors:
 * BAD_FORMAT naming the line, or a version that is not supported. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_replay_text(const char* text, uint64_t length,
                                                 hrt_replay_report* out_report) HRT_NOEXCEPT;

/** Replays a file of at most 1 GiB. Errors: as hrt_replay_text(), and SYSTEM if the file cannot be read.
 *  [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_replay_file(const char* path,
                                                 hrt_replay_report* out_report) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
