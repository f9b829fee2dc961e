/*
 * What the host lends the library: memory, and an ear for what no call can return. Both are for the whole
 * process; set them before anything else is made.
 */
#ifndef HAPTIC_RETARGETING_HOST_H
#define HAPTIC_RETARGETING_HOST_H

#include "base.h"

#if defined(__cplusplus)
extern "C" {
#endif

/** Where the library's memory comes from. The functions may be called from any thread, at the same time; they
 *  must not call this library, and must not throw. */
typedef struct hrt_allocator {
  uint32_t struct_size;
  uint32_t reserved;
  /** Passed to both functions; never read. */
  void* context;
  /** Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null if it can't. */
  void* (*allocate)(void* context, size_t size, size_t alignment);
  /** Takes back what allocate() returned. */
  void (*release)(void* context, void* memory);
} hrt_allocator;

/** Has all memory come from `allocator` from now on; null: from the C library, as at first. The struct is
 *  copied. Errors: WRONG_STATE while the library holds memory, as for a session, a calibration or a scene.
 *  [any-thread], but not while another thread is in any call of this library. */
HRT_API hrt_result hrt_set_allocator(const hrt_allocator* allocator) HRT_NOEXCEPT;

/** hrt_log_callback: how bad it is. */
#define HRT_LOG_WARNING 1
#define HRT_LOG_ERROR 2

/** Hears what no call can return, such as that a recording's disk is full. `text` is one line, valid during
 *  the call. Called from a thread of the library's own, never from within a call of the host's; must not call
 *  this library, and must not throw. */
typedef void (*hrt_log_callback)(void* context, uint32_t level, const char* text);

/** Has `callback` called with `context` from now on; null: nobody, as at first. Errors and thread rule: as
 *  hrt_set_allocator(). */
HRT_API hrt_result hrt_set_log_callback(hrt_log_callback callback, void* context) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
