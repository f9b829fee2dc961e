/*
 * Recordings: all that crosses this interface, in a file, as it happens; and replaying them.
 *
 * A recording is CSV with comments (#), numbers in full precision, one row for each begin, update and end of
 * the session, refused ones too, so that R, pandas and MATLAB open it as it is; comments hold configuration,
 * targets and where the plate stands. A thread of the library's own writes it: a slow disk or a full
 * one never holds up a call, loses rows instead, and is reported.
 */
#ifndef HAPTIC_RETARGETING_RECORDING_H
#define HAPTIC_RETARGETING_RECORDING_H

#include "session.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** How a recording does. Set `struct_size` before the call. */
typedef struct hrt_recording_status {
  uint32_t struct_size;
  /** The errno of the first write that failed, after which nothing more is written; 0: none did. */
  int32_t system_error;
  /** Calls recorded, as far as the operating system has taken them. */
  uint64_t rows_written;
  /** Calls that are not in the file, because the disk was too slow or failed. 0 at the end: it is complete.
   */
  uint64_t rows_lost;
} hrt_recording_status;

/** Records the session from now on into a file, which is created or replaced.
 *  Errors: SYSTEM if it can't be created, WRONG_STATE during a reach or while recording, OUT_OF_MEMORY.
 *  [one-thread] */
HRT_API hrt_result hrt_recording_start(hrt_session session, const char* path) HRT_NOEXCEPT;

/** How the recording does. Errors: WRONG_STATE if there is none. [real-time] */
HRT_API hrt_result hrt_recording_get_status(hrt_session session,
                                            hrt_recording_status* out_status) HRT_NOEXCEPT;

/** Writes what is left, closes the file and tells how it went; may wait for the disk. Destroying the session
 *  does this too. Errors: WRONG_STATE if there is no recording. [one-thread] */
HRT_API hrt_result hrt_recording_stop(hrt_session session, hrt_recording_status* out_status) HRT_NOEXCEPT;

/** What a replay found. Set `struct_size` before the call. */
typedef struct hrt_replay_report {
  uint32_t struct_size;
  /** 1 if the recording is whole: it has its end, and no rows were lost; else 0, and what precedes the gap
   *  was replayed. */
  uint32_t complete;
  /** Rows replayed. */
  uint64_t rows;
  /** The line of the file, from 1, of the first row that came out otherwise than recorded, in its
   *  result or any number; 0: all came out the same, bit for bit. */
  uint64_t first_different_line;
  /** FNV-1a of the commands as replayed, which is the same on every host: of each row "update" without
   *  error, flags as 8 bytes, step, and the seven numbers after them, least significant byte first. */
  uint64_t hash;
} hrt_replay_report;

/** Runs the recorded calls again and compares results, commands and summaries. Errors: BAD_FORMAT naming the
 *  line, or the version if it is that of a library of 0.1. [any-thread] */
HRT_API hrt_result hrt_replay_text(const char* text, uint64_t length,
                                   hrt_replay_report* out_report) HRT_NOEXCEPT;

/** The same of a file of at most 1 GiB. Errors: SYSTEM if it can't be read. [any-thread] */
HRT_API hrt_result hrt_replay_file(const char* path, hrt_replay_report* out_report) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
