// A set-up of the plugin: the user receives the plugin's instructions, and the plate its commands.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "samples/app/run/finger_record.h"
#include "samples/app/run/run_context.h"

namespace hrt::app {

/// True if `step` requests something other than `asked`. HRT_STEP_HOLD_STILL continues the previous request.
bool is_new_instruction(const hrt_setup_step& asked, const hrt_setup_step& step);

/// Request in words. `mark_names`: the marks' names for the user.
std::string request_of(const hrt_setup_step& step, const std::vector<std::string>& mark_names);

/// One set-up. It continues in a new session of the runtime after a session was lost.
class SetUp {
 public:
  /// `what`: HRT_SETUP_*. `mark_names`: the marks' names for the user; empty: the set-up has no marks. Throws Failure:
  /// ExitCode::scene if the plugin rejects the request, ExitCode::plugin for other errors.
  SetUp(const Plugin& plugin, hrt_session session, std::uint32_t what, const hrt_setup_config& config,
        std::vector<std::string> mark_names = {});
  ~SetUp();
  SetUp(const SetUp&) = delete;
  SetUp& operator=(const SetUp&) = delete;

  /// Runs until the result is complete. Prints a line per slide to `slides`, unless it is null. Throws XrLost, after
  /// which it may be called again; Failure: no_hand if the user does not respond in time or six slides in a row are
  /// rejected, registration if touches are rejected three times, plate if the plate does not turn; otherwise Failure or
  /// XrFailure.
  hrt_setup_result run(RunContext& context, std::ostream* slides = nullptr);

  std::uint32_t done() const { return asked_.done; }

 private:
  void run_until_finish(RunContext& context, XrTime* now, std::ostream* slides);
  hrt_setup_step update(RunContext& context, XrTime time);
  void ask(RunContext& context, const hrt_setup_step& step);
  void check_dropped() const;

  const Plugin& plugin_;
  hrt_session session_;
  std::vector<std::string> mark_names_;
  hrt_setup_result result_{};
  hrt_setup_step asked_{};
  XrTime asked_at_ = 0;
  std::optional<FingerRecord> fingers_;  // since the last request
  std::optional<double> commanded_deg_;
  XrTime later_by_ = 0;  // set-up time minus runtime time, whose clock may restart with a session
  XrTime last_ = 0;      // time of the set-up's latest frame
};

}  // namespace hrt::app
