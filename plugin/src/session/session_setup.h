// A session's set-up: what is asked for, seen and found crosses the boundary here.
#pragma once

#include <cstdint>
#include <vector>

#include "core/setup/setup.h"
#include "haptic_retargeting/setup.h"
#include "haptic_retargeting/study.h"
#include "plugin/src/session/targets.h"

namespace hrt::plugin {

/// Fails naming the first field that is out of its range.
hrt_result check_setup_config(const hrt_setup_config& config);

/// Every call that fails changes nothing.
class SessionSetup {
 public:
  /// Whether one can be made: of a checked configuration.
  static hrt_result check(const hrt_session_config& session, const Targets& targets, std::uint32_t what);
  SessionSetup(const hrt_session_config& session, const Targets& targets, std::uint32_t what,
               const hrt_setup_config& checked_config, double plate_orientation_deg);

  /// Real-time.
  hrt_result update(const hrt_session_config& session, const hrt_sample& sample, hrt_setup_step* out);
  /// Fits and writes what is found into `*session`, and the slides of a calibration to `*residuals`.
  hrt_result finish(hrt_session_config* session, std::vector<hrt_setup_residual>* residuals, hrt_setup_result* out);
  bool is_over() const { return setup_.left() == 0; }

 private:
  SetupSample seen(const hrt_session_config& session, const hrt_sample& sample) const;
  hrt_result check_shown(const hrt_sample& sample, const SetupSample& seen) const;
  hrt_setup_step to_c(const SetupStep& step, const hrt_session_config& session);

  double touch_sd_mm_;
  Setup setup_;
  hrt_setup_result result_{};
  double plate_orientation_deg_;  // as last asked for
  bool sampled_ = false;
  std::int64_t last_time_ns_ = 0;
};

/// What the user reads or hears, in one line.
void write_step_text(const SetupStep& step, char (&out)[HRT_TEXT_SIZE]);

}  // namespace hrt::plugin
