// What session handles stand for.
#pragma once

#include "plugin/src/abi/handles.h"
#include "plugin/src/recording/recorded_session.h"

namespace hrt::plugin {

using Sessions = HandleTable<RecordedSession, HRT_SESSIONS_MAX, 0x51>;
extern constinit Sessions sessions;

/// Runs the body of an entry point on the session that the handle stands for.
template <class Body>
hrt_result with_session(const char* call, hrt_session handle, Body&& body) noexcept {
  return guarded(call, [&]() -> hrt_result {
    const Sessions::Lease lease = sessions.lease(handle.value);
    if (lease.result() == HRT_ERROR_BUSY)
      return fail(HRT_ERROR_BUSY, "another thread is in a call on this session");
    if (lease.result() != HRT_OK)
      return fail(HRT_ERROR_INVALID_HANDLE, "session ", handle.value, " does not exist");
    return body(*lease);
  });
}

}  // namespace hrt::plugin
