// FNV-1a, 64 bits, and the hash of commands in hrt_replay_report::hash.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "haptic_retargeting/recording.h"

namespace hrt::plugin {

class Hash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) add_byte(static_cast<unsigned char>(byte));
  }
  /// Adds 8 bytes, the least significant one first.
  void add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) add_byte(value >> (8 * byte) & 0xff);
  }
  std::uint64_t value() const { return hash_; }

 private:
  void add_byte(std::uint64_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3; }

  std::uint64_t hash_ = 0xcbf29ce484222325;
};

inline void add(const hrt_command& command, Hash& hash) {
#define HRT_ADD_WHOLE(name) hash.add(static_cast<std::uint64_t>(command.name));
#define HRT_ADD_NUMBER(name) hash.add(std::bit_cast<std::uint64_t>(command.name));
  HRT_HASHED_FIELDS(HRT_ADD_WHOLE, HRT_ADD_NUMBER)
#undef HRT_ADD_WHOLE
#undef HRT_ADD_NUMBER
}

}  // namespace hrt::plugin
