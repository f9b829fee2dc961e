#pragma once

#include <cstdint>

#include "haptic_retargeting/host.h"

namespace hrt::plugin {

/// The log of one session. If `log` is null, the session uses the log of the process.
struct SessionLog {
  void* context = nullptr;
  void (*log)(void* context, std::uint32_t level, const char* text) = nullptr;
};

/// Writes to the log of the session or, if the session has none, to the log of the process. Any thread; takes a lock.
void write_log(std::uint32_t level, const char* text, const SessionLog& of_session = {});

/// Sets the log of a session. Waits for the end of a write_log() on another thread.
void set_log(SessionLog* of_session, const hrt_host& host);

/// Constructs the mutex of write_log() again, in a forked child: a thread of the parent may have held it.
void reset_log_mutex_after_fork();

}  // namespace hrt::plugin
