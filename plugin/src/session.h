// What a session handle stands for.
#pragma once

#include <cstdint>

#include "core/retargeter.h"
#include "haptic_retargeting/haptic_retargeting.h"
#include "plugin/src/handle_table.h"
#include "plugin/src/targets.h"

namespace hrt::plugin {

struct Session {
  explicit Session(const hrt_session_config& checked_config);

  hrt_session_config config;
  Retargeter retargeter;
  Targets targets;

  bool reaching = false;
  bool reachable = false;  // the pair of the reach
  bool sampled = false;    // the reach has had a sample
  std::int64_t last_time_ns = 0;
  double plate_orientation_deg = 0.0;  // last commanded
};

inline constexpr std::uint8_t session_kind = 0x51;
using Sessions = HandleTable<Session, HRT_SESSIONS_MAX, session_kind>;
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

hrt_session_config default_session_config();

/// Where a session's reaches start, in the plane of the plate.
PlatePoint start_of(const hrt_session_config& config);

}  // namespace hrt::plugin
