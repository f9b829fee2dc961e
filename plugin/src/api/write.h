// Conversion of core types to the structs of the C interface.
#pragma once

#include "haptic_retargeting/gap.h"
#include "haptic_retargeting/recording.h"
#include "haptic_retargeting/setup.h"
#include "plugin/src/session/gap.h"
#include "plugin/src/session/session.h"

namespace hrt::plugin {

hrt_session_config to_c(const SessionModel& model);
hrt_target_config to_c(const Target& target);
/// The next two functions replace numbers that are not finite by 0, and set HRT_COMMAND_FAULT if there were any.
hrt_command to_c(const PlateCommand& command);
hrt_reach_summary to_c(const ReachSummary& summary);
hrt_setup_step to_c(const SetupStep& step);
hrt_setup_result to_c(const SetupReport& report);
hrt_setup_residual to_c(const CalibratedSlide& slide);
hrt_gap to_c(const Gap& gap, hrt_target real_target, hrt_target virtual_target);

void write(const Vec3& from, double (&to)[3]);
/// Writes a point on the plate in plate coordinates: its height is 0.
void write_point(const PlatePoint& point, double (&out_m)[3]);

void write_step_text(const SetupStep& step, char (&out)[HRT_TEXT_SIZE]);
/// Writes why the last dropped part of a set-up was dropped.
void write_drop_text(const SetupReport& report, char (&out)[HRT_TEXT_SIZE]);

}  // namespace hrt::plugin
