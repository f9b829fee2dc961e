// The host's logs.
#pragma once

#include <cstdint>

#include "haptic_retargeting/host.h"

namespace hrt::plugin {

/// Where the messages of one session go: to its own callback, or without one to the host's. Any thread; each
/// call takes the one lock of all logs.
class SessionLog {
 public:
  void set(hrt_log_callback callback, void* context);
  void write(std::uint32_t level, const char* text) const;

 private:
  hrt_log_callback callback_ = nullptr;
  void* context_ = nullptr;
};

/// In the child of a fork, where the thread that held the lock does not exist.
void unlock_log_of_parent();

}  // namespace hrt::plugin
