#include "samples/app/firmware/plate.h"

#include <stddef.h>
#include <string.h>

enum {
  /* The protocol requires a stop within 300 ms of the host's last line. The next pulse comes up to 20 ms later. */
  HEARTBEAT_MS = 275,
  EMERGENCY_MS = 2, /* a shorter opening is noise */
  SUPPLY_MS = 5,    /* a shorter dip is due to a starting motor */
  SUPPLY_ADC = 409, /* half of 4 V, on a scale of 5 V: servos for 5 to 6 V lose their force below 4 V */
  /* At first, one pulse in eight is sent. Many servos drive their motor for 20 ms per pulse, so that they turn at an
   * eighth of their speed. Homing by 180 degrees at an eighth of 200 degrees a second takes 7.2 s. */
  HOME_MS = 8000,
  SETTLE_PERIOD_MS = 160,
  FRAME_MS = 20,
  /* Largest angle by which the pulse may be ahead of the measured orientation: MIN_LEAD_MILLIDEG plus the speed times
   * the sum of the setting `latency` and LEAD_MS (a pulse period, and the sensor's filter), up to
   * FAST_LEAD_MILLIDEG; after `FAST`: FAST_LEAD_MILLIDEG. */
  LEAD_MS = 30,
  MIN_LEAD_MILLIDEG = 2000,
  FAST_LEAD_MILLIDEG = 60000,
  HELD_MILLIDEG = 1000, /* a stop does not change the pulse of a servo that is nearer to its pulse */
  AT_REST_MS = 1000,    /* a stop does not change a pulse that has not moved for this time */
  BLOCKED_MS = 500,     /* a servo that moves by less than MOVED_MILLIDEG in this time at the largest lead has failed */
  MOVED_MILLIDEG = 3000,
  MAX_SETTLE_MILLIDEG = 6000, /* a servo that moves farther away from its first pulse turns against its sensor */
  SETTLED_MILLIDEG = 400,     /* largest motion between two pulses of a settled servo */
  TRIM_TICKS = 40             /* largest change of the pulse by a setting, in half microseconds */
};

static int32_t clamp(int32_t value, int32_t min, int32_t max) { return value < min ? min : value > max ? max : value; }

static int32_t distance(int32_t a, int32_t b) { return a < b ? b - a : a - b; }

static bool is_measured(const Plate* plate) {
  return settings_has_feedback(&plate->settings) && plate->reading_256ths >= 0;
}

/* Computes the step and the largest lead. Called after HELLO, FAST and a change of a setting, not every millisecond,
 * because divisions are slow on the board. */
static void plan_motion(Plate* plate) {
  const int32_t speed = settings_speed(&plate->settings);
  plate->step_microdeg = plate->fast ? 360000000 : speed * 10;
  const int32_t time_ms = plate->settings.value[SETTING_LATENCY_MS] / 100 + LEAD_MS;
  const int32_t lead = MIN_LEAD_MILLIDEG + speed / 100 * time_ms;
  plate->max_lead_millideg = plate->fast || lead > FAST_LEAD_MILLIDEG ? FAST_LEAD_MILLIDEG : lead;
}

static bool is_homing(const Plate* plate) { return plate->pulses && !plate->homed; }

static void keep_within_limits(Plate* plate) {
  plate->position_microdeg = clamp(plate->position_microdeg, settings_lower_limit(&plate->settings) * 10000,
                                   settings_upper_limit(&plate->settings) * 10000);
  plate->target_microdeg = plate->position_microdeg;
}

static bool is_settled(const Plate* plate) { return plate->pulses && plate->settle_ms == 0; }

/* Ends the motion of the pulse. If a pulse that moved within AT_REST_MS is ahead of a servo with a sensor, first moves
 * it back to the measured position, so that the servo stops there. */
static void hold(Plate* plate) {
  const bool may_turn = is_settled(plate) && plate->at_rest_ms < AT_REST_MS;
  if (may_turn && is_measured(plate) &&
      distance(plate->measured_millideg, plate->position_microdeg / 1000) > HELD_MILLIDEG)
    plate->position_microdeg = plate->measured_millideg * 1000;
  keep_within_limits(plate);
}

static void stop(Plate* plate, PlateStop why) {
  hold(plate);
  if (is_homing(plate)) plate->pulses = false; /* a servo that was not homed completely has an unknown position */
  if (plate->state == PLATE_FOLLOWING) plate->state = PLATE_RESTING;
  plate->stops_due = (uint16_t)(plate->stops_due | 1U << why);
}

/* Stops, ends the pulses, and refuses motions until the next HELLO. A hand may then turn the plate: without a sensor,
 * its orientation is unknown. */
static void latch(Plate* plate, PlateStop why) {
  stop(plate, why);
  plate->state = PLATE_LATCHED;
  plate->latched_by = why;
  plate->pulses = plate->homed = false;
}

/* Starts the pulses at the measured position; or, to home a servo without a sensor, at `home_microdeg`. */
static void start_pulses(Plate* plate, int32_t home_microdeg) {
  plate->homed = is_measured(plate);
  plate->position_microdeg = plate->homed ? plate->measured_millideg * 1000 : home_microdeg;
  keep_within_limits(plate);
  plate->settle_ms = plate->homed ? SETTLE_PERIOD_MS : HOME_MS;
  plate->blocked_ms = 0;
  plate->near_millideg = plate->moved_from_millideg = plate_orientation_millideg(plate);
  plate->near_pulse_millideg = plate->position_microdeg / 1000;
  plate->pulses = true;
}

static void turn_to(Plate* plate, int32_t orientation, bool may_home) {
  if (plate->state == PLATE_LATCHED) {
    stop(plate, plate->latched_by);
  } else if (orientation < settings_lower_limit(&plate->settings) ||
             orientation > settings_upper_limit(&plate->settings)) {
    stop(plate, PLATE_STOP_LIMIT);
  } else if (!plate_orientation_is_known(plate) && !plate->pulses && !may_home) {
    stop(plate, PLATE_STOP_UNHOMED);
  } else {
    if (!plate->pulses) start_pulses(plate, orientation * 10000);
    plate->target_microdeg = orientation * 10000;
    plate->state = PLATE_FOLLOWING;
  }
}

/* Processes a millisecond of the first pulses, which hold a servo with a sensor where it is, or home one without.
 * Latches if the servo turns away from its first pulse, as with exchanged settings adc_least and adc_most. */
static void settle(Plate* plate) {
  --plate->settle_ms;
  if (is_measured(plate) && !is_homing(plate)) {
    const int32_t measured = plate->measured_millideg;
    if (distance(measured, plate->near_pulse_millideg) >
        distance(plate->near_millideg, plate->near_pulse_millideg) + MAX_SETTLE_MILLIDEG) {
      latch(plate, PLATE_STOP_SENSOR);
    } else if (plate->settle_ms == 0 && distance(measured, plate->moved_from_millideg) > SETTLED_MILLIDEG) {
      plate->moved_from_millideg = measured;
      plate->settle_ms = SETTLE_PERIOD_MS;
    }
  }
  if (plate->settle_ms == 0) plate->homed = plate->pulses;
}

static void move_pulse(Plate* plate) {
  if (plate->settle_ms > 0) {
    settle(plate);
    return;
  }
  const int32_t step = plate->step_microdeg;
  const int32_t remaining = plate->target_microdeg - plate->position_microdeg;
  plate->at_rest_ms = remaining != 0 ? 0 : plate->at_rest_ms < AT_REST_MS ? plate->at_rest_ms + 1 : AT_REST_MS;
  const int32_t position = plate->position_microdeg + clamp(remaining, -step, step);
  if (!is_measured(plate)) {
    plate->position_microdeg = position;
    return;
  }
  /* A pulse that is too far ahead of the servo waits for it, but does not move back. */
  const int32_t measured = plate->measured_millideg, lead = plate->max_lead_millideg;
  const int32_t min = (measured - lead) * 1000, max = (measured + lead) * 1000, now = plate->position_microdeg;
  const int32_t bounded = clamp(position, now < min ? now : min, now > max ? now : max);
  plate->is_held_back = bounded != position;
  plate->position_microdeg = bounded;
}

/* True if the servo has moved away from the pulse since it was last near it, as with exchanged settings adc_least and
 * adc_most. */
static bool moves_against_pulse(const Plate* plate, int32_t measured) {
  const int32_t turned = measured - plate->near_millideg;
  const int32_t wanted = plate->position_microdeg / 1000 - plate->near_pulse_millideg;
  return (turned > MOVED_MILLIDEG && wanted < 0) || (turned < -MOVED_MILLIDEG && wanted > 0);
}

static void check_servo(Plate* plate) {
  if (!is_settled(plate) || !is_measured(plate)) return;
  const int32_t measured = plate->measured_millideg, pulse = plate->position_microdeg / 1000;
  const bool is_off = plate->is_held_back || distance(measured, pulse) > plate->max_lead_millideg;
  if (distance(measured, pulse) < MOVED_MILLIDEG) {
    plate->near_millideg = measured;
    plate->near_pulse_millideg = pulse;
  }
  if (!is_off || distance(measured, plate->moved_from_millideg) > MOVED_MILLIDEG) {
    plate->moved_from_millideg = measured;
    plate->blocked_ms = 0;
  } else if (++plate->blocked_ms >= BLOCKED_MS) {
    latch(plate, moves_against_pulse(plate, measured) ? PLATE_STOP_SENSOR : PLATE_STOP_STUCK);
  }
}

bool plate_orientation_is_known(const Plate* plate) { return is_measured(plate) || plate->homed; }

int32_t plate_orientation_millideg(const Plate* plate) {
  return is_measured(plate) ? plate->measured_millideg : plate->position_microdeg / 1000;
}

uint16_t plate_pulse_ticks(const Plate* plate) {
  if (!plate->pulses) return 0;
  if (plate->settle_ms > 0 && plate->settle_ms % SETTLE_PERIOD_MS < SETTLE_PERIOD_MS - FRAME_MS) return 0;
  const int32_t position = plate->position_microdeg;
  return settings_pulse_ticks(&plate->settings, (position + (position < 0 ? -500 : 500)) / 1000);
}

static void start_session(Plate* plate, uint16_t session) {
  plate->greeted = true;
  plate->session = session;
  plate->fast = false;
  plan_motion(plate);
  plate->sequence = 0;
  plate->error = LINE_OK;
  plate->stops_due = 0;
  plate->conf_next = plate->conf_end;
  plate->test_next = TEST_LINES;
  hold(plate);
  plate->state = PLATE_RESTING;
  if (is_homing(plate)) plate->pulses = false;
  if (plate->supply_low) latch(plate, PLATE_STOP_SUPPLY);
  if (plate->emergency_open) latch(plate, PLATE_STOP_EMERGENCY);
  plate->due = (uint16_t)((plate->due & DUE_BOOT) | DUE_PLATE);
}

/* Changes a setting. Refuses a value that is invalid, or that would change a present pulse by more than TRIM_TICKS or
 * put it beyond the limits. */
static LineError change_setting(Plate* plate, Setting setting, int32_t value) {
  const Settings before = plate->settings;
  const uint16_t pulse = plate_pulse_ticks(plate);
  plate->settings.value[setting] = value;
  const int32_t orientation = plate->position_microdeg / 10000;
  LineError error = settings_valid(&plate->settings) ? LINE_OK : LINE_OUT_OF_RANGE;
  if (error == LINE_OK && plate->pulses) {
    const int32_t jump = (int32_t)plate_pulse_ticks(plate) - (int32_t)pulse;
    if (jump < -TRIM_TICKS || jump > TRIM_TICKS || orientation < settings_lower_limit(&plate->settings) ||
        orientation > settings_upper_limit(&plate->settings))
      error = LINE_STEP;
  }
  if (error != LINE_OK) {
    plate->settings = before;
    return error;
  }
  if (!plate->pulses) keep_within_limits(plate);
  plan_motion(plate);
  plate->conf_next = (uint8_t)setting;
  plate->conf_end = (uint8_t)(setting + 1);
  return LINE_OK;
}

static bool is_at_rest(const Plate* plate) {
  return plate->position_microdeg == plate->target_microdeg && plate->settle_ms == 0;
}

static LineError execute_conf(Plate* plate, const char* name, const char* value) {
  if (name == NULL) {
    plate->conf_next = 0;
    plate->conf_end = SETTING_COUNT;
    return LINE_OK;
  }
  const Setting setting = setting_named(name);
  if (setting == SETTING_COUNT || value == NULL) return LINE_BAD_WORD;
  int32_t number = 0;
  if (!line_parse_hundredths(value, &number)) return LINE_BAD_NUMBER;
  if (!is_at_rest(plate)) return LINE_BUSY;
  return change_setting(plate, setting, number);
}

static LineError execute_save(Plate* plate) {
  if (plate->state == PLATE_FOLLOWING || !is_at_rest(plate)) return LINE_BUSY;
  uint8_t bytes[SETTINGS_BYTES];
  settings_pack(&plate->settings, bytes);
  plate->board->save(bytes);
  return LINE_OK;
}

/* Parses an angle from -360 to 360 degrees, in hundredths of a degree. */
static LineError parse_angle(const char* word, int32_t* out) {
  if (word == NULL) return LINE_BAD_WORD;
  if (!line_parse_angle(word, out)) return LINE_BAD_NUMBER;
  return *out < -36000 || *out > 36000 ? LINE_OUT_OF_RANGE : LINE_OK;
}

/* Returns the next word of `rest`, and moves `rest` to the word after it. Null: the end, or a space too many. */
static char* next_word(char** rest) {
  char* word = *rest;
  if (word == NULL || *word == 0 || *word == ' ') return NULL;
  char* end = word;
  while (*end != 0 && *end != ' ') ++end;
  if (*end == ' ') {
    if (end[1] == 0) return NULL; /* a space ends the body */
    *end++ = 0;
  }
  *rest = end;
  return word;
}

static bool equals(const char* word, const char* wanted) { return word != NULL && strcmp(word, wanted) == 0; }

/* Executes SET, HOME, BEAT, FAST or STOP, which end with a sequence number. */
static LineError execute_motion(Plate* plate, const char* verb, char* rest) {
  const bool homes = equals(verb, "HOME"), sets = homes || equals(verb, "SET"), stops = equals(verb, "STOP");
  const bool goes_fast = equals(verb, "FAST");
  if (!sets && !stops && !goes_fast && !equals(verb, "BEAT")) return LINE_BAD_WORD;
  int32_t angle = 0;
  uint16_t sequence = 0;
  if (sets) {
    const LineError error = parse_angle(next_word(&rest), &angle);
    if (error != LINE_OK) return error;
  }
  const char* word = next_word(&rest);
  if (word == NULL) return LINE_BAD_WORD;
  if (!line_parse_sequence(word, &sequence)) return LINE_BAD_NUMBER;
  if (*rest != 0) return LINE_BAD_WORD;
  plate->sequence = sequence;
  plate->due |= DUE_AT;
  if (sets) turn_to(plate, angle, homes);
  if (goes_fast) plate->fast = true;
  if (goes_fast) plan_motion(plate);
  if (stops) stop(plate, PLATE_STOP_HOST);
  return LINE_OK;
}

/* Executes CONF, SAVE, INFO or TEST. */
static LineError execute_service(Plate* plate, const char* verb, char* rest) {
  const char* first = *rest != 0 ? next_word(&rest) : NULL;
  const char* second = *rest != 0 ? next_word(&rest) : NULL;
  if (*rest != 0) return LINE_BAD_WORD;
  if (equals(verb, "CONF")) return execute_conf(plate, first, second);
  if (first != NULL) return LINE_BAD_WORD;
  if (equals(verb, "SAVE")) return execute_save(plate);
  if (equals(verb, "INFO")) plate->due |= DUE_INFO;
  if (equals(verb, "TEST")) plate->test_next = 0;
  return LINE_OK;
}

static bool is_service(const char* verb) {
  return equals(verb, "CONF") || equals(verb, "SAVE") || equals(verb, "INFO") || equals(verb, "TEST");
}

/* Executes HELLO. A host with another token may start a session once the present host is silent for HEARTBEAT_MS. */
static LineError execute_hello(Plate* plate, char* rest) {
  const char* version = next_word(&rest);
  const char* token = *rest != 0 ? next_word(&rest) : NULL;
  uint16_t session = 0;
  if (!equals(version, "2") || *rest != 0) return LINE_BAD_WORD;
  if (token != NULL && !line_parse_sequence(token, &session)) return LINE_BAD_NUMBER;
  if (plate->greeted && session != plate->session && plate->silent_ms < HEARTBEAT_MS) return LINE_SESSION;
  start_session(plate, session);
  return LINE_OK;
}

/* Removes the token from the end of a body, if the session has a token. Returns false if the body has no such token. */
static bool remove_token(const Plate* plate, char* body) {
  if (plate->session == 0) return true;
  char* end = body;
  while (*end != 0) ++end;
  while (end != body && *end != ' ') --end;
  uint16_t token = 0;
  if (!line_parse_sequence(end == body ? body : end + 1, &token) || token != plate->session) return false;
  *end = 0;
  return true;
}

static LineError execute_line(Plate* plate, char* body) {
  char* rest = body;
  char* verb = next_word(&rest);
  if (verb == NULL) return LINE_BAD_WORD;
  if (equals(verb, "HELLO")) return execute_hello(plate, rest);
  if (!plate->greeted) return LINE_NOT_GREETED;
  if (!remove_token(plate, rest)) return LINE_SESSION;
  if (is_service(verb)) return execute_service(plate, verb, rest);
  return execute_motion(plate, verb, rest);
}

void plate_receive(Plate* plate, char byte) {
  LineError error;
  if (!line_receive(&plate->buffer, byte, &error)) return;
  if (error == LINE_OK) error = execute_line(plate, plate->buffer.text);
  if (error == LINE_OK) {
    plate->silent_ms = 0;
  } else if (plate->greeted || error == LINE_NOT_GREETED) {
    plate->error = error;
  }
}

void plate_start(Plate* plate, const PlateBoard* board, const Settings* saved) {
  const Plate empty = {0};
  *plate = empty;
  plate->board = board;
  plate->settings = saved != NULL ? *saved : settings_default();
  plate->settings_preset = saved == NULL;
  plate->reading_256ths = plate->supply_adc = -1;
  keep_within_limits(plate);
  plate->test_next = TEST_LINES;
  plate->due = DUE_BOOT;
}

static void read_supply(Plate* plate, int16_t adc) {
  if (adc >= 0) plate->supply_adc = adc;
  const bool low =
      plate->settings.value[SETTING_SUPPLY] != 0 && plate->supply_adc >= 0 && plate->supply_adc < SUPPLY_ADC;
  plate->supply_low_ms = !low ? 0 : plate->supply_low_ms < SUPPLY_MS ? (uint8_t)(plate->supply_low_ms + 1) : SUPPLY_MS;
  plate->supply_low = plate->supply_low_ms == SUPPLY_MS;
  if (plate->supply_low && plate->state != PLATE_LATCHED) latch(plate, PLATE_STOP_SUPPLY);
}

static void read_inputs(Plate* plate, const PlateInputs* inputs) {
  const int32_t reading = (int32_t)inputs->adc * 256;
  if (plate->reading_256ths < 0) {
    plate->reading_256ths = reading;
  } else if (reading >= 0) {
    plate->reading_256ths += (reading - plate->reading_256ths) / 8;
  }
  if (is_measured(plate))
    plate->measured_millideg = settings_measured_millideg(&plate->settings, (uint16_t)(plate->reading_256ths / 16));
  const bool open = inputs->emergency_open && plate->settings.value[SETTING_EMERGENCY] != 0;
  plate->open_ms = !open ? 0 : plate->open_ms < EMERGENCY_MS ? (uint8_t)(plate->open_ms + 1) : EMERGENCY_MS;
  plate->emergency_open = plate->open_ms == EMERGENCY_MS;
  read_supply(plate, inputs->supply_adc);
  if (plate->emergency_open && (plate->state != PLATE_LATCHED || plate->latched_by != PLATE_STOP_EMERGENCY))
    latch(plate, PLATE_STOP_EMERGENCY);
}

void plate_tick(Plate* plate, const PlateInputs* inputs) {
  read_inputs(plate, inputs);
  if (plate->silent_ms < HEARTBEAT_MS) ++plate->silent_ms;
  if (plate->state == PLATE_FOLLOWING && plate->silent_ms >= HEARTBEAT_MS) stop(plate, PLATE_STOP_HEARTBEAT);
  if (plate->pulses) move_pulse(plate);
  check_servo(plate);
  send_due_lines(plate);
}

void plate_saved(Plate* plate, bool whole) {
  if (whole) {
    plate->settings_preset = false;
    if (plate->greeted) plate->due |= DUE_SAVED;
  } else {
    stop(plate, PLATE_STOP_FAULT);
  }
}
