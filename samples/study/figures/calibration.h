// The result of a calibration as text, JSON, a profile for the plugin, and a picture.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/calibrate/calibration.h"
#include "samples/study/figures/figures.h"

namespace hrt::study {

struct CalibrationReport {
  std::string name;  ///< of the data
  std::size_t trials = 0;
  double goal_direction_deg = 0.0;
  Calibration calibration;
};

/// A value of a calibration, with how it is written.
struct EstimatedTrait {
  const char* name;   ///< name in JSON
  const char* words;  ///< label with its unit
  Interval interval;
  int decimals;
};

std::vector<EstimatedTrait> estimated_traits(const Calibration& calibration);

std::string calibration_text(const CalibrationReport& report);
nlohmann::ordered_json calibration_json(const CalibrationReport& report);

/// JSON for hrt_profile_load(), without fields that the data cannot determine.
std::string calibration_profile(const Calibration& calibration);

/// Directions against the plate's orientation with the fit, and the residuals.
Figure calibration_figure(const CalibrationReport& report);

}  // namespace hrt::study
