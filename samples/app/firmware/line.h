/* Lines of the plate's protocol (plugin/src/plate/protocol.md): bytes to bodies, bodies to words and numbers,
 * and back. C11 without a library: the same code runs on the board and in the host's tests. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { LINE_SIZE = 64 }; /**< longest line, in bytes, with its end */

/** Why a line is refused; the word that ERROR lines carry is line_error_word(). */
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

/** Takes one byte in. True if it ended a line: `error` says whether it is valid, and the body is in
 * `buffer->text` until the next call. */
bool line_take(LineBuffer* buffer, char byte, LineError* error);

/** Writes `body` with its sum and end into `out` (LINE_SIZE bytes). Returns the length, 0 if too long. */
uint8_t line_seal(char* out, const char* body);

/** Cuts the next word off `rest`, which then points behind it. Null if there is none, or if words are not
 * separated by exactly one space. */
char* line_word(char** rest);

/** A decimal number of at most 12 characters below ten million, times 100; further decimals are cut off.
 * False if it is none. */
bool line_hundredths(const char* word, int32_t* out);

/** The same with the fixed width of protocol 2: sign, three digits, point, two digits. */
bool line_fixed_angle(const char* word, int32_t* out);

/** A sequence number: exactly five digits, at most 65535. */
bool line_sequence(const char* word, uint16_t* out);

/** Append to the text at `end`, which holds a 0 there; return the new end. The caller has the room. */
char* line_put_text(char* end, const char* text);
char* line_put_hundredths(char* end, int32_t hundredths);
char* line_put_fixed_angle(char* end, int32_t hundredths);
char* line_put_digits(char* end, uint32_t value, uint8_t width);

#ifdef __cplusplus
}
#endif
