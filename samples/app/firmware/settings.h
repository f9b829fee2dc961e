/* What differs from plate to plate, kept in EEPROM. C11 without a library. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Shortest and longest pulse that leaves the board. */
enum { PULSE_LEAST_US = 500, PULSE_MOST_US = 2500 };

/** Every setting has a name for CONF lines, a range and a default (settings.c). */
typedef enum Setting {
  SETTING_ZERO_US, /**< pulse at orientation 0: the trim */
  SETTING_SPAN_US, /**< change of the pulse over 180 degrees; negative: the servo turns clockwise */
  SETTING_MIN_DEG, /**< limits of the orientation */
  SETTING_MAX_DEG,
  SETTING_SPEED_DEG_S, /**< speed of the motion */
  SETTING_LATENCY_MS,  /**< from a line to the servo's motion: half of a frame and the servo's dead time */
  SETTING_ADC_LEAST,   /**< readings of the sensor at the two limits; equal: there is none */
  SETTING_ADC_MOST,
  SETTING_EMERGENCY, /**< 1: the emergency stop's contact must be closed; 0: there is none */
  SETTING_SUPPLY,    /**< 1: the servo's supply is sensed, and must be there; 0: it is not sensed */
  SETTING_BEND_0,    /**< error of the sensor's line at `least` + (`most` - `least`) * i / BEND_PARTS, subtracted */
  SETTING_BEND_LAST = SETTING_BEND_0 + 8,
  SETTING_SERIAL, /**< serial number */
  SETTING_COUNT
} Setting;

enum { BEND_PARTS = SETTING_BEND_LAST - SETTING_BEND_0 };

/** Values in hundredths of each setting's unit. */
typedef struct Settings {
  int32_t value[SETTING_COUNT];
} Settings;

/** As they are kept in EEPROM: mark, version, values, CRC-16, all little-endian. */
enum { SETTINGS_BYTES = 4 + 4 * SETTING_COUNT + 2 };

const char* setting_name(Setting setting);
/** The setting of this name; SETTING_COUNT if there is none. */
Setting setting_named(const char* name);

Settings settings_default(void);
/** True if every value is in its range and all fit together. */
bool settings_valid(const Settings* settings);

void settings_pack(const Settings* settings, uint8_t bytes[SETTINGS_BYTES]);
/** False, and `settings` untouched, unless the bytes are whole and the settings valid. */
bool settings_unpack(Settings* settings, const uint8_t bytes[SETTINGS_BYTES]);

/** Pulse for an orientation, in half microseconds, rounded and within the range of pulses. */
uint16_t settings_pulse_ticks(const Settings* settings, int32_t orientation_millideg);

/** The limits, hundredths of a degree: those of the settings as far as pulses reach. */
int32_t settings_least(const Settings* settings);
int32_t settings_most(const Settings* settings);

/** Speed of the motion, in hundredths of a degree a second. Without a sensor at most 60 degrees a second, which every
 * hobby servo can follow: the pulse of a slower one would run ahead, and the servo would run on after a stop. */
int32_t settings_speed(const Settings* settings);

bool settings_has_feedback(const Settings* settings);
/** Orientation in thousandths of a degree, within a turn, at this reading of the potentiometer, times 16. */
int32_t settings_measured_millideg(const Settings* settings, uint16_t reading_16ths);

#ifdef __cplusplus
}
#endif
