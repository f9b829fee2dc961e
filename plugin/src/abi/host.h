// The host's log.
#pragma once

#include <cstdint>

#include "haptic_retargeting/host.h"

namespace hrt::plugin {

/// The log of one session; empty: it has none of its own.
struct SessionLog {
  void* context = nullptr;
  void (*log)(void* context, std::uint32_t level, const char* text) = nullptr;
};

/// To the log of the session if it has one, else to that of the process. Any thread; takes a lock.
void write_log(std::uint32_t level, const char* text, const SessionLog& of_session = {});

/// Waits for a running write_log().
void set_log(SessionLog* of_session, const hrt_host& host);

/// In the child of a fork, where the thread that held the lock does not exist.
void unlock_log_of_parent();

}  // namespace hrt::plugin
