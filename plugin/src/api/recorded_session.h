// The object behind a session's handle. Its calls are recorded while a recording is in progress.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "plugin/src/abi/entry.h"
#include "plugin/src/abi/host.h"
#include "plugin/src/api/conditions.h"
#include "plugin/src/recording/recorder.h"
#include "plugin/src/session/session.h"

namespace hrt::plugin {

/// A call converts the structs of the C headers, calls the session and writes the results. If a call fails, session and
/// outputs are unchanged. Calls of a reach take the pointers of the caller; a call whose struct cannot be read is not
/// recorded.
class RecordedSession {
 public:
  explicit RecordedSession(const SessionModel& valid_model) : session_(valid_model) {}
  ~RecordedSession() = default;
  RecordedSession(const RecordedSession&) = delete;
  RecordedSession& operator=(const RecordedSession&) = delete;

  const Session& session() const { return session_; }

  hrt_result set_model(const SessionModel& valid_model);
  hrt_result add_target(const Target& checked_target, std::uint64_t* out_id);
  hrt_result set_target(std::uint64_t id, const Target& checked_target);
  hrt_result remove_target(std::uint64_t id);
  /// Replaces the model and adds all targets. Their `served_by` is 1 plus the index of the assigned target in
  /// `checked_targets`; 0: none. `out_targets` may be null.
  hrt_result add_scene(const SessionModel& valid_model, std::span<const Target> checked_targets,
                       hrt_target* out_targets);

  hrt_result begin(const hrt_reach_config* given);
  hrt_result update(const hrt_sample* given, hrt_command* out);
  hrt_result retarget(hrt_target real_target, hrt_target virtual_target);
  hrt_result touched(const hrt_contact* given);
  hrt_result cancel();
  hrt_result end(hrt_reach_summary* out);
  hrt_result begin_setup(std::uint32_t what, const hrt_setup_config& config);
  hrt_result update_setup(const hrt_sample& sample, hrt_setup_step* out);
  hrt_result finish_setup(hrt_setup_result* out);
  hrt_result cancel_setup();

  /// Sets the initial plate orientation of a replay.
  hrt_result set_plate_orientation_deg(double orientation_deg);
  /// Geometry of the reach in progress; all 0 without a reach.
  ReachGeometry reach_geometry() const;

  /// Logs what past calls of reaches found: HRT_COMMAND_FAULT once for the session, HRT_COMMAND_REGISTRATION and
  /// HRT_COMMAND_IMPLAUSIBLE once for each configuration. `handle` identifies the session in the log.
  void log_findings(std::uint64_t handle);

  void log_conditions(std::uint64_t handle) const;

  void set_log(const hrt_host& host) { plugin::set_log(&log_, host); }

  std::uint32_t state() const;  ///< flags HRT_STATE_*

  /// `handle` identifies the session in the log.
  hrt_result start_recording(const char* path, std::uint64_t handle);
  hrt_result check_recording() const;
  /// The next three functions require that check_recording() succeeds.
  hrt_recording_status recording_status() { return recorder_->status(); }
  hrt_recording_status flush_recording() { return recorder_->flush(); }
  hrt_recording_status stop_recording();

  Conditions conditions;

 private:
  template <class MakeRecord>
  void record(MakeRecord&& make_record) const {
    if (recorder_) recorder_->push(make_record());
  }
  void forget_findings();
  TargetChanged changed(TargetChanged::Change change, std::uint64_t id) const;

  Session session_;
  bool had_fault_ = false, logged_fault_ = false;
  bool registration_was_poor_ = false;  // true if a command with this configuration had HRT_COMMAND_REGISTRATION
  bool logged_registration_ = false;
  Implausible implausible_;  // the first finding with this configuration
  bool logged_implausible_ = false;
  SessionLog log_;                      // declared before the recorder, whose thread reads it
  std::unique_ptr<Recorder> recorder_;  // null: no recording
};

using Sessions = HandleTable<RecordedSession, HRT_SESSIONS_MAX, 0x51>;
extern constinit Sessions sessions;

}  // namespace hrt::plugin
