// One user and one plate, as the entry points and replays call them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/plate/touched_frame.h"
#include "core/reach/reach.h"
#include "haptic_retargeting/reach.h"
#include "plugin/src/session/session_config.h"
#include "plugin/src/session/session_setup.h"
#include "plugin/src/session/targets.h"

namespace hrt {
class Retargeter;
}

namespace hrt::plugin {

/// Every call that fails changes nothing. Those of a reach are real-time.
class Session {
 public:
  explicit Session(const hrt_session_config& checked_config);
  ~Session();

  const hrt_session_config& config() const { return config_; }
  /// Between reaches.
  hrt_result set_config(const hrt_session_config& checked_config);

  /// Where the last command left the plate.
  double plate_orientation_deg() const { return plate_orientation_deg_; }
  void set_plate_orientation_deg(double orientation_deg) { plate_orientation_deg_ = orientation_deg; }

  /// What a caller gave has been read, not checked.
  hrt_result begin(const hrt_reach_config& config);
  hrt_result update(const hrt_sample& sample, hrt_command* command);
  hrt_result retarget(hrt_target real_target, hrt_target virtual_target);
  hrt_result touched(const hrt_contact& contact);
  hrt_result cancel();
  hrt_result end(hrt_reach_summary* summary);
  /// Nor a set-up.
  hrt_result check_no_reach() const;
  hrt_result check_reach() const;
  bool reaching() const { return reaching_; }

  hrt_result begin_setup(std::uint32_t what, const hrt_setup_config& config);
  hrt_result update_setup(const hrt_sample& sample, hrt_setup_step* step);
  /// Not real-time, as begin_setup() and cancel_setup().
  hrt_result finish_setup(hrt_setup_result* result);
  hrt_result cancel_setup();
  hrt_result get_residual(std::uint32_t slide, hrt_setup_residual* out) const;
  bool setting_up() const { return setup_ != nullptr; }
  /// A value of some command or summary was not finite (HRT_COMMAND_FAULT).
  bool has_failed() const { return failed_; }
  /// A command under this configuration was flagged HRT_COMMAND_REGISTRATION.
  bool has_doubted_registration() const { return registration_doubted_; }
  /// What the last begin() or retarget() made of its targets, or the update() that started.
  const Reach& reach() const { return reach_; }
  /// reach() if it has started in the last update(), where the finger was first seen.
  std::optional<Reach> started() const { return started_ ? std::optional(reach_) : std::nullopt; }

  Targets targets;

 private:
  hrt_result aim(const Pair& pair, const PlatePoint& start, Reach* out) const;
  hrt_result start_at(const PlatePoint& finger);
  void judge_registration(const Reach& reach);
  bool is_registration_doubtful(std::int64_t time_ns) const;
  void learn_from(const Contact& contact);
  void write_command(const PlateCommand& command, std::uint32_t finger_flags, hrt_command* out) const;
  hrt_result check_setup() const;
  hrt_reach_summary to_c(const ReachSummary& summary) const;
  void carry(const FingerEstimate& estimate);

  hrt_session_config config_;
  const std::unique_ptr<Retargeter> retargeter_;  // apart, so that who calls a session is not built anew with it
  std::unique_ptr<SessionSetup> setup_;           // null: none is under way
  std::vector<hrt_setup_residual> residuals_;     // of the last calibration
  Pair pair_{};                                   // as the targets were when the reach was given them
  PlatePoint start_;
  Reach reach_{};
  bool reaching_ = false;
  bool awaits_finger_ = false;         // the reach starts where the finger is first seen
  bool started_ = false;               // there, in the last update
  bool sampled_ = false;               // the reach has had a sample
  bool ended_ = false;                 // the reach has ended, and its contact may still come
  std::optional<SeenFinger> finger_;   // where it was then
  bool touched_ = false;               // the contact of the reach is known
  std::optional<Contact> contact_;     // of the reach that is under way
  bool contradicted_ = false;          // contacts move the real target by more than is believable
  bool registration_poor_ = false;     // as far as it can be known before a sample
  bool registration_flagged_ = false;  // by any command of the reach
  bool registration_doubted_ = false;  // of any reach under this configuration
  bool faulty_ = false;                // a value of the reach was not finite
  bool failed_ = false;                // nor was one of any reach
  std::int64_t last_time_ns_ = 0;
  double plate_orientation_deg_ = 0.0;
};

}  // namespace hrt::plugin
