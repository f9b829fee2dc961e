// A set-up of a session: which parts are missing, what is shown and what the fits change.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/setup/setup_fit.h"
#include "core/tracker/repeated_position.h"
#include "plugin/src/session/found_model.h"
#include "plugin/src/session/targets.h"

namespace hrt::plugin {

/// Selects all parts for which the session has no result and the samples have the data; not a part itself.
inline constexpr std::uint32_t setup_all_missing = 64;

/// Results of a set-up since it began.
struct SetupReport {
  std::uint32_t done = 0;  ///< parts that were found and applied
  std::uint32_t left = 0;
  std::uint32_t dropped = 0;  ///< without a result, and not repeated
  SetupDrop drop;             ///< the last dropped part; drop_reason owns its text
  std::string drop_reason;
  int slides = 0;  ///< number of slides that were made
  std::optional<FingertipOffset> fingertip;
  std::optional<Registration> registration;
  std::optional<RegistrationCheck> check;
  std::optional<Calibration> calibration;
  RetestDifference differing;
};

/// Every call that fails changes nothing.
class SessionSetup {
 public:
  /// Fails unless a set-up of these parts can be made.
  static hrt_result check(const SessionModel& model, const Targets& targets, std::uint32_t parts,
                          const SetupConfig& asked);

  /// `asked`: the caller's choice of marks (none: the default ones), touches, slides and plate range.
  SessionSetup(const SessionModel& model, const Targets& targets, std::uint32_t parts, const SetupConfig& asked,
               double plate_orientation_deg);

  SetupPart part() const { return setup_.part(); }
  SetupStep step() const { return setup_.step(); }
  /// Processes one sample. Real-time.
  hrt_result update(const SessionModel& model, const SetupSample& sample, SetupStep* out);
  /// Continues the fit of the current part by one step, of less than 1 ms. Once it is complete, applies the result to
  /// the model and adds it to the report.
  hrt_result finish(SessionModel* model, SetupReport* report);
  bool is_over() const { return setup_.left() == 0; }

 private:
  hrt_result check_shown(const SetupSample& sample) const;

  Setup setup_;
  double plate_orientation_deg_;  // plate orientation of the last step
  std::optional<std::int64_t> last_time_ns_;
  RepeatedPosition<Eigen::Vector3d> repeated_;
  std::unique_ptr<PartFit> fit_;  // fit of the present part, in progress
};

}  // namespace hrt::plugin
