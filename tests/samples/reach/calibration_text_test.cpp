// The text of a calibration, from results that no simulation needs to produce.
#include "samples/reach/output/calibration_text.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/samples/text.h"

namespace hrt::reach {
namespace {

constexpr hrt_interval known(double value, double width) {
  return {value, value - width / 2.0, value + width / 2.0, 1, 0};
}

CalibrationOutcome outcome() {
  CalibrationOutcome outcome{.result = {.struct_size = sizeof(hrt_calibration_result)}, .enough = true};
  hrt_calibration_result& result = outcome.result;
  result.trials = 3;
  result.trials_used = 3;
  result.illusion = HRT_ILLUSION_SATURATING;
  result.illusion_scale_deg = 52.0;
  result.peak_offset_deg = 52.0;
  result.tactile_weight = known(0.2, 0.02);
  result.person_weight = known(0.25, 0.02);
  result.person_curve = known(0.1, 0.0);
  result.max_gap_deg = known(9.6, 1.0);
  result.bias_deg = known(-1.25, 0.5);
  result.tracker_noise_m = known(0.0012, 0.0001);
  for (std::uint32_t trial = 0; trial < 3; ++trial)
    outcome.slides.push_back(
        {.struct_size = sizeof(hrt_calibration_slide), .verdict = HRT_SLIDE_USED, .trial = trial});
  return outcome;
}

std::string text_of(const CalibrationOutcome& outcome) {
  std::ostringstream out;
  print_calibration(out, outcome);
  return out.str();
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_TRUE(has(text, part));
}

TEST(CalibrationText, ShowsTheCurveAndItsNumbers) {
  const std::string text = text_of(outcome());
  expect_part(text, "3 slides, 3 used\n");
  expect_part(text, "in proportion, constant beyond 52 deg");
  // 0.25 t - 0.1 t (t / 75)^2 at 75 is 18.75 - 7.5; its deviation that of w alone, 75 * 0.01.
  expect_part(text, " 11.2 +- 0.8\n");
  expect_part(text, "0.200      95 % within 0.190 to 0.210");
  expect_part(text, "9.600 deg  95 % within 9.100 to 10.100");
  expect_part(text, "52 deg from the motion");
  expect_part(text, "-1.250 deg");
  expect_part(text, "1.200 mm ");
  expect_part(text, "habit of curving                   not known\n");
  expect_part(text, "The model fits the slides.\nEnough");
}

TEST(CalibrationText, IsSpokenInShort) {
  EXPECT_EQ(
      calibration_in_words(outcome()),
      "The calibration is complete after 3 slides. It is as exact as was asked. The share of touch is 20 "
      "percent, between 19 and 21. The largest gap that a plate can hold is 10 degrees. The model fits the "
      "slides.");
  CalibrationOutcome bad = outcome();
  bad.enough = false;
  bad.result.lack_of_fit = HRT_LACK_OF_FIT_PATH;
  bad.result.tactile_weight.known = bad.result.max_gap_deg.known = 0;
  EXPECT_EQ(
      calibration_in_words(bad),
      "The calibration is complete after 3 slides. The time ran out before it was as exact as was asked. "
      "The model does not fit the slides: the printed text says why.");
}

TEST(CalibrationText, NamesSlidesAndWhatToDo) {
  CalibrationOutcome bad = outcome();
  bad.enough = false;
  bad.result.lack_of_fit = HRT_LACK_OF_FIT_ANGLE | HRT_LACK_OF_FIT_ORDER | HRT_LACK_OF_FIT_PATH;
  bad.result.illusion = HRT_ILLUSION_NONE;
  bad.result.person_weight.known = 0;
  bad.result.slides_outlying = bad.result.slides_along_ridges = 1;
  bad.slides[1].verdict = HRT_SLIDE_OUTLYING;
  bad.slides[1].plate_deg = 30.0;
  bad.slides[1].residual_deg = -4.2;
  bad.slides[2].verdict = HRT_SLIDE_ALONG_RIDGES;
  bad.slides[2].plate_deg = 75.0;
  const std::string text = text_of(bad);
  expect_part(text, "3 slides, 1 used\n");
  expect_part(text, "no curve fits\n");
  expect_part(text, "curve of the illusion              not known\n");
  expect_part(text, "slide 2, plate at 30 deg: unlike the others, -4.2 deg off the fit");
  expect_part(text, "slide 3, plate at 75 deg: the finger moved along the ridges");
  expect_part(text, "Check the plate's zero");
  expect_part(text, "practise or rest");
  expect_part(text, "slower, longer and even");
  expect_part(text, "The time ran out");
}

}  // namespace
}  // namespace hrt::reach
