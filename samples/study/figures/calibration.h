// The result of a calibration as text, JSON, a profile for the plugin, and a picture.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/calibration.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {

struct CalibrationReport {
  std::string name;  ///< of the data
  std::size_t trials = 0;
  CalibrationConfig config;
  Calibration calibration;
};

std::string calibration_text(const CalibrationReport& report);
nlohmann::ordered_json calibration_json(const CalibrationReport& report);

/// What a calibration was measured with, as a profile keeps it; 0 and empty: unknown.
struct MeasuredWith {
  std::int64_t time_s = 0;  ///< since 1970, UTC
  std::string plate;
  std::string tracker;
};

/// JSON for hrt_profile_load(), without fields that the data cannot determine.
std::string calibration_profile(const Calibration& calibration, const MeasuredWith& conditions);

/// Directions against the plate's orientation with the fit, and the residuals.
Figure calibration_figure(const CalibrationReport& report);

}  // namespace hrt::study
