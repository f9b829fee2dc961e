// What a session handle stands for.
#pragma once

#include <cstdint>
#include <memory>

#include "core/retargeter.h"
#include "haptic_retargeting/haptic_retargeting.h"
#include "plugin/src/handle_table.h"
#include "plugin/src/recorder.h"
#include "plugin/src/session_config.h"
#include "plugin/src/targets.h"

namespace hrt::plugin {

/// One user and one plate. Every call that fails changes nothing. begin(), update() and end() are real-time.
class Session {
 public:
  explicit Session(const hrt_session_config& checked_config);

  const hrt_session_config& config() const { return config_; }
  /// Between reaches.
  hrt_result set_config(const hrt_session_config& checked_config);

  /// Where the last command left the plate.
  double plate_orientation_deg() const { return plate_orientation_deg_; }
  void set_plate_orientation_deg(double orientation_deg) { plate_orientation_deg_ = orientation_deg; }

  /// What a caller gave has been read, not checked.
  hrt_result begin(const hrt_reach_config& config, Reach* out_reach);
  hrt_result update(const hrt_sample& sample, hrt_command* command);
  hrt_result end(hrt_reach_summary* summary);
  hrt_result check_no_reach() const;
  hrt_result check_reach() const;

  Targets targets;
  std::unique_ptr<Recorder> recorder;  ///< null: nothing is recorded

  /// Takes note of a call that has ended.
  void record(const Record& record) const {
    if (recorder) recorder->push(record);
  }

 private:
  hrt_result resolve(const hrt_reach_config& config, Reach* out) const;
  hrt_result try_begin(const hrt_reach_config& config, Reach* out);
  hrt_result try_update(const hrt_sample& sample, hrt_command* command);
  hrt_result try_end(hrt_reach_summary* summary);
  hrt_command command(std::uint32_t finger_flags) const;
  void carry(const FingerEstimate& estimate);

  hrt_session_config config_;
  Retargeter retargeter_;
  bool reaching_ = false;
  bool sampled_ = false;  // the reach has had a sample
  std::int64_t last_time_ns_ = 0;
  double plate_orientation_deg_ = 0.0;
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

}  // namespace hrt::plugin
