/*
 * The device that turns the plate, without serial code in the engine: libhrt_plate, a library of its own
 * beside the plugin. Contract, results, structs and thread tags are those of base.h; errors of these calls
 * have their text in hrt_plate_last_error().
 *
 * A plate is opened by name:
 *
 * - `serial:/dev/ttyACM0`, `serial:COM3`: a plate with the line protocol of samples/plate/protocol.md
 * - `dynamixel:/dev/ttyUSB0?id=1`: an XL330 servo under the plate, by Dynamixel Protocol 2.0
 * - `plate.json`: the file of `hrt-plate commission`, which has the name of its device, and what was measured
 *
 * Options of a servo, separated by '&': id (0 to 252, default 1), baud (57600, 115200 or 1000000, default
 * 57600), speed (degrees a second, 10 to 1000, default 300), effort (percent of the servo's limit of current,
 * 5 to 100, default 50; never more than 5 N at the plate's rim, 75 mm from its axis).
 *
 * One thread a plate talks to it. No call waits for a device, except hrt_plate_close(), 0.5 s at most.
 * A plate stops when the host is silent (hrt_plate_options::host_timeout_ns), when it is closed, and when it
 * fails; a plate that has failed stays so: close it and open it again. In the child of a fork a plate cannot
 * be used; closing it there only forgets it. The end of the process closes all plates. On Windows close them
 * before the library is unloaded.
 */
#ifndef HAPTIC_RETARGETING_PLATE_H
#define HAPTIC_RETARGETING_PLATE_H

#include "haptic_retargeting/base.h"
#include "haptic_retargeting/session.h"

#if defined(_WIN32) && defined(HRT_BUILDING_PLATE)
#define HRT_PLATE_API __declspec(dllexport)
#elif defined(_WIN32)
#define HRT_PLATE_API __declspec(dllimport)
#elif defined(__GNUC__)
#define HRT_PLATE_API __attribute__((visibility("default")))
#else
#define HRT_PLATE_API
#endif

#if defined(__cplusplus)
extern "C" {
#endif

/** A plate. Zero is never one. */
typedef struct hrt_plate {
  uint64_t value;
} hrt_plate;

/** What hrt_plate_set() does while HRT_PLATE_REPORT_UNHOMED is set. */
#define HRT_PLATE_HOMING_REFUSED 0u /**< refuses with WRONG_STATE */
#define HRT_PLATE_HOMING_SLOW                                                                              \
  1u /**< the plate goes to the orientation of the first call, slowly, in about 8 s: no finger on it. Many \
      * servos turn slowly then; a digital one may go there at its full speed. */

/** How to treat a plate. */
typedef struct hrt_plate_options {
  uint32_t struct_size;
  /** HRT_PLATE_HOMING_*. Default HRT_PLATE_HOMING_REFUSED. */
  uint32_t homing;
  /** After this time without hrt_plate_set(), hrt_plate_stop() or hrt_plate_get() the plate stops where it
   * is: an application that hangs leaves no moving plate. The next hrt_plate_set() moves it again. 50 ms to
   * 10 s. Default 300 ms. */
  int64_t host_timeout_ns;
} hrt_plate_options;

/** What a plate is doing. */
#define HRT_PLATE_STATE_OPENING 1u /**< being greeted: up to 6 s, because boards start when their line is opened */
#define HRT_PLATE_STATE_READY 2u   /**< takes commands */
#define HRT_PLATE_STATE_FAILED 3u  /**< was stopped if it still heard; hrt_plate_report::message has the reason */

/** Why a plate has failed. */
#define HRT_PLATE_FAULT_NONE 0u      /**< it has not failed */
#define HRT_PLATE_FAULT_LINE 1u      /**< the line cannot be opened or set up, or is in use */
#define HRT_PLATE_FAULT_NO_ANSWER 2u /**< nothing answers as such a plate */
#define HRT_PLATE_FAULT_UNPLUGGED 3u /**< the line is gone, or takes nothing in */
#define HRT_PLATE_FAULT_SILENT 4u    /**< not heard for half a second */
#define HRT_PLATE_FAULT_NO_REPORT 5u /**< does not report its orientation */
#define HRT_PLATE_FAULT_LIMITS 6u    /**< reports an angle beyond its limits, or refused one */
#define HRT_PLATE_FAULT_STUCK 7u     /**< commanded, and not moving */
#define HRT_PLATE_FAULT_RESTARTED 8u /**< restarted, or announced itself anew */
#define HRT_PLATE_FAULT_EMERGENCY 9u /**< its emergency stop is open */
#define HRT_PLATE_FAULT_DEVICE 10u   /**< reports a fault: voltage, temperature, overload ... */
#define HRT_PLATE_FAULT_PROTOCOL 11u /**< answers what the protocol does not allow */
#define HRT_PLATE_FAULT_INTERNAL 12u /**< out of memory, or a defect of this library */

/** What a report holds. */
#define HRT_PLATE_REPORT_ORIENTATION 1u  /**< the orientation is known */
#define HRT_PLATE_REPORT_MEASURED 2u     /**< by a sensor; else it is assumed from the commands */
#define HRT_PLATE_REPORT_ROUND_TRIP 4u   /**< the line was measured */
#define HRT_PLATE_REPORT_COMMANDED 8u    /**< a command holds; else the plate stays where it is */
#define HRT_PLATE_REPORT_HOST_SILENT 16u /**< stopped by hrt_plate_options::host_timeout_ns */
#define HRT_PLATE_REPORT_UNHOMED                                                                            \
  32u /**< nobody knows where the plate stands: it has no sensor, and was switched on, reset, or stopped by \
       * its emergency stop since it last knew */
#define HRT_PLATE_REPORT_FIRST_MOTION 64u  /**< it has not come to a command since it was opened: keep fingers off */
#define HRT_PLATE_REPORT_COMMISSIONED 128u /**< latency and speed are those of the file */
#define HRT_PLATE_REPORT_DEVIATES                                                                        \
  256u /**< it turned slower than 80 % of what the file says, or rests farther from its command than its \
        * error and three deviations, for a second: commission it anew */

/** What is known of a plate. All numbers are finite, and 0 while they are unknown. */
typedef struct hrt_plate_report {
  uint32_t struct_size;
  /** What it is doing: HRT_PLATE_STATE_*. */
  uint32_t state;
  /** Why it has failed: HRT_PLATE_FAULT_*. */
  uint32_t fault;
  /** What the report holds: HRT_PLATE_REPORT_*. */
  uint32_t flags;
  /** As last reported, degrees, -360 to 360; base.h defines it. For hrt_sample::plate_orientation_deg. */
  double orientation_deg;
  /** Orientation that was last sent, within the stops. */
  double command_deg;
  /** Time since the report of the orientation arrived. */
  int64_t age_ns;
  /** From a command to the plate's motion: the plate's own, and half of the round trip. For
   *  hrt_session_config::plate.latency_ns, if it is not 0. */
  int64_t latency_ns;
  /** Of a message and its answer on the line, median. */
  int64_t round_trip_ns;
  /** The plate's own, or less if it was seen to turn slower. For
   *  hrt_session_config::plate.max_speed_deg_s. */
  double max_speed_deg_s;
  /** As measured by `hrt-plate commission`; 0 without its file. For
   *  hrt_session_config::plate.max_acceleration_deg_s2. */
  double max_acceleration_deg_s2;
  /** Stops, or both 0 if the plate turns freely. For hrt_session_config, if they are 180 degrees apart or
   * more. */
  double lower_stop_deg;
  double upper_stop_deg;
  /** Messages that the plate refused, or that were damaged on their way. */
  uint64_t refused_messages;
  /** The device, in one line of UTF-8: "protocol 2, firmware 1.0.0, serial number 000042". */
  char description[128];
  /** Why the plate has failed, in one line of UTF-8: "the plate at /dev/ttyACM0 is unplugged". */
  char message[256];
} hrt_plate_report;

/** Starts to open the plate named `device`, and returns at once: hrt_plate_get() has the state, and whether
 * it failed. `options` may be null: defaults. Opening moves nothing: until the first hrt_plate_set() a hobby
 * servo gets no pulse and is without force, a Dynamixel holds its place.
 * Errors: OUT_OF_RANGE (a malformed name or file, with what is allowed), LIMIT_REACHED (16 plates),
 * OUT_OF_MEMORY, SYSTEM (no thread). [any-thread] */
HRT_NODISCARD HRT_PLATE_API hrt_result hrt_plate_open(const char* device, const hrt_plate_options* options,
                                                      hrt_plate* out_plate) HRT_NOEXCEPT;

/** Turns the plate to this orientation, -1e6 to 1e6 degrees, or to one that feels the same (ridges repeat
 *  every 180 degrees): the nearest within the stops; if there is none, the nearest stop. Holds until the next
 *  one, or hrt_plate_stop(). Sent within 5 ms, unless the computer is busy. Errors: WRONG_STATE unless the
 * plate is READY, and while it is UNHOMED, unless hrt_plate_options::homing is HRT_PLATE_HOMING_SLOW.
 * [real-time] */
HRT_NODISCARD HRT_PLATE_API hrt_result hrt_plate_set(hrt_plate plate, double orientation_deg) HRT_NOEXCEPT;

/** Stops the plate where it is; it holds. Errors: as hrt_plate_set(). [real-time] */
HRT_NODISCARD HRT_PLATE_API hrt_result hrt_plate_stop(hrt_plate plate) HRT_NOEXCEPT;

/** Fills `*out_report`. Set its `struct_size` before the call. Reads the monotonic clock. [real-time] */
HRT_NODISCARD HRT_PLATE_API hrt_result hrt_plate_get(hrt_plate plate, hrt_plate_report* out_report) HRT_NOEXCEPT;

/** Stops the plate, restores its line, and ends its thread: within 0.5 s. Null is allowed. [one-thread] */
HRT_PLATE_API hrt_result hrt_plate_close(hrt_plate plate) HRT_NOEXCEPT;

/** Returns the text of this thread's last failed call of this library: one line of English, empty if no call
 * has failed. Never null; valid until this thread's next failed call. [any-thread] */
HRT_PLATE_API const char* hrt_plate_last_error(void) HRT_NOEXCEPT;

/** Fills speed, acceleration, latency and stops of a READY plate in; stops that are less than 180 degrees
 * apart stay out. [any-thread] */
static inline void hrt_session_config_from_plate(hrt_session_config* config, const hrt_plate_report* report) {
  const int has_stops = report->upper_stop_deg - report->lower_stop_deg >= 180.0;
  config->plate.max_speed_deg_s = report->max_speed_deg_s;
  config->plate.max_acceleration_deg_s2 = report->max_acceleration_deg_s2;
  config->plate.latency_ns = report->latency_ns;
  config->plate.lower_stop_deg = has_stops ? report->lower_stop_deg : 0.0;
  config->plate.upper_stop_deg = has_stops ? report->upper_stop_deg : 0.0;
}

#if defined(__cplusplus)
}
#endif

#endif
