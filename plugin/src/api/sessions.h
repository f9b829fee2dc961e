// Handles of sessions.
#pragma once

#include "plugin/src/abi/handles.h"
#include "plugin/src/api/recorded_session.h"

namespace hrt::plugin {

using Sessions = HandleTable<RecordedSession, HRT_SESSIONS_MAX, 0x51>;
extern constinit Sessions sessions;

/// Runs the body of an entry point on the session of a handle.
template <class Body>
hrt_result with_session(const char* call, hrt_session handle, Body&& body) noexcept {
  return with_lease(call, "session", sessions, handle.value, body);
}

}  // namespace hrt::plugin
