#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Widths of the shortest and of the longest pulse that the board sends. */
enum { PULSE_MIN_US = 500, PULSE_MAX_US = 2500 };

/** Settings of a plate, stored in EEPROM. settings.c has their names in CONF lines, their ranges and their defaults. */
typedef enum Setting {
  SETTING_ZERO_US,     /**< width of the pulse at orientation 0 */
  SETTING_SPAN_US,     /**< change of the pulse width over 180 degrees; negative: longer pulses turn clockwise */
  SETTING_MIN_DEG,     /**< lower limit of the orientation */
  SETTING_MAX_DEG,     /**< upper limit of the orientation */
  SETTING_SPEED_DEG_S, /**< speed of the motion */
  SETTING_LATENCY_MS,  /**< time from a command to the servo's motion: half of the pulse period and the dead time */
  SETTING_ADC_AT_MIN,  /**< reading of the sensor at the lower limit */
  SETTING_ADC_AT_MAX,  /**< reading at the upper limit; equal to that at the lower limit if there is no sensor */
  SETTING_EMERGENCY,   /**< 1: the emergency stop's contact must be closed; 0: there is no emergency stop */
  SETTING_SUPPLY,      /**< 1: the servo's supply is measured at A1 and must be present; 0: it is not measured */
  SETTING_BEND_0,      /**< bend i: error of the sensor at i / BEND_PARTS of its range of readings; is subtracted */
  SETTING_BEND_LAST = SETTING_BEND_0 + 8,
  SETTING_SERIAL, /**< serial number, which identifies the plate in its plate file */
  SETTING_COUNT
} Setting;

enum { BEND_PARTS = SETTING_BEND_LAST - SETTING_BEND_0 };

/** Values of all settings, in hundredths of the unit of each. */
typedef struct Settings {
  int32_t value[SETTING_COUNT];
} Settings;

/** Size in EEPROM: mark, version, values, CRC-16, all little-endian. */
enum { SETTINGS_BYTES = 4 + 4 * SETTING_COUNT + 2 };

const char* setting_name(Setting setting);
/** Returns the setting of this name; SETTING_COUNT if no setting has it. */
Setting setting_named(const char* name);

Settings settings_default(void);
/** True if every value is in its range and the values are consistent. */
bool settings_valid(const Settings* settings);

/** Converts the settings to the bytes that EEPROM stores. */
void settings_pack(const Settings* settings, uint8_t bytes[SETTINGS_BYTES]);
/** Reads the bytes of settings_pack(). Returns false, and leaves `settings` unchanged, unless all of them are valid. */
bool settings_unpack(Settings* settings, const uint8_t bytes[SETTINGS_BYTES]);

/** Returns the pulse for an orientation, in half microseconds, rounded and within the range of pulses. */
uint16_t settings_pulse_ticks(const Settings* settings, int32_t orientation_millideg);

/** Limits in hundredths of a degree: the settings, or the orientations at PULSE_MIN_US and PULSE_MAX_US if narrower. */
int32_t settings_lower_limit(const Settings* settings);
int32_t settings_upper_limit(const Settings* settings);

/** Speed of the motion, in hundredths of a degree a second. Without a sensor it is at most 60 degrees a second, because
 * a servo that lagged behind its pulse would continue to turn after a stop. */
int32_t settings_speed(const Settings* settings);

bool settings_has_feedback(const Settings* settings);
/** Orientation in thousandths of a degree, within +-360000, at the reading reading_16ths / 16. Requires a sensor. */
int32_t settings_measured_millideg(const Settings* settings, uint16_t reading_16ths);

#ifdef __cplusplus
}
#endif
