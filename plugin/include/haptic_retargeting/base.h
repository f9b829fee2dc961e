/*
 * Results, error texts, version, the host's allocator and log; and the contract of every call in these
 * headers.
 *
 * Calls
 *  - Every call returns hrt_result. HRT_OK is 0; every error is negative. On an error neither the session nor
 *    the outputs change, and hrt_last_error() names the call, the field, its value and what is allowed.
 *  - No call throws, aborts or terminates, when memory runs out neither.
 *  - Thread tags:
 *      [any-thread]  any thread, any time.
 *      [one-thread]  any thread, but one at a time for a session. The second thread gets HRT_ERROR_BUSY.
 *      [real-time]   as [one-thread]; no lock, allocation, system call or I/O, and bounded time, on error
 *                    paths too. On Windows a thread's first call allocates memory for its error text.
 *
 * Structs
 *  - Set `struct_size` to sizeof the struct; hrt_session_config_init() and its like (init.h) do, and set the
 *    defaults. A null configuration means the defaults, too. Bytes beyond the library's size must be zero.
 *  - Fields named `reserved` must be zero. Integers have a fixed width. Fields are aligned as C
 *    aligns them.
 *  - Texts and paths are UTF-8, on Windows too.
 *
 * In your process (plugin/README.md has numbers and details)
 *  - Calls round to nearest and, on x86, trap no floating-point exception; they restore the host's mode.
 * Flush-to-zero and the locale have no effect.
 *  - No signal is sent or handled. The only threads are those of recordings, one each, which block signals.
 *  - In the child of a fork sessions work; recordings stay with the parent (study.h).
 *  - dlclose() and the end of the process end all recordings. No thread may be in a call by then.
 *  - Stack: 32 kB in [real-time] calls, 64 kB in others. Memory: 16 kB a session, 9 MB a recording.
 *
 * Units are in the names: _deg degrees, _deg2 degrees squared, _m metres, _ns nanoseconds.
 *
 * Plate coordinates are right-handed: x to the user's right, y up from the plate's face, z towards the user.
 * The origin is the plate's centre. The mid-line is -z: straight away from the user.
 *
 * Directions are measured from the mid-line, counter-clockwise positive seen from above: a target to the left
 * has a positive direction.
 *
 * Plate orientation is the direction of the normal of the ridges, counter-clockwise from the mid-line, seen
 * from above. 0: ridges across the mid-line, left to right. Ridges repeat every 180 degrees. Seen from above,
 * with the user at the bottom and arrows along the normal:
 *
 *        0 degrees         45 degrees         90 degrees      mid-line
 *
 *            ^             ^  /   /             |  |  |           ^
 *        ----|----          \/   /   /          |  |  |           |
 *        ----|----          /\  /   /        <--|--+  |           |
 *        ----|----         /  \/   /            |  |  |          user
 */
#ifndef HAPTIC_RETARGETING_BASE_H
#define HAPTIC_RETARGETING_BASE_H

#include <stddef.h>
#include <stdint.h>

/* A host that links the static library defines HRT_STATIC. */
#if defined(HRT_STATIC)
#define HRT_API
#elif defined(_WIN32)
#if defined(HRT_BUILDING_LIBRARY)
#define HRT_API __declspec(dllexport)
#else
#define HRT_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define HRT_API __attribute__((visibility("default")))
#else
#define HRT_API
#endif

/* Of results that must not be ignored: of every call but those that destroy. */
#if defined(__cplusplus) && __cplusplus >= 201703L
#define HRT_NODISCARD [[nodiscard]]
#elif defined(__GNUC__)
#define HRT_NODISCARD __attribute__((warn_unused_result))
#else
#define HRT_NODISCARD
#endif

#if defined(__cplusplus)
#define HRT_NOEXCEPT noexcept
extern "C" {
#else
#define HRT_NOEXCEPT
#endif

/** Version of these headers. hrt_get_version() returns the library's. */
#define HRT_VERSION_MAJOR 0
#define HRT_VERSION_MINOR 4
#define HRT_VERSION_PATCH 0
/** Version that hrt_session_create() is given: the same major and, before 1.0, minor number is needed. */
#define HRT_VERSION (HRT_VERSION_MAJOR * 10000 + HRT_VERSION_MINOR * 100 + HRT_VERSION_PATCH)

/** HRT_OK or one of the errors below. Their numbers never change. */
typedef int32_t hrt_result;

#define HRT_OK 0
/** A pointer that must not be null was null. */
#define HRT_ERROR_NULL_ARGUMENT (-1)
/** The handle or id is null, stale, of another session, or was never given out. */
#define HRT_ERROR_INVALID_HANDLE (-2)
/** `struct_size` is below this library's, no multiple of 8, or above 4096, or bytes that this library does not know
 * are not zero. */
#define HRT_ERROR_STRUCT_SIZE (-3)
/** A value is outside its documented range, not a number, or infinite. */
#define HRT_ERROR_OUT_OF_RANGE (-4)
/** The call is not allowed now: for example an update without a reach. */
#define HRT_ERROR_WRONG_STATE (-5)
/** Another thread is in a call on this session. */
#define HRT_ERROR_BUSY (-6)
/** The sample is older than the one before it. */
#define HRT_ERROR_TIME_REVERSED (-7)
/** An allocation failed. */
#define HRT_ERROR_OUT_OF_MEMORY (-8)
/** The number of objects or samples is at its limit. */
#define HRT_ERROR_LIMIT_REACHED (-9)
/** The caller's buffer is too small for the output. */
#define HRT_ERROR_BUFFER_TOO_SMALL (-11)
/** Another target of this session has this name. */
#define HRT_ERROR_NAME_TAKEN (-12)
/** The operating system refused a file or a thread. */
#define HRT_ERROR_SYSTEM (-13)
/** A file or text is malformed, or a scene's file cannot be read. hrt_last_error() names the place. */
#define HRT_ERROR_BAD_FORMAT (-14)
/** The data cannot determine the requested value. hrt_last_error() names what is missing. */
#define HRT_ERROR_INSUFFICIENT_DATA (-15)
/** A defect in this library. Please report it with the text of hrt_last_error(). */
#define HRT_ERROR_INTERNAL (-99)

/** Returns the name of a result, such as "HRT_ERROR_BUSY", or "unknown result". Never null; valid as long as
 * the library is loaded. [any-thread] */
HRT_API const char* hrt_result_string(hrt_result result) HRT_NOEXCEPT;

/** Returns the text of this thread's last failed call: one line of English, empty if no call has failed.
 * Never null; valid until this thread's next failed call. [any-thread] */
HRT_API const char* hrt_last_error(void) HRT_NOEXCEPT;

/** Returns the library's version. From 1.0 on, a major version only grows by additions; before, the changelog
 * names what a minor version changes. Null pointers are skipped. [any-thread] */
HRT_API void hrt_get_version(uint32_t* out_major, uint32_t* out_minor, uint32_t* out_patch) HRT_NOEXCEPT;

/** Level of a log message. */
#define HRT_LOG_WARNING 1
#define HRT_LOG_ERROR 2

/** What the host lends to the library, for the whole process. All zero with `struct_size`: memory of the C
 * library, and no log. No function may call this library or throw. Each is called on any thread. */
typedef struct hrt_host {
  uint32_t struct_size;
  uint32_t reserved;
  /** Passed to all functions. The library does not read it. */
  void* context;
  /** Returns `size` bytes (at least 1) at a multiple of `alignment` (a power of two), or null on failure.
   * Called concurrently. Null, as `release` then has to be: the C library's. */
  void* (*allocate)(void* context, size_t size, size_t alignment);
  /** Releases memory that allocate() returned. As of free(), it gets no size: an allocator that needs it
   * keeps it beside the memory. Called concurrently. */
  void (*release)(void* context, void* memory);
  /** Receives what no call can return, for example that a recording's disk is full. `level` is HRT_LOG_*.
   * `text` is one line that names the session and, of a recording, the file; valid during the call. Called
   * within calls that are not real-time or on a thread of the library, one call at a time. Null: no log. */
  void (*log)(void* context, uint32_t level, const char* text);
} hrt_host;

/** Sets allocator and log; the struct is copied. Null: the defaults. Waits for a call of the former log to
 * end; it is not called any more once this returns. Errors: WRONG_STATE if the allocator changes while a
 * session, person or scene exists; NULL_ARGUMENT for one of allocate and release. [any-thread];
 * an allocator changes while no other thread is in a call of this library. */
HRT_NODISCARD HRT_API hrt_result hrt_set_host(const hrt_host* host) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
