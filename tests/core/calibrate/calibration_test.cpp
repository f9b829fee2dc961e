#include "core/calibrate/calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/calibrate/slide_scatter.h"
#include "core/paper_simulation/paper_slide.h"
#include "tests/core/calibrate/calibrated.h"

namespace hrt::test {
namespace {

constexpr double angles_deg[] = {-60.0, -30.0, 0.0, 30.0, 60.0};

std::vector<CalibrationTrial> simulate(const CalibrationCondition& condition, int trials_an_angle) {
  std::vector<CalibrationTrial> trials;
  std::uint32_t trial = 0;
  for (const double angle_deg : angles_deg) {
    for (int i = 0; i < trials_an_angle; ++i) {
      trials.push_back(simulate_calibration_trial(condition, angle_deg, {.seed = 1, .condition = 0, .trial = trial++}));
    }
  }
  return trials;
}

// Straight slides in settled directions P = (2 - 0.2 T) / 0.8: w_T = 0.2 and a bias of 2 degrees.
TEST(Calibration, StraightSlides_GiveTheHandCalculatedWeightAndBias) {
  std::vector<CalibrationTrial> trials;
  for (const double angle_deg : angles_deg) {
    for (int repeat = 0; repeat < 2; ++repeat) {
      // A small difference between repetitions, since residuals are needed for the intervals.
      const double direction_deg = (2.0 - 0.2 * angle_deg) / 0.8 + (repeat ? 0.01 : -0.01);
      trials.push_back(straight_slide(angle_deg, direction_deg, 270));
    }
  }
  const Calibration calibration = calibrated(trials);
  EXPECT_NEAR(calibration.tactile_weight.value, 0.2, 5e-3);
  EXPECT_NEAR(calibration.bias_deg.value, 2.0, 0.05);
  EXPECT_NEAR(calibration.habit_deg.value, 0.0, 0.1);
  EXPECT_LT(calibration.tactile_weight.lower, 0.2);
  EXPECT_GT(calibration.tactile_weight.upper, 0.2);
  ASSERT_EQ(calibration.slides.size(), 10U);
  for (const CalibratedSlide& slide : calibration.slides)
    EXPECT_NEAR(settled_direction_deg(slide.fitted_deg), settled_direction_deg(slide.parts_deg), 0.1);
}

// A tracker of 30 Hz read by an application at 90 Hz: each position is repeated twice.
TEST(Calibration, RepeatedPositions_GiveTheResultWithoutThem) {
  PersonCondition condition;
  condition.tracker.white_mm = 1.0;
  std::vector<CalibrationTrial> seldom = slides(condition, 0, grid(2)), copied = seldom;
  for (std::size_t i = 0; i < seldom.size(); ++i) {
    std::vector<TimedPoint>& samples = copied[i].samples;
    seldom[i].samples.clear();
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (k % 3 == 0) seldom[i].samples.push_back(samples[k]);
      samples[k].position = samples[k - k % 3].position;
    }
  }
  const Calibration expected = calibrated(seldom), found = calibrated(copied);
  EXPECT_EQ(found.tactile_weight.value, expected.tactile_weight.value);
  EXPECT_EQ(found.noise.white_mm.value, expected.noise.white_mm.value);
  EXPECT_GT(found.noise.white_mm.value, 0.5);
}

// Slopes that no w_T causes, with so much scatter that the interval includes possible values of w_T.
TEST(Calibration, SlopesBeyondAnyWeight_AreRejected) {
  std::vector<CalibrationTrial> trials;
  for (const double angle_deg : {-20.0, -10.0, 0.0, 10.0, 20.0}) {
    for (const double scatter_deg : {-36.0, 36.0}) {
      trials.push_back(straight_slide(angle_deg, 1.64 * angle_deg + scatter_deg, 90));
    }
  }
  EXPECT_NE(refused(trials).find("the tactile weight is between -"), std::string::npos) << refused(trials);
}

// More than 5 s without a sample end a slide.
TEST(Calibration, ASampleCenturiesLater_IsIgnored) {
  auto trials = simulate({}, 3);
  const Calibration timely = calibrated(trials);
  trials[7].samples.back().time_s = 1e10;
  const Calibration late = calibrated(trials);
  EXPECT_NEAR(late.tactile_weight.value, timely.tactile_weight.value, 0.001);
  EXPECT_NEAR(late.bias_deg.value, timely.bias_deg.value, 0.05);
}

TEST(Calibration, TooFewSlidesOrAngles_AreRejected) {
  const CalibrationCondition condition;
  EXPECT_NE(refused({}).find("at least 10 are needed"), std::string::npos);
  EXPECT_NE(refused(simulate(condition, 1)).find("at least 10 are needed"), std::string::npos);

  std::vector<CalibrationTrial> one_angle;
  for (std::uint32_t i = 0; i < 20; ++i) {
    one_angle.push_back(simulate_calibration_trial(condition, 30.0, {.seed = 1, .condition = 0, .trial = i}));
  }
  EXPECT_NE(refused(one_angle).find("different angles"), std::string::npos);

  CalibrationCondition numb = condition;
  numb.participant.tactile_weight = 0.005;
  EXPECT_NE(refused(simulate(numb, 4)).find("the tactile weight is"), std::string::npos);

  std::vector<CalibrationTrial> resting = simulate(condition, 2);
  for (CalibrationTrial& trial : resting) {
    for (TimedPoint& sample : trial.samples) sample.position = {};
  }
  EXPECT_NE(refused(resting).find("0 of 10"), std::string::npos);
}

TEST(Calibration, PlateAnglesWithin3Degrees_CountOnce) {
  std::vector<SlideTrack> slides;
  for (const double angle_deg : {30.0, 0.0, -30.0, -28.0, 0.0, 3.0}) slides.emplace_back().plate_deg = angle_deg;
  EXPECT_EQ(different_angles(slides), 4);
}

// Rotations of the plate by less than 5 degrees, or before the motion of the finger, do not count.
TEST(Calibration, ARotatingPlateDuringASlide_ExcludesTheSlide) {
  std::vector<CalibrationTrial> trials = simulate({}, 3);
  const Calibration at_rest = calibrated(trials);
  const auto turned = [&](std::size_t first, std::size_t end, double turn_deg) {
    CalibrationTrial trial = trials[0];
    trial.plate_deg.assign(trial.samples.size(), trial.plate_orientation_deg);
    for (std::size_t i = first; i < std::min(end, trial.samples.size()); ++i) trial.plate_deg[i] += turn_deg;
    return trial;
  };
  trials.push_back(turned(100, 200, -5.1));
  trials.push_back(turned(150, 400, 5.1));
  const Calibration calibration = calibrated(trials);
  EXPECT_EQ(calibration.slides_turned, 2U);
  EXPECT_EQ(calibration.slides.size(), at_rest.slides.size());
  EXPECT_EQ(calibration.tactile_weight.value, at_rest.tactile_weight.value);
  ASSERT_EQ(calibration.advice().size(), at_rest.advice().size() + 1);
  trials[0] = turned(0, 40, 90.0);
  trials[1] = turned(150, 400, 4.9);
  EXPECT_EQ(calibrated(trials).slides_turned, 2U);
}

TEST(Calibration, InvalidSamples_AreRejectedWithTheirNumber) {
  std::vector<CalibrationTrial> trials = simulate({}, 2);
  trials[3].samples[7].position.away_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(trials), "trial 4, sample 8: the position is not finite. Correct or remove the sample");
  trials = simulate({}, 2);
  trials[0].samples[5].time_s = trials[0].samples[4].time_s;
  EXPECT_EQ(refused(trials),
            "trial 1, sample 6: the time is not finite or does not increase. Correct or remove the sample");
  trials[2].plate_orientation_deg = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refused({trials[2]}), "trial 1: the plate orientation is not a finite number. Correct or remove the trial");
  trials[4].plate_deg = {0.0};
  EXPECT_EQ(refused({trials[4]}),
            "trial 1: not every sample has the plate's orientation. Add it to each sample or to none");
  trials[4].plate_deg.assign(trials[4].samples.size(), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(refused({trials[4]}), "trial 1: a plate orientation is not finite. Correct or remove the trial");
  EXPECT_EQ(refused({}, std::numeric_limits<double>::infinity()),
            "the goal direction is not a finite number. Give it in degrees");
}

TEST(Calibration, MirroredSlides_GiveTheSameWeightAndOppositeBias) {
  CalibrationCondition condition;
  condition.participant.bias_deg = 2.0;
  std::vector<CalibrationTrial> trials = simulate(condition, 3);
  const Calibration one = calibrated(trials);
  for (CalibrationTrial& trial : trials) {
    trial.plate_orientation_deg = -trial.plate_orientation_deg;
    for (TimedPoint& sample : trial.samples) sample.position.right_mm = -sample.position.right_mm;
  }
  const Calibration other = calibrated(trials);
  EXPECT_NEAR(one.tactile_weight.value, other.tactile_weight.value, 1e-4);
  EXPECT_NEAR(one.bias_deg.value, -other.bias_deg.value, 0.01);
}

}  // namespace
}  // namespace hrt::test
