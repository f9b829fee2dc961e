#include "samples/plate/firmware/plate.h"

#include <stddef.h>

#include "samples/plate/firmware/answer.h"

enum {
  /* The protocol's limit is 300 ms; up to 20 of them pass until the next pulse shows the stop. */
  HEARTBEAT_MS = 275,
  EMERGENCY_MS = 2,      /* a shorter opening is noise */
  SETTLE_BLIND_MS = 500, /* a hobby servo turns 180 degrees in less */
  SETTLE_SEEN_MS = 40,
  ASTRAY_MILLIDEG = 15000,
  ASTRAY_MS = 500,
  MOVED_MILLIDEG = 3000,
  TRIM_TICKS = 40 /* largest jump of the pulse by a changed setting, in half microseconds */
};

static int32_t clamp(int32_t value, int32_t min, int32_t max) {
  return value < min ? min : value > max ? max : value;
}

static bool is_measured(const Plate* plate) {
  return settings_has_feedback(&plate->settings) && plate->reading_16ths >= 0;
}

static int32_t measured_millideg(const Plate* plate) {
  return settings_measured_millideg(&plate->settings, (uint16_t)plate->reading_16ths);
}

static void stop(Plate* plate, PlateStop why) {
  plate->target_microdeg = plate->position_microdeg;
  if (plate->state == PLATE_FOLLOWING) plate->state = PLATE_RESTING;
  plate->stops_due = (uint8_t)(plate->stops_due | 1U << why);
}

/* A stop without pulses, until the next HELLO. */
static void latch(Plate* plate, PlateStop why) {
  stop(plate, why);
  plate->state = PLATE_LATCHED;
  plate->latched_by = why;
  plate->pulses = false;
}

static void keep_within_limits(Plate* plate) {
  plate->position_microdeg = clamp(plate->position_microdeg, settings_least(&plate->settings) * 10000,
                                   settings_most(&plate->settings) * 10000);
  plate->target_microdeg = plate->position_microdeg;
}

static void start_pulses(Plate* plate) {
  if (is_measured(plate)) plate->position_microdeg = measured_millideg(plate) * 1000;
  keep_within_limits(plate);
  plate->settle_ms = is_measured(plate) ? SETTLE_SEEN_MS : SETTLE_BLIND_MS;
  plate->astray_ms = 0;
  plate->pulses = true;
}

static void turn_to(Plate* plate, int32_t orientation) {
  if (plate->state == PLATE_LATCHED) {
    stop(plate, plate->latched_by);
  } else if (orientation < settings_least(&plate->settings) ||
             orientation > settings_most(&plate->settings)) {
    stop(plate, PLATE_STOP_LIMIT);
  } else {
    if (!plate->pulses) start_pulses(plate);
    plate->target_microdeg = orientation * 10000;
    plate->state = PLATE_FOLLOWING;
  }
}

static void move(Plate* plate) {
  if (plate->settle_ms > 0) {
    --plate->settle_ms;
    return;
  }
  const int32_t step = plate->settings.value[SETTING_SPEED_DEG_S] * 10; /* microdegrees in a millisecond */
  plate->position_microdeg += clamp(plate->target_microdeg - plate->position_microdeg, -step, step);
}

/* Far from its pulse and not on its way there. */
static void watch_servo(Plate* plate) {
  if (!plate->pulses || plate->settle_ms > 0 || !is_measured(plate)) return;
  const int32_t measured = measured_millideg(plate);
  const int32_t apart = measured - plate->position_microdeg / 1000,
                moved = measured - plate->astray_at_millideg;
  const bool astray = apart < -ASTRAY_MILLIDEG || apart > ASTRAY_MILLIDEG;
  if (!astray || moved < -MOVED_MILLIDEG || moved > MOVED_MILLIDEG) {
    plate->astray_at_millideg = measured;
    plate->astray_ms = 0;
  } else if (++plate->astray_ms >= ASTRAY_MS) {
    latch(plate, PLATE_STOP_STUCK);
  }
}

int32_t plate_place_millideg(const Plate* plate) {
  return is_measured(plate) ? measured_millideg(plate) : plate->position_microdeg / 1000;
}

uint16_t plate_pulse_ticks(const Plate* plate) {
  if (!plate->pulses) return 0;
  const int32_t position = plate->position_microdeg;
  return settings_pulse_ticks(&plate->settings, (position + (position < 0 ? -500 : 500)) / 1000);
}

static void greet(Plate* plate, uint8_t version) {
  plate->version = version;
  plate->sequence = 0;
  plate->error = LINE_OK;
  plate->stops_due = 0;
  plate->conf_next = plate->conf_end;
  plate->test_next = TEST_LINES;
  plate->target_microdeg = plate->position_microdeg;
  plate->state = PLATE_RESTING;
  if (plate->emergency_open) latch(plate, PLATE_STOP_EMERGENCY);
  plate->due = (uint16_t)((plate->due & DUE_BOOT) | DUE_PLATE);
}

/* Settings that move the servo by more than a trim's step wait until it gets no pulses. */
static LineError change_setting(Plate* plate, Setting setting, int32_t value) {
  const Settings before = plate->settings;
  const uint16_t pulse = plate_pulse_ticks(plate);
  plate->settings.value[setting] = value;
  const int32_t place = plate->position_microdeg / 10000;
  bool fits = settings_valid(&plate->settings);
  if (fits && plate->pulses) {
    const int32_t jump = (int32_t)plate_pulse_ticks(plate) - (int32_t)pulse;
    fits = jump >= -TRIM_TICKS && jump <= TRIM_TICKS && place >= settings_least(&plate->settings) &&
           place <= settings_most(&plate->settings);
  }
  if (!fits) {
    plate->settings = before;
    return LINE_OUT_OF_RANGE;
  }
  if (!plate->pulses) keep_within_limits(plate);
  plate->conf_next = (uint8_t)setting;
  plate->conf_end = (uint8_t)(setting + 1);
  return LINE_OK;
}

static bool is_still(const Plate* plate) {
  return plate->position_microdeg == plate->target_microdeg && plate->settle_ms == 0;
}

static LineError hear_conf(Plate* plate, const char* name, const char* value) {
  if (name == NULL) {
    plate->conf_next = 0;
    plate->conf_end = SETTING_COUNT;
    return LINE_OK;
  }
  const Setting setting = setting_named(name);
  if (setting == SETTING_COUNT || value == NULL) return LINE_BAD_WORD;
  int32_t number = 0;
  if (!line_hundredths(value, &number)) return LINE_BAD_NUMBER;
  if (!is_still(plate)) return LINE_BUSY;
  return change_setting(plate, setting, number);
}

static LineError hear_save(Plate* plate) {
  if (plate->state == PLATE_FOLLOWING || !is_still(plate)) return LINE_BUSY;
  uint8_t bytes[SETTINGS_BYTES];
  settings_pack(&plate->settings, bytes);
  plate->board->save(bytes);
  return LINE_OK;
}

/* An angle in the version's form, within a turn. */
static LineError read_angle(const Plate* plate, const char* word, int32_t* out) {
  if (word == NULL) return LINE_BAD_WORD;
  const bool read = plate->version == LINE_CRC ? line_fixed_angle(word, out) : line_hundredths(word, out);
  if (!read) return LINE_BAD_NUMBER;
  return *out < -36000 || *out > 36000 ? LINE_OUT_OF_RANGE : LINE_OK;
}

static bool is_word(const char* word, const char* wanted) {
  if (word == NULL) return false;
  while (*word != 0 && *word == *wanted) {
    ++word;
    ++wanted;
  }
  return *word == *wanted;
}

/* SET, BEAT and STOP; in protocol 2 each ends with a sequence number. */
static LineError hear_drive(Plate* plate, const char* verb, char* rest) {
  const bool sets = is_word(verb, "SET"), stops = is_word(verb, "STOP");
  if (!sets && !stops && !is_word(verb, "BEAT")) return LINE_BAD_WORD;
  int32_t angle = 0;
  uint16_t sequence = 0;
  if (sets) {
    const LineError error = read_angle(plate, line_word(&rest), &angle);
    if (error != LINE_OK) return error;
  }
  if (plate->version == LINE_CRC) {
    const char* word = line_word(&rest);
    if (word == NULL) return LINE_BAD_WORD;
    if (!line_sequence(word, &sequence)) return LINE_BAD_NUMBER;
  }
  if (*rest != 0) return LINE_BAD_WORD;
  plate->sequence = sequence;
  if (plate->version == LINE_CRC) plate->due |= DUE_AT;
  if (sets) turn_to(plate, angle);
  if (stops) stop(plate, PLATE_STOP_HOST);
  return LINE_OK;
}

/* What the host of protocol 2 may ask beside that. */
static LineError hear_service(Plate* plate, const char* verb, char* rest) {
  const char* first = *rest != 0 ? line_word(&rest) : NULL;
  const char* second = *rest != 0 ? line_word(&rest) : NULL;
  if (*rest != 0) return LINE_BAD_WORD;
  if (is_word(verb, "CONF")) return hear_conf(plate, first, second);
  if (first != NULL) return LINE_BAD_WORD;
  if (is_word(verb, "SAVE")) return hear_save(plate);
  if (is_word(verb, "INFO")) {
    plate->due |= DUE_INFO;
  } else if (is_word(verb, "TEST")) {
    plate->test_next = 0;
  } else {
    return LINE_BAD_WORD;
  }
  return LINE_OK;
}

static bool is_service(const char* verb) {
  return is_word(verb, "CONF") || is_word(verb, "SAVE") || is_word(verb, "INFO") || is_word(verb, "TEST");
}

static LineError hear_line(Plate* plate, char* body, uint8_t sum) {
  char* rest = body;
  char* verb = line_word(&rest);
  if (verb == NULL) return LINE_BAD_WORD;
  if (is_word(verb, "HELLO")) {
    const char* version = line_word(&rest);
    if (!is_word(version, sum == LINE_CRC ? "2" : "1") || *rest != 0) return LINE_BAD_WORD;
    greet(plate, sum);
    return LINE_OK;
  }
  if (plate->version == 0) return LINE_NOT_GREETED;
  if (sum != plate->version) return LINE_BAD_SUM;
  if (sum == LINE_CRC && is_service(verb)) return hear_service(plate, verb, rest);
  return hear_drive(plate, verb, rest);
}

void plate_hear(Plate* plate, char byte) {
  LineTaken taken;
  if (!line_take(&plate->buffer, byte, &taken)) return;
  LineError error = taken.error;
  if (error == LINE_OK) error = hear_line(plate, plate->buffer.text, taken.sum);
  if (error == LINE_OK) {
    plate->silent_ms = 0;
  } else if (plate->version == LINE_CRC || error == LINE_NOT_GREETED) {
    plate->error = error;
  }
}

void plate_start(Plate* plate, const PlateBoard* board, const Settings* saved,
                 const int32_t* known_microdeg) {
  const Plate empty = {0};
  *plate = empty;
  plate->board = board;
  plate->settings = saved != NULL ? *saved : settings_default();
  plate->settings_preset = saved == NULL;
  plate->reading_16ths = -1;
  plate->position_microdeg = known_microdeg != NULL ? *known_microdeg : 0;
  keep_within_limits(plate);
  plate->test_next = TEST_LINES;
  plate->due = DUE_BOOT;
}

static void read_inputs(Plate* plate, const PlateInputs* inputs) {
  const int32_t reading = (int32_t)inputs->adc * 16;
  if (plate->reading_16ths < 0) {
    plate->reading_16ths = reading;
  } else if (reading >= 0) {
    plate->reading_16ths += (reading - plate->reading_16ths) / 8;
  }
  const bool open = inputs->emergency_open && plate->settings.value[SETTING_EMERGENCY] != 0;
  plate->open_ms = !open ? 0 : plate->open_ms < EMERGENCY_MS ? (uint8_t)(plate->open_ms + 1) : EMERGENCY_MS;
  plate->emergency_open = plate->open_ms == EMERGENCY_MS;
  if (plate->emergency_open && (plate->state != PLATE_LATCHED || plate->latched_by != PLATE_STOP_EMERGENCY))
    latch(plate, PLATE_STOP_EMERGENCY);
}

void plate_tick(Plate* plate, const PlateInputs* inputs) {
  read_inputs(plate, inputs);
  if (plate->silent_ms < HEARTBEAT_MS) ++plate->silent_ms;
  if (plate->state == PLATE_FOLLOWING && plate->silent_ms >= HEARTBEAT_MS) stop(plate, PLATE_STOP_HEARTBEAT);
  if (plate->pulses) move(plate);
  watch_servo(plate);
  answer(plate);
}

void plate_saved(Plate* plate, bool whole) {
  if (whole) {
    plate->settings_preset = false;
    if (plate->version == LINE_CRC) plate->due |= DUE_SAVED;
  } else {
    stop(plate, PLATE_STOP_FAULT);
  }
}
