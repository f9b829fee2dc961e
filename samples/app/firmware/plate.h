/* The plate's behaviour: what it does on each line, on each millisecond and on its inputs
 * (plugin/src/plate/protocol.md). C11 without a library or hardware; main.c gives it the board. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "samples/app/firmware/line.h"
#include "samples/app/firmware/settings.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PLATE_FIRMWARE_VERSION "1.1.0"

/** What the board does for the plate. */
typedef struct PlateBoard {
  /** Queues a whole line, or nothing: false if there is no room now. */
  bool (*send)(const char* line, uint8_t length);
  /** Begins to write the settings to EEPROM; plate_saved() reports the end. */
  void (*save)(const uint8_t bytes[SETTINGS_BYTES]);
} PlateBoard;

/** What the board reads, once a millisecond. */
typedef struct PlateInputs {
  bool emergency_open; /**< the emergency stop's contact is open: pressed, or its wire is broken */
  int16_t adc;         /**< reading of the sensor, 0 to 1023; negative: none yet */
  int16_t supply_adc;  /**< reading of half of the servo's supply; negative: none yet */
} PlateInputs;

typedef enum PlateState {
  PLATE_RESTING,   /**< holds its place; SET moves it */
  PLATE_FOLLOWING, /**< turns to the target and holds it, while the host is heard */
  PLATE_LATCHED    /**< no pulses after an emergency, or a fault of servo or supply; only HELLO ends it */
} PlateState;

/** Lines to the host that are due, as bits; and how many those of a self-test are. */
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

/** All of one plate's state. Read it in tests; change it through the functions. */
typedef struct Plate {
  const PlateBoard* board;
  Settings settings;
  bool settings_preset; /**< none were in EEPROM */
  LineBuffer buffer;
  PlateState state;
  PlateStop latched_by;

  int32_t position_microdeg; /**< of the motion, as the pulse has it */
  int32_t target_microdeg;
  int32_t step_microdeg;     /**< of the motion in a millisecond */
  int32_t max_lead_millideg; /**< of the pulse over the sensor */
  bool pulses;
  bool homed;                  /**< the servo is at position_microdeg, as far as a blind plate can know */
  uint16_t settle_ms;          /**< until the servo is where the first pulses send it */
  int32_t reading_256ths;      /**< of the sensor, smoothed; negative: none yet */
  int32_t measured_millideg;   /**< place at that reading */
  bool is_held_back;           /**< the pulse waits for the servo, which it would lead by too much */
  uint16_t blocked_ms;         /**< time of that without a motion */
  int32_t moved_from_millideg; /**< measured place at the last motion */
  int32_t near_millideg;       /**< measured place when the pulse last did not wait */
  int32_t near_pulse_millideg; /**< the pulse at that time */
  uint16_t at_rest_ms;         /**< time since the pulse last moved, up to a limit */
  uint8_t open_ms;             /**< since the emergency stop's contact opened */
  bool emergency_open;
  int16_t supply_adc;
  uint8_t supply_low_ms; /**< time for which the servo's supply has been too low */
  bool supply_low;
  uint16_t loop_ms; /**< longest time between two ticks: main.c */

  bool greeted;       /**< by a host, since the reset */
  uint16_t session;   /**< token of that host, which its lines end with; 0: they have none */
  bool fast;          /**< the motion has no limit of its own until the next greeting */
  uint16_t sequence;  /**< last one that was taken in */
  uint16_t silent_ms; /**< since the last valid line */
  uint16_t report_ms; /**< since the last AT */
  uint8_t error_ms;   /**< until the next ERROR may be sent */
  LineError error;
  uint16_t due;       /**< lines to send: DUE_* */
  uint16_t stops_due; /**< bits of PlateStop */
  uint8_t conf_next, conf_end;
  uint8_t test_next;
} Plate;

/** The plate after a reset: no pulses. `saved`: what EEPROM holds; null: nothing valid. */
void plate_start(Plate* plate, const PlateBoard* board, const Settings* saved);

/** A byte from the host. */
void plate_hear(Plate* plate, char byte);

/** Call once a millisecond. */
void plate_tick(Plate* plate, const PlateInputs* inputs);

/** The settings were written and read back; `whole`: without a difference. */
void plate_saved(Plate* plate, bool whole);

/** True if plate_place_millideg() is known: by a sensor, or because the plate was homed and has had pulses
 * since. */
bool plate_knows_place(const Plate* plate);

/** Where the plate is, in thousandths of a degree: measured if it has a sensor, else as its motion has it. */
int32_t plate_place_millideg(const Plate* plate);

/** Width of the servo's next pulse in half microseconds; 0: no pulse. */
uint16_t plate_pulse_ticks(const Plate* plate);

/** Of answer.c, for plate.c: sends what is due, once a millisecond; what finds no room waits for the next
 * one. */
void answer(Plate* plate);

#ifdef __cplusplus
}
#endif
