// Calibration data as CSV: slides over a fixed plate, one row per tracked position; read from a file or simulated.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/paper_simulation/paper_slide.h"

namespace hrt::study {

inline constexpr const char* calibration_header = "trial,time_s,right_m,away_m,plate_orientation_deg";

/// A simulated person's session: `trials_per_angle` slides at each plate angle, in random order.
struct Session {
  CalibrationCondition condition;
  std::vector<double> plate_angles_deg{-75.0, -67.5, -60.0, -52.5, -45.0, -37.5, -30.0, -22.5, -15.0, -7.5, 0.0,
                                       7.5,   15.0,  22.5,  30.0,  37.5,  45.0,  52.5,  60.0,  67.5,  75.0};
  std::uint64_t trials_per_angle = 2;
  std::uint64_t seed = 1;
};

std::vector<CalibrationTrial> simulate_session(const Session& session);

/// Returns the session as CSV, after comments with the true values of the simulated person.
std::string session_csv(const Session& session);

/// Parses calibration data. Comments (#), empty lines and unknown columns are ignored. `name`: file name for errors.
/// Throws UsageError naming the place and the allowed values.
std::vector<CalibrationTrial> parse_calibration_csv(const std::string& name, std::string_view text);

}  // namespace hrt::study
