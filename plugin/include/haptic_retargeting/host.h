/*
 * The host's allocator and log, for the whole process. Set the allocator before creating any object.
 */
#ifndef HAPTIC_RETARGETING_HOST_H
#define HAPTIC_RETARGETING_HOST_H

#include "base.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Source of the library's memory. Both functions are called from any thread, concurrently. Neither may
 *  call this library or throw. */
typedef struct hrt_allocator {
  uint32_t struct_size;
  uint32_t reserved;
  /** Passed to both functions. The library does not read it. */
  void* context;
  /** Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null on failure. */
  void* (*allocate)(void* context, size_t size, size_t alignment);
  /** Releases memory that allocate() returned. As of free(), it gets no size: an allocator that needs it
   * keeps it beside the memory. */
  void (*release)(void* context, void* memory);
} hrt_allocator;

/** Sets the allocator. Null: the C library's, the default. The struct is copied. Errors: WRONG_STATE while
 *  a session, calibration or scene exists. [any-thread], while no other thread is in a call of this
 *  library. */
HRT_NODISCARD HRT_API hrt_result hrt_set_allocator(const hrt_allocator* allocator) HRT_NOEXCEPT;

/** Level of a log message. */
#define HRT_LOG_WARNING 1
#define HRT_LOG_ERROR 2

/** Receives what no call can return, for example that a recording's disk is full. `level` is HRT_LOG_*.
 *  `text` is one line that names the session and, of a recording, the file; valid during the call. Called on
 *  a thread of the library or within a call that is not real-time, one call at a time in the process. It may
 *  not call this library or throw. */
typedef void (*hrt_log_callback)(void* context, uint32_t level, const char* text);

/** Sets the log callback of sessions that have none of their own (hrt_session_set_log_callback()). Null: no
 *  log, the default. The former callback is not called any more once this
 *  returns; the call waits for it to end. [any-thread] */
HRT_NODISCARD HRT_API hrt_result hrt_set_log_callback(hrt_log_callback callback, void* context) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
