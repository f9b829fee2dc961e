/* Lines that the plate sends to the host. */
#include "samples/app/firmware/plate.h"

enum { REPORT_MS = 20, ERROR_MS = 10 };

/* Words of ERROR lines, in the order of LineError. */
static const char* const error_words[] = {"none",  "length",   "byte", "sum",  "word",   "number",
                                          "range", "greeting", "busy", "step", "session"};
/* Words of STOPPED lines, in the order of PlateStop. */
static const char* const stop_words[PLATE_STOP_COUNT] = {"host",  "heartbeat", "limit",   "fault", "emergency",
                                                         "stuck", "sensor",    "unhomed", "supply"};

static bool send(Plate* plate, const char* body) {
  char line[LINE_SIZE];
  return plate->board->send(line, line_encode(line, body));
}

static bool send_words(Plate* plate, const char* verb, const char* word) {
  char body[LINE_SIZE];
  char* end = line_append_text(body, verb);
  *end++ = ' ';
  line_append_text(end, word);
  return send(plate, body);
}

static bool send_greeting(Plate* plate) {
  const Settings* settings = &plate->settings;
  char body[LINE_SIZE];
  char* end = line_append_text(body, "PLATE 2 ");
  end = line_append_hundredths(end, settings_lower_limit(settings));
  *end++ = ' ';
  end = line_append_hundredths(end, settings_upper_limit(settings));
  *end++ = ' ';
  end = line_append_hundredths(end, settings_speed(settings));
  *end++ = ' ';
  end = line_append_hundredths(end, settings->value[SETTING_LATENCY_MS]);
  line_append_text(end, settings_has_feedback(settings) ? " measured" : " assumed");
  return send(plate, body);
}

static bool send_orientation(Plate* plate) {
  const int32_t millideg = plate_orientation_millideg(plate);
  const int32_t hundredths = (millideg + (millideg < 0 ? -5 : 5)) / 10;
  char body[LINE_SIZE];
  char* end = line_append_text(body, "AT ");
  end = plate_orientation_is_known(plate) ? line_append_angle(end, hundredths) : line_append_text(end, "unknown");
  *end++ = ' ';
  line_append_digits(end, plate->sequence, 5);
  return send(plate, body);
}

/* Returns 0 for a negative value, which means that there was no reading yet. */
static int32_t at_least_0(int32_t value) { return value < 0 ? 0 : value; }

static bool send_info(Plate* plate) {
  char words[32];
  char* end = line_append_text(words, PLATE_FIRMWARE_VERSION " ");
  line_append_digits(end, (uint32_t)plate->settings.value[SETTING_SERIAL] / 100, 6);
  return send_words(plate, "INFO", words);
}

static bool send_setting(Plate* plate, Setting setting) {
  char words[32];
  char* end = line_append_text(words, setting_name(setting));
  *end++ = ' ';
  line_append_hundredths(end, plate->settings.value[setting]);
  return send_words(plate, "CONF", words);
}

static bool send_test(Plate* plate, uint8_t number) {
  char words[32];
  switch (number) {
    case 0:
      line_append_text(words, plate->settings_preset ? "settings default" : "settings saved");
      break;
    case 1:
      line_append_text(line_append_text(words, "emergency "), plate->settings.value[SETTING_EMERGENCY] == 0 ? "unused"
                                                              : plate->emergency_open                       ? "open"
                                                                                                            : "closed");
      break;
    case 2:
      line_append_digits(line_append_text(words, "adc "), (uint32_t)at_least_0(plate->reading_256ths) / 256, 1);
      break;
    case 3: /* supply in hundredths of a volt: the converter measures half of the supply, and 1023 is 5 V */
      if (plate->settings.value[SETTING_SUPPLY] == 0)
        line_append_text(words, "supply unused");
      else
        line_append_hundredths(line_append_text(words, "supply "), at_least_0(plate->supply_adc) * 1000 / 1023);
      break;
    case 4:
      line_append_hundredths(line_append_text(words, "pulse "), (int32_t)plate_pulse_ticks(plate) * 50);
      break;
    case 5:
      line_append_digits(line_append_text(words, "loop "), plate->loop_ms, 1);
      break;
    default:
      line_append_text(words, "end");
      break;
  }
  return send_words(plate, "TEST", words);
}

void send_due_lines(Plate* plate) {
  if (plate->report_ms < REPORT_MS) ++plate->report_ms;
  if ((plate->due & DUE_BOOT) != 0) {
    if (!send(plate, "BOOT")) return;
    plate->due &= (uint16_t)~DUE_BOOT;
  }
  if (plate->error_ms > 0) --plate->error_ms;
  if (plate->error != LINE_OK && plate->error_ms == 0 && send_words(plate, "ERROR", error_words[plate->error])) {
    plate->error = LINE_OK;
    plate->error_ms = ERROR_MS;
  }
  if (!plate->greeted) return;
  if ((plate->due & DUE_PLATE) != 0) {
    if (!send_greeting(plate)) return;
    plate->due &= (uint16_t)~DUE_PLATE;
  }
  for (int why = 0; why < PLATE_STOP_COUNT; ++why) {
    if ((plate->stops_due & 1U << why) == 0) continue;
    if (!send_words(plate, "STOPPED", stop_words[why])) return;
    plate->stops_due = (uint16_t)(plate->stops_due & ~(1U << why));
  }
  if ((plate->due & DUE_AT) != 0 || plate->report_ms >= REPORT_MS) {
    if (!send_orientation(plate)) return;
    plate->due &= (uint16_t)~DUE_AT;
    plate->report_ms = 0;
  }
  if ((plate->due & DUE_INFO) != 0 && send_info(plate)) plate->due &= (uint16_t)~DUE_INFO;
  if ((plate->due & DUE_SAVED) != 0 && send(plate, "SAVED")) plate->due &= (uint16_t)~DUE_SAVED;
  if (plate->conf_next < plate->conf_end && send_setting(plate, (Setting)plate->conf_next)) ++plate->conf_next;
  if (plate->test_next < TEST_LINES && send_test(plate, plate->test_next)) ++plate->test_next;
}
