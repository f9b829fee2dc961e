// Functions for tests of calibrations.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "core/calibrate/calibration.h"
#include "core/math/elementary.h"
#include "core/simulation/slide.h"

namespace hrt::test {

inline Calibration calibrated(const std::vector<CalibrationTrial>& trials) {
  const auto result = calibrate(trials);
  const auto* refusal = std::get_if<CalibrationRefusal>(&result);
  EXPECT_EQ(refusal, nullptr) << refusal->reason;
  return refusal ? Calibration{} : std::get<Calibration>(result);
}

inline std::string refused(const std::vector<CalibrationTrial>& trials, double goal_direction_deg = 0.0) {
  const auto result = calibrate(trials, goal_direction_deg);
  const auto* refusal = std::get_if<CalibrationRefusal>(&result);
  EXPECT_NE(refusal, nullptr);
  return refusal ? refusal->reason : "";
}

inline bool covers(const Interval& interval, double truth) {
  return interval.lower <= truth && truth <= interval.upper;
}

/// Eleven plate angles, each `slides_an_angle` times, ordered so that a trend over the session is no trend over the
/// angle.
inline std::vector<double> grid(int slides_an_angle) {
  std::vector<double> angles;
  for (int i = 0; i < 11 * slides_an_angle; ++i) angles.push_back(-75.0 + 15.0 * ((i * 7) % 11));
  return angles;
}

inline std::vector<CalibrationTrial> slides(const PersonCondition& condition, std::uint32_t index,
                                            const std::vector<double>& angles) {
  std::vector<CalibrationTrial> trials;
  for (std::size_t i = 0; i < angles.size(); ++i)
    trials.push_back(simulate_slide(condition, angles[i], 1, index, static_cast<std::uint32_t>(i)));
  return trials;
}

/// A straight slide of 100 mm in `direction_deg`, in 3 s.
inline CalibrationTrial straight_slide(double plate_deg, double direction_deg, int samples) {
  CalibrationTrial trial{.plate_orientation_deg = plate_deg, .samples = {}};
  for (int i = 0; i <= samples; ++i) {
    const double travel_mm = 100.0 * i / samples;
    trial.samples.push_back(
        {3.0 * i / samples, {-travel_mm * sin_deg(direction_deg), travel_mm * cos_deg(direction_deg)}});
  }
  return trial;
}

}  // namespace hrt::test
