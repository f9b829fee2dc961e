/* CRC-16, most significant bit first and without reflection. C11 and C++. */
#pragma once

#include <stddef.h>

static inline unsigned crc16(const char* bytes, size_t count, unsigned polynomial, unsigned start) {
  unsigned crc = start;
  for (; count > 0; --count, ++bytes) {
    crc ^= (*bytes & 0xFFU) << 8;
    for (int bit = 0; bit < 8; ++bit) crc = ((crc << 1) ^ ((crc & 0x8000U) != 0 ? polynomial : 0U)) & 0xFFFFU;
  }
  return crc;
}

/** CRC-16/CCITT-FALSE, of the line protocol and of the firmware's settings; 0x29B1 for "123456789". */
static inline unsigned crc16_ccitt(const char* bytes, size_t count) { return crc16(bytes, count, 0x1021, 0xFFFF); }

/** CRC-16/UMTS, of Dynamixel packets; 0xFEE8 for "123456789". */
static inline unsigned crc16_umts(const char* bytes, size_t count) { return crc16(bytes, count, 0x8005, 0); }
