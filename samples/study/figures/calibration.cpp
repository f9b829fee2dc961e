#include "samples/study/figures/calibration.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/learning.h"
#include "core/person/person_belief.h"
#include "samples/app/text/text.h"
#include "samples/study/cli/output.h"

namespace hrt::study {
namespace {

constexpr const char* verdict_name[] = {"used", "outlying", "along_ridges"};

std::string interval_text(const EstimatedTrait& trait) {
  return between(trait.interval.lower, trait.interval.upper, trait.decimals, " to ");
}

std::string row(const std::string& name, const std::string& value, const std::string& rest) {
  return "  " + left(name, 36) + right(value, 15) + "   " + rest + '\n';
}

std::string fit_text(const Calibration& calibration) {
  const LackOfFit& lack = calibration.lack_of_fit;
  const auto line = [](const char* over, double p) {
    return row(std::string("  ") + over, fixed(p, 3), p < min_fit_p ? "a pattern" : "none");
  };
  std::string text = "\nPatterns in what the fit leaves, probability by chance\n" +
                     line("over the plate's angle", lack.angle_p) + line("over the order of the slides", lack.order_p) +
                     line("along the paths", lack.path_p);
  for (const CalibratedSlide& slide : calibration.slides) {
    if (slide.verdict != SlideVerdict::outlying) continue;
    Eigen::Index part = 0;
    (slide.parts_deg - slide.fitted_deg).cwiseAbs().maxCoeff(&part);
    text += "  left out: trial " + std::to_string(slide.trial + 1) + ", an outlier: part " + std::to_string(part + 1) +
            " of its path goes to " + fixed(slide.parts_deg(part), 1) + " deg, the fit to " +
            fixed(slide.fitted_deg(part), 1) + '\n';
  }
  if (const std::size_t along = calibration.count(SlideVerdict::along_ridges); along > 0)
    text += "  left out: " + std::to_string(along) + " slides nearly along the ridges, where the illusion flips\n";
  if (calibration.max_plate_deg > 60.0)
    text += "  slides used reach plate angles of " + fixed(calibration.max_plate_deg, 0) +
            " deg; published human data cover 60\n";
  for (const std::string& advice : calibration.advice()) text += "Next: " + advice + ".\n";
  return text;
}

}  // namespace

std::vector<EstimatedTrait> estimated_traits(const Calibration& calibration) {
  return {{"tactile_weight", "tactile weight w_T at 60°", calibration.tactile_weight, 3},
          {"bias_deg", "bias, °, left positive", calibration.bias_deg, 2},
          {"habit_deg", "habit of curving, °", calibration.habit_deg, 2},
          {"max_gap_deg", "largest gap, °", calibration.max_gap_deg, 1},
          {"person_weight", "slope w of the controller's curve", calibration.slope, 3},
          {"person_curve", "curve b of it", calibration.curve, 3},
          {"tracker_noise_mm", "tracker noise, white, mm", calibration.noise.white_mm, 3},
          {"correlated_noise_mm", "tracker noise, correlated, mm", calibration.noise.correlated_mm, 3},
          {"noise_correlation_s", "its correlation time, s", calibration.noise.correlation_s, 3}};
}

std::string calibration_text(const CalibrationReport& report) {
  const Calibration& calibration = report.calibration;
  std::string text = "Calibration of " + report.name + ": " + std::to_string(calibration.count(SlideVerdict::used)) +
                     " of " + std::to_string(report.trials) + " trials have a slide that can be used\n\n";
  text += row("", "estimate", "95 % interval");
  for (const EstimatedTrait& trait : estimated_traits(calibration)) {
    const std::string value = fixed(trait.interval.value, trait.decimals);
    text += trait.interval.known ? row(trait.words, value, interval_text(trait))
                                 : row(trait.words, "not determined", "best fit " + value);
  }
  text += row("largest gap, plate from motion, °", fixed(calibration.peak_offset_deg, 0), "") + fit_text(calibration);
  return text + "\nThe method has been tried on simulated people only; there was no human trial.\n";
}

nlohmann::ordered_json calibration_json(const CalibrationReport& report) {
  const Calibration& calibration = report.calibration;
  nlohmann::ordered_json page{
      {"data", report.name},
      {"tried_on", "simulated people only"},
      {"trials", report.trials},
      {"trials_used", calibration.count(SlideVerdict::used)},
      {"goal_direction_deg", report.goal_direction_deg},
  };
  for (const EstimatedTrait& trait : estimated_traits(calibration))
    page[trait.name] = {{"value", trait.interval.value},
                        {"interval", {trait.interval.lower, trait.interval.upper}},
                        {"known", trait.interval.known}};
  page["slides_turned"] = calibration.slides_turned;
  page["fits"] = calibration.fits();
  page["lack_of_fit"] = {{"angle_p", calibration.lack_of_fit.angle_p},
                         {"order_p", calibration.lack_of_fit.order_p},
                         {"path_p", calibration.lack_of_fit.path_p}};
  page["min_fit_p"] = min_fit_p;
  page["peak_offset_deg"] = calibration.peak_offset_deg;
  for (const CurvePoint& point : calibration.band)
    page["curve"].push_back({{"offset_deg", point.offset_deg},
                             {"shift_deg", point.shift_deg.value},
                             {"interval", {point.shift_deg.lower, point.shift_deg.upper}}});
  for (const CalibratedSlide& slide : calibration.slides) {
    const auto residuals_deg = (slide.parts_deg - slide.fitted_deg).eval();
    page["slides"].push_back({{"trial", slide.trial + 1},
                              {"verdict", verdict_name[static_cast<int>(slide.verdict)]},
                              {"plate_deg", slide.plate_deg},
                              {"direction_deg", settled_direction_deg(slide.parts_deg)},
                              {"fitted_deg", settled_direction_deg(slide.fitted_deg)},
                              {"residuals_deg", std::vector<double>(residuals_deg.begin(), residuals_deg.end())}});
  }
  page["advice"] = calibration.advice();
  return page;
}

std::string calibration_profile(const Calibration& calibration) {
  nlohmann::ordered_json profile{{"format", "haptic retargeting profile"}, {"version", 1}};
  const Interval& weight = calibration.tactile_weight;
  if (weight.known) {
    profile["tactile_weight"] = weight.value;
    profile["tactile_weight_sd"] =
        std::max(deviation_of_interval(weight.lower, weight.upper), Tuning{}.min_carried_weight_sd);
  }
  if (calibration.bias_deg.known) profile["bias_deg"] = calibration.bias_deg.value;
  if (const auto noise = known_noise(calibration.noise)) {
    profile["tracker_noise_m"] = noise->white_mm / mm_per_m;
    if (noise->correlated_mm > 0.0) {
      profile["tracker_correlated_noise_m"] = noise->correlated_mm / mm_per_m;
      profile["tracker_correlation_s"] = noise->correlation_s;
    }
  }
  if (calibration.slope.known && calibration.curve.known && calibration.bias_deg.known && calibration.habit_deg.known) {
    const PersonBelief belief = calibrated_person({.weight = calibration.slope,
                                                   .curve = calibration.curve,
                                                   .weight_curve_correlation = calibration.slope_curve_correlation,
                                                   .bias_deg = calibration.bias_deg,
                                                   .habit_deg = calibration.habit_deg});
    for (int i = 0; i < PersonState::traits; ++i) {
      profile["person_mean"].push_back(belief.mean(i));
      for (int j = 0; j <= i; ++j) profile["person_covariance"].push_back(belief.covariance(i, j));
    }
  }
  return profile.dump(2) + '\n';
}

Figure calibration_figure(const CalibrationReport& report) {
  return {.name = "calibration",
          .title = "Directions over plates at rest",
          .caption = "",
          .data = calibration_json(report)};
}

}  // namespace hrt::study
