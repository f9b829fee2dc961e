// What calibration data say of a person, as text, JSON, a profile for the plugin, and a picture.
#pragma once

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
std::string calibration_json(const CalibrationReport& report);

/// What hrt_profile_load() takes; has no field of which the data can't tell.
std::string calibration_profile(const Calibration& calibration);

/// Directions against the plate's orientation with the fit, and the residuals.
Figure calibration_figure(const CalibrationReport& report);

}  // namespace hrt::study
