#include "plugin/include/plate_driver/plate_text.h"

#include <stddef.h>

#include "plugin/include/plate_driver/crc16.h"

enum { MAX_NUMBER = 12 };

static const char hex_digits[] = "0123456789ABCDEF";

enum { SUM_DIGITS = 4 };

/* Writes the checksum of `body` as upper-case hexadecimal digits, without a terminating zero. */
static void write_checksum(char* out, const char* body, uint8_t length) {
  unsigned sum = crc16_ccitt(body, length);
  for (uint8_t i = SUM_DIGITS; i > 0; --i, sum >>= 4) out[i - 1] = hex_digits[sum & 15];
}

/* Checks a complete line. If it is valid, replaces the asterisk before the checksum by a 0. */
static LineError check(char* text, uint8_t length) {
  uint8_t star = 0;
  for (; star < length && text[star] != '*'; ++star)
    if (text[star] < 0x20 || text[star] > 0x7E) return LINE_BAD_BYTE;
  if (star == 0 || length != star + 1 + SUM_DIGITS) return LINE_BAD_SUM;
  char sum[SUM_DIGITS];
  write_checksum(sum, text, star);
  for (int i = 0; i < SUM_DIGITS; ++i)
    if (text[star + 1 + i] != sum[i]) return LINE_BAD_SUM;
  text[star] = 0;
  return LINE_OK;
}

bool line_receive(LineBuffer* buffer, char byte, LineError* error) {
  if (byte != '\n') {
    if (buffer->length + 1 == LINE_SIZE) buffer->too_long = true;
    if (!buffer->too_long) buffer->text[buffer->length++] = byte;
    return false;
  }
  if (buffer->too_long) {
    *error = LINE_TOO_LONG;
  } else {
    if (buffer->length > 0 && buffer->text[buffer->length - 1] == '\r') --buffer->length;
    *error = check(buffer->text, buffer->length);
  }
  buffer->length = 0;
  buffer->too_long = false;
  return true;
}

uint8_t line_encode(char* out, const char* body) {
  uint8_t length = 0;
  while (body[length] != 0) {
    if (length + 6 >= LINE_SIZE) return 0;
    out[length] = body[length];
    ++length;
  }
  out[length] = '*';
  write_checksum(out + length + 1, body, length);
  out[length + 1 + SUM_DIGITS] = '\n';
  return (uint8_t)(length + 2 + SUM_DIGITS);
}

static bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool line_parse_hundredths(const char* word, int32_t* out) {
  uint8_t length = 0;
  while (word[length] != 0)
    if (++length > MAX_NUMBER) return false;
  const bool negative = *word == '-';
  if (negative) ++word;
  if (!is_digit(*word)) return false;
  int32_t value = 0;
  for (; is_digit(*word); ++word) {
    if (value > 999999) return false; /* with this digit and two decimals, it could overflow */
    value = value * 10 + (*word - '0');
  }
  uint8_t decimals = 0;
  if (*word == '.') {
    ++word;
    if (!is_digit(*word)) return false;
    for (; is_digit(*word); ++word) {
      if (decimals == 2) continue; /* cut off */
      value = value * 10 + (*word - '0');
      ++decimals;
    }
  }
  if (*word != 0) return false;
  for (; decimals < 2; ++decimals) value *= 10;
  *out = negative ? -value : value;
  return true;
}

bool line_parse_angle(const char* word, int32_t* out) {
  static const char pattern[] = "+000.00";
  for (size_t i = 0; i < sizeof pattern; ++i) {
    const char c = word[i];
    const bool fits = pattern[i] == '0' ? is_digit(c) : pattern[i] == '+' ? c == '+' || c == '-' : c == pattern[i];
    if (!fits) return false;
  }
  int32_t value = 0;
  for (uint8_t i = 1; i < 7; ++i)
    if (i != 4) value = value * 10 + (word[i] - '0');
  *out = word[0] == '-' ? -value : value;
  return true;
}

bool line_parse_sequence(const char* word, uint16_t* out) {
  uint32_t value = 0;
  for (uint8_t i = 0; i < 5; ++i) {
    if (!is_digit(word[i])) return false;
    value = value * 10 + (uint32_t)(word[i] - '0');
  }
  if (word[5] != 0 || value > 65535) return false;
  *out = (uint16_t)value;
  return true;
}

char* line_append_text(char* end, const char* text) {
  while (*text != 0) *end++ = *text++;
  *end = 0;
  return end;
}

char* line_append_digits(char* end, uint32_t value, uint8_t width) {
  char digits[10];
  uint8_t count = 0;
  do {
    digits[count++] = (char)('0' + value % 10);
    value /= 10;
  } while (value > 0);
  for (; width > count; --width) *end++ = '0';
  while (count > 0) *end++ = digits[--count];
  *end = 0;
  return end;
}

static char* append_angle(char* end, int32_t hundredths, uint8_t width) {
  const uint32_t size = (uint32_t)(hundredths < 0 ? -hundredths : hundredths);
  end = line_append_digits(end, size / 100, width);
  *end++ = '.';
  return line_append_digits(end, size % 100, 2);
}

char* line_append_hundredths(char* end, int32_t hundredths) {
  if (hundredths < 0) *end++ = '-';
  return append_angle(end, hundredths, 1);
}

char* line_append_angle(char* end, int32_t hundredths) {
  *end++ = hundredths < 0 ? '-' : '+';
  return append_angle(end, hundredths, 3);
}
