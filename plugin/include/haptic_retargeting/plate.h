/*
 * Driver of the device that turns the plate: libhrt_plate, a separate library that is installed with the plugin.
 * The rules of base.h for calls, results, structs and threads apply; hrt_plate_last_error() has the text of an error.
 *
 * Example: turns a plate to 30 degrees.
 *
 *   #include <haptic_retargeting/plate.h>
 *   #include <stdio.h>
 *
 *   int main(int argc, char** argv) {
 *     hrt_plate plate = {0};
 *     hrt_plate_report report = {0};
 *     report.struct_size = sizeof report;
 *     if (hrt_plate_open(argc > 1 ? argv[1] : "serial:/dev/ttyACM0", NULL, &plate)) {
 *       puts(hrt_plate_last_error());
 *       return 1;
 *     }
 *     int failed = 0, arrived = 0;
 *     while (!failed && !arrived) { // your frame loop
 *       failed = hrt_plate_get(plate, &report) || report.state == HRT_PLATE_STATE_FAILED;
 *       if (failed || report.state != HRT_PLATE_STATE_READY) continue;
 *       failed = hrt_plate_set(plate, 30.0); // hrt_command::plate_orientation_deg
 *       arrived = report.orientation_deg > 29.5 && report.orientation_deg < 30.5;
 *     }
 *     if (failed) puts(report.fault != HRT_PLATE_FAULT_NONE ? report.message : hrt_plate_last_error());
 *     hrt_plate_close(plate);
 *     return failed;
 *   }
 *
 * A plate is opened by name:
 *
 * - `serial:/dev/ttyACM0`, `serial:COM3`: a plate that implements plugin/src/plate/protocol.md
 * - `dynamixel:/dev/ttyUSB0?id=1`: an XL330 servo under the plate, which uses Dynamixel Protocol 2.0
 * - `plate.json`: a file that the program `hrt-plate commission` wrote, with the device's name and measured properties
 *
 * Options of a Dynamixel servo, separated by '&': id (0 to 252, default 1), baud (57600, 115200 or 1000000, default
 * 57600), speed (degrees a second, 10 to 1000, default 300), effort (percent of the servo's stall current of
 * 1.47 A, 5 to 100, default 50). The current is also limited so that the force at the plate's rim, 75 mm from the axis,
 * is at most 4 N, calculated from the maker's stall torque.
 *
 * Each plate has one thread for its communication. Calls tagged [real-time] read the monotonic clock, which is a system
 * call on some systems. Only hrt_plate_close() waits for a device, for at most 0.5 s. A plate stops if the application
 * makes no calls (hrt_plate_options::host_timeout_ns), when it is closed, and when it fails. A failure is permanent:
 * close the plate and open it again. In the child of a fork, calls on a plate of the parent fail with WRONG_STATE;
 * closing the plate there only releases its handle. The end of the process closes all plates. On Windows, close plates
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

/** A plate's handle. Zero is never a plate. */
typedef struct hrt_plate {
  uint64_t value;
} hrt_plate;

/** @enumeration HRT_PLATE_HOMING Effect of hrt_plate_set() while the plate orientation is unknown
 *  (HRT_PLATE_REPORT_UNHOMED). */
typedef uint32_t hrt_plate_homing;
#define HRT_PLATE_HOMING_REFUSED 0u /**< hrt_plate_set() fails with WRONG_STATE */
/** The first hrt_plate_set() moves the plate slowly, for about 8 s. Keep fingers off the plate: a digital servo may
 *  nevertheless move at its full speed. */
#define HRT_PLATE_HOMING_SLOW 1u

/** Options of hrt_plate_open(). */
typedef struct hrt_plate_options {
  uint32_t struct_size;
  /** Effect of hrt_plate_set() while the orientation is unknown. A plate without a sensor needs HOMING_SLOW after its
   *  supply was switched on. @default HRT_PLATE_HOMING_REFUSED */
  hrt_plate_homing homing;
  /** Time without hrt_plate_set(), hrt_plate_stop() or hrt_plate_get() after which the plate stops at its present
   *  orientation, so that the plate does not keep moving if the application hangs. The next hrt_plate_set() moves the
   *  plate again. Raise the time for an application whose frames may take longer.
   *  @range 50 ms to 10 s @default 300 ms */
  int64_t host_timeout_ns;
} hrt_plate_options;

/** @enumeration HRT_PLATE_STATE State of a plate. */
typedef uint32_t hrt_plate_state;
#define HRT_PLATE_STATE_OPENING 1u /**< connecting: up to about 6 s, because many boards restart when opened */
#define HRT_PLATE_STATE_READY 2u   /**< accepts commands */
#define HRT_PLATE_STATE_FAILED 3u  /**< stopped, if it was still connected; hrt_plate_report::message has the reason */

/** @enumeration HRT_PLATE_FAULT Cause of a plate's failure. */
typedef uint32_t hrt_plate_fault;
#define HRT_PLATE_FAULT_NONE 0u      /**< no failure */
#define HRT_PLATE_FAULT_LINE 1u      /**< the serial port cannot be opened or configured, or is in use */
#define HRT_PLATE_FAULT_NO_ANSWER 2u /**< no device answers, or its description or settings differ from the file */
#define HRT_PLATE_FAULT_UNPLUGGED 3u /**< the serial port has disappeared, or accepts no data */
#define HRT_PLATE_FAULT_SILENT 4u    /**< the device has sent nothing for half a second */
#define HRT_PLATE_FAULT_NO_REPORT 5u /**< the device does not report its orientation */
#define HRT_PLATE_FAULT_LIMITS 6u    /**< the device reports an angle beyond its limits, or rejected such a command */
#define HRT_PLATE_FAULT_STUCK 7u     /**< the plate has not moved towards its command for a second */
#define HRT_PLATE_FAULT_RESTARTED 8u /**< the device restarted, or announced itself again */
#define HRT_PLATE_FAULT_EMERGENCY 9u /**< the emergency stop is pressed, or its wire is broken */
#define HRT_PLATE_FAULT_DEVICE 10u   /**< the device reports a fault, such as voltage, temperature or overload */
#define HRT_PLATE_FAULT_PROTOCOL 11u /**< the device does not follow the protocol, for example leaves out an answer */
#define HRT_PLATE_FAULT_INTERNAL 12u /**< memory is exhausted, or this library has a defect */

/** @flags HRT_PLATE_REPORT Content of a report, and warnings. */
typedef uint32_t hrt_plate_report_flags;
#define HRT_PLATE_REPORT_ORIENTATION 1u  /**< the orientation is known */
#define HRT_PLATE_REPORT_MEASURED 2u     /**< a sensor measures the orientation; without the flag, it is assumed */
#define HRT_PLATE_REPORT_ROUND_TRIP 4u   /**< hrt_plate_report::round_trip_ns was measured */
#define HRT_PLATE_REPORT_COMMANDED 8u    /**< the plate turns to a command, or holds it; otherwise, it is stopped */
#define HRT_PLATE_REPORT_HOST_SILENT 16u /**< hrt_plate_options::host_timeout_ns has stopped the plate */
/** The plate orientation is unknown (not homed): the plate has no sensor, and was switched on, reset, or stopped by its
 *  emergency stop or a loss of its servo's supply since the orientation was last known. */
#define HRT_PLATE_REPORT_UNHOMED 32u
#define HRT_PLATE_REPORT_FIRST_MOTION 64u  /**< the plate has reached no command since opening: keep fingers off */
#define HRT_PLATE_REPORT_COMMISSIONED 128u /**< speed, acceleration and latency are from the plate's file */
/** The plate differs from its file: it is slower than 80 % of the file's speed, it has rested for a second further from
 *  its command than the file's error, or it follows commands more than 40 ms later than the file's latency. Commission
 *  the plate again. */
#define HRT_PLATE_REPORT_DEVIATES 256u

/** State and properties of a plate. Numbers are 0 while they are unknown. */
typedef struct hrt_plate_report {
  uint32_t struct_size;
  /** State of the plate. */
  hrt_plate_state state;
  /** Cause of the failure. */
  hrt_plate_fault fault;
  /** Content of the report, and warnings. */
  hrt_plate_report_flags flags;
  /** Last reported plate orientation, from -360 to 360. Copy it to hrt_sample::plate_orientation_deg. @ccw */
  double orientation_deg;
  /** Orientation of the last command, after the choice of an equivalent orientation within the stops. @ccw */
  double command_deg;
  /** Time since the last report of the orientation was received. */
  int64_t age_ns;
  /** Time from a command to the plate's motion: latency of the plate plus half of the round trip. */
  int64_t latency_ns;
  /** Median time from a message to its answer at the serial port. */
  int64_t round_trip_ns;
  /** Maximum speed of the plate: that of its settings or its file, or the observed speed if that is lower. */
  double max_speed_deg_s;
  /** Maximum acceleration that `hrt-plate commission` measured; 0 if the plate was not opened by its file. */
  double max_acceleration_deg_s2;
  /** Lower stop; for a Dynamixel servo, which has no stop, the driver's limit of -360. @ccw */
  double lower_stop_deg;
  /** Upper stop; for a Dynamixel servo, the driver's limit of 360. @ccw */
  double upper_stop_deg;
  /** Number of messages that the plate rejected or that were damaged in transmission. */
  uint64_t refused_messages;
  /** Name of the device in one line of UTF-8: "protocol 2, firmware 1.1.0, serial number 000042". */
  char description[128];
  /** Reason of a failure, in one line of UTF-8: "the plate at /dev/ttyACM0 is unplugged". */
  char message[256];
} hrt_plate_report;

/** Starts to open a plate, and returns without waiting for the device; hrt_plate_get() reports when the plate is ready,
 *  or why it failed.
 *  Opening does not move the plate. Until the first hrt_plate_set(), a Dynamixel holds its position. A hobby servo gets
 *  no pulse and exerts no force, or holds its orientation if the board still sends the pulses of an earlier session.
 *
 *  @param device     Name of the plate; see the beginning of this file.
 *  @param options    Options, copied. Null: the defaults.
 *  @param out_plate  Handle of the plate.
 *  @return OUT_OF_RANGE for a malformed name or file, or naming a field of `options`; LIMIT_REACHED for more than 16
 *          plates; OUT_OF_MEMORY; SYSTEM if the file cannot be read or no thread can be started.
 *  @threadsafety [any-thread] */
HRT_NODISCARD HRT_PLATE_API hrt_result hrt_plate_open(const char* device, const hrt_plate_options* options,
                                                      hrt_plate* out_plate) HRT_NOEXCEPT;

/** Turns the plate to the orientation that is nearest to the present one and has the same ridges as the given one: they
 *  repeat every 180 degrees. If the stops allow no such orientation, turns the plate to the nearest stop. The plate
 *  holds its orientation until the next command. The command is sent within 5 ms, to a Dynamixel servo within 20 ms,
 *  unless the computer is busy.
 *
 *  @param orientation_deg  Plate orientation. @range -1e6 to 1e6 @ccw
 *  @return OUT_OF_RANGE naming orientation_deg; WRONG_STATE if the plate is not READY, or if it is UNHOMED and
 *          hrt_plate_options::homing is not HRT_PLATE_HOMING_SLOW.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_PLATE_API hrt_result hrt_plate_set(hrt_plate plate, double orientation_deg) HRT_NOEXCEPT;

/** Stops the plate, which then holds its present orientation.
 *
 *  @return WRONG_STATE if the plate is not READY.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_PLATE_API hrt_result hrt_plate_stop(hrt_plate plate) HRT_NOEXCEPT;

/** Returns the state of the plate. Call it every frame: calls also show that the application does not hang
 *  (hrt_plate_options::host_timeout_ns).
 *
 *  @param out_report  State and properties.
 *  @return WRONG_STATE in the child of a fork.
 *  @threadsafety [real-time] */
HRT_NODISCARD HRT_PLATE_API hrt_result hrt_plate_get(hrt_plate plate, hrt_plate_report* out_report) HRT_NOEXCEPT;

/** Stops the plate, restores the settings of its serial port, and ends its thread within 0.5 s.
 *
 *  @param plate  Plate. Null is allowed.
 *  @threadsafety [one-thread] */
HRT_PLATE_API hrt_result hrt_plate_close(hrt_plate plate) HRT_NOEXCEPT;

/** Returns the text of this thread's last failed call of this library: one line, empty if no call has failed.
 *
 *  @return Text in UTF-8. Never null; valid until this thread's next failed call.
 *  @threadsafety [any-thread] */
HRT_PLATE_API const char* hrt_plate_last_error(void) HRT_NOEXCEPT;

/** Copies speed, acceleration, latency and stops of a READY plate into a configuration. A configuration cannot have
 *  stops that are less than 180 degrees apart: instead of such stops, both are set to 0, as for a plate that turns
 *  freely.
 *
 *  @threadsafety [any-thread] */
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
