/* Behaviour of the plate on each line, each millisecond and each input (plugin/src/plate/protocol.md). C11 without a
 * library or hardware; main.c provides the board. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "samples/app/firmware/line.h"
#include "samples/app/firmware/settings.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PLATE_FIRMWARE_VERSION "1.1.0"

/** Functions that the board provides. */
typedef struct PlateBoard {
  /** Queues a whole line. Returns false, and queues nothing, if the buffer is full. */
  bool (*send)(const char* line, uint8_t length);
  /** Starts to write the settings to EEPROM; the board calls plate_saved() at the end. */
  void (*save)(const uint8_t bytes[SETTINGS_BYTES]);
} PlateBoard;

/** Inputs of the board, once a millisecond. */
typedef struct PlateInputs {
  bool emergency_open; /**< the emergency stop is pressed, or its wire is broken */
  int16_t adc;         /**< reading of the sensor, 0 to 1023; negative: no reading yet */
  int16_t supply_adc;  /**< reading of half of the servo's supply; negative: no reading yet */
} PlateInputs;

typedef enum PlateState {
  PLATE_RESTING,   /**< holds its orientation; SET moves it */
  PLATE_FOLLOWING, /**< turns to the target and holds it, while heartbeats arrive */
  PLATE_LATCHED    /**< no pulses after an emergency, or a fault of servo or supply; only HELLO ends it */
} PlateState;

/** Bits of the lines that are due to the host; and the number of lines of a self-test. */
enum { DUE_BOOT = 1, DUE_PLATE = 2, DUE_INFO = 4, DUE_SAVED = 8, DUE_AT = 16 };
enum { TEST_LINES = 7 };

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

/** State of one plate. Tests may read it; only the functions change it. */
typedef struct Plate {
  const PlateBoard* board;
  Settings settings;
  bool settings_preset; /**< EEPROM had no valid settings */
  LineBuffer buffer;
  PlateState state;
  PlateStop latched_by;

  int32_t position_microdeg; /**< orientation of the pulse */
  int32_t target_microdeg;
  int32_t step_microdeg;     /**< largest change of the pulse in a millisecond */
  int32_t max_lead_millideg; /**< largest lead of the pulse over the sensor */
  bool pulses;
  bool homed;                  /**< the servo has had the time to reach position_microdeg */
  uint16_t settle_ms;          /**< remaining time in which the servo reaches its first pulses */
  int32_t reading_256ths;      /**< smoothed reading of the sensor; negative: no reading yet */
  int32_t measured_millideg;   /**< orientation at that reading */
  bool is_held_back;           /**< the pulse waits at its largest lead over the servo */
  uint16_t blocked_ms;         /**< duration of this wait without a motion */
  int32_t moved_from_millideg; /**< measured orientation at the last motion */
  int32_t near_millideg;       /**< measured orientation when the pulse was last near it */
  int32_t near_pulse_millideg; /**< orientation of the pulse at that time */
  uint16_t at_rest_ms;         /**< time since the pulse last moved, up to a limit */
  uint8_t open_ms;             /**< time since the emergency stop's contact opened */
  bool emergency_open;
  int16_t supply_adc;
  uint8_t supply_low_ms; /**< time for which the servo's supply has been too low */
  bool supply_low;
  uint16_t loop_ms; /**< longest time between two ticks; set by main.c */

  bool greeted;       /**< a host has greeted the plate since the reset */
  uint16_t session;   /**< token of that host at the end of its lines; 0: no token */
  bool fast;          /**< the speed of motions is not limited until the next greeting */
  uint16_t sequence;  /**< last accepted sequence number */
  uint16_t silent_ms; /**< time since the last valid line */
  uint16_t report_ms; /**< time since the last AT */
  uint8_t error_ms;   /**< time until the next ERROR may be sent */
  LineError error;
  uint16_t due;       /**< lines to send: DUE_* */
  uint16_t stops_due; /**< bits of PlateStop */
  uint8_t conf_next, conf_end;
  uint8_t test_next;
} Plate;

/** Initializes the plate after a reset, without pulses. `saved`: settings of the EEPROM; null if they are not valid. */
void plate_start(Plate* plate, const PlateBoard* board, const Settings* saved);

/** Processes a byte from the host. */
void plate_receive(Plate* plate, char byte);

/** Processes the inputs. Call it once a millisecond. */
void plate_tick(Plate* plate, const PlateInputs* inputs);

/** Reports that the settings were written. `whole`: they were read back without a difference. */
void plate_saved(Plate* plate, bool whole);

/** True if the orientation is known: from a sensor, or because the plate was homed and has had pulses since. */
bool plate_knows_place(const Plate* plate);

/** Orientation in thousandths of a degree: measured with a sensor, otherwise the orientation of the pulse. */
int32_t plate_place_millideg(const Plate* plate);

/** Width of the servo's next pulse in half microseconds; 0: no pulse. */
uint16_t plate_pulse_ticks(const Plate* plate);

/** Sends the lines that are due, once a millisecond. Lines that find the buffer full are sent later. Defined in
 * answer.c. */
void answer(Plate* plate);

#ifdef __cplusplus
}
#endif
