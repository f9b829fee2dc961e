/* Checksums of 16 bits: cyclic redundancy checks, most significant bit first, without reflection. C11 and C++. */
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

/** Returns the CRC-16/CCITT-FALSE, which the line protocol and the stored settings use: 0x29B1 for "123456789". */
static inline unsigned crc16_ccitt(const char* bytes, size_t count) { return crc16(bytes, count, 0x1021, 0xFFFF); }

/** Returns the CRC-16/UMTS, which Dynamixel packets use: 0xFEE8 for "123456789". */
static inline unsigned crc16_umts(const char* bytes, size_t count) { return crc16(bytes, count, 0x8005, 0); }
