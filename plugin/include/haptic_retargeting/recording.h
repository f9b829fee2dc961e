/*
 * Recordings of a session, and their replay.
 *
 * Example: records a session without a reach, and replays the file.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <haptic_retargeting/recording.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session session;
 *     hrt_recording_status status = hrt_recording_status_init();
 *     hrt_replay_report report = hrt_replay_report_init();
 *     int failed = hrt_session_create(HRT_VERSION, NULL, &session) || hrt_recording_start(session, "session.csv") ||
 *                  hrt_recording_stop(session, &status) || hrt_recording_replay("session.csv", NULL, 0, &report);
 *     if (failed) puts(hrt_last_error());
 *     return failed || status.rows_lost || !report.complete || report.first_different_line;
 *   }
 *
 * A recording is a CSV file with comments (#), which R, pandas and MATLAB open directly. It has a row for each call
 * hrt_reach_begin, _update, _retarget, _touched, _cancel and _end, and hrt_setup_update, _finish and _cancel, also for
 * a failed call if its handle and structs can be read. Comments contain configurations, targets, calls of
 * hrt_setup_begin() and the plate orientation at the start. Numbers have full precision.
 *
 * A thread of the library writes the file, so that a slow or full disk does not delay the recorded calls; calls that
 * cannot be written are dropped and counted. In WebAssembly without threads, a recorded call writes the file itself
 * when 8192 calls are waiting.
 */
#ifndef HAPTIC_RETARGETING_RECORDING_H
#define HAPTIC_RETARGETING_RECORDING_H

#include "reach.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** State of a recording. */
typedef struct hrt_recording_status {
  uint32_t struct_size;
  /** Value of errno of the first failed write, after which nothing is written; 0: no write failed. */
  int32_t system_error;
  /** Rows that the operating system has accepted for writing. If no row was lost, hrt_replay_report::rows is equal. */
  uint64_t rows_written;
  /** Number of rows and comments that were dropped, because the disk was slow or failed. If rows_lost and system_error
   *  are 0 after hrt_recording_stop(), the file is complete. */
  uint64_t rows_lost;
} hrt_recording_status;

/** Starts recording the session into a file, which is created or replaced. The child of a fork has the sessions, but
 *  not the recordings: its calls are not recorded until it starts a recording by this call.
 *
 *  @param path  Name of the file.
 *  @return SYSTEM if the file cannot be written, is not a regular file, or another recording is written to it, in this
 *          process or another, or if no thread can be started; WRONG_STATE during a reach or a set-up, or while
 *          recording; OUT_OF_MEMORY.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_start(hrt_session session, const char* path) HRT_NOEXCEPT;

/** Returns the state of the recording.
 *
 *  @param out_status  State of the recording.  @return WRONG_STATE without a recording.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_get_status(hrt_session session,
                                                          hrt_recording_status* out_status) HRT_NOEXCEPT;

/** Waits until the operating system has accepted all rows so far, so that they survive a crash of the process, or until
 *  a write has failed. The file stays open. The call may wait for the disk.
 *
 *  @param out_status  State of the recording.  @return WRONG_STATE without a recording.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_flush(hrt_session session,
                                                     hrt_recording_status* out_status) HRT_NOEXCEPT;

/** Writes the remaining rows, closes the file and returns the final state. The call may wait for the disk. Destroying
 *  the session also stops its recording.
 *
 *  @param out_status  Final state of the recording.  @return WRONG_STATE without a recording.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_stop(hrt_session session, hrt_recording_status* out_status) HRT_NOEXCEPT;

/** @enumeration HRT_ENDING How a recording ended. */
typedef uint32_t hrt_recording_ending;
#define HRT_ENDING_COMPLETE 0  /**< the end line is present; no row was altered or lost */
#define HRT_ENDING_CUT 1       /**< the end line is missing: the file was cut, or the process ended while recording */
#define HRT_ENDING_LOST_ROWS 2 /**< the disk was too slow for some rows: only the rows before them were replayed */
#define HRT_ENDING_ALTERED 3   /**< the checksum in the end line does not match the text before it */

/** The fields of hrt_command that hrt_replay_report::hash covers, in this order: WHOLE(name) for each integer,
 *  NUMBER(name) for each double. The list does not change, so that hashes of different versions can be compared. */
#define HRT_HASHED_FIELDS(WHOLE, NUMBER) \
  WHOLE(flags)                           \
  NUMBER(plate_orientation_deg)          \
  NUMBER(bearing_deg)                    \
  NUMBER(perceived_direction_deg)        \
  NUMBER(felt_error_deg)                 \
  NUMBER(predicted_miss_deg)             \
  NUMBER(miss_sd_deg)                    \
  NUMBER(distance_to_go_m)               \
  NUMBER(time_to_go_s)                   \
  NUMBER(tactile_weight)                 \
  NUMBER(tactile_weight_sd)              \
  NUMBER(misfit)                         \
  WHOLE(paper.step)                      \
  NUMBER(paper.finger_direction_deg)     \
  NUMBER(paper.aimed_direction_deg)

/** Result of a replay. */
typedef struct hrt_replay_report {
  uint32_t struct_size;
  /** 1 if `ending` is HRT_ENDING_COMPLETE. @bool */
  uint32_t complete;
  /** Number of rows that were replayed. */
  uint64_t rows;
  /** Line, from 1, of the first row whose result or any number differs from the recorded one; 0: all replayed rows are
   *  equal, bit for bit. */
  uint64_t first_different_line;
  /** Hash (FNV-1a, 64 bits) of the replayed commands, equal on all machines: it covers the fields of HRT_HASHED_FIELDS
   *  for each successful row "update", each field as 8 bytes, least significant byte first. */
  uint64_t hash;
  /** How the recording ended. */
  hrt_recording_ending ending;
  uint32_t reserved;
} hrt_replay_report;

/** Replays a recording: repeats its calls and compares results, commands, summaries, and steps and results of set-ups.
 *
 *  @param path        Name of the file, of at most 1 GiB. Not used, and may be null, if `text` is given.
 *  @param text        Content of a recording, or null.
 *  @param length      Bytes of the content.
 *  @param out_report  Result of the comparison.
 *  @return BAD_FORMAT naming the line, or for a text that does not begin like a recording of version 4; SYSTEM if the
 *          file cannot be read; OUT_OF_MEMORY.
 *  @threadsafety [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_recording_replay(const char* path, const char* text, uint64_t length,
                                                      hrt_replay_report* out_report) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "recording_init.h"

#endif
