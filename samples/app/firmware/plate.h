/* Behaviour of the plate: processes each received line and, every millisecond, the inputs of the board
 * (plugin/src/plate/protocol.md). C11 without access to hardware, which samples/plate/firmware/main.c has. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "plugin/include/plate_driver/plate_text.h"
#include "samples/app/firmware/settings.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PLATE_FIRMWARE_VERSION "1.1.0"

/** Functions of the board, which the firmware calls. */
typedef struct PlateBoard {
  /** Queues a whole line. Returns false, and queues nothing, if the buffer is full. */
  bool (*send)(const char* line, uint8_t length);
  /** Starts to write the settings to EEPROM; the board calls plate_saved() at the end. */
  void (*save)(const uint8_t bytes[SETTINGS_BYTES]);
} PlateBoard;

/** Inputs that the board reads every millisecond. */
typedef struct PlateInputs {
  bool emergency_open; /**< the emergency stop is pressed, or its wire is broken */
  int16_t adc;         /**< reading of the sensor, 0 to 1023; negative before the first reading */
  int16_t supply_adc;  /**< half of the servo's supply voltage, 0 to 1023 for 0 to 5 V; negative: no reading yet */
} PlateInputs;

typedef enum PlateState {
  PLATE_RESTING,   /**< the plate holds its orientation, or has no pulses, until SET or HOME */
  PLATE_FOLLOWING, /**< the plate turns to the target and holds it, while lines of the host arrive */
  PLATE_LATCHED    /**< no pulses, after an emergency or a fault of servo, sensor or supply, until a HELLO */
} PlateState;

/** Bits of Plate::due: lines that must be sent to the host. */
enum { DUE_BOOT = 1, DUE_PLATE = 2, DUE_INFO = 4, DUE_SAVED = 8, DUE_AT = 16 };
enum { TEST_LINES = 7 }; /**< number of lines of a self-test */

/** Reasons of a stop, in the order of their words in answer.c. */
typedef enum PlateStop {
  PLATE_STOP_HOST,
  PLATE_STOP_HEARTBEAT,
  PLATE_STOP_LIMIT,
  PLATE_STOP_FAULT,
  PLATE_STOP_EMERGENCY,
  PLATE_STOP_STUCK,
  PLATE_STOP_SENSOR,
  PLATE_STOP_UNHOMED,
  PLATE_STOP_SUPPLY,
  PLATE_STOP_COUNT
} PlateStop;

/** State of one plate. Only the functions below change it, except loop_ms. */
typedef struct Plate {
  const PlateBoard* board;
  Settings settings;
  bool settings_preset; /**< EEPROM has no valid settings */
  LineBuffer buffer;
  PlateState state;
  PlateStop latched_by;

  int32_t position_microdeg;   /**< orientation that the present pulse commands */
  int32_t target_microdeg;     /**< orientation to which the pulse moves */
  int32_t step_microdeg;       /**< largest change of the pulse in a millisecond */
  int32_t max_lead_millideg;   /**< largest angle by which the pulse may be ahead of the measured orientation */
  bool pulses;                 /**< the servo gets pulses */
  bool homed;                  /**< the first pulse was at the measured position, or the homing has ended */
  uint16_t settle_ms;          /**< remaining time for the servo to reach the orientation of its first pulses */
  int32_t reading_256ths;      /**< smoothed reading of the sensor, times 256; negative before the first reading */
  int32_t measured_millideg;   /**< orientation at reading_256ths */
  bool is_held_back;           /**< the pulse waits, because it is ahead of the servo by max_lead_millideg */
  uint16_t blocked_ms;         /**< time for which the pulse has waited without a motion of the servo */
  int32_t moved_from_millideg; /**< earlier measured orientation, from which a motion is detected */
  int32_t near_millideg;       /**< measured orientation when the servo was last near the pulse */
  int32_t near_pulse_millideg; /**< orientation of the pulse at that time */
  uint16_t at_rest_ms;         /**< time since the pulse last moved, up to a limit */
  uint8_t open_ms;             /**< time since the contact of the emergency stop opened, up to a limit */
  bool emergency_open;         /**< the contact has been open for longer than noise lasts */
  int16_t supply_adc;
  uint8_t supply_low_ms; /**< time for which the servo's supply has been too low */
  bool supply_low;       /**< the supply has been too low for longer than a dip lasts */
  uint16_t loop_ms;      /**< longest time between two ticks; set by main.c */

  bool greeted;                /**< a host has sent HELLO since the reset */
  uint16_t session;            /**< token at the end of each line of the host; 0: the host uses no token */
  bool fast;                   /**< the speed is not limited until the next HELLO */
  uint16_t sequence;           /**< last accepted sequence number */
  uint16_t silent_ms;          /**< time since the last accepted line, up to a limit */
  uint16_t report_ms;          /**< time since the last AT, up to a limit */
  uint8_t error_ms;            /**< time until the next ERROR may be sent */
  LineError error;             /**< reason of the ERROR line that is due; LINE_OK: no such line is due */
  uint16_t due;                /**< bits DUE_* of lines that must be sent */
  uint16_t stops_due;          /**< bits of the STOPPED lines that must be sent: 1 << PlateStop */
  uint8_t conf_next, conf_end; /**< settings that must be sent: conf_next to conf_end - 1 */
  uint8_t test_next;           /**< next line of the self-test; TEST_LINES: no line is due */
} Plate;

/** Initializes the plate after a reset, without pulses. `saved`: settings of the EEPROM; null if they are not valid. */
void plate_start(Plate* plate, const PlateBoard* board, const Settings* saved);

void plate_receive(Plate* plate, char byte);

/** Processes the inputs, moves the pulse and sends lines. Call it every millisecond. */
void plate_tick(Plate* plate, const PlateInputs* inputs);

/** Notifies the firmware that the board has written the settings. `whole`: EEPROM returned the same bytes. */
void plate_saved(Plate* plate, bool whole);

/** True if a sensor measures the orientation, or if the plate was homed and has had pulses since. */
bool plate_orientation_is_known(const Plate* plate);

/** Orientation in thousandths of a degree: measured with a sensor, otherwise the orientation of the pulse. */
int32_t plate_orientation_millideg(const Plate* plate);

/** Width of the servo's next pulse in half microseconds; 0: no pulse. */
uint16_t plate_pulse_ticks(const Plate* plate);

/** Sends the lines that are due, as far as the board's buffer has space. plate_tick() calls it. Defined in answer.c. */
void send_due_lines(Plate* plate);

#ifdef __cplusplus
}
#endif
