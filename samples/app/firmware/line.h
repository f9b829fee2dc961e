/* Parser and writer of the lines of the plate's protocol (plugin/src/plate/protocol.md). C11 without a library: the
 * same code runs on the board and in the host's tests. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { LINE_SIZE = 64 }; /**< longest line in bytes, with its end */

/** Reason for which a line is refused. line_error_word() returns its word in ERROR lines. */
typedef enum LineError {
  LINE_OK,
  LINE_TOO_LONG,
  LINE_BAD_BYTE,
  LINE_BAD_SUM,
  LINE_BAD_WORD,
  LINE_BAD_NUMBER,
  LINE_OUT_OF_RANGE,
  LINE_NOT_GREETED,
  LINE_BUSY,
  LINE_STEP,
  LINE_SESSION
} LineError;
const char* line_error_word(LineError error);

/** Collects bytes up to the end of a line. */
typedef struct LineBuffer {
  char text[LINE_SIZE]; /**< after line_take(): the body, with a 0 at its end */
  uint8_t length;
  bool too_long;
} LineBuffer;

/** Appends one byte. Returns true if it ended a line: `error` is then its validity, and `buffer->text` has the body
 * until the next call. */
bool line_take(LineBuffer* buffer, char byte, LineError* error);

/** Writes `body` with checksum and line end to `out` (LINE_SIZE bytes). Returns the length; 0 if it is too long. */
uint8_t line_seal(char* out, const char* body);

/** Returns the next word of `rest`, which then points behind it. Null at the end, or if words are not separated by
 * exactly one space. */
char* line_word(char** rest);

/** Reads a decimal number below ten million, in hundredths; further decimals are cut off. Returns false if the word is
 * not a number or has more than 12 characters. */
bool line_hundredths(const char* word, int32_t* out);

/** Reads a number in the fixed format of protocol 2: sign, three digits, point, two digits. */
bool line_fixed_angle(const char* word, int32_t* out);

/** Reads a sequence number: exactly five digits, at most 65535. */
bool line_sequence(const char* word, uint16_t* out);

/** Append to a text that ends at `end`, and return its new end. The caller provides the space. */
char* line_put_text(char* end, const char* text);
char* line_put_hundredths(char* end, int32_t hundredths);
char* line_put_fixed_angle(char* end, int32_t hundredths);
char* line_put_digits(char* end, uint32_t value, uint8_t width);

#ifdef __cplusplus
}
#endif
