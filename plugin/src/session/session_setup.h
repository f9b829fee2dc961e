// A set-up of a session: selects the parts, and applies the results of their fits to the session's model.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/setup/setup_fit.h"
#include "core/tracker/recent_places.h"
#include "plugin/src/session/setup_results.h"
#include "plugin/src/session/targets.h"

namespace hrt::plugin {

/// Value of HRT_SETUP_ALL_MISSING.
inline constexpr std::uint32_t setup_all_missing = 64;

struct SetupReport {
  std::uint32_t done = 0;     ///< flags of the parts that ended with a result
  std::uint32_t left = 0;     ///< flags of the pending parts
  std::uint32_t dropped = 0;  ///< flags of the parts that ended without a result
  SetupDrop drop;             ///< the last dropped part; drop.reason is valid while the set-up exists
  std::string drop_reason;    ///< copy of drop.reason
  int slides = 0;
  std::optional<FingertipOffset> fingertip;
  std::optional<Registration> registration;
  std::optional<RegistrationCheck> check;
  std::optional<Calibration> calibration;
  RetestDifference differing;
};

/// A set-up in progress. If a call fails, the set-up and the model are unchanged.
class SessionSetup {
 public:
  /// Fails if the parts cannot be combined, or if a requirement of a part is not met.
  static hrt_result check(const SessionModel& model, const Targets& targets, std::uint32_t parts,
                          const SetupConfig& asked);

  /// Reads the fields of hrt_setup_config from `asked`. If it has no marks, the default marks are used.
  SessionSetup(const SessionModel& model, const Targets& targets, std::uint32_t parts, const SetupConfig& asked,
               double plate_orientation_deg);

  SetupPart part() const { return setup_.part(); }
  SetupStep step() const { return setup_.step(); }
  hrt_result update(const SessionModel& model, const SetupSample& sample, SetupStep* out);
  /// Continues the fit of the current part for at most a few milliseconds. When the fit is complete, applies its result
  /// to the model and adds it to the report.
  hrt_result finish(SessionModel* model, SetupReport* report);
  bool is_over() const { return setup_.left() == 0; }

 private:
  hrt_result check_shown(const SetupSample& sample) const;

  Setup setup_;
  double plate_orientation_deg_;  // of the last step
  std::optional<std::int64_t> last_time_ns_;
  RepeatedPosition<Eigen::Vector3d> repeated_;
  std::unique_ptr<PartFit> fit_;  // fit of the current part; null if it has not begun
};

}  // namespace hrt::plugin
