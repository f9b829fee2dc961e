// The fit of people who are not its model (core/simulation/person.h), and what it says when it is wrong.
#include "core/calibrate/person_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/calibrate/slide_plan.h"
#include "tests/core/calibrate/calibrated.h"

namespace hrt::test {
namespace {

PersonCondition drawn(const char* family, std::uint32_t index) {
  return draw_person(*people_family(family), 2.0, 1, index);
}

double true_weight(const PersonCondition& condition) {
  const SimulatedIllusion& illusion = condition.person.illusion;
  return (felt_shift_deg(illusion, 60.0) - felt_shift_deg(illusion, -60.0)) / 120.0;
}

// The families are those of the simulation, written a second time.
TEST(IllusionCurve, IsThatOfSimulatedPeople) {
  constexpr std::pair<IllusionFamily, CurveFamily> pairs[] = {{IllusionFamily::linear, CurveFamily::linear},
                                                              {IllusionFamily::saturating, CurveFamily::saturating},
                                                              {IllusionFamily::sine, CurveFamily::sine},
                                                              {IllusionFamily::tanh, CurveFamily::tanh},
                                                              {IllusionFamily::dead_band, CurveFamily::dead_band}};
  for (const auto& [simulated, fitted] : pairs)
    for (double t = -120.0; t <= 120.0; t += 7.0)
      EXPECT_NEAR(curve_shift_deg({fitted, 0.2, 45.0}, t), felt_shift_deg({simulated, 0.2, 45.0}, t), 1e-12);
  for (double t = -80.0; t <= 80.0; t += 20.0)
    EXPECT_NEAR(curve_shift_deg({CurveFamily::unequal, 0.2, 0.1}, t),
                felt_shift_deg({IllusionFamily::unequal, 0.2, 45.0}, t), 1e-12);
}

// By hand: w 60 within 45 degrees of 0.2 t is 9 degrees at 45 and beyond, so 0.15 at 60.
TEST(IllusionCurve, WeightAndPeak) {
  const IllusionCurve curve{CurveFamily::saturating, 0.2, 45.0};
  EXPECT_NEAR(curve_weight(curve), 0.15, 1e-12);
  EXPECT_NEAR(curve_peak(curve, 1.0).shift_deg, 9.0, 1e-12);
  EXPECT_NEAR(curve_peak(curve, -1.0).offset_deg, 45.0, 1e-12);
  EXPECT_NEAR(curve_peak({CurveFamily::sine, 0.2, 0.0}, 1.0).offset_deg, 45.0, 1e-12);
  EXPECT_NEAR(curve_peak({CurveFamily::linear, 0.2, 0.0}, 1.0).offset_deg, 75.0, 1e-12);
}

// Without noise of person or tracker, whatever their gain and delay.
TEST(PersonFit, IsUnbiasedWithoutNoise) {
  for (const double gain : {6.0, 9.0}) {
    for (const double delay_s : {0.0, 0.06}) {
      PersonCondition condition;
      condition.person = {.gain_per_s = gain, .delay_s = delay_s, .noise_deg2_per_s = 0.0, .bias_deg = 2.0};
      condition.person.duration_s = 2.0;
      condition.tracker.white_m = 1e-6;
      const Calibration calibration = calibrated(slides(condition, 0, grid(2)));
      EXPECT_NEAR(calibration.tactile_weight.value, 0.2, 0.002) << gain << ' ' << delay_s;
      EXPECT_NEAR(calibration.bias_deg.value, 2.0, 0.1);
    }
  }
}

// 95 % intervals over people whose illusion, habit or tracker is not that of the old regression, which was
// off by 0.06 to 0.10 with them. hrt-study coverage prints more people. Of 8 to 10 known intervals of 95 %,
// all but 2 cover with a probability of 99 %.
TEST(PersonFit, IntervalsCoverWhereKnown) {
  int known = 0;
  int weight = 0;
  int bias = 0;
  int habit = 0;
  int people = 0;
  for (const char* family : {"linear", "clip-45", "sine-45", "habit-5", "noise-100"}) {
    for (std::uint32_t index = 0; index < 2; ++index) {
      const PersonCondition condition = drawn(family, index);
      const Calibration calibration = calibrated(slides(condition, index, grid(4)));
      ++people;
      if (!calibration.tactile_weight.known) continue;
      ++known;
      weight += covers(calibration.tactile_weight, true_weight(condition));
      bias += covers(calibration.bias_deg, condition.person.bias_deg);
      habit += covers(calibration.habit_deg, condition.person.habit_deg);
      EXPECT_NEAR(calibration.tactile_weight.value, true_weight(condition), 0.03) << family << index;
    }
  }
  EXPECT_GE(known, people * 6 / 10);
  const int min = known - 2;
  EXPECT_GE(weight, min) << known;
  EXPECT_GE(bias, min) << known;
  EXPECT_GE(habit, min) << known;
}

TEST(PersonFit, FindsTheFamily) {
  int sine = 0;
  int saturating = 0;
  for (std::uint32_t index = 0; index < 4; ++index) {
    sine += calibrated(slides(drawn("sine-45", index), index, grid(4))).peak_offset_deg < 55.0;
    saturating +=
        calibrated(slides(drawn("clip-45", index), index, grid(4))).illusion.family == CurveFamily::saturating;
  }
  EXPECT_GE(sine, 3);
  EXPECT_GE(saturating, 2);
}

TEST(PersonFit, NamesSlidesThatWentElsewhere) {
  const PersonCondition condition = drawn("linear", 1);
  std::vector<CalibrationTrial> trials = slides(condition, 1, grid(3));
  const Calibration before = calibrated(trials);
  for (const std::size_t trial : {4U, 17U}) {
    for (TimedPoint& sample : trials[trial].samples) sample.position.right_m += 0.4 * sample.position.away_m;
  }
  const Calibration after = calibrated(trials);
  for (const CalibratedSlide& slide : after.slides) {
    const bool moved = slide.trial == 4 || slide.trial == 17;
    EXPECT_TRUE(!moved || slide.verdict != SlideVerdict::used) << slide.trial;
  }
  EXPECT_NEAR(after.tactile_weight.value, before.tactile_weight.value, 0.01);
}

// A person whose weight falls over the session.
TEST(PersonFit, WithholdsWhatChangesOverTheSession) {
  int found = 0;
  for (std::uint32_t index = 0; index < 5; ++index) {
    std::vector<CalibrationTrial> trials;
    const std::vector<double> angles = grid(4);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      PersonCondition now = drawn("linear", index);
      now.person.illusion.tactile_weight -= 0.08 * (static_cast<double>(i) / static_cast<double>(angles.size()) - 0.5);
      trials.push_back(simulate_slide(now, angles[i], 1, index, static_cast<std::uint32_t>(i)));
    }
    const Calibration calibration = calibrated(trials);
    if (calibration.lack_of_fit.order_p >= min_fit_p) continue;
    ++found;
    EXPECT_FALSE(calibration.tactile_weight.known);
    EXPECT_FALSE(calibration.advice().empty());
  }
  EXPECT_GE(found, 4);
}

// An illusion to one side alone, with a bump that no family has.
TEST(PersonFit, WithholdsWhatNoFamilyFits) {
  const PersonCondition condition = drawn("linear", 3);
  std::vector<CalibrationTrial> trials = slides(condition, 3, grid(4));
  for (CalibrationTrial& trial : trials) {
    const double bump = std::abs(trial.plate_orientation_deg - 30.0) < 10.0 ? 0.10 : 0.0;
    for (TimedPoint& sample : trial.samples) sample.position.right_m += bump * sample.position.away_m;
  }
  const Calibration calibration = calibrated(trials);
  EXPECT_LT(calibration.lack_of_fit.angle_p, min_fit_p);
  EXPECT_FALSE(calibration.tactile_weight.known);
  EXPECT_FALSE(calibration.max_gap_deg.known);
}

TEST(PersonFit, FewAnglesAreTakenForLinearAndSaidSo) {
  std::vector<double> angles;
  for (int i = 0; i < 20; ++i) angles.push_back(-50.0 + 25.0 * ((i * 3) % 5));
  const Calibration calibration = calibrated(slides(drawn("linear", 1), 1, angles));
  EXPECT_EQ(calibration.families.size(), 1U);
  EXPECT_FALSE(calibration.curve.known);
  EXPECT_FALSE(calibration.max_gap_deg.known);
  EXPECT_NE(calibration.advice().front().find("taken for linear"), std::string::npos);
}

std::vector<CalibrationTrial> planned(const PersonCondition& condition, std::uint32_t index, int count,
                                      const SlidePlan& plan, int* enough_at) {
  std::vector<CalibrationTrial> trials;
  *enough_at = 0;
  for (int i = 0; i < count; ++i) {
    const NextSlide next = next_slide(trials, 0.0, plan);
    EXPECT_GE(next.plate_deg, plan.lower_plate_deg);
    EXPECT_LE(next.plate_deg, plan.upper_plate_deg);
    if (next.enough && *enough_at == 0) *enough_at = i;
    trials.push_back(simulate_slide(condition, next.plate_deg, 1, index, static_cast<std::uint32_t>(i)));
  }
  return trials;
}

// The same interval of w_T from half the slides of the grid of -60 to 60 that calibrations used before.
TEST(SlidePlan, HalfTheSlidesOfAFixedGrid) {
  double of_grid = 0.0;
  double of_plan = 0.0;
  for (std::uint32_t index = 0; index < 4; ++index) {
    const PersonCondition condition = drawn("clip-60", index);
    std::vector<double> angles;
    for (int i = 0; i < 42; ++i) angles.push_back(-60.0 + 20.0 * ((i * 3) % 7));
    int enough_at = 0;
    const Calibration fixed = calibrated(slides(condition, index, angles));
    const Calibration chosen = calibrated(planned(condition, index, 21, {}, &enough_at));
    of_grid += fixed.tactile_weight.upper - fixed.tactile_weight.lower;
    of_plan += chosen.tactile_weight.upper - chosen.tactile_weight.lower;
  }
  EXPECT_LE(of_plan, 1.05 * of_grid);
}

TEST(SlidePlan, SaysWhenItIsEnough) {
  int enough_at = 0;
  planned(drawn("linear", 1), 1, 30, {.enough_weight_width = 0.03}, &enough_at);
  EXPECT_GE(enough_at, min_trials);
  EXPECT_LE(enough_at, 30);
  int never = 0;
  planned(drawn("linear", 1), 1, 14, {.enough_weight_width = 0.0}, &never);
  EXPECT_EQ(never, 0);
}

}  // namespace
}  // namespace hrt::test
