// Rate and delay of simulated people's steering, from slides within which the plate turns.
#include "core/calibrate/steering_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/calibrate/slide_plan.h"
#include "tests/core/calibrate/calibrated.h"

namespace hrt::test {
namespace {

// Slides over a plate at rest, then `turning` ones.
std::vector<CalibrationTrial> turning_slides(const PersonCondition& condition, int turning) {
  std::vector<CalibrationTrial> trials = slides(condition, 0, grid(2));
  for (int i = 0; i < turning; ++i)
    trials.push_back(simulate_turning_slide(condition, i % 2 == 0 ? 35.0 : -35.0, 1, 0,
                                            static_cast<std::uint32_t>(trials.size())));
  return trials;
}

PersonCondition person(double rate_per_s, double delay_s) {
  PersonCondition condition = draw_person(*people_family("linear"), 2.0, 1, 0);
  condition.person.gain_per_s = rate_per_s;
  condition.person.delay_s = delay_s;
  return condition;
}

// Without noise of person and tracker the law itself is seen.
TEST(SteeringFit, FindsRateAndDelayOfWhoSteersByTheLaw) {
  for (const auto& [rate_per_s, delay_s] : {std::pair{6.0, 0.10}, {11.0, 0.03}}) {
    PersonCondition condition = person(rate_per_s, delay_s);
    condition.tracker.white_m = 0.0002;
    condition.person.noise_deg2_per_s = 0.5;
    const Calibration calibration = calibrated(turning_slides(condition, 8));
    const SteeringFit& steering = calibration.steering;
    EXPECT_EQ(steering.slides, 8);
    EXPECT_TRUE(steering.rate_per_s.known);
    EXPECT_TRUE(steering.delay_s.known);
    EXPECT_NEAR(steering.rate_per_s.value / rate_per_s, 1.0, 0.1);
    EXPECT_NEAR(steering.delay_s.value, delay_s, 0.01);
  }
}

TEST(SteeringFit, SlidesOverATurningPlateCountForNothingElse) {
  const PersonCondition condition = person(8.0, 0.06);
  const Calibration without = calibrated(turning_slides(condition, 0));
  const Calibration with = calibrated(turning_slides(condition, 6));
  EXPECT_EQ(with.tactile_weight.value, without.tactile_weight.value);
  EXPECT_EQ(with.slides.size(), without.slides.size());
  EXPECT_EQ(without.steering.slides, 0);
  EXPECT_FALSE(without.steering.rate_per_s.known);
  EXPECT_FALSE(without.steering.delay_s.known);
  EXPECT_EQ(next_slide(turning_slides(condition, 6), 0.0, {}).plate_deg,
            next_slide(turning_slides(condition, 0), 0.0, {}).plate_deg);
}

TEST(SteeringFit, FewSlidesAreNotEnough) {
  const Calibration calibration = calibrated(turning_slides(person(8.0, 0.06), 5));
  EXPECT_EQ(calibration.steering.slides, 5);
  EXPECT_FALSE(calibration.steering.rate_per_s.known);
  const std::vector<std::string> advice = calibration.advice();
  ASSERT_FALSE(advice.empty());
  EXPECT_NE(advice.back().find("the steering takes 6 slides"), std::string::npos) << advice.back();
}

// Reports with the wrong sign: no law has an answer to the other side.
TEST(SteeringFit, PathsThatNoLawExplainsAreNoticed) {
  std::vector<CalibrationTrial> trials = turning_slides(person(8.0, 0.06), 12);
  EXPECT_GT(calibrated(trials).steering.law_p, min_fit_p);
  for (CalibrationTrial& trial : trials)
    for (double& plate_deg : trial.plate_deg) plate_deg = -plate_deg;
  const Calibration calibration = calibrated(trials);
  EXPECT_LT(calibration.steering.law_p, 1e-4);
  EXPECT_FALSE(calibration.steering.rate_per_s.known);
  EXPECT_FALSE(calibration.steering.delay_s.known);
  EXPECT_TRUE(calibration.tactile_weight.known);
  const std::vector<std::string> advice = calibration.advice();
  ASSERT_FALSE(advice.empty());
  EXPECT_NE(advice.back().find("unlike every law of steering"), std::string::npos) << advice.back();
}

// A report that trembles by less than 5 degrees is of a plate at rest.
TEST(SteeringFit, ATremblingReportIsOfAPlateAtRest) {
  std::vector<CalibrationTrial> trials = turning_slides(person(8.0, 0.06), 0);
  const Calibration still = calibrated(trials);
  for (CalibrationTrial& trial : trials)
    for (std::size_t i = 0; i < trial.samples.size(); ++i)
      trial.plate_deg.push_back(trial.plate_orientation_deg + (i % 2 == 0 ? 2.0 : -2.0));
  const Calibration trembling = calibrated(trials);
  EXPECT_EQ(trembling.tactile_weight.value, still.tactile_weight.value);
  EXPECT_EQ(trembling.steering.slides, 0);
}

TEST(SteeringFit, OrientationsAreChecked) {
  std::vector<CalibrationTrial> trials = turning_slides(person(8.0, 0.06), 1);
  trials.back().plate_deg.back() = std::nan("");
  EXPECT_NE(refused(trials).find("a plate orientation is not finite"), std::string::npos);
  trials.back().plate_deg.pop_back();
  EXPECT_NE(refused(trials).find("not every sample has the plate's orientation"), std::string::npos);
}

}  // namespace
}  // namespace hrt::test
