/* Encoder and parser of the text lines of the plate's protocol (plugin/src/plate/protocol.md). C11 without a library:
 * the driver and the firmware use the same code. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { LINE_SIZE = 64 }; /**< longest line in bytes, including its line feed */

/** Reason for which a line is refused. The firmware reports it in ERROR lines. */
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

/** Collects bytes up to the end of a line. */
typedef struct LineBuffer {
  char text[LINE_SIZE]; /**< after line_receive() with LINE_OK: the body, with a 0 at its end */
  uint8_t length;
  bool too_long;
} LineBuffer;

/** Appends a received byte. Returns true if the byte ends a line: `*error` is then LINE_OK, and `buffer->text` is the
 *  body until the next call; or `*error` is the reason for which the line is not valid. */
bool line_receive(LineBuffer* buffer, char byte, LineError* error);

/** Writes `body`, its checksum and the line end to `out` (LINE_SIZE bytes). Returns the length of this line; 0 if it
 *  would be too long. */
uint8_t line_encode(char* out, const char* body);

/** Parses a decimal number with an absolute value below ten million, and sets `*out` to 100 times the number, rounded
 *  towards 0: 123 for "1.239". Returns false if the word is not such a number or has more than 12 characters. */
bool line_parse_hundredths(const char* word, int32_t* out);

/** Parses an angle of SET, HOME or AT: sign, three digits, point, two digits. The fixed width exposes a lost or doubled
 *  character. Sets `*out` to the angle in hundredths of a degree. Returns false for any other text. */
bool line_parse_angle(const char* word, int32_t* out);

/** Parses a sequence number: exactly five digits, at most 65535. Returns false for any other text. */
bool line_parse_sequence(const char* word, uint16_t* out);

/** The following functions write text and a terminating 0 at `end`, and return the position of the 0. The caller
 *  provides the space. line_append_digits() writes at least `width` digits, with leading zeros. */
char* line_append_text(char* end, const char* text);
char* line_append_hundredths(char* end, int32_t hundredths);
char* line_append_angle(char* end, int32_t hundredths);
char* line_append_digits(char* end, uint32_t value, uint8_t width);

#ifdef __cplusplus
}
#endif
