/*
 * Results, error texts, version, and the rules for all calls of the library.
 *
 * Example: a failed call reports what is wrong.
 *
 *   #include <haptic_retargeting/haptic_retargeting.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     hrt_session session;
 *     hrt_session_config config = hrt_session_config_init();
 *     config.plate.radius_m = 75; // millimetres by mistake
 *     hrt_result result = hrt_session_create(HRT_VERSION, &config, &session);
 *     printf("%s: %s\n", hrt_result_string(result), hrt_last_error());
 *     return result != HRT_ERROR_OUT_OF_RANGE;
 *   }
 *
 * Calls
 *  - Calls return hrt_result, except those that return a text, the version or a struct with its defaults. HRT_OK is 0;
 *    every error is negative. After an error, the session and the outputs are unchanged, and hrt_last_error() names
 *    the call and what is wrong.
 *  - No call throws, aborts or terminates the process, including when memory is exhausted. Exceptions (PROCESS.md):
 *    hrt_scene_load() if memory is exhausted, and hrt_recording_start() beyond the process's limit of file sizes.
 *  - The comment of a call lists its errors, except NULL_ARGUMENT, INVALID_HANDLE, STRUCT_SIZE, BUSY and INTERNAL.
 *  - Comments omit the prefixes of constants: WRONG_STATE is HRT_ERROR_WRONG_STATE, and ARRIVAL or GUIDANCE_ARRIVAL is
 *    HRT_GUIDANCE_ARRIVAL.
 *  - Thread tags:
 *      [any-thread]  any thread, at any time.
 *      [one-thread]  any thread, but only one at a time for each session, person, scene or plate. While one thread is
 *                    in a call, a call of a second thread returns BUSY.
 *      [real-time]   as [one-thread]. In addition, the call takes no lock, allocates nothing, makes no system call and
 *                    takes bounded time, also when it fails. On Windows, the first call of a thread allocates memory
 *                    for its error text.
 *
 * Structs
 *  - Set `struct_size` to the size of the struct before each call, also in structs that the call fills. The _init()
 *    function of the struct, such as hrt_session_config_init(), sets the size and the defaults. In a struct that a call
 *    reads, bytes beyond the size that the library knows must be zero.
 *  - Fields named `reserved` must be zero.
 *  - A value of a type such as hrt_guidance is one of the constants below the type. Flags are the constants below their
 *    type, joined by |.
 *  - Texts and paths are UTF-8, on Windows too.
 *
 * In your process (PROCESS.md has the details, and the needs of stack and memory)
 *  - Calls set rounding to nearest and, on x86, mask floating-point exceptions; at their end, they restore the host's
 *    floating-point mode. The host's flush-to-zero mode and locale do not affect results.
 *  - The library sends and handles no signals. Its only threads are one for each recording, which blocks signals.
 *  - The child of a fork has the sessions, but not the recordings (recording.h).
 *  - dlclose() and the end of the process end all recordings. No thread may be in a call at that time.
 *
 * Names end with their units: _deg degrees, _deg2 degrees squared, _deg_s degrees per second, _deg_s2 degrees per
 * second squared, _m metres, _s seconds, _ns nanoseconds. Tags in comments give other units, ranges and defaults; the
 * range of an array applies to each element:
 *   @unit U           unit of a value whose name does not end in it; 1: a pure number
 *   @range A to B     allowed values; "0 or A to B" allows 0 as well
 *   @default V        value that hrt_..._init() sets
 *   @norm A to B      allowed length of a vector
 *   @elements HRT_X   array whose elements the constants HRT_X_* index
 *   @bool             0 or 1
 *   @ccw              angle that is positive counter-clockwise, seen from above
 *   @profile FIELD    stored in profiles (profile.h); if FIELD is given, only while that field is not 0
 *   @flatten NAME     name of the field in other languages, profiles and recordings. On a nested struct, * stands for
 *                     the name of each of its fields
 *
 * Plate coordinates are right-handed: x to the user's right, y up from the plate's face, z towards the user.
 * The origin is the plate's centre. The mid-line is the -z axis, straight away from the user.
 *
 * Directions are angles from the mid-line, positive counter-clockwise, seen from above: a target to the left has a
 * positive direction. The bearing of a position is the direction of the straight line from the start of the reach to
 * the position. On a curved path, the direction of the motion differs from the bearing.
 *
 * Plate orientation is the direction of the normal of the ridges, counter-clockwise from the mid-line, seen
 * from above. At 0, the ridges run across the mid-line, left to right. Orientations 180 degrees apart have the same
 * ridges. Seen from above, with the user at the bottom and arrows along the normal:
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

/* Define HRT_STATIC in a program that links the static library. */
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

/* Compilers warn if the result of a call is ignored. Calls that destroy an object lack this attribute. */
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

/** Version of these headers. hrt_get_version() returns the version of the library. */
#define HRT_VERSION_MAJOR 0
#define HRT_VERSION_MINOR 5
#define HRT_VERSION_PATCH 0
/** Version to pass to hrt_session_create(), which rejects headers of another major or minor version. */
#define HRT_VERSION (HRT_VERSION_MAJOR * 10000 + HRT_VERSION_MINOR * 100 + HRT_VERSION_PATCH)

/** Result of a call: HRT_OK or one of HRT_ERROR_*. */
typedef int32_t hrt_result;

#define HRT_OK 0 /**< the call succeeded */
/** @enumeration HRT_ERROR Errors of calls. */
/** A pointer that must not be null was null. */
#define HRT_ERROR_NULL_ARGUMENT (-1)
/** The handle or id is 0, was never returned by the library, or is of a destroyed object or of another session. */
#define HRT_ERROR_INVALID_HANDLE (-2)
/** `struct_size` is smaller than the size that this library knows, larger than 4096, or not a multiple of the struct's
 *  alignment; or bytes beyond the known size are not zero. */
#define HRT_ERROR_STRUCT_SIZE (-3)
/** A value is outside its range or not finite, or values do not fit each other. */
#define HRT_ERROR_OUT_OF_RANGE (-4)
/** The call is not allowed in the present state, for example an update while no reach is in progress. */
#define HRT_ERROR_WRONG_STATE (-5)
/** Another thread is in a call on this session, person, scene or plate. */
#define HRT_ERROR_BUSY (-6)
/** `time_ns` is earlier than in the previous call of this reach, set-up or simulated person. */
#define HRT_ERROR_TIME_REVERSED (-7)
/** An allocation failed. */
#define HRT_ERROR_OUT_OF_MEMORY (-8)
/** The maximum number of sessions, targets, scenes, simulated people or plates exists already. */
#define HRT_ERROR_LIMIT_REACHED (-9)
/** The caller's buffer is too small for the output. */
#define HRT_ERROR_BUFFER_TOO_SMALL (-11)
/** The name is already taken by another target of the session. */
#define HRT_ERROR_NAME_TAKEN (-12)
/** A file could not be opened, read or written, or a thread could not be started. */
#define HRT_ERROR_SYSTEM (-13)
/** A file or text is malformed, or its version is not supported. */
#define HRT_ERROR_BAD_FORMAT (-14)
/** The samples so far do not suffice for the call. hrt_last_error() names what is missing. */
#define HRT_ERROR_INSUFFICIENT_DATA (-15)
/** A defect in this library. Please report it with the text of hrt_last_error(). */
#define HRT_ERROR_INTERNAL (-99)

/** Returns the name of a result.
 *
 *  @param result  Any number.
 *  @return Name such as "HRT_ERROR_BUSY", or "unknown result". Never null; valid as long as the library is loaded.
 *  @threadsafety [any-thread] */
HRT_API const char* hrt_result_string(hrt_result result) HRT_NOEXCEPT;

/** Returns the text of this thread's last failed call: one line, empty if no call has failed.
 *
 *  @return Text in UTF-8. Never null; valid until this thread's next failed call.
 *  @threadsafety [any-thread] */
HRT_API const char* hrt_last_error(void) HRT_NOEXCEPT;

/** Returns the version of the library; HRT_VERSION is that of the headers.
 *
 *  @param out_major  Receives the major version. Null is allowed for each of the three outputs.
 *  @threadsafety [any-thread] */
HRT_API void hrt_get_version(uint32_t* out_major, uint32_t* out_minor, uint32_t* out_patch) HRT_NOEXCEPT;

#if defined(__cplusplus)
}
#endif

#endif
