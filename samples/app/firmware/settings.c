#include "samples/app/firmware/settings.h"

#include <string.h>

#include "plugin/include/plate_driver/crc16.h"

typedef struct Range {
  char name[10];
  bool whole; /* without decimals */
  int32_t min, max, preset;
} Range;

/* clang-format off */
#define BEND(i) {"bend_" #i, false,          -1000,              1000,      0}
static const Range ranges[SETTING_COUNT] = {
    {"zero",      true,                  50000,             250000, 150000},
    {"span",      true,                -250000,             250000, 200000},
    {"least",     false,                -18000,                  0,  -4500},
    {"most",      false,                     0,              18000,   4500},
    {"speed",     true,                    100,             100000,  20000},
    {"latency",   true,                      0,              20000,   3000},
    {"adc_least", true,                      0,             102300,      0},
    {"adc_most",  true,                      0,             102300,      0},
    {"emergency", true,                      0,                100,    100},
    {"supply",    true,                      0,                100,    100},
    BEND(0), BEND(1), BEND(2), BEND(3), BEND(4), BEND(5), BEND(6), BEND(7), BEND(8),
    {"serial",    true,                      0,           99999900,      0},
};
/* clang-format on */

static const int32_t min_span = 50000, min_adc_span = 5000;
static const int32_t max_unmeasured_speed = 6000;

enum { VERSION = 2 };

const char* setting_name(Setting setting) { return ranges[setting].name; }

Setting setting_named(const char* name) {
  uint8_t setting = 0;
  while (setting < SETTING_COUNT && strcmp(name, ranges[setting].name) != 0) ++setting;
  return (Setting)setting;
}

Settings settings_default(void) {
  Settings settings;
  for (int i = 0; i < SETTING_COUNT; ++i) settings.value[i] = ranges[i].preset;
  return settings;
}

bool settings_valid(const Settings* settings) {
  for (int i = 0; i < SETTING_COUNT; ++i) {
    const int32_t value = settings->value[i];
    if (value < ranges[i].min || value > ranges[i].max) return false;
    if (ranges[i].whole && value % 100 != 0) return false;
  }
  const int32_t span = settings->value[SETTING_SPAN_US];
  if (span > -min_span && span < min_span) return false;
  if (settings->value[SETTING_MAX_DEG] - settings->value[SETTING_MIN_DEG] < 100) return false;
  const int32_t adc = settings->value[SETTING_ADC_AT_MAX] - settings->value[SETTING_ADC_AT_MIN];
  return adc == 0 || adc <= -min_adc_span || adc >= min_adc_span;
}

void settings_pack(const Settings* settings, uint8_t bytes[SETTINGS_BYTES]) {
  bytes[0] = 'H';
  bytes[1] = 'R';
  bytes[2] = 'P';
  bytes[3] = VERSION;
  uint8_t* end = bytes + 4;
  for (int i = 0; i < SETTING_COUNT; ++i) {
    uint32_t value = (uint32_t)settings->value[i];
    for (uint8_t k = 0; k < 4; ++k, value >>= 8) *end++ = (uint8_t)value;
  }
  const unsigned crc = crc16_ccitt((const char*)bytes, SETTINGS_BYTES - 2);
  end[0] = (uint8_t)crc;
  end[1] = (uint8_t)(crc >> 8);
}

bool settings_unpack(Settings* settings, const uint8_t bytes[SETTINGS_BYTES]) {
  const uint16_t crc = (uint16_t)(bytes[SETTINGS_BYTES - 2] | (uint16_t)bytes[SETTINGS_BYTES - 1] << 8);
  if (bytes[0] != 'H' || bytes[1] != 'R' || bytes[2] != 'P' || bytes[3] != VERSION ||
      crc != crc16_ccitt((const char*)bytes, SETTINGS_BYTES - 2))
    return false;
  Settings read;
  for (int i = 0; i < SETTING_COUNT; ++i) {
    uint32_t value = 0;
    for (uint8_t k = 4; k > 0; --k) value = value << 8 | bytes[4 + 4 * i + k - 1];
    read.value[i] = (int32_t)value;
  }
  if (!settings_valid(&read)) return false;
  *settings = read;
  return true;
}

uint16_t settings_pulse_ticks(const Settings* settings, int32_t orientation_millideg) {
  /* The product is at most 180000 * 5000 = 9e8, which fits into 32 bits. */
  const int32_t ticks_per_half_turn = settings->value[SETTING_SPAN_US] / 50;
  const int32_t product = orientation_millideg * ticks_per_half_turn;
  const int32_t turned = (product + (product < 0 ? -90000 : 90000)) / 180000;
  const int32_t ticks = settings->value[SETTING_ZERO_US] / 50 + turned;
  if (ticks < 2 * PULSE_MIN_US) return 2 * PULSE_MIN_US;
  if (ticks > 2 * PULSE_MAX_US) return 2 * PULSE_MAX_US;
  return (uint16_t)ticks;
}

/* Returns the orientation, in hundredths of a degree, at which the pulse has this width. */
static int32_t orientation_at(const Settings* settings, int32_t pulse_us) {
  const int32_t zero_us = settings->value[SETTING_ZERO_US] / 100;
  return (pulse_us - zero_us) * 18000 / (settings->value[SETTING_SPAN_US] / 100);
}

int32_t settings_lower_limit(const Settings* settings) {
  const int32_t limit = settings->value[SETTING_MIN_DEG];
  const int32_t at_pulse = orientation_at(settings, settings->value[SETTING_SPAN_US] > 0 ? PULSE_MIN_US : PULSE_MAX_US);
  return at_pulse > limit ? at_pulse : limit;
}

int32_t settings_upper_limit(const Settings* settings) {
  const int32_t limit = settings->value[SETTING_MAX_DEG];
  const int32_t at_pulse = orientation_at(settings, settings->value[SETTING_SPAN_US] > 0 ? PULSE_MAX_US : PULSE_MIN_US);
  return at_pulse < limit ? at_pulse : limit;
}

int32_t settings_speed(const Settings* settings) {
  const int32_t speed = settings->value[SETTING_SPEED_DEG_S];
  return settings_has_feedback(settings) || speed < max_unmeasured_speed ? speed : max_unmeasured_speed;
}

bool settings_has_feedback(const Settings* settings) {
  return settings->value[SETTING_ADC_AT_MIN] != settings->value[SETTING_ADC_AT_MAX];
}

/* Returns the nonlinearity of the sensor, in hundredths of a degree, at the fraction part / whole of the range of its
 * readings. Interpolates linearly between the settings bend_0 to bend_8. */
static int32_t bend_at(const Settings* settings, int32_t part, int32_t whole) {
  if (whole < 0) {
    part = -part;
    whole = -whole;
  }
  part = part < 0 ? 0 : part > whole ? whole : part;
  const int32_t before = part * BEND_PARTS / whole; /* the product is at most 16368 * 8 */
  const int32_t* bend = &settings->value[SETTING_BEND_0 + before];
  return before == BEND_PARTS ? bend[0] : bend[0] + (bend[1] - bend[0]) * (part * BEND_PARTS - before * whole) / whole;
}

int32_t settings_measured_millideg(const Settings* settings, uint16_t reading_16ths) {
  const int32_t at_min = settings->value[SETTING_ADC_AT_MIN] / 100 * 16;
  const int32_t at_max = settings->value[SETTING_ADC_AT_MAX] / 100 * 16;
  const int32_t min = settings->value[SETTING_MIN_DEG];
  const int32_t width = settings->value[SETTING_MAX_DEG] - min;
  /* The product part * width is at most 16368 * 36000 = 6e8, which fits into 32 bits. */
  const int32_t part = (int32_t)reading_16ths - at_min, whole = at_max - at_min;
  const int32_t orientation = min + part * width / whole - bend_at(settings, part, whole);
  const int32_t turn = 36000;
  return (orientation < -turn ? -turn : orientation > turn ? turn : orientation) * 10;
}
