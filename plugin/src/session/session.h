// The state of the plugin for one user at one plate. If a call fails, the session is unchanged.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "core/retargeter.h"
#include "core/tracker/recent_places.h"
#include "plugin/src/session/contact.h"
#include "plugin/src/session/plausibility.h"
#include "plugin/src/session/session_setup.h"

namespace hrt::plugin {

struct ReachRequest {
  std::uint64_t real_target = 0;
  std::uint64_t virtual_target = 0;
  std::optional<double> plate_orientation_deg;  ///< unset: that of the session
  double duration_s = 0.0;                      ///< expected duration of the motion; 0: unknown
  bool starts_at_finger = false;
};

class Session {
 public:
  /// Requires is_valid(model).
  explicit Session(SessionModel model) : model_(std::move(model)) {}

  const SessionModel& model() const { return model_; }
  /// Requires is_valid(model). Fails during a reach or a set-up.
  hrt_result set_model(const SessionModel& model);

  /// Orientation at which the plate is assumed to be: that of the last command, or that given to begin() after it.
  double plate_orientation_deg() const { return plate_orientation_deg_; }
  void set_plate_orientation_deg(double orientation_deg) { plate_orientation_deg_ = orientation_deg; }

  bool is_reaching() const { return std::holds_alternative<Reaching>(state_); }
  bool is_setting_up() const { return std::holds_alternative<SettingUp>(state_); }
  hrt_result check_idle() const;
  hrt_result check_reaching() const;
  hrt_result check_setting_up() const;

  /// Requires that check_idle() succeeds.
  hrt_result begin(const ReachRequest& request);
  /// Requires that check_reaching() succeeds.
  hrt_result update(const FingerSample& sample, PlateCommand* out);
  hrt_result retarget(std::uint64_t real_target, std::uint64_t virtual_target);
  /// Fails if no reach is in progress or has just ended, if this reach already has a contact, or if the plate is not
  /// registered.
  hrt_result check_contact_due() const;
  /// Requires that check_contact_due() succeeds.
  hrt_result touched(const ContactReport& report);
  hrt_result cancel();
  hrt_result end(ReachSummary* out);
  /// Makes end() discard estimates and contact of the present reach. Call it if a value of a command was not finite.
  void mark_faulty();

  /// The likely mistake in the current reach, or in the last one.
  const Implausible& implausible() const { return implausible_; }

  /// Geometry of the reach in progress, after the last retarget.
  const Reach& reach() const { return std::get<Reaching>(state_).reach; }
  /// True while a reach waits for the position of the finger at which it will start.
  bool awaits_finger() const { return is_reaching() && std::get<Reaching>(state_).awaits_finger; }

  /// Requires that check_idle() succeeds.
  hrt_result begin_setup(std::uint32_t parts, const SetupConfig& asked);
  /// Requires that check_setting_up() succeeds.
  hrt_result update_setup(const SetupSample& sample, SetupStep* out);
  /// Continues the current fit; after the last fit, ends the set-up.
  hrt_result finish_setup();
  hrt_result cancel_setup();
  /// Requires is_setting_up().
  SetupPart setup_part() const { return std::get<SettingUp>(state_)->part(); }
  SetupStep setup_step() const { return std::get<SettingUp>(state_)->step(); }
  const SetupReport& setup_report() const { return *report_; }
  /// Slides of the last calibration or retest; empty before the first one.
  const std::vector<CalibratedSlide>& slides() const {
    return report_ && report_->calibration ? report_->calibration->slides : former_slides_;
  }

  Targets targets;

 private:
  struct Pair {
    TargetPlace real;
    TargetPlace virtual_target;
  };
  struct RegistrationAssessment {
    bool is_poor = false;  // missing although required, or less accurate than required
    bool contacts_disagree = false;
  };
  /// Data of an ended reach, for a contact that is reported after its end.
  struct EndedReach {
    PlatePoint start;
    TargetPlace real;
    std::optional<FingerPosition> finger;
    bool was_touched = false;
  };
  struct Idle {
    std::optional<EndedReach> last;
  };
  struct Reaching {
    Reaching(const Pair& targets, const Reach& first, const RetargeterConfig& config)
        : pair(targets), reach(first), start(first.start), retargeter(config) {}

    Pair pair;
    Reach reach;       // geometry after the last retarget
    PlatePoint start;  // start of the reach, before any retarget
    Retargeter retargeter;
    Plausibility plausibility;
    RepeatedPosition<PlatePoint> repeated;
    bool awaits_finger = false;
    RegistrationAssessment assessment;
    std::optional<std::int64_t> last_time_ns;
    std::optional<Contact> contact;
    bool registration_doubtful = false;  // true if any command of the reach had this flag
    bool faulty = false;
  };
  using SettingUp = std::unique_ptr<SessionSetup>;

  hrt_result find_pair(std::uint64_t real_target, std::uint64_t virtual_target, Pair* out) const;
  hrt_result aim(const Pair& pair, const PlatePoint& start, Reach* reach) const;
  Plausibility plausibility_of(const Reach& reach) const;
  hrt_result start_at(const PlatePoint& finger, Reaching* reaching) const;
  RegistrationAssessment assess_registration(const Reach& reach) const;
  bool is_too_old(std::int64_t time_ns) const;
  void learn(const Retargeter& retargeter, const ReachSummary& summary);

  SessionModel model_;
  std::variant<Idle, Reaching, SettingUp> state_;
  double plate_orientation_deg_ = 0.0;
  Implausible implausible_;
  std::unique_ptr<SetupReport> report_;         // report of the latest set-up; null before the first one
  std::vector<CalibratedSlide> former_slides_;  // slides of the last calibration or retest before that set-up
};

}  // namespace hrt::plugin
