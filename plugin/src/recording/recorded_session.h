// A session whose calls are recorded while a recording is running.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plugin/src/recording/recorder.h"
#include "plugin/src/session/conditions.h"
#include "plugin/src/session/session.h"

namespace hrt::plugin {

/// Forwards calls to a session and, while recording, to the recorder. A call that fails changes nothing. Calls of a
/// reach and refuse() are real-time.
class RecordedSession {
 public:
  explicit RecordedSession(const hrt_session_config& checked_config) : session_(checked_config) {}
  ~RecordedSession() = default;
  RecordedSession(const RecordedSession&) = delete;
  RecordedSession& operator=(const RecordedSession&) = delete;

  const Session& session() const { return session_; }

  hrt_result set_config(const hrt_session_config& checked_config);
  hrt_result add_target(const hrt_target_config& checked_config, std::uint64_t* out_id);
  hrt_result set_target(std::uint64_t id, const hrt_target_config& checked_config);
  hrt_result remove_target(std::uint64_t id);
  /// Replaces the configuration and adds all targets, or changes nothing. `served_by` has for each target the index of
  /// the real target that serves it, if there is one.
  hrt_result add_scene(const hrt_session_config& checked_config, std::span<const hrt_target_config> checked_targets,
                       std::span<const std::optional<std::size_t>> served_by, std::vector<std::uint64_t>* out_ids);

  hrt_result begin(const hrt_reach_config& config);
  hrt_result update(const hrt_sample& sample, hrt_command* command) {
    const hrt_result result = session_.update(sample, command);
    if (recorder_) record_update(result, sample, *command);
    return result;
  }
  hrt_result retarget(hrt_target real_target, hrt_target virtual_target);
  hrt_result touched(const hrt_contact& contact);
  hrt_result cancel();
  hrt_result end(hrt_reach_summary* summary);
  hrt_result begin_setup(std::uint32_t what, const hrt_setup_config& config);
  hrt_result update_setup(const hrt_sample& sample, hrt_setup_step* step);
  hrt_result finish_setup(hrt_setup_result* result);
  hrt_result cancel_setup();
  /// Records a call that was refused with `result` because of `argument`. Returns `result`.
  hrt_result refuse(hrt_result result, Refused::Argument argument, const void* given);

  /// Logs once if the session has failed, and once per configuration if a reach was flagged HRT_COMMAND_REGISTRATION.
  /// The log identifies the session by `handle`.
  void log_findings(std::uint64_t handle);

  /// Logs if the person was measured under other conditions than the present ones.
  void log_conditions(std::uint64_t handle) const;

  /// HRT_STATE_*.
  std::uint32_t state() const;

  /// The log identifies the session by `handle`.
  hrt_result start_recording(const char* path, std::uint64_t handle);
  hrt_result check_recording() const;
  /// Require that check_recording() succeeds.
  RecorderStatus recording_status() const { return recorder_->status(); }
  RecorderStatus stop_recording();

  Conditions conditions;

 private:
  template <class MakeRecord>
  void record(MakeRecord&& make_record) const {
    if (recorder_) recorder_->push(make_record());
  }
  void record_update(hrt_result result, const hrt_sample& sample, const hrt_command& command) const;
  void record_target(TargetChanged::Change change, std::uint64_t id) const;

  Session session_;
  bool failure_logged_ = false;
  bool registration_logged_ = false;    // for the present configuration
  std::unique_ptr<Recorder> recorder_;  // null: nothing is recorded
};

}  // namespace hrt::plugin
