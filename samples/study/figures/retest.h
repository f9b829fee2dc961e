// Test and retest of a person: two calibrations compared, as text and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/calibrate/retest.h"
#include "samples/study/figures/calibration.h"

namespace hrt::study {

struct ComparedValue {
  EstimatedTrait trait;  ///< of the first calibration
  RetestDifference difference;
};

struct RetestReport {
  CalibrationReport first;
  CalibrationReport second;
  std::vector<ComparedValue> values;
};

RetestReport compare_calibrations(CalibrationReport first, CalibrationReport second);

std::string retest_text(const RetestReport& report);
nlohmann::ordered_json retest_json(const RetestReport& report);

}  // namespace hrt::study
