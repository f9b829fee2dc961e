#pragma once

#include <cstdint>

#include "haptic_retargeting/host.h"

namespace hrt::plugin {

/// The log of one session. If `log` is null, the session uses the log that hrt_host_set() has set.
struct SessionLog {
  void* context = nullptr;
  void (*log)(void* context, std::uint32_t level, const char* text) = nullptr;
};

/// Writes to the log of the session or, if the session has none, to that of hrt_host_set(). Any thread; takes a lock.
void write_log(std::uint32_t level, const char* text, const SessionLog& of_session = {});

/// Sets the log of a session. Waits while another thread is in write_log().
void set_log(SessionLog* of_session, const hrt_host& host);

/// Replaces the mutex of write_log() in a forked child: if a thread of the parent held the mutex, it would stay locked.
void reset_log_mutex_after_fork();

}  // namespace hrt::plugin
