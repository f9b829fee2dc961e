/*
 * Types and calls that everything else stands on: results, version, error texts, memory, log.
 *
 * Contract of every call in these headers:
 *  - It returns hrt_result. HRT_OK is 0 and every error is negative; on an error nothing changes,
 *    neither the session nor the outputs, and hrt_last_error() says what was wrong and what is allowed.
 *  - It never throws, aborts or terminates; hrt_scene_load_file() tells of one exception.
 *  - Its tag tells the thread rule:
 *      [any-thread]  at any time, from any thread.
 *      [one-thread]  from any thread, but two threads must not be in calls on one session at the same
 *                    time; the second of them gets HRT_ERROR_BUSY and nothing is corrupted.
 *      [real-time]   as [one-thread]; also takes no lock, allocates nothing, makes no system call, does
 *                    no input or output, and takes bounded time, on its error paths too. On Windows
 *                    a thread's first call allocates the room for its error text.
 *
 * Structs begin with `struct_size`, to be set to sizeof the struct as the caller was compiled with it
 * (the *_default() calls do). A caller compiled against an older header passes a smaller struct, whose
 * missing fields take their defaults; one compiled against a newer header passes a larger one, whose
 * further bytes must be zero. Fields named `reserved` must be zero. Integers have a fixed width, and
 * there is no padding between fields.
 *
 * Texts and paths are UTF-8, on Windows too.
 *
 * Units are in the names: _deg degrees, _deg2 degrees squared, _m metres, _ns nanoseconds.
 * Directions are measured from the plate's mid-line, which points straight away from the user,
 * counter-clockwise positive seen from above: a target to the left has a positive direction.
 * Plate coordinates are right-handed, in metres: x to the user's right, y up from the plate's face,
 * z towards the user; the mid-line is -z.
 */
#ifndef HAPTIC_RETARGETING_BASE_H
#define HAPTIC_RETARGETING_BASE_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
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

#if defined(__cplusplus)
#define HRT_NOEXCEPT noexcept
extern "C" {
#else
#define HRT_NOEXCEPT
#endif

/** Version of these headers; hrt_get_version() tells that of the library. */
#define HRT_VERSION_MAJOR 0
#define HRT_VERSION_MINOR 2
#define HRT_VERSION_PATCH 0

/** What became of a call: HRT_OK or one of the errors below. Their numbers never change. */
typedef int32_t hrt_result;

#define HRT_OK 0
/** A pointer that must not be null was null. */
#define HRT_ERROR_NULL_ARGUMENT (-1)
/** The handle or id is null, was never given out, is of another session, or of something destroyed. */
#define HRT_ERROR_INVALID_HANDLE (-2)
/** `struct_size` is below the first version's, or bytes beyond what this library knows are not zero. */
#define HRT_ERROR_STRUCT_SIZE (-3)
/** A value is outside its documented range, not a number, or infinite. */
#define HRT_ERROR_OUT_OF_RANGE (-4)
/** Not now: for example an update without a reach, or a new configuration during one. */
#define HRT_ERROR_WRONG_STATE (-5)
/** Another thread is in a call on this session. */
#define HRT_ERROR_BUSY (-6)
/** The sample's time is before that of the sample before it. */
#define HRT_ERROR_TIME_REVERSED (-7)
#define HRT_ERROR_OUT_OF_MEMORY (-8)
/** There are as many of these as there can be. */
#define HRT_ERROR_LIMIT_REACHED (-9)
/** Nothing has this name. */
#define HRT_ERROR_NOT_FOUND (-10)
/** The caller's buffer cannot hold the answer. */
#define HRT_ERROR_BUFFER_TOO_SMALL (-11)
/** Another target of this session has this name. */
#define HRT_ERROR_NAME_TAKEN (-12)
/** The operating system refused: a file, a thread. */
#define HRT_ERROR_SYSTEM (-13)
/** A text is not what it should be; hrt_last_error() tells where. */
#define HRT_ERROR_BAD_FORMAT (-14)
/** The data do not tell what was asked of them; hrt_last_error() tells what is missing. */
#define HRT_ERROR_INSUFFICIENT_DATA (-15)
/** A defect in this library; please report it with the text of hrt_last_error(). */
#define HRT_ERROR_INTERNAL (-99)

/** The name of a result, such as "HRT_ERROR_BUSY"; "unknown result" for any other number.
 *  Never null; lives as long as the library. [any-thread] */
HRT_API const char* hrt_result_string(hrt_result result) HRT_NOEXCEPT;

/** What went wrong in this thread's last failed call, in English, in one line: the call, the argument,
 *  its value and what is allowed. Empty if none has failed. Never null; valid until the next failed call of
 *  this thread. [any-thread] */
HRT_API const char* hrt_last_error(void) HRT_NOEXCEPT;

/** The library's version. Within a major version there are only additions. Null pointers are skipped.
 *  [any-thread] */
HRT_API void hrt_get_version(uint32_t* out_major, uint32_t* out_minor, uint32_t* out_patch) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
