// Rows of a recording that are calls of a calibration.
#pragma once

#include <string>
#include <string_view>

#include "plugin/src/recording/row.h"

namespace hrt::plugin {

/// The calls, for messages.
inline constexpr std::string_view calibration_calls =
    ", calibration_begin_trial, calibration_add_sample, calibration_end_trial, calibration_cancel_trial, "
    "calibration_next_angle, calibration_solve";

void write(const TrialBegun& begun, hrt_result result, RecordText& out);
void write(const TrialSampled& sampled, hrt_result result, RecordText& out);
void write(const TrialEnded& ended, hrt_result result, RecordText& out);
void write(const TrialCancelled& cancelled, hrt_result result, RecordText& out);
void write(const AngleChosen& chosen, hrt_result result, RecordText& out);
void write(const CalibrationSolved& solved, hrt_result result, RecordText& out);

bool is_calibration_call(std::string_view call);

/// A row of the solve call without the values that 0.3 found and this version does not.
std::string without_former_values(std::string_view row);

/// What went into such a call.
hrt_result read_calibration_call(const Cells& cells, Record* out);

}  // namespace hrt::plugin
