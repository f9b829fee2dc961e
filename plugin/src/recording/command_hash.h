// The hash of commands in hrt_replay_report::hash.
#pragma once

#include <bit>
#include <cstdint>

#include "haptic_retargeting/recording.h"
#include "plugin/src/abi/hash.h"

namespace hrt::plugin {

inline void add(const hrt_command& command, Hash& hash) {
#define HRT_ADD_WHOLE(name) hash.add(static_cast<std::uint64_t>(command.name));
#define HRT_ADD_NUMBER(name) hash.add(std::bit_cast<std::uint64_t>(command.name));
  HRT_HASHED_FIELDS(HRT_ADD_WHOLE, HRT_ADD_NUMBER)
#undef HRT_ADD_WHOLE
#undef HRT_ADD_NUMBER
}

}  // namespace hrt::plugin
