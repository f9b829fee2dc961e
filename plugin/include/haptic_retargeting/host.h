/*
 * Functions of the host that the library calls: allocator and log.
 *
 * Example: log messages on the standard error output.
 *
 *   #include <haptic_retargeting/host.h>
 *   #include <stdio.h>
 *
 *   static void log_line(void* context, hrt_log_level level, const char* text) {
 *     fprintf((FILE*)context, "%s: %s\n", level == HRT_LOG_ERROR ? "error" : "warning", text);
 *   }
 *
 *   int main(void) {
 *     hrt_host host = hrt_host_init(); // with the allocator of the C library
 *     host.context = stderr;
 *     host.log = log_line;
 *     return hrt_host_set(&host);
 *   }
 */
#ifndef HAPTIC_RETARGETING_HOST_H
#define HAPTIC_RETARGETING_HOST_H

#include "session.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** @enumeration HRT_LOG Level of a log message. */
typedef uint32_t hrt_log_level;
#define HRT_LOG_WARNING 1 /**< a probable mistake, or results that are less accurate or incomplete */
#define HRT_LOG_ERROR 2   /**< a recording has stopped, or the library has a defect */

/** Functions of the host. By default, all are null: the library uses the allocator of the C library, and has no log.
 *  The functions must not call this library or throw. Each may be called on any thread. */
typedef struct hrt_host {
  uint32_t struct_size;
  uint32_t reserved;
  /** Pointer that is passed to all functions. The library does not dereference it. */
  void* context;
  /** Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null on failure. Set it to
   *  keep the library's memory in a budget of the engine. Called concurrently. Null: the allocator of the C library;
   *  `release` must then be null too. */
  void* (*allocate)(void* context, size_t size, size_t alignment);
  /** Releases memory that allocate() returned. Like free(), this function does not receive the size: an allocator that
   *  needs the size must store it next to the memory. Called concurrently. */
  void (*release)(void* context, void* memory);
  /** Receives events that no call can return, for example that the disk of a recording is full. `level` is one of
   *  HRT_LOG_*. `text` is one line that names the session or the file; it is valid during the call. Called on the
   *  thread of a recording, or within a call that is not tagged [real-time]; one call at a time. Null: the events are
   *  lost. */
  void (*log)(void* context, hrt_log_level level, const char* text);
} hrt_host;

/** Sets allocator and log. The log receives all lines, except those of sessions with a log of their own
 *  (hrt_host_set_log()). Waits while a log is being called; after this call returns, the former log is not called.
 *
 *  @param host  Functions, copied. Null: the defaults.
 *  @return WRONG_STATE if the allocator changes while a session, person or scene exists; NULL_ARGUMENT if only one of
 *          allocate and release is given; OUT_OF_RANGE if `reserved` is not 0.
 *  @threadsafety [any-thread], but while the allocator changes no other thread may be in a call of this library. */
HRT_NODISCARD HRT_API hrt_result hrt_host_set(const hrt_host* host) HRT_NOEXCEPT;

/** Sets a log for one session instead of that of hrt_host_set(), for processes in which several parts use this library.
 *  Waits while a log is being called; after this call returns, the former log receives no lines of the session. Writes
 *  to the new log what [real-time] calls could not write, such as the reason of HRT_COMMAND_IMPLAUSIBLE: call it after
 *  a reach to receive these lines immediately.
 *
 *  @param host  Host whose `context` and `log` are copied; `allocate` and `release` must be null. If `host` or
 *               `host->log` is null, the session uses the log of hrt_host_set() again.
 *  @return OUT_OF_RANGE if the host has an allocator.
 *  @threadsafety [one-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_host_set_log(hrt_session session, const hrt_host* host) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#include "host_init.h"

#endif
